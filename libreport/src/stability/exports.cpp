// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Files read again: by libscene's own reader of mesh files, and glTF by its JSON and its buffer.

#include <algorithm>
#include <bit>
#include <cstring>
#include <nlohmann/json.hpp>

#include "stability/scene_text.hpp"
#include "stability/stability_case.hpp"
#include "sweepkit/scene/gltf.hpp"
#include "sweepkit/scene/mesh_file.hpp"
#include "sweepkit/scene/mesh_output.hpp"

namespace sweepkit::report {
namespace {

constexpr const char* kStage = "export";
constexpr const char* kFloat = "float32 only in the mesh, relative to an origin per object";

std::string text_of(double distance, double size) {
  const auto number = [](double x) { return nlohmann::json(x).dump(); };
  const std::string at = number(distance);
  return R"({"sweepkit": 1, "objects": [{"name": "o", "tessellation": {"contour": 16, "trajectory": 16},
    "sweep": {"contour": {"circle": {"radius": )" +
         number(0.2 * size) + R"(}}, "trajectory": {"bezier": [[)" + at + ", 0, " + at + "], [" + at + ", " +
         number(size) + ", " + at + "], [" + number(distance + size) + ", " + number(size) + ", " + at +
         R"(]]}}}]})";
}

// Positions in the world, in double.
std::vector<glm::dvec3> positions_of(const scene::Model& model) {
  std::vector<glm::dvec3> all;
  const sweep::Mesh& mesh = *model.meshes.front();
  for (const glm::vec3& p : mesh.positions()) all.push_back(glm::dvec3(p) + mesh.origin);
  return all;
}

double nearest(const glm::dvec3& p, const std::vector<glm::dvec3>& all) {
  double least = INFINITY;
  for (const glm::dvec3& q : all) least = std::min(least, glm::distance(p, q));
  return least;
}

StabilityCase mesh_file(const std::string& ending, double distance, const std::string& power) {
  const bool is_single = ending == "stl";
  return {
      .name = "export_" + ending + "_far_" + power,
      .stage = kStage,
      .input = "a tube of 1 m, " + power + " m from the origin, as ." + ending + " and read again",
      .hardness = distance,
      .hardness_is = "distance over size",
      .promise = is_single ? ".stl always float32" : kFloat,
      .unit = "m",
      .run =
          [=] {
            const std::string file = "m." + ending;
            const MadeScene made(text_of(distance, 1), {.product = scene::Request::Product::kMeshFile,
                                                        .has_textures = scene::holds_textures(file),
                                                        .has_texcoords = scene::holds_texcoords(file)});
            const scene::MeshOutput output = scene::make_mesh_output(made.model.scene, made.plan, file);
            const std::vector<std::byte>& bytes = output.files.back().bytes;
            const scene::MeshFile read =
                scene::parse_mesh_file({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, file);
            const std::vector<glm::dvec3> exact = positions_of(made.model);
            // A double each, and where float32 is enough for the size a half step of it at 1 m.
            Reached reached{.bound = std::sqrt(3.0) * (0x1p-24 + kRounding * 2 * distance)};
            double in_float = 0;
            for (const glm::dvec3& p : read.positions)
              reached.error = worse(reached.error, nearest(p, exact));
            for (const glm::dvec3& p : exact)
              in_float = worse(in_float, glm::length(glm::dvec3(glm::vec3(p)) - p));
            reached.in_float = in_float;
            return reached;
          },
      .limit =
          is_single && distance > 100
              ? "STL has float32 coordinates and no origin: a far object is blurred to 6e-8 of its distance"
              : ""};
}

struct Accessor {
  std::vector<glm::vec3> values;
  std::vector<float> min, max;
  glm::dvec3 translation{0.0};
};

Accessor positions_in_gltf(const MadeScene& made) {
  const scene::GltfFile file = scene::make_gltf(made.model.scene, made.plan, "m.gltf", {});
  const auto& text = file.files.back().bytes;
  const auto& buffer = file.files.front().bytes;
  const nlohmann::json json = nlohmann::json::parse(reinterpret_cast<const char*>(text.data()),
                                                    reinterpret_cast<const char*>(text.data()) + text.size());
  const nlohmann::json& accessor =
      json["accessors"][json["meshes"][0]["primitives"][0]["attributes"]["POSITION"].get<std::size_t>()];
  const nlohmann::json& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
  const std::size_t start =
      view.value("byteOffset", std::size_t{0}) + accessor.value("byteOffset", std::size_t{0});
  const std::size_t step = view.value("byteStride", sizeof(glm::vec3));
  Accessor read{.min = accessor["min"].get<std::vector<float>>(),
                .max = accessor["max"].get<std::vector<float>>()};
  for (std::size_t i = 0; i < accessor["count"].get<std::size_t>(); ++i) {
    glm::vec3 p;
    std::memcpy(&p, buffer.data() + start + i * step, sizeof p);
    read.values.push_back(p);
  }
  const nlohmann::json& node = json["nodes"][0];
  if (node.contains("translation")) {
    const auto t = node["translation"].get<std::vector<double>>();
    read.translation = {t[0], t[1], t[2]};
  }
  return read;
}

StabilityCase gltf_bounds(double size, const std::string& power) {
  return {.name = "export_gltf_bounds_" + power,
          .stage = kStage,
          .input = "a tube of " + power + " m in glTF: min and max against its positions",
          .hardness = std::max(size, 1 / size),
          .hardness_is = "size over 1 m, or the inverse",
          .promise = "min and max of a glTF accessor are those of its float32 values",
          .unit = "numbers of six that are other bits",
          .run = [size] {
            const Accessor read = positions_in_gltf(
                MadeScene(text_of(0, size), {.product = scene::Request::Product::kMeshFile}));
            Reached reached;
            for (glm::length_t k = 0; k < 3; ++k) {
              float least = INFINITY;
              float most = -INFINITY;
              for (const glm::vec3& p : read.values) {
                least = std::min(least, p[k]);
                most = std::max(most, p[k]);
              }
              if (read.min[static_cast<std::size_t>(k)] != least) reached.error += 1;
              if (read.max[static_cast<std::size_t>(k)] != most) reached.error += 1;
            }
            return reached;
          }};
}

StabilityCase gltf_far(double distance, const std::string& power) {
  return {.name = "export_gltf_far_" + power,
          .stage = kStage,
          .input = "a tube of 1 m, " + power + " m from the origin, in glTF",
          .hardness = distance,
          .hardness_is = "distance over size",
          .promise = kFloat,
          .unit = "m",
          .run = [distance] {
            const MadeScene made(text_of(distance, 1), {.product = scene::Request::Product::kMeshFile});
            const Accessor read = positions_in_gltf(made);
            const std::vector<glm::dvec3> exact = positions_of(made.model);
            if (read.values.size() != exact.size()) return Reached{.error = NAN};
            // The mesh's own float32 positions, and their sum with the node's place in double.
            Reached reached{.bound = std::sqrt(3.0) * 4 * kRounding * distance};
            double in_float = 0;
            for (std::size_t i = 0; i < exact.size(); ++i) {
              reached.error =
                  worse(reached.error, glm::length(glm::dvec3(read.values[i]) + read.translation - exact[i]));
              in_float = worse(in_float, glm::length(glm::dvec3(glm::vec3(exact[i])) - exact[i]));
            }
            reached.in_float = in_float;
            return reached;
          }};
}

}  // namespace

std::vector<StabilityCase> export_cases() {
  return {mesh_file("ply", 1e3, "1e3"), mesh_file("ply", 1e7, "1e7"), mesh_file("obj", 1e7, "1e7"),
          mesh_file("stl", 1, "1"),     mesh_file("stl", 1e7, "1e7"), gltf_bounds(1e-8, "1e_8"),
          gltf_bounds(1, "1"),          gltf_bounds(1e8, "1e8"),      gltf_far(1e3, "1e3"),
          gltf_far(1e7, "1e7")};
}

}  // namespace sweepkit::report
