// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Every fault that a scene file can have is told in one line with its place: file, line, column, pointer.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scene_text.hpp"

namespace sweepkit::scene {
namespace {

struct Fault {
  std::string text;
  std::string message;
};

void expect_messages(const std::vector<Fault>& faults) {
  for (const auto& [text, message] : faults) EXPECT_EQ(fault_of(text), message) << text;
}

// A scene whose line 3 is `line`.
std::string with_line(const std::string& line) {
  return "{\n  \"sweepkit\": 1,\n  " + line + ",\n  \"objects\": [" + kFloor + "]\n}";
}

// A scene of one object "a" with line 3 inside it.
std::string with_object(const std::string& line) {
  return "{\n  \"sweepkit\": 1, \"objects\": [{\"name\": \"a\",\n  " + line + "}]\n}";
}

std::string with_contour(const std::string& curve) {
  return with_object("\"sweep\": {\"contour\":\n  " + curve +
                     ",\n  \"trajectory\": {\"line\": [[0, 0, 0], [0, 1, 0]]}}");
}

TEST(SceneFaults, BrokenJsonIsToldWhereItBreaks) {
  const std::string no = "not valid JSON: ";
  expect_messages({
      {"", "s.json:1:1: " + no +
               "while parsing value - unexpected end of input; expected '[', '{', or a literal"},
      {"{\n  \"sweepkit\"",
       "s.json:2:13: " + no + "while parsing object separator - unexpected end of input; expected ':'"},
      {"{\"a\": 1,}",
       "s.json:1:9: " + no + "while parsing object key - unexpected '}'; expected string literal"},
      {"{\"a\" 1}",
       "s.json:1:6: " + no + "while parsing object separator - unexpected number literal; expected ':'"},
      {"[1,,2]",
       "s.json:1:4: " + no + "while parsing value - unexpected ','; expected '[', '{', or a literal"},
      {"[1\n 2]", "s.json:2:2: " + no + "while parsing array - unexpected number literal; expected ']'"},
      {"{\"a\": 1} x", "s.json:1:10: " + no + "while parsing value - invalid literal; expected end of input"},
      {"{\"a\": NaN}", "s.json:1:7: " + no + "while parsing value - invalid literal"},
      {"{\"a\": nul}", "s.json:1:7: " + no + "while parsing value - invalid literal"},
      {"{\"a\": \"x", "s.json:1:7: " + no + "while parsing value - invalid string: missing closing quote"},
      {"{\"a\": \"\xff\"}",
       "s.json:1:7: " + no + "while parsing value - invalid string: ill-formed UTF-8 byte"},
      {"{\"a\": 1.}", "s.json:1:7: " + no + "while parsing value - invalid number; expected digit after '.'"},
  });
}

TEST(SceneFaults, NumbersAndKeysThatJsonAllowsButNobodyMeansAreRefused) {
  expect_messages({
      {"{\"a\": [1e999]}", "s.json:1:8: the number '1e999' is too large"},
      {"{\"a\": 1,\n \"a\": 2}", "s.json:2:2: \"a\" stands twice in this object; leave one out"},
  });
}

TEST(SceneFaults, NestingIsRefusedBeforeTheStackEnds) {
  EXPECT_EQ(fault_of(std::string(1000000, '[')),
            "s.json:1:65: values are nested deeper than 64 levels; the scene needs fewer");
}

TEST(SceneFaults, WhatEverySceneNeeds) {
  expect_messages({
      {"[1]", "s.json:1:1: needs an object, got an array"},
      {"{}", "s.json:1:1: needs \"sweepkit\""},
      {"{\"sweepkit\": 2}",
       "s.json:1:14: /sweepkit: this program reads version 1 of the scene format, got 2"},
      {"{\"sweepkit\": \"1\"}", "s.json:1:14: /sweepkit: needs a number, got a string"},
      {"{\"sweepkit\": 1}", "s.json:1:1: needs \"objects\""},
      {"{\"sweepkit\": 1, \"objects\": []}", "s.json:1:28: /objects: needs at least one object"},
      {"{\"sweepkit\": 1, \"objects\": {}}", "s.json:1:28: /objects: needs an array, got an object"},
      {"{\"sweepkit\": 1, \"objects\": [7]}", "s.json:1:29: /objects/0: needs an object, got a number"},
      {"{\"sweepkit\": 1, \"objects\": [{}]}", "s.json:1:29: /objects/0: needs \"name\""},
  });
}

TEST(SceneFaults, UnknownKeysAreRefusedByNameAtTheKeyItself) {
  expect_messages({
      {with_line("\"camra\": {}"), "s.json:3:3: /camra: unknown key \"camra\"; did you mean \"camera\"?"},
      {with_line("\"camera\": {\"radius\": 4}"),
       "s.json:3:14: /camera/radius: unknown key \"radius\"; there is \"eye\", \"target\", \"up\", "
       "\"fov_deg\", \"width\", \"height\""},
      {with_object("\"sweep\": {\"contuor\": {}}"),
       "s.json:3:13: /objects/0/sweep/contuor: unknown key \"contuor\"; did you mean \"contour\"?"},
      {with_line("\"materials\": {\"a/b~\": {\"difuse\": 1}}"),
       "s.json:3:26: /materials/a~1b~0/difuse: unknown key \"difuse\"; did you mean \"diffuse\"?"},
      {with_line("\"materials\": {\"m\": {\"line\\nbreak\": 1}}"),
       "s.json:3:23: /materials/m/line\\u000abreak: unknown key \"line\\u000abreak\"; there is \"diffuse\", "
       "\"texture\", "
       "\"specular\", \"shininess\", \"reflect\", \"transmit\", \"ior\", \"absorption\", \"fresnel\", "
       "\"normal_map\", \"normal_strength\""},
  });
}

TEST(SceneFaults, KeysThatComeLaterAreNotTakenSilently) {
  for (const char* line : {"\"lights\": [{\"point\": [0, 0, 0], \"size\": 1}]",
                           "\"materials\": {\"m\": {\"height_map\": \"x\"}}"}) {
    EXPECT_NE(fault_of(with_line(line)).find("unknown key"), std::string::npos) << line;
  }
  const std::string straight =
      "\"contour\": {\"circle\": {\"radius\": 1}}, \"trajectory\": {\"line\": [[0,0,0],[0,1,0]]}";
  for (const std::string& line : {std::string("\"mesh\": {\"file\": \"x.obj\", \"lod\": 1}"),
                                  "\"sweep\": {" + straight + ", \"texture\": 1}"}) {
    EXPECT_NE(fault_of(with_object(line)).find("unknown key"), std::string::npos) << line;
  }
}

TEST(SceneFaults, NormalMaps) {
  const auto with = [](const std::string& material) {
    return with_line(
        R"("textures": {"i": {"image": "i.png"}, "p": {"procedural": "noise"}}, "materials": {"m": )" +
        material + "}");
  };
  const std::string at = "s.json:3:";
  expect_messages({
      {with(R"({"normal_map": "j"})"),
       at + "106: /materials/m/normal_map: there is no texture \"j\"; there is \"i\", \"p\""},
      {with(R"({"normal_map": "p"})"), at + "106: /materials/m/normal_map: needs an image: \"p\" is "
                                            "procedural; sweepkit bake --normals makes an "
                                            "image of it"},
      {with(R"({"normal_strength": 1})"),
       at + "111: /materials/m/normal_strength: needs \"normal_map\" beside it"},
      {with(R"({"normal_map": "i", "normal_strength": -1})"),
       at + "130: /materials/m/normal_strength: needs to be at least 0 and at most 1000, got -1"},
      {with(R"({"normal_map": "i"}, "n": {"texture": "i"})"),
       at + "91: /materials/m: its normal map \"i\" is the colours of \"n\" too; name the image twice under "
            "\"textures\""},
  });
}

TEST(SceneFaults, Camera) {
  const std::string at = "s.json:3:";
  expect_messages({
      {with_line("\"camera\": {\"eye\": [0, 0, 1]}"),
       at + "13: /camera: needs \"target\" where there is \"eye\""},
      {with_line("\"camera\": {\"target\": [0, 0, 1]}"),
       at + "13: /camera: needs \"eye\" where there is \"target\""},
      {with_line("\"camera\": {\"eye\": [0, 0, 1], \"target\": [0, 0, 1]}"),
       at + "42: /camera/target: needs to differ from \"eye\""},
      {with_line("\"camera\": {\"up\": [0, 0, 0]}"),
       at + "20: /camera/up: needs a direction that is not zero"},
      {with_line("\"camera\": {\"fov_deg\": 180}"),
       at + "25: /camera/fov_deg: needs to be at least 0.001 and at most 179 degrees, got 180"},
      {with_line("\"camera\": {\"width\": 0}"),
       at + "23: /camera/width: needs to be at least 1 and at most 65536 pixels, got 0"},
      {with_line("\"camera\": {\"width\": 1e9}"),
       at + "23: /camera/width: needs to be at least 1 and at most 65536 pixels, got 1e+09"},
      {with_line("\"camera\": {\"height\": 2.5}"), at + "24: /camera/height: needs a whole number, got 2.5"},
      {with_line("\"camera\": {\"height\": null}"), at + "24: /camera/height: needs a number, got null"},
      {with_line("\"camera\": {\"eye\": [0, 0]}"),
       at + "13: /camera: needs \"target\" where there is \"eye\""},
      {with_line("\"camera\": {\"eye\": [0, 0], \"target\": [0, 0, 0]}"),
       at + "21: /camera/eye: needs 3 numbers, got 2"},
      {with_line("\"camera\": {\"eye\": [0, 0, \"x\"], \"target\": [0, 0, 0]}"),
       at + "28: /camera/eye/2: needs a number, got a string"},
      {with_line("\"camera\": {\"eye\": 4, \"target\": [0, 0, 0]}"),
       at + "21: /camera/eye: needs 3 numbers in an array, got a number"},
      {with_line("\"camera\": {\"eye\": [0, 0, 1e10], \"target\": [0, 0, 0]}"),
       at + "28: /camera/eye/2: needs to be at least -1e+09 and at most 1e+09 m, got 1e+10"},
  });
}

TEST(SceneFaults, LightAndSurroundings) {
  const std::string at = "s.json:3:";
  expect_messages({
      {with_line("\"background\": \"x.exr\""),
       at + "17: /background: needs 3 numbers in an array, got a string"},
      {with_line("\"background\": {}"), at + "17: /background: needs \"image\""},
      {with_line("\"background\": {\"image\": 1}"),
       at + "27: /background/image: needs a string, got a number"},
      {with_line("\"background\": {\"image\": \"x\", \"wrap\": \"clamp\"}"),
       at + "32: /background/wrap: unknown key \"wrap\"; there is \"image\""},
      {with_line("\"ambient\": [-1, 0, 0]"),
       at + "15: /ambient/0: needs to be at least 0 and at most 65504, got -1"},
      {with_line("\"depth\": 65"), at + "12: /depth: needs to be at least 0 and at most 64 levels, got 65"},
      {with_line("\"depth\": true"), at + "12: /depth: needs a number, got true or false"},
      {with_line("\"lights\": [{}]"), at + "14: /lights/0: needs \"point\" or \"directional\""},
      {with_line("\"lights\": [{\"point\": [0, 0, 0], \"directional\": [0, 0, 1]}]"),
       at + "50: /lights/0/directional: a light is \"point\" or \"directional\", not both"},
      {with_line("\"lights\": [{\"directional\": [0, 0, 1], \"radius\": 1}]"),
       at + "51: /lights/0/radius: only a \"point\" light has a radius"},
      {with_line("\"lights\": [{\"point\": [0, 0, 0], \"radius\": -1}]"),
       at + "45: /lights/0/radius: needs to be at least 0 and at most 1e+09 m, got -1"},
      {with_line("\"lights\": [{\"directional\": [0, 0, 0]}]"),
       at + "30: /lights/0/directional: needs a direction that is not zero"},
  });
}

TEST(SceneFaults, Textures) {
  const std::string at = "s.json:3:";
  const auto texture = [](const std::string& of) { return with_line("\"textures\": {\"t\":\n " + of + "}"); };
  expect_messages({
      {with_line("\"textures\": []"), at + "15: /textures: needs an object, got an array"},
      {texture("{}"), "s.json:4:2: /textures/t: needs \"image\" or \"procedural\""},
      {texture("{\"image\": \"x\", \"procedural\": \"tiles\"}"),
       "s.json:4:31: /textures/t/procedural: a texture is an \"image\" or a \"procedural\", not both"},
      {texture("{\"image\": 3}"), "s.json:4:12: /textures/t/image: needs a string, got a number"},
      {texture("{\"image\": \"x\", \"wrap\": \"once\"}"),
       "s.json:4:25: /textures/t/wrap: needs \"repeat\", \"clamp\" or \"mirror\", got \"once\""},
      {texture("{\"image\": \"x\", \"color_space\": \"rgb\"}"),
       "s.json:4:32: /textures/t/color_space: needs \"srgb\" or \"linear\", got \"rgb\""},
      {texture("{\"procedural\": \"stone\"}"),
       "s.json:4:17: /textures/t/procedural: needs \"checker\", \"tiles\", \"bands\", \"brick\", \"marble\", "
       "\"wood\", \"granite\", \"clouds\" or \"noise\", got \"stone\""},
      {texture("{\"procedural\": \"tiles\", \"grout\": 2}"),
       "s.json:4:35: /textures/t/grout: needs to be at least 0 and at most 1, got 2"},
      {texture("{\"procedural\": \"tiles\", \"on\": \"xyz\"}"),
       "s.json:4:32: /textures/t/on: needs \"uv\" or \"position\", got \"xyz\""},
      {texture("{\"procedural\": \"tiles\", \"scale\": 0}"),
       "s.json:4:35: /textures/t/scale: needs to be at least 1e-09 and at most 1e+09, got 0"},
      {texture("{\"procedural\": \"checker\", \"colors\": [[0, 0, 0]]}"),
       "s.json:4:38: /textures/t/colors: needs at least 2 colours, got 1"},
      {texture("{\"procedural\": \"checker\", \"colors\": [[0, 0, 0], [1, 1, 1], [0, 0, 0]]}"),
       "s.json:4:38: /textures/t/colors: a checker has 2 colours, got 3"},
      {texture("{\"procedural\": \"checker\", \"colors\": [[0, 0, 0], [0, 0, 2]]}"),
       "s.json:4:57: /textures/t/colors/1/2: needs to be at least 0 and at most 1, got 2"},
      {texture("{\"procedural\": \"bands\", \"widths\": [1]}"),
       "s.json:4:36: /textures/t/widths: needs \"colors\" beside it, one for each width"},
      {texture("{\"procedural\": \"bands\", \"colors\": [[0, 0, 0], [1, 1, 1]], \"widths\": [1]}"),
       "s.json:4:70: /textures/t/widths: needs one width for each of the 2 colours, got 1"},
      {texture("{\"procedural\": \"marble\", \"octaves\": 99}"),
       "s.json:4:38: /textures/t/octaves: needs to be at least 1 and at most 16, got 99"},
      {texture("{\"procedural\": \"marble\", \"turbulence\": -1}"),
       "s.json:4:41: /textures/t/turbulence: needs to be at least 0 and at most 1000, got -1"},
  });
}

TEST(SceneFaults, KeysOfProceduralTextures) {
  // A texture of a kind with one number out of its range; what is told of it.
  struct Number {
    std::string kind, key, value, range;
  };
  const std::vector<Number> numbers = {
      {"brick", "mortar", "1.5", "at least 0 and at most 1"},
      {"brick", "mortar", "-0.1", "at least 0 and at most 1"},
      {"brick", "ratio", "0.01", "at least 0.1 and at most 100"},
      {"brick", "ratio", "101", "at least 0.1 and at most 100"},
      {"brick", "bond", "2", "at least 0 and at most 1"},
      {"wood", "rings", "0", "at least 0.01 and at most 1e+06"},
      {"wood", "rings", "1e7", "at least 0.01 and at most 1e+06"},
      {"wood", "grain", "-1", "at least 0 and at most 1"},
      {"wood", "turbulence", "1001", "at least 0 and at most 1000"},
      {"clouds", "coverage", "1.1", "at least 0 and at most 1"},
      {"granite", "octaves", "0", "at least 1 and at most 16"},
      {"noise", "octaves", "17", "at least 1 and at most 16"},
  };
  for (const auto& [kind, key, value, range] : numbers) {
    const std::string message = fault_of(
        with_line(R"("textures": {"t": {"procedural": ")" + kind + R"(", ")" + key + "\": " + value + "}}"));
    EXPECT_NE(message.find("/textures/t/" + key + ": needs to be " + range + ", got "), std::string::npos)
        << message;
  }
  // Keys of other kinds are not known.
  for (const char* rest :
       {R"("checker", "mortar": 0.1)", R"("tiles", "mortar": 0.1)", R"("brick", "grout": 0.1)",
        R"("brick", "octaves": 2)", R"("marble", "rings": 2)", R"("granite", "turbulence": 1)",
        R"("wood", "coverage": 0.5)", R"("noise", "grain": 0.5)", R"("tiles", "basis": "perlin-1985")"}) {
    const std::string message =
        fault_of(with_line(std::string(R"("textures": {"t": {"procedural": )") + rest + "}}"));
    EXPECT_NE(message.find("unknown key"), std::string::npos) << rest << ": " << message;
  }
  EXPECT_NE(fault_of(with_line(R"("textures": {"t": {"procedural": "noise", "basis": "simplex"}})"))
                .find(R"(/textures/t/basis: needs "perlin-2002" or "perlin-1985", got "simplex")"),
            std::string::npos);
  std::string many = "[0, 0, 0]";
  for (int i = 0; i < 256; ++i) many += ", [1, 1, 1]";
  EXPECT_NE(fault_of(with_line(R"("textures": {"t": {"procedural": "noise", "colors": [)" + many + "]}}"))
                .find("/textures/t/colors: needs at most 256 colours, got 257"),
            std::string::npos);
}

TEST(SceneFaults, Materials) {
  const std::string at = "s.json:3:";
  expect_messages({
      {with_line("\"materials\": {\"m\": {\"diffuse\": [1, 1, 2]}}"),
       at + "41: /materials/m/diffuse/2: needs to be at least 0 and at most 1, got 2"},
      {with_line("\"materials\": {\"m\": {\"specular\": \"red\"}}"),
       at + "35: /materials/m/specular: needs 3 numbers in an array, got a string"},
      {with_line("\"materials\": {\"m\": {\"shininess\": -1}}"),
       at + "36: /materials/m/shininess: needs to be at least 0 and at most 1e+06, got -1"},
      {with_line("\"materials\": {\"m\": {\"reflect\": 1.5}}"),
       at + "34: /materials/m/reflect: needs to be at least 0 and at most 1, got 1.5"},
      {with_line("\"materials\": {\"m\": {\"transmit\": -0.5}}"),
       at + "35: /materials/m/transmit: needs to be at least 0 and at most 1, got -0.5"},
      {with_line("\"materials\": {\"m\": {\"ior\": 0}}"),
       at + "30: /materials/m/ior: needs to be at least 0.1 and at most 10, got 0"},
      {with_line("\"materials\": {\"m\": {\"absorption\": [0, 0, -1]}}"),
       at + "44: /materials/m/absorption/2: needs to be at least 0 and at most 1e+09, got -1"},
      {with_line("\"materials\": {\"m\": {\"fresnel\": \"shlick\"}}"),
       at + "34: /materials/m/fresnel: needs \"none\", \"schlick\" or \"exact\", got \"shlick\""},
      {with_line("\"materials\": {\"m\": {\"texture\": \"t\"}}"),
       at + "34: /materials/m/texture: there is no texture \"t\": the scene has none"},
  });
}

TEST(SceneFaults, NamesThatAreNotThereComeWithThoseThatAre) {
  const std::string textures =
      "\"textures\": {\"tiles\": {\"procedural\": \"tiles\"}, \"oak\": {\"procedural\": \"bands\"}}, ";
  expect_messages({
      {with_line(textures + "\"materials\": {\"m\": {\"texture\": \"tile\"}}"),
       "s.json:3:114: /materials/m/texture: there is no texture \"tile\"; did you mean \"tiles\"?"},
      {with_line(textures + "\"materials\": {\"m\": {\"texture\": \"granite\"}}"),
       "s.json:3:114: /materials/m/texture: there is no texture \"granite\"; there is \"tiles\", \"oak\""},
      {with_object("\"plane\": {\"size\": [1, 1]}, \"material\": \"x\""),
       "s.json:3:42: /objects/0/material: there is no material \"x\": the scene has none"},
  });
}

TEST(SceneFaults, Objects) {
  const std::string at = "s.json:3:";
  const std::string plane = "\"plane\": {\"size\": [1, 1]}";
  expect_messages({
      {with_object("\"scale\": 1"),
       "s.json:2:30: /objects/0: needs one of \"sweep\", \"revolve\", \"plane\", \"mesh\" or \"parts\""},
      {with_object(plane + ", \"parts\": []"),
       at + "39: /objects/0/parts: an object has one shape or \"parts\", not both"},
      {with_object("\"parts\": []"), at + "12: /objects/0/parts: needs at least one part"},
      {with_object("\"parts\": [{}]"),
       at + "13: /objects/0/parts/0: needs one of \"sweep\", \"revolve\", \"plane\" or \"mesh\""},
      {with_object("\"revolve\": {\"contour\": {\"line\": [[1, 0], [1, 1]]}}, " + plane),
       at + "64: /objects/0/plane: an object has one shape; put several under \"parts\""},
      {with_object("\"plane\": {\"size\": [1, 0]}"),
       at + "25: /objects/0/plane/size/1: needs to be at least 1e-09 and at most 1e+09 m, got 0"},
      {with_object(plane + ", \"scale\": 0"),
       at + "39: /objects/0/scale: needs factors other than 0, which would flatten the object"},
      {with_object(plane + ", \"scale\": [1, 0, 1]"),
       at + "39: /objects/0/scale: needs factors other than 0, which would flatten the object"},
      {with_object(plane + ", \"instances\": {}"),
       at + "43: /objects/0/instances: needs an array, got an object"},
      {with_object(plane + ", \"instances\": []"),
       at + "43: /objects/0/instances: needs at least one instance; leave it out for the object by itself"},
      {with_object(plane + ", \"instances\": [{}, {\"scale\": 0}]"),
       at + "58: /objects/0/instances/1/scale: needs factors other than 0, which would flatten the object"},
      {with_object(plane + ", \"instances\": [{\"name\": \"b\"}]"),
       at + "45: /objects/0/instances/0/name: unknown key \"name\"; there is \"translate\", \"rotate_deg\", "
            "\"scale\""},
      {with_object(plane + ", \"translate\": [0, 1e10, 0]"),
       at + "47: /objects/0/translate/1: needs to be at least -1e+09 and at most 1e+09 m, got 1e+10"},
      {with_object(plane + ", \"crease_deg\": 181"),
       at + "44: /objects/0/crease_deg: needs to be at least 0 and at most 180 degrees, got 181"},
      {with_object(plane + ", \"uv\": {\"by\": \"area\"}"),
       at + "43: /objects/0/uv/by: needs \"arc-length\" or \"parameter\", got \"area\""},
      {with_object(plane + ", \"uv\": {\"repeat\": [1, 1], \"size\": 2}"),
       at + "63: /objects/0/uv/size: decides in place of \"repeat\"; leave one out"},
      {with_object(plane + ", \"uv\": {\"repeat\": [0, 1]}"),
       at + "48: /objects/0/uv/repeat/0: needs to be at least 1e-06 and at most 1e+06, got 0"},
      {with_object(plane + ", \"tessellation\": {\"contour\": -3}"),
       at + "58: /objects/0/tessellation/contour: needs to be at least 1 and at most 32768 cells, got -3"},
      {with_object(plane + ", \"tessellation\": {\"trajectory\": 1e9}"),
       at + "61: /objects/0/tessellation/trajectory: needs to be at least 1 and at most 32768 cells, got "
            "1e+09"},
      {scene_text("", "{\"name\": \"\", " + plane + "}"),
       "s.json:1:38: /objects/0/name: needs a name that is not empty"},
      {scene_text("", kFloor + ", " + kFloor),
       "s.json:1:75: /objects/1: the name \"floor\" is taken by an object before; choose another"},
  });
}

TEST(SceneFaults, Curves) {
  const std::string contour = "/objects/0/sweep/contour";
  expect_messages({
      {with_contour("{\"bezier\": [[0, 0]]}"),
       "s.json:4:14: " + contour + "/bezier: needs at least 2 control points, got 1"},
      {with_contour("{\"bezier\": [[0, 0, 0], [1, 1, 1]]}"),
       "s.json:4:15: " + contour + "/bezier/0: needs 2 numbers, got 3"},
      {with_contour("{\"bezier\": [[0, 0], [1, 1e300]]}"),
       "s.json:4:27: " + contour +
           "/bezier/1/1: needs to be at least -1e+09 and at most 1e+09 m, got 1e+300"},
      {with_contour("{\"beziers\": [[[0, 0]]]}"),
       "s.json:4:16: " + contour + "/beziers/0: needs at least 2 control points, got 1"},
      {with_contour("{\"free\": [[0, 0], [1, 1]], \"closed\": 1}"),
       "s.json:4:40: " + contour + "/closed: needs true or false, got a number"},
      {with_contour("{\"free\": [[0, 0], [1, 1]], \"closed\": true}"),
       "s.json:4:12: " + contour + "/free: needs at least 3 points, got 2"},
      {with_contour("{\"line\": [[0, 0], [1, 1], [2, 2]]}"),
       "s.json:4:12: " + contour + "/line: a line needs 2 points, got 3"},
      {with_contour("{\"circle\": {\"radius\": 0}}"),
       "s.json:4:25: " + contour + "/circle/radius: needs to be at least 1e-09 and at most 1e+09 m, got 0"},
      {with_contour("{\"circle\": {}}"), "s.json:4:14: " + contour + "/circle: needs \"radius\""},
      {with_contour("{}"), "s.json:4:3: " + contour +
                               ": needs one of \"bezier\", \"beziers\", \"free\", \"polyline\", \"line\", "
                               "\"svg\", \"path\", \"csv\", \"circle\", \"ellipse\", "
                               "\"rectangle\", \"polygon\", \"star\", \"arc\""},
      {with_contour("{\"helix\": {\"radius\": 1}}"),
       "s.json:4:4: " + contour +
           "/helix: unknown key \"helix\"; there is \"bezier\", \"beziers\", \"free\", "
           "\"polyline\", \"line\", \"svg\", \"path\", \"csv\", \"circle\", \"ellipse\", \"rectangle\", "
           "\"polygon\", \"star\", \"arc\""},
      {with_contour("{\"rectangle\": {\"width\": 2, \"height\": 1, \"corner_radius\": 0.6}}"),
       "s.json:4:17: " + contour +
           "/rectangle: corner_radius needs to be 0 m to half of the shorter side, 0.5 m, got 0.6"},
      {with_contour("{\"polygon\": {\"sides\": 2, \"radius\": 1}}"),
       "s.json:4:25: " + contour + "/polygon/sides: needs to be at least 3 and at most 4096, got 2"},
      {with_contour("{\"arc\": {\"radius\": 1, \"from_deg\": 0, \"to_deg\": 400}}"),
       "s.json:4:11: " + contour +
           "/arc: arc needs angles that differ by at most 360 degrees, and not by 0, got 0 and 400"},
      {with_contour("{\"line\": [[0, 0], [1, 1]], \"circle\": {\"radius\": 1}}"),
       "s.json:4:40: " + contour +
           "/circle: a curve is of one kind, but there is \"line\" and \"circle\"; leave one out"},
      {with_object("\"sweep\": {\"contour\": {\"circle\": {\"radius\": 1}}}"),
       "s.json:3:12: /objects/0/sweep: needs \"trajectory\""},
      {with_object("\"revolve\": {\"contour\": {\"line\": [[1, 0], [1, 1]]}, \"angle_deg\": 0}"),
       "s.json:3:67: /objects/0/revolve/angle_deg: needs to be at least 1e-06 and at most 360 degrees, got "
       "0"},
      {with_object("\"revolve\": {\"contour\": {\"line\": [[1, 0], [1, 1]]}, \"caps\": \"round\"}"),
       "s.json:3:62: /objects/0/revolve/caps: needs \"flat\" or \"none\", got \"round\""},
  });
}

TEST(SceneFaults, LawsAndOrientation) {
  const auto with_sweep = [](const std::string& keys) {
    return with_object(
        "\"sweep\": {\"contour\": {\"circle\": {\"radius\": 1}}, "
        "\"trajectory\": {\"line\": [[0, 0, 0], [0, 1, 0]]},\n" +
        keys + "}");
  };
  const std::string at = "s.json:4:";
  const std::string shape = "/objects/0/sweep";
  expect_messages({
      {with_sweep("\"profile\": -1"),
       at + "12: " + shape + "/profile: needs to be at least 0 and at most 1e+09, got -1"},
      {with_sweep("\"profile\": {}"),
       at + "12: " + shape + "/profile: needs a number, \"points\" or \"bezier\", one of them"},
      {with_sweep("\"profile\": {\"points\": [[0, 1]], \"bezier\": [[0, 1], [1, 1]]}"),
       at + "12: " + shape + "/profile: needs a number, \"points\" or \"bezier\", one of them"},
      {with_sweep("\"profile\": {\"points\": [[0, 1], [0.5]]}"),
       at + "32: " + shape + "/profile/points/1: needs 2 numbers, t and the value there, got 1"},
      {with_sweep("\"profile\": {\"points\": [[0.5, 1], [0.5, 2]]}"),
       at + "23: " + shape +
           "/profile/points: point 1 needs t above the point's before it, got 0.5 after 0.5"},
      {with_sweep("\"profile\": {\"x\": {\"points\": [[2, 1]]}}"),
       at + "31: " + shape + "/profile/x/points/0/0: needs to be at least 0 and at most 1, got 2"},
      {with_sweep("\"profile\": {\"x\": 1, \"z\": 1}"),
       at + "21: " + shape + "/profile/z: unknown key \"z\"; there is \"x\", \"y\""},
      {with_sweep("\"twist_deg\": \"half\""),
       at + "14: " + shape + "/twist_deg: needs a number or an object with \"points\" or \"bezier\""},
      {with_sweep("\"frames\": \"bishop\""),
       at + "11: " + shape +
           "/frames: needs \"rotation-minimizing\", \"frenet\" or \"fixed-up\", got \"bishop\""},
      {with_sweep("\"up\": [0, 0, 0]"), at + "7: " + shape + "/up: needs a direction, got [0, 0, 0]"},
      {with_sweep("\"frames\": \"frenet\", \"guide\": {\"line\": [[0, 0, 1], [0, 1, 1]]}"),
       at + "30: " + shape + "/guide: says where the section points, and so does \"frames\"; leave one out"},
  });
}

TEST(SceneFaults, WhatACurveFindsItselfGetsThePlaceOfTheCurve) {
  const std::string message = fault_of(with_contour("{\"polyline\": [[1, 1], [1, 1]]}"));
  EXPECT_EQ(message.rfind("s.json:4:16: /objects/0/sweep/contour/polyline: ", 0), 0u) << message;
}

}  // namespace
}  // namespace sweepkit::scene
