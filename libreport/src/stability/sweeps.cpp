// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/sweep/sweep.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <set>

#include "stability/stability_case.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/sweep/primitives.hpp"

namespace sweepkit::report {
namespace {

constexpr const char* kStage = "sweeps";
constexpr const char* kNormals =
    "normals from the surface's own derivatives; unit to 1e-6; finite at poles, cusps and zero-area places";
constexpr const char* kFloat = "positions in float32 relative to an origin per object";
constexpr const char* kRings = "rings and loops: first and last are the same bits";
constexpr double kPi = std::numbers::pi;
// Float32's half step at 1, and what a few operations before it may add.
constexpr double kFloatRounding = 0x1p-24;

using sweep::Mesh;

sweep::Curve3 upright() {
  return sweep::polyline<3>({{0, 0, 0}, {0, 0, 1}}, false);
}

// NaN where a number of the mesh is not finite, else how far its normals are from unit.
double off_unit(const Mesh& mesh) {
  double worst = 0;
  for (const glm::vec3& n : mesh.normals()) worst = worse(worst, std::abs(glm::length(glm::dvec3(n)) - 1));
  for (const glm::vec3& p : mesh.positions()) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return NAN;
  }
  for (const glm::vec2& uv : mesh.texcoords()) {
    if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) return NAN;
  }
  return worst;
}

StabilityCase normals_case(const std::string& name, const std::string& input, double hardness,
                           const std::string& hardness_is, std::function<Mesh()> make) {
  return {.name = "sweeps_" + name,
          .stage = kStage,
          .input = input,
          .hardness = hardness,
          .hardness_is = hardness_is,
          .promise = kNormals,
          .unit = "of a unit normal",
          .run = [make = std::move(make)] { return Reached{.error = off_unit(make()), .bound = 1e-6}; }};
}

StabilityCase profile_to(double end, const std::string& power) {
  return normals_case(
      "profile_to_" + power, "a tube whose profile falls to " + power, 1 / std::max(end, 1e-16),
      "first size over last", [end] {
        const sweep::Law law = sweep::Law::through({{0, 1}, {1, end}});
        return sweep::sweep(sweep::star_contour(5, 0.2, 0.1), upright(), {.profile = {law, law}});
      });
}

StabilityCase morph_to(double size, const std::string& power) {
  return normals_case("morph_to_" + power, "a circle that becomes a star " + power + " times as large",
                      1 / size, "first size over last", [size] {
                        return sweep::sweep(
                            sweep::circle_contour(0.2), upright(),
                            {.morph = {{1, {sweep::star_contour(5, 0.2 * size, 0.1 * size)}}}});
                      });
}

StabilityCase twist(double turns, const std::string& power) {
  return normals_case(
      "twist_" + power, "a bar twisted by " + power + " turns and 77 degrees", turns, "turns", [turns] {
        return sweep::sweep(sweep::rectangle_contour(0.2, 0.1), upright(), {.twist_deg = 360 * turns + 77});
      });
}

StabilityCase step_law(double width, const std::string& power) {
  return normals_case(
      "step_" + power, "a profile that falls to 1e-9 within " + power + " of the way", 1 / width,
      "way over the step's width", [width] {
        const sweep::Law step = sweep::Law::through({{0, 1}, {0.5, 1}, {0.5 + width, 1e-9}, {1, 1e-9}});
        return sweep::sweep(sweep::circle_contour(0.1), upright(), {.profile = {step, step}});
      });
}

std::array<Mesh, 3> shapes(double size) {
  return {
      sweep::sweep(sweep::circle_contour(0.3 * size), sweep::circle_trajectory(size)),
      sweep::sweep(sweep::star_contour(5, 0.2 * size, 0.1 * size),
                   sweep::bezier_curve<3>({{0, 0, 0}, {size, 0, 0}, {size, size, 0}, {size, size, size}})),
      sweep::revolve(sweep::bezier_curve<2>({{0, 0}, {size, 0}, {size, size}, {0, 2 * size}}))};
}

