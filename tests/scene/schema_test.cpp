// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The schema's keys, requirements, names and ranges are held against the reader itself, each way: at every
// object that the schema knows, every word that stands in the readers' sources or in the schema is tried as a
// key. That valid scenes pass a validator, and which refused ones it refuses, is tests/viewers/schema.mjs.

#include "sweepkit/scene/schema.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <set>
#include <sstream>

#include "scene_text.hpp"
#include "sweepkit/sweep/options.hpp"

namespace sweepkit::scene {
namespace {

using nlohmann::json;

const json& schema() {
  static const json parsed = json::parse(scene_schema());
  return parsed;
}

const json& definition(const std::string& name) {
  return name.empty() ? schema() : schema()["$defs"][name];
}

// A value that a definition describes, where it stands in a scene that is sound but for files that are not
// there.
struct Location {
  std::string name;  // of the definition; empty: the scene itself
  json scene;
  std::string pointer;
};

json scene_with(const std::string& key, json value) {
  json scene = json::parse(scene_text(""));
  scene[key] = std::move(value);
  return scene;
}

// With what a strength needs beside it.
json scene_with_a_normal_map() {
  json scene = scene_with("materials", {{"m", {{"normal_map", "i"}}}});
  scene["textures"] = {{"i", {{"image", "i.png"}}}};
  return scene;
}

json scene_of_object(json object) {
  return {{"sweepkit", 1}, {"objects", {std::move(object)}}};
}

json straight_sweep() {
  return json::parse(
      R"({"contour": {"circle": {"radius": 1}}, "trajectory": {"line": [[0, 0, 0], [0, 1, 0]]}})");
}

json scene_of_sweep(const std::string& key, json value) {
  json sweep = straight_sweep();
  sweep[key] = std::move(value);
  return scene_of_object({{"name", "a"}, {"sweep", std::move(sweep)}});
}

std::vector<Location> locations() {
  const json floor = json::parse(kFloor);
  const auto floor_with = [&](const std::string& key, json value) {
    json object = floor;
    object[key] = std::move(value);
    return scene_of_object(object);
  };
  std::vector<Location> all = {
      {"", json::parse(scene_text("")), ""},
      {"camera", scene_with("camera", json::object()), "/camera"},
      {"camera", scene_with("camera", {{"eye", {0, 0, 1}}, {"target", {0, 0, 0}}}), "/camera"},
      {"backgroundImage", scene_with("background", {{"image", "x.exr"}}), "/background"},
      {"light", scene_with("lights", {{{"point", {0, 0, 0}}}}), "/lights/0"},
      {"light", scene_with("lights", {{{"directional", {0, 0, 1}}}}), "/lights/0"},
      {"imageTexture", scene_with("textures", {{"t", {{"image", "x.png"}}}}), "/textures/t"},
      {"material", scene_with_a_normal_map(), "/materials/m"},
      {"object", scene_of_object(floor), "/objects/0"},
      {"instance", floor_with("instances", {json::object()}), "/objects/0/instances/0"},
      {"tessellation", floor_with("tessellation", json::object()), "/objects/0/tessellation"},
      {"uv", floor_with("uv", json::object()), "/objects/0/uv"},
      {"plane", scene_of_object(floor), "/objects/0/plane"},
      {"mesh", scene_of_object({{"name", "a"}, {"mesh", {{"file", "a.obj"}}}}), "/objects/0/mesh"},
      {"part", scene_of_object({{"name", "a"}, {"parts", {{{"plane", floor["plane"]}}}}}),
       "/objects/0/parts/0"},
      {"sweep", scene_of_object({{"name", "a"}, {"sweep", straight_sweep()}}), "/objects/0/sweep"},
      {"morphKey", scene_of_sweep("morph", {{{"at", 1}, {"contour", straight_sweep()["contour"]}}}),
       "/objects/0/sweep/morph/0"},
      {"revolve", scene_of_object({{"name", "a"}, {"revolve", {{"contour", {{"line", {{1, 0}, {1, 1}}}}}}}}),
       "/objects/0/revolve"},
      {"profileOfTwo", scene_of_sweep("profile", {{"x", 1}}), "/objects/0/sweep/profile"},
  };
  for (const std::string kind :
       {"checker", "tiles", "bands", "brick", "marble", "wood", "granite", "clouds", "noise"}) {
    all.push_back({kind + "Texture", scene_with("textures", {{"t", {{"procedural", kind}}}}), "/textures/t"});
  }
  for (const std::string form : {"points", "bezier"}) {
    const std::string suffix = form == "points" ? "Points" : "Bezier";
    const json law = {{form, {{0, 1}, {1, 2}}}};
    all.push_back({"size" + suffix, scene_of_sweep("profile", {{"x", law}}), "/objects/0/sweep/profile/x"});
    all.push_back({"twist" + suffix, scene_of_sweep("twist_deg", law), "/objects/0/sweep/twist_deg"});
  }
  const json curves = json::parse(R"({
      "circle": {"circle": {"radius": 1}}, "ellipse": {"ellipse": {"rx": 1, "ry": 2}},
      "rectangle": {"rectangle": {"width": 1, "height": 1}}, "polygon": {"polygon": {"sides": 5, "radius": 1}},
      "star": {"star": {"points": 5, "radius": 1, "inner_radius": 0.5}},
      "arc": {"arc": {"radius": 1, "from_deg": 0, "to_deg": 90}}, "svg": {"svg": "x.svg"}, "path": {"path": "M0 0h1v1z"},
      "csv": {"csv": "x.csv"}, "bezier2": {"bezier": [[0, 0], [1, 1]]}, "beziers2": {"beziers": [[[0, 0], [1, 1]]]},
      "free2": {"free": [[0, 0], [1, 1]]}, "polyline2": {"polyline": [[0, 0], [1, 1]]}, "line2": {"line": [[0, 0], [1, 1]]}})");
  for (const auto& [name, curve] : curves.items()) {
    const bool is_primitive = curve.begin()->is_object();
    const bool is_flat = name.back() == '2';
    all.push_back(
        {is_flat ? name : name + "Curve", scene_of_sweep("contour", curve), "/objects/0/sweep/contour"});
    if (is_primitive)
      all.push_back({name, scene_of_sweep("contour", curve), "/objects/0/sweep/contour/" + name});
  }
  const json spatial = json::parse(R"({
      "helix": {"helix": {"radius": 1, "pitch": 1, "turns": 1}},
      "torus_knot": {"torus_knot": {"p": 2, "q": 3, "radius": 2, "tube": 1}},
      "bezier3": {"bezier": [[0, 0, 0], [1, 1, 1]]}, "beziers3": {"beziers": [[[0, 0, 0], [1, 1, 1]]]},
      "free3": {"free": [[0, 0, 0], [1, 1, 1]]}, "polyline3": {"polyline": [[0, 0, 0], [1, 1, 1]]},
      "line3": {"line": [[0, 0, 0], [1, 1, 1]]}})");
  for (const auto& [name, curve] : spatial.items()) {
    const bool is_primitive = curve.begin()->is_object();
    const std::string at = "/objects/0/sweep/trajectory";
    all.push_back({is_primitive ? name + "Curve" : name, scene_of_sweep("trajectory", curve), at});
    std::string of_primitive = at;
    of_primitive.append("/").append(name);
    if (is_primitive) all.push_back({name, scene_of_sweep("trajectory", curve), of_primitive});
  }
  return all;
}

