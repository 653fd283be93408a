// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "uv_report.hpp"

#include <cstdio>
#include <cstdlib>
#include <vector>

#include "sweepkit/error.hpp"
#include "sweepkit/scene/output_file.hpp"
#include "sweepkit/texmap/distortion.hpp"
#include "sweepkit/texmap/heat_map.hpp"
#include "sweepkit/texmap/image_file.hpp"
#include "sweepkit/texmap/triangle_maps.hpp"

namespace sweepkit::tools {
namespace {

// An object's positions as they lie in the world, but about the mesh's own origin: distances are the same,
// and float32 keeps them.
std::vector<glm::vec3> world_positions(const scene::Object& object, const scene::MeshView& mesh) {
  const glm::dmat3 linear(object.world_from_object);
  std::vector<glm::vec3> positions;
  positions.reserve(mesh.positions.size());
  for (const glm::vec3& p : mesh.positions) positions.push_back(glm::vec3(linear * glm::dvec3(p)));
  return positions;
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

// Four digits tell all that one asks of a ratio.
double rounded(double ratio) {
  return std::strtod(number(ratio).c_str(), nullptr);
}

}  // namespace

Table uv_table(const scene::Scene& scene) {
  Table table{"uv", {}};
  for (const scene::Object& object : scene.objects) {
    if (object.instance > 0) continue;
    const scene::MeshView& mesh = scene.meshes[object.mesh];
    const std::vector<glm::vec3> positions = world_positions(object, mesh);
    const texmap::MappedSurface surface{positions, mesh.texcoords, mesh.triangles};
    const texmap::Distortion d = texmap::summarize(texmap::find_distortion(surface));
    const texmap::EdgeContinuity edges = texmap::count_continuous_edges(surface);
    const double continuous = edges.interior_edges == 0 ? 1
                                                        : static_cast<double>(edges.continuous_edges) /
                                                              static_cast<double>(edges.interior_edges);
    table.rows.push_back({{"object", object.name},
                          {"homogeneity u", rounded(d.u_homogeneity)},
                          {"homogeneity u 95%", rounded(d.u_homogeneity_95)},
                          {"homogeneity v", rounded(d.v_homogeneity)},
                          {"homogeneity v 95%", rounded(d.v_homogeneity_95)},
                          {"aspect mean", rounded(d.aspect_ratio.mean)},
                          {"aspect median", rounded(d.aspect_ratio.median)},
                          {"aspect 95%", rounded(d.aspect_ratio.percentile_95)},
                          {"aspect worst", rounded(d.aspect_ratio.worst)},
                          {"density 95%", rounded(d.density_95)},
                          {"continuous", rounded(continuous)},
                          {"overlap", rounded(texmap::find_overlap(surface))},
                          {"degenerate", std::uint64_t{d.degenerate_triangles}},
                          {"mirrored", std::uint64_t{d.mirrored_triangles}}});
  }
  return table;
}

Table centroid_table(const scene::Scene& scene) {
  Table table{"centroid error", {}};
  for (const scene::Object& object : scene.objects) {
    if (object.instance > 0) continue;
    const scene::MeshView& mesh = scene.meshes[object.mesh];
    const std::vector<glm::vec3> positions = world_positions(object, mesh);
    for (const texmap::CentroidErrors& errors :
         texmap::summarize_centroid_errors({positions, mesh.texcoords, mesh.triangles})) {
      if (errors.method.empty()) continue;
      table.rows.push_back({{"object", object.name},
                            {"map", std::string(errors.method)},
                            {"mean", errors.has_value ? Value(rounded(errors.mean)) : Value()},
                            {"worst", errors.has_value ? Value(rounded(errors.worst)) : Value()},
                            {"failures", std::uint64_t{errors.failures}}});
    }
  }
  return table;
}

void write_heat_map(const scene::Scene& scene, const HeatMapRequest& request, const Output& output) {
  const texmap::ImageFormat format = texmap::image_format(request.file);
  const scene::Object& object = scene.objects.front();
  const scene::MeshView& mesh = scene.meshes[object.mesh];
  const std::vector<glm::vec3> positions = world_positions(object, mesh);
  const texmap::MappedSurface surface{positions, mesh.texcoords, mesh.triangles};
  const std::vector<texmap::TriangleDistortion> distortion = texmap::find_distortion(surface);
  std::vector<double> ratios;
  if (request.measure == HeatMeasure::kHomogeneity) {
    ratios = texmap::find_inhomogeneity(distortion);
  } else {
    for (const texmap::TriangleDistortion& t : distortion) ratios.push_back(t.aspect_ratio());
  }
  const texmap::HeatMap map =
      texmap::draw_heat_map(surface, ratios, {request.size.width, request.size.height});
  const std::vector<std::byte> bytes = texmap::encode_image(map.image, format);
  scene::write_files(std::vector<scene::OutputFile>{{request.file, bytes}});
  say(request.file + ": " +
          (request.measure == HeatMeasure::kHomogeneity ? "resolution against its mean" : "aspect ratio") +
          " of \"" + object.name + "\", dark 1 to bright " + number(map.brightest) +
          " and more, logarithmic; u " + number(map.low.x) + " to " + number(map.high.x) + ", v " +
          number(map.low.y) + " to " + number(map.high.y),
      output);
}

}  // namespace sweepkit::tools