StabilityCase scale(double size, const std::string& power) {
  return {.name = "sweeps_scale_" + power,
          .stage = kStage,
          .input = "torus, bent star and vase of " + power + " m against those of 1 m",
          .hardness = std::max(size, 1 / size),
          .hardness_is = "size over 1 m, or the inverse",
          .promise = kFloat,
          .unit = "of the size",
          .run = [size] {
            // Both are rounded to float32 at coordinates up to 2: two half steps in three coordinates, and
            // double's own far below.
            Reached reached{.bound = 2 * 2 * std::sqrt(3.0) * kFloatRounding};
            const std::array<Mesh, 3> small = shapes(size);
            const std::array<Mesh, 3> metres = shapes(1);
            for (std::size_t k = 0; k < small.size(); ++k) {
              if (small[k].positions().size() != metres[k].positions().size()) return Reached{.error = NAN};
              for (std::size_t i = 0; i < small[k].positions().size(); ++i) {
                const glm::dvec3 a = glm::dvec3(small[k].positions()[i]) + small[k].origin;
                const glm::dvec3 b = glm::dvec3(metres[k].positions()[i]) + metres[k].origin;
                reached.error = worse(reached.error, glm::length(a / size - b));
              }
            }
            return reached;
          }};
}

StabilityCase far(double distance, const std::string& power) {
  return {.name = "sweeps_far_" + power,
          .stage = kStage,
          .input = "a tube of 5 m, " + power + " m from the origin, against the same one at it",
          .hardness = distance,
          .hardness_is = "distance over 1 m",
          .promise = kFloat,
          .unit = "m",
          .run = [distance] {
            const glm::dvec3 offset(distance, -distance, distance);
            const std::array<glm::dvec3, 4> near = {{{0, 0, 0}, {1, 0, 1}, {0, 2, 3}, {4, 0, 5}}};
            std::vector<glm::dvec3> moved;
            for (const glm::dvec3& p : near) moved.push_back(p + offset);
            const Mesh here =
                sweep::sweep(sweep::circle_contour(0.1), sweep::bezier_curve<3>({near.begin(), near.end()}));
            const Mesh there = sweep::sweep(sweep::circle_contour(0.1), sweep::bezier_curve<3>(moved));
            // Float32 at up to 8 from either origin, and 32 roundings of double where it is.
            Reached reached{.bound = std::sqrt(3.0) * (2 * 8 * kFloatRounding + 32 * kRounding * distance)};
            double in_float = 0;
            for (std::size_t i = 0; i < here.positions().size(); ++i) {
              const glm::dvec3 a = glm::dvec3(here.positions()[i]) + here.origin;
              const glm::dvec3 b = glm::dvec3(there.positions()[i]) + (there.origin - offset);
              reached.error = worse(reached.error, glm::length(a - b));
              in_float = worse(in_float, glm::length(glm::dvec3(glm::vec3(a + offset)) - offset - a));
            }
            reached.in_float = in_float;
            return reached;
          }};
}

// Every vertex of the last ring is one of the first, bit for bit, however the symmetry turned it.
StabilityCase closed_loop(double spoiled, const std::string& power) {
  return {.name = "sweeps_closed_" + power,
          .stage = kStage,
          .input = "a knot of a polygon with one corner " + power + " of its radius off: nearly symmetric",
          .hardness = 1 / spoiled,
          .hardness_is = "radius over what spoils the symmetry",
          .promise = kRings,
          .unit = "vertices of the last ring that are not in the first",
          .run = [spoiled] {
            std::vector<glm::dvec2> corners;
            for (int k = 0; k < 6; ++k) {
              const double r = k == 2 ? 0.3 * (1 + spoiled) : 0.3;
              corners.push_back(r * glm::dvec2(std::cos(kPi * k / 3), std::sin(kPi * k / 3)));
            }
            const Mesh mesh = sweep::sweep(sweep::polyline<2>(corners, true), sweep::torus_knot(2, 3, 2, 0.8),
                                           {.tessellation = {24, 128}});
            using Place = std::array<float, 3>;
            std::set<Place> first;
            std::vector<Place> last;
            for (const sweep::GridPatch& patch : mesh.patches) {
              for (std::uint32_t i = 0; i <= patch.columns; ++i) {
                const glm::vec3& p = mesh.positions()[patch.vertex(i, 0)];
                const glm::vec3& q = mesh.positions()[patch.vertex(i, patch.rows)];
                first.insert({p.x, p.y, p.z});
                last.push_back({q.x, q.y, q.z});
              }
            }
            return Reached{.error = static_cast<double>(std::ranges::count_if(
                               last, [&](const Place& place) { return !first.contains(place); }))};
          }};
}