// The scene with a value set where the location is.
std::string fault_with(const Location& location, const std::string& key, const json& value) {
  json scene = location.scene;
  scene[json::json_pointer(location.pointer)][key] = value;
  return fault_of(scene.dump());
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// Refused for the key alone: it is none here, or says for the second time what the thing is.
bool is_refused_as_key(const std::string& message, const std::string& key) {
  return has(message, "unknown key \"" + key + "\"") || has(message, "a curve is of one kind") ||
         has(message, "a texture is an \"image\" or a \"procedural\", not both") ||
         has(message, "\"points\" or \"bezier\", one of them");
}

std::set<std::string> vocabulary() {
  std::set<std::string> words;
  const std::regex word("\"([$a-z][a-z0-9_]*)\"");
  const auto add = [&](const std::string& text) {
    for (std::sregex_iterator at(text.begin(), text.end(), word), end; at != end; ++at)
      words.insert((*at)[1]);
  };
  for (const auto& entry : std::filesystem::directory_iterator(SWEEPKIT_SCENE_SOURCES)) {
    const std::string name = entry.path().filename().string();
    if (name != "document.cpp" && !name.starts_with("read_")) continue;
    std::ostringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    add(text.str());
  }
  add(schema().dump());
  return words;
}

TEST(SceneSchema, EveryObjectInItIsTriedHere) {
  std::set<std::string> tried;
  for (const Location& location : locations()) tried.insert(location.name);
  std::set<std::string> there = {""};
  for (const auto& [name, value] : schema()["$defs"].items()) {
    if (value.contains("properties")) there.insert(name);
  }
  EXPECT_EQ(tried, there);
}

TEST(SceneSchema, HasTheReadersKeysAndNoOthers) {
  const std::set<std::string> words = vocabulary();
  EXPECT_GT(words.size(), 150u);
  for (const Location& location : locations()) {
    const json& of = definition(location.name);
    EXPECT_EQ(of["additionalProperties"], false) << location.name;
    for (const std::string& key : words) {
      if (location.scene[json::json_pointer(location.pointer)].contains(key)) {
        EXPECT_TRUE(of["properties"].contains(key)) << location.name << " " << key;
        continue;
      }
      const std::string message = fault_with(location, key, nullptr);
      EXPECT_NE(message, "") << location.name << " takes null for " << key;
      EXPECT_EQ(of["properties"].contains(key), !is_refused_as_key(message, key))
          << location.name << " " << key << ": " << message;
    }
  }
}

TEST(SceneSchema, RequiresWhatTheReaderRequires) {
  for (const Location& location : locations()) {
    const json::json_pointer at(location.pointer);
    const json& of = definition(location.name);
    const std::string sound = fault_of(location.scene.dump());
    for (const auto& [key, value] : location.scene[at].items()) {
      json without = location.scene;
      without[at].erase(key);
      const json required = of.value("required", json::array());
      const json together = of.value("dependentRequired", json::object());
      // Light, object and part need one of several keys.
      const bool is_needed = std::find(required.begin(), required.end(), key) != required.end() ||
                             of.contains("oneOf") || of.contains("minProperties") || together.contains(key);
      EXPECT_EQ(fault_of(without.dump()) != sound, is_needed) << location.name << " without " << key;
    }
  }
}

// What a $ref stands for, with what stands beside it.
json resolved(const json& value) {
  if (!value.contains("$ref")) return value;
  return resolved(definition(value["$ref"].get<std::string>().substr(std::string("#/$defs/").size())));
}

// Whether the limits are where the reader has them; no answer where it looks at something else first.
std::optional<bool> has_range(const Location& location, const std::string& key, const json& number,
                              const std::function<json(double)>& value_of) {
  const bool is_whole = number["type"] == "integer";
  const auto beyond = [&](double limit, double way) {
    return is_whole ? limit + way : std::nextafter(limit, way * 1e300);
  };
  for (const auto& [limit, way] : {std::pair("minimum", -1.0), {"maximum", 1.0}}) {
    if (!number.contains(limit)) continue;
    const double at = number[limit].get<double>();
    const std::string outside = fault_with(location, key, value_of(beyond(at, way)));
    if (has(outside, "where there is") || has(outside, "not both") || has(outside, "only a"))
      return std::nullopt;
    const std::string inside = fault_with(location, key, value_of(at));
    if (!has(outside, "needs to be") || has(inside, "needs to be at") || has(inside, "needs to be 0 m"))
      return false;
  }
  return true;
}

TEST(SceneSchema, HasTheReadersRangesToTheLastBit) {
  std::set<std::string> tried;
  std::set<std::string> there;
  for (const Location& location : locations()) {
    for (const auto& [key, of_key] : definition(location.name)["properties"].items()) {
      const json value = resolved(of_key);
      const bool is_vector =
          value.contains("items") && value.contains("maxItems") && value["minItems"] == value["maxItems"];
      const json number = is_vector ? resolved(value["items"]) : value;
      if (!number.contains("minimum")) continue;
      const auto value_of = [&](double x) {
        if (!is_vector) return json(x);
        json vector(value["minItems"].get<std::size_t>(), 0.5);
        vector[0] = x;
        return vector;
      };
      std::string name = location.name;
      name.append("/").append(key);
      there.insert(name);
      const std::optional<bool> is_same = has_range(location, key, number, value_of);
      if (is_same) {
        tried.insert(name);
        EXPECT_TRUE(*is_same) << name << " " << number;
      }
    }
  }
  EXPECT_EQ(tried, there);
  EXPECT_GT(tried.size(), 70u);
}

TEST(SceneSchema, HasTheReadersNames) {
  std::size_t tried = 0;
  for (const Location& location : locations()) {
    for (const auto& [key, value] : definition(location.name)["properties"].items()) {
      if (!value.contains("enum")) continue;
      std::string list;
      const json& names = value["enum"];
      for (std::size_t i = 0; i < names.size(); ++i)
        list += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + names[i].dump();
      EXPECT_TRUE(
          has(fault_with(location, key, "none of them"), ": needs " + list + ", got \"none of them\""))
          << location.name << " " << key << ": " << fault_with(location, key, "none of them");
      EXPECT_EQ(fault_with(location, key, value["default"]), fault_of(location.scene.dump()))
          << location.name << " " << key;
      ++tried;
    }
  }
  EXPECT_GT(tried, 20u);
  json kinds = json::array();
  for (const json& texture : schema()["$defs"]["texture"]["oneOf"]) {
    const json of = resolved(texture);
    if (of["properties"].contains("procedural")) kinds.push_back(of["properties"]["procedural"]["const"]);
  }
  EXPECT_EQ(kinds, json(texmap::kProceduralNames));
}

TEST(SceneSchema, TellsTheDefaultsThatTheReaderHas) {
  const json& definitions = schema()["$defs"];
  const Document document = parse(scene_text(
      R"("lights": [{"point": [0, 0, 0]}], "materials": {"m": {}}, "textures": {"w": {"procedural": "wood"}, "b": {"procedural": "brick"},
         "c": {"procedural": "clouds"}, "t": {"procedural": "tiles"}, "m": {"procedural": "marble"}})"));
  const json& camera = definitions["camera"]["properties"];
  EXPECT_EQ(camera["fov_deg"]["default"], document.camera.fov_deg);
  EXPECT_EQ(camera["width"]["default"], document.width);
  EXPECT_EQ(camera["height"]["default"], document.height);
  EXPECT_EQ(schema()["properties"]["depth"]["default"], document.depth);
  const json& material = definitions["material"]["properties"];
  EXPECT_EQ(material["shininess"]["default"], document.materials[0].shininess);
  EXPECT_EQ(material["ior"]["default"], document.materials[0].ior);
  EXPECT_EQ(material["diffuse"]["default"][1].get<float>(), document.materials[0].diffuse.g);
  const auto of = [&](std::size_t i) { return std::get<texmap::Procedural>(document.textures[i].source); };
  const auto default_of = [&](const std::string& kind, const std::string& key) {
    return definitions[kind + "Texture"]["properties"][key]["default"];
  };
  for (std::size_t i = 0; i < document.textures.size(); ++i) {
    const std::string kind(texmap::kProceduralNames[static_cast<std::size_t>(of(i).kind)]);
    EXPECT_EQ(default_of(kind, "scale"), of(i).scale);
    EXPECT_EQ(default_of(kind, "on"), of(i).on == texmap::ProceduralOn::kUv ? "uv" : "position");
  }
  EXPECT_EQ(default_of("wood", "rings"), of(0).rings);
  EXPECT_EQ(default_of("wood", "grain"), of(0).grain);
  EXPECT_EQ(default_of("brick", "mortar"), of(1).mortar);
  EXPECT_EQ(default_of("brick", "ratio"), of(1).ratio);
  EXPECT_EQ(default_of("brick", "bond"), of(1).bond);
  EXPECT_EQ(default_of("clouds", "coverage"), of(2).coverage);
  EXPECT_EQ(default_of("tiles", "grout"), of(3).grout);
  EXPECT_EQ(definitions["sweep"]["properties"]["miter_limit"]["default"], sweep::SweepOptions{}.miter_limit);
  EXPECT_EQ(definitions["tessellation"]["properties"]["contour"]["maximum"], sweep::kMaxCells);
  EXPECT_EQ(definitions["tessellation"]["properties"]["contour"]["default"], sweep::Tessellation{}.contour);
}

TEST(SceneSchema, ASceneMayNameItAndIsTheSameWithIt) {
  EXPECT_EQ(fault_of(scene_text(R"("$schema": "scene.schema.json")")), "");
  EXPECT_NE(fault_of(scene_text(R"("$schema": 1)")).find("/$schema: needs a string, got a number"),
            std::string::npos);
  EXPECT_NE(fault_of(scene_text(R"("materials": {"m": {"$schema": "x"}})")).find("unknown key"),
            std::string::npos);
  const SceneFile plain(scene_text(R"("depth": 3)"), "s.json");
  const SceneFile named(scene_text(R"("$schema": "scene.schema.json", "depth": 3)"), "s.json");
  EXPECT_EQ(plain.content_hash(""), named.content_hash(""));
}

}  // namespace
}  // namespace sweepkit::scene
