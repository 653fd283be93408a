// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// float32 and double beside ours: the textbook's test, "Fast, minimum storage ray/triangle intersection"
// [Moeller97], over the same triangles.

#include <array>
#include <memory>
#include <random>

#include "mesh_accelerator.hpp"
#include "quad.hpp"
#include "stability/stability_case.hpp"
#include "sweepkit/sweep/primitives.hpp"
#include "sweepkit/sweep/sweep.hpp"
#include "triangle_intersection.hpp"

namespace sweepkit::report {
namespace {

constexpr const char* kStage = "rays";
constexpr const char* kWatertight = "ray and triangle: watertight";
constexpr const char* kSameBytes = "ray and triangle: the same bytes at scales of 2^-10 and 2^10";

struct Shape {
  std::vector<glm::vec3> positions;
  std::vector<sweep::Triangle> triangles;
  std::vector<sweep::GridPatch> patches;

  scene::MeshView view() const {
    scene::MeshView view;
    view.positions = positions;
    view.triangles = triangles;
    view.patches = patches;
    return view;
  }
};

Shape ball(double scale, const glm::dvec3& middle) {
  const sweep::Mesh mesh =
      sweep::revolve(sweep::Curve2({sweep::ArcSegment<2>{{0, 0}, {1, 0}, {0, 1}, -90, 90}}),
                     {.tessellation = {16, 32}, .has_half_edges = false});
  Shape shape{{}, mesh.triangles, mesh.patches};
  for (const glm::vec3& p : mesh.positions()) shape.positions.emplace_back(scale * glm::dvec3(p) + middle);
  return shape;
}

template <class Real>
bool meets_by_textbook(const Shape& shape, const render::Ray& ray) {
  using Vec = glm::vec<3, Real>;
  const Vec origin(ray.origin);
  const Vec direction(ray.direction);
  for (const sweep::Triangle& t : shape.triangles) {
    const Vec a(shape.positions[t[0]]);
    const Vec e1 = Vec(shape.positions[t[1]]) - a;
    const Vec e2 = Vec(shape.positions[t[2]]) - a;
    const Vec p = glm::cross(direction, e2);
    const Real determinant = glm::dot(e1, p);
    if (determinant == 0) continue;
    const Vec s = origin - a;
    const Real u = glm::dot(s, p) / determinant;
    const Vec q = glm::cross(s, e1);
    const Real v = glm::dot(direction, q) / determinant;
    if (u >= 0 && v >= 0 && u + v <= 1 && glm::dot(e2, q) / determinant > 0) return true;
  }
  return false;
}

enum class Aim { kVertex, kEdge };

// Rays that leave a closed ball, or arrive at it, aimed at vertices and edges of its half that is looked at.
StabilityCase leaks(const std::string& name, const std::string& input, double hardness,
                    const std::string& hardness_is, Aim aim, double scale, const glm::dvec3& middle,
                    double distance) {
  return {.name = "rays_" + name,
          .stage = kStage,
          .input = input,
          .hardness = hardness,
          .hardness_is = hardness_is,
          .promise = kWatertight,
          .unit = "rays of 1000 that get through",
          .run = [=] {
            const Shape shape = ball(scale, middle);
            const scene::MeshView view = shape.view();
            const auto seads = render::make_accelerator(view, render::Accelerator::kSeads);
            const auto sweep = render::make_accelerator(view, render::Accelerator::kSweep);
            const auto linear = render::make_accelerator(view, render::Accelerator::kLinear);
            std::mt19937 random(3);
            std::uniform_real_distribution<double> real(-0.3, 0.3);
            Reached reached;
            double in_float = 0;
            double in_double = 0;
            for (int n = 0; n < 1000; ++n) {
              const sweep::Triangle& t = shape.triangles[random() % shape.triangles.size()];
              const glm::dvec3 a(shape.positions[t[0]]);
              const glm::dvec3 b(shape.positions[t[1]]);
              const glm::dvec3 target = aim == Aim::kVertex ? a : 0.5 * (a + b);
              // From near the middle through the target, moved straight back where it comes from afar.
              const double x = real(random);
              const double y = real(random);
              const glm::dvec3 inside = middle + scale * glm::dvec3(x, y, real(random));
              const glm::dvec3 direction = target - inside;
              const render::Ray ray{inside - distance * direction, direction};
              for (const auto* accelerator : {seads.get(), sweep.get(), linear.get()}) {
                render::Hit hit;
                accelerator->find_nearest(ray, 0, hit);
                if (!hit.is_hit()) reached.error += 1;
              }
              if (!meets_by_textbook<float>(shape, ray)) in_float += 1;
              if (!meets_by_textbook<double>(shape, ray)) in_double += 1;
            }
            reached.in_float = in_float;
            reached.in_double = in_double;
            return reached;
          }};
}

// Where the ray is at t and where the triangle says it was met, against each other in quadruple precision.
StabilityCase grazing(double slope, const std::string& power) {
  return {
      .name = "rays_grazing_" + power,
      .stage = kStage,
      .input = "rays at " + power + " rad to triangles of 1 m",
      .hardness = 1 / slope,
      .hardness_is = "1 over the angle (1/rad)",
      .promise = "a hit lies on the ray and on the triangle within a few roundings and 2^-26 of its size",
      .unit = "m",
      .run = [slope] {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> real(0.1, 1);
        // Triangles of up to sqrt(2) m; 16 roundings of coordinates up to 4.
        Reached reached{.bound = 2 * 0x1p-26 + 16 * 4 * kRounding};
        for (int n = 0; n < 2000; ++n) {
          const glm::vec3 a(0, 0, 0);
          const glm::vec3 b(static_cast<float>(real(random)), 0, 0.25F * static_cast<float>(real(random)));
          const glm::vec3 c(0, static_cast<float>(real(random)), 0.25F * static_cast<float>(real(random)));
          const glm::dvec3 normal = glm::normalize(glm::cross(glm::dvec3(b), glm::dvec3(c)));
          const glm::dvec3 inside = (glm::dvec3(b) + glm::dvec3(c)) / 3.0;
          const glm::dvec3 flat = glm::normalize(glm::dvec3(b) + real(random) * glm::dvec3(c));
          const glm::dvec3 direction = flat - slope * normal;
          const render::ShearedRay ray({inside - 2.0 * direction, direction});
          render::Hit hit;
          if (!ray.meets(a, b, c, render::kNoEnd, hit)) continue;
          Quad apart = 0;
          const glm::dvec3 origin = inside - 2.0 * direction;
          for (glm::length_t k = 0; k < 3; ++k) {
            const Quad on_ray = origin[k] + static_cast<Quad>(hit.t) * direction[k];
            const Quad on_triangle = static_cast<Quad>(hit.a) * a[k] + static_cast<Quad>(hit.b) * b[k] +
                                     static_cast<Quad>(hit.c) * c[k];
            apart += (on_ray - on_triangle) * (on_ray - on_triangle);
          }
          reached.error = worse(reached.error, static_cast<double>(sqrtq(apart)));
        }
        return reached;
      }};
}

StabilityCase same_bytes(int power) {
  return {
      .name = std::string("rays_same_bytes_2e") + (power < 0 ? "_" : "") + std::to_string(std::abs(power)),
      .stage = kStage,
      .input = "a ball and its rays 2^" + std::to_string(power) + " times as large",
      .hardness = std::ldexp(1, std::abs(power)),
      .hardness_is = "scale, or its inverse",
      .promise = kSameBytes,
      .unit = "rays of 1000 that hit otherwise",
      .run = [power] {
        const double scale = std::ldexp(1, power);
        const Shape one = ball(1, {0.1, 0.2, 0.3});
        Shape other = one;
        for (glm::vec3& p : other.positions) p *= static_cast<float>(scale);
        const scene::MeshView one_view = one.view();
        const scene::MeshView other_view = other.view();
        const auto here = render::make_accelerator(one_view, render::Accelerator::kSweep);
        const auto there = render::make_accelerator(other_view, render::Accelerator::kSweep);
        std::mt19937 random(9);
        std::uniform_real_distribution<double> real(-1, 1);
        Reached reached;
        for (int n = 0; n < 1000; ++n) {
          const double x = real(random);
          const double y = real(random);
          const glm::dvec3 origin(3 * x, 3 * y, 4);
          const glm::dvec3 direction = glm::dvec3(real(random), y, 0.3) - origin;
          render::Hit a;
          render::Hit b;
          here->find_nearest({origin, direction}, 0, a);
          there->find_nearest({scale * origin, scale * direction}, 0, b);
          if (a.triangle != b.triangle || a.t != b.t || a.a != b.a || a.b != b.b || a.c != b.c)
            reached.error += 1;
        }
        return reached;
      }};
}

}  // namespace

std::vector<StabilityCase> ray_cases() {
  const glm::dvec3 origin(0.0);
  const auto at_scale = [&](double scale, const std::string& power, Aim aim) {
    const bool is_vertex = aim == Aim::kVertex;
    return leaks(
        (is_vertex ? "vertices_" : "edges_") + power,
        std::string("from inside a ball of ") + power + " m at its " + (is_vertex ? "vertices" : "edges"),
        std::max(scale, 1 / scale), "size over 1 m, or the inverse", aim, scale, origin, 0);
  };
  return {at_scale(1, "1", Aim::kVertex),
          at_scale(1, "1", Aim::kEdge),
          at_scale(1e-9, "1e_9", Aim::kVertex),
          at_scale(1e-9, "1e_9", Aim::kEdge),
          at_scale(1e9, "1e9", Aim::kVertex),
          at_scale(1e9, "1e9", Aim::kEdge),
          leaks("afar_1e7", "at the vertices of a ball of 1 m from 1e7 m away", 1e7, "distance over size",
                Aim::kVertex, 1, origin, 1e7),
          leaks("far_origin_1e3", "from inside a ball 1e3 m from the origin at its edges", 1e3,
                "distance from the origin over size", Aim::kEdge, 1, {1e3, -1e3, 1e3}, 0),
          grazing(1e-3, "1e_3"),
          grazing(1e-6, "1e_6"),
          grazing(1e-9, "1e_9"),
          same_bytes(-10),
          same_bytes(10)};
}

}  // namespace sweepkit::report
