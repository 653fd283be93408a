// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "traced_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "eye_rays.hpp"
#include "sweepkit/scene/camera.hpp"

namespace sweepkit::report {
namespace {

glm::dvec3 knot(double s) {
  const double r = 2 + 0.8 * std::cos(3 * s);
  return {r * std::cos(2 * s), 0.8 * std::sin(3 * s), -r * std::sin(2 * s)};
}

TracedMesh trefoil_tube(std::uint32_t round, std::uint32_t along) {
  constexpr double kRadius = 0.35;
  TracedMesh mesh;
  const double step = 2 * std::numbers::pi / along;
  for (std::uint32_t j = 0; j <= along; ++j) {
    const double s = j == along ? 0 : j * step;
    const glm::dvec3 middle = knot(s);
    const glm::dvec3 tangent = glm::normalize(knot(s + 1e-4) - knot(s - 1e-4));
    // Away from the ring inside of the torus that the knot winds about: never along the tangent.
    const glm::dvec3 ring(2 * std::cos(2 * s), 0, -2 * std::sin(2 * s));
    const glm::dvec3 out = middle - ring;
    const glm::dvec3 x = glm::normalize(out - glm::dot(out, tangent) * tangent);
    const glm::dvec3 y = glm::cross(tangent, x);
    for (std::uint32_t i = 0; i <= round; ++i) {
      const double angle = i == round ? 0 : 2 * std::numbers::pi * i / round;
      mesh.positions.emplace_back(middle + kRadius * (std::cos(angle) * x + std::sin(angle) * y));
    }
  }
  sweep::GridPatch patch;
  patch.columns = round;
  patch.rows = along;
  for (std::uint32_t j = 0; j < along; ++j) {
    for (std::uint32_t i = 0; i < round; ++i) {
      const std::uint32_t q = patch.vertex(i + 1, j);
      const std::uint32_t r = patch.vertex(i, j + 1);
      mesh.triangles.push_back({r, q - 1, q});
      mesh.triangles.push_back({q, r + 1, r});
    }
  }
  mesh.patches.push_back(patch);
  return mesh;
}

}  // namespace

scene::MeshView TracedMesh::view() const {
  scene::MeshView view;
  view.positions = positions;
  view.triangles = triangles;
  view.patches = patches;
  return view;
}

TracedMesh trefoil_of(double triangles) {
  const double round = triangles < 7200 ? std::max(3.0, std::round(std::sqrt(triangles / 30))) : 60;
  return trefoil_tube(static_cast<std::uint32_t>(round),
                      static_cast<std::uint32_t>(std::round(triangles / (2 * round))));
}

std::vector<render::Ray> eye_rays_about(const glm::dvec3& low, const glm::dvec3& high, int side) {
  const double radius = 0.5 * glm::length(high - low);
  scene::Camera camera;
  camera.target = 0.5 * (low + high);
  camera.fov_deg = 34;
  camera.eye = camera.target +
               radius / std::sin(17 * std::numbers::pi / 180) * glm::normalize(glm::dvec3(0.5, 0.5, 0.8));
  const render::EyeRays eye(camera, side, side);
  std::vector<render::Ray> rays;
  for (int y = 0; y < side; y += 4) {
    for (int x = 0; x < side; x += 4) {
      for (int k = 0; k < 16; ++k) rays.push_back(eye.through(x + k % 4, y + k / 4));
    }
  }
  return rays;
}

std::vector<render::Ray> incoherent_rays_about(const glm::dvec3& low, const glm::dvec3& high, int side) {
  const double radius = 0.5 * glm::length(high - low);
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> real(0, 1);
  std::vector<render::Ray> rays;
  for (int n = 0; n < side * side; ++n) {
    const glm::dvec3 out(normal(random), normal(random), normal(random));
    const glm::dvec3 origin = 0.5 * (low + high) + 1.5 * radius * glm::normalize(out);
    const glm::dvec3 aim = low + (high - low) * glm::dvec3(real(random), real(random), real(random));
    rays.push_back({origin, glm::normalize(aim - origin)});
  }
  return rays;
}

}  // namespace sweepkit::report