StabilityCase tiny_torus(double ring, const std::string& power) {
  return {.name = "sweeps_torus_" + power,
          .stage = kStage,
          .input = "torus of curvature " + power + "/m to a tolerance: its volume by Pappus",
          .hardness = 1 / ring,
          .hardness_is = "curvature times 1 m",
          .promise = "the surface is no farther from the mesh than the tolerance",
          .unit = "of the volume",
          .run = [ring] {
            const double tube = 0.1 * ring;
            const double tolerance = 1e-4 * ring;
            const Mesh mesh = sweep::sweep(sweep::circle_contour(tube), sweep::circle_trajectory(ring),
                                           {.tessellation = {.tolerance = tolerance}});
            double volume = 0;
            for (const sweep::Triangle& t : mesh.triangles) {
              const auto at = [&](std::uint32_t v) { return glm::dvec3(mesh.positions()[v]) / ring; };
              volume += glm::dot(at(t[0]), glm::cross(at(t[1]), at(t[2]))) / 6;
            }
            const double exact = 2 * kPi * kPi * 0.01;
            // The area times the tolerance, 4 pi^2 R r e over 2 pi^2 R r^2.
            return Reached{.error = std::abs(volume - exact) / exact, .bound = 2 * tolerance / tube};
          }};
}

StabilityCase cusp_trajectory() {
  return normals_case("cusps", "a trajectory that turns right back twice", 180, "degrees of the turn", [] {
    return sweep::sweep(sweep::circle_contour(0.05),
                        sweep::bezier_curve<3>({{0, 0, 0}, {2, 0, 0}, {-1, 0, 0}, {1, 0, 0}}));
  });
}

StabilityCase poles(double beside, const std::string& power) {
  return normals_case("pole_" + power, "a vase that meets its axis within " + power + " rad of it",
                      1 / beside, "1 over the angle to the axis (1/rad)", [beside] {
                        return sweep::revolve(sweep::bezier_curve<2>({{0, 0}, {beside, 1}, {1, 1}, {0, 2}}));
                      });
}

// What is no number is refused where it is given, before anything is made of it.
template <class Use>
StabilityCase refusal(const std::string& name, const std::string& input, Use use) {
  return {.name = "sweeps_refused_" + name,
          .stage = kStage,
          .input = input + " of NaN, infinity and -infinity",
          .hardness = 1e308,
          .hardness_is = "size over 1, at least",
          .promise = "bad input is refused before any work",
          .unit = "of three values that are taken",
          .run = [use] {
            Reached reached;
            for (const double bad : {static_cast<double>(NAN), HUGE_VAL, -HUGE_VAL}) {
              try {
                use(bad);
                reached.error += 1;
              } catch (const InputError&) {
              }
            }
            return reached;
          }};
}

}  // namespace

std::vector<StabilityCase> sweep_cases() {
  return {profile_to(1e-3, "1e_3"),
          profile_to(1e-9, "1e_9"),
          profile_to(0, "0"),
          morph_to(1, "1"),
          morph_to(1e-6, "1e_6"),
          morph_to(1e-9, "1e_9"),
          twist(1e2, "1e2"),
          twist(1e4, "1e4"),
          twist(1e6, "1e6"),
          step_law(1e-6, "1e_6"),
          step_law(1e-12, "1e_12"),
          scale(1e-3, "1e_3"),
          scale(1e-9, "1e_9"),
          scale(1e9, "1e9"),
          far(1e3, "1e3"),
          far(1e7, "1e7"),
          closed_loop(1e-3, "1e_3"),
          closed_loop(1e-9, "1e_9"),
          closed_loop(1e-15, "1e_15"),
          tiny_torus(1e-3, "1e3"),
          tiny_torus(1e-6, "1e6"),
          refusal("law", "a law", [](double bad) { sweep::Law{bad}; }),
          refusal("bezier_law", "a control point of a law",
                  [](double bad) {
                    sweep::Law::bezier({{0, 1}, {1, bad}});
                  }),
          refusal("law_points", "a point of a law",
                  [](double bad) {
                    sweep::Law::through({{0, 1}, {1, bad}});
                  }),
          cusp_trajectory(),
          poles(1e-3, "1e_3"),
          poles(1e-9, "1e_9")};
}

}  // namespace sweepkit::report
