// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Symbols: (N, B, T) a frame; k the curvature and tau the torsion of a helix of radius r that climbs c a
// radian: tau = c / (r^2 + c^2), and a rotation-minimizing normal turns by -tau a metre against Frenet's.

#include "frames.hpp"

#include "quad.hpp"
#include "rotation_minimizing_frames.hpp"
#include "stability/stability_case.hpp"
#include "stations.hpp"
#include "sweepkit/sweep/primitives.hpp"

namespace sweepkit::report {
namespace {

constexpr const char* kStage = "frames";
constexpr const char* kDouble = "positions, frames, arc length: double inside";
constexpr const char* kFinite = "finite at poles, cusps and zero-area places";

// How far three vectors are from a right-handed orthonormal frame.
double askew(const sweep::Frame& f) {
  double worst = glm::length(glm::cross(f.normal, f.binormal) - f.tangent);
  for (const double dot :
       {glm::dot(f.normal, f.binormal), glm::dot(f.normal, f.tangent), glm::dot(f.binormal, f.tangent),
        glm::dot(f.normal, f.normal) - 1, glm::dot(f.binormal, f.binormal) - 1})
    worst = worse(worst, std::abs(dot));
  return worst;
}

StabilityCase straight(int stations, const std::string& power) {
  return {
      .name = "frames_straight_" + power,
      .stage = kStage,
      .input = "slanted straight line, " + power + " stations",
      .hardness = static_cast<double>(stations),
      .hardness_is = "steps",
      .promise = kDouble,
      .unit = "rad",
      .run = [stations] {
        // The tangents are the same bits, so nothing may turn.
        const sweep::Curve3 line = sweep::polyline<3>({{0.1, 0.2, 0.3}, {1, 2, 4}}, false);
        const auto frames = sweep::rotation_minimizing_frames(line, sweep::place_stations(line, stations));
        Reached reached{.bound = 4 * kRounding * std::sqrt(static_cast<double>(stations))};
        for (const sweep::StationFrames& at : frames)
          reached.error = worse(reached.error, glm::length(at.out.frame.normal - frames[0].out.frame.normal));
        return reached;
      }};
}

// A curve in a plane keeps its binormal, through an inflection too.
StabilityCase inflection(double height, const std::string& power) {
  return {.name = "frames_inflection_" + power,
          .stage = kStage,
          .input = "S in a plane, " + power + " m high, 2 m long",
          .hardness = 2 / height,
          .hardness_is = "length over height",
          .promise = kDouble,
          .unit = "rad",
          .run = [height] {
            const sweep::Curve3 curve =
                sweep::bezier_curve<3>({{-1, 0, -height}, {0, 0, height}, {0, 0, -height}, {1, 0, height}});
            constexpr int kSteps = 1000;
            const auto frames =
                sweep::rotation_minimizing_frames(curve, sweep::place_stations(curve, kSteps));
            // No step leaves the plane by more than two reflections' rounding.
            Reached reached{.bound = 16 * kRounding * kSteps};
            for (const sweep::StationFrames& at : frames)
              reached.error = worse(reached.error, glm::length(at.out.frame.binormal - glm::dvec3(0, 1, 0)));
            return reached;
          }};
}

StabilityCase half_turn(double short_of, const std::string& power) {
  return {.name = "frames_half_turn_" + power,
          .stage = kStage,
          .input = "a corner that turns back but for " + power + " rad",
          .hardness = 1 / short_of,
          .hardness_is = "1 over what is short of a half turn (1/rad)",
          .promise = kFinite,
          .unit = "of a unit frame",
          .run = [short_of] {
            const glm::dvec3 to(std::sin(short_of), 0, -std::cos(short_of));
            Reached reached{.bound = 16 * kRounding};
            for (int i = 0; i < 16; ++i) {
              const double a = static_cast<double>(quad_pi()) * (i + 0.5) / 8;
              const sweep::Curve3 curve =
                  sweep::polyline<3>({{0, 0, 0}, {0, 0, 1}, glm::dvec3(0, 0, 1) + to}, false);
              const auto frames = sweep::rotation_minimizing_frames(curve, sweep::place_stations(curve, 8),
                                                                    {std::cos(a), std::sin(a), 0});
              for (const sweep::StationFrames& at : frames)
                reached.error = worse(reached.error, askew(at.out.frame));
            }
            return reached;
          }};
}

StabilityCase along_up(double beside, const std::string& power) {
  return {.name = "frames_along_up_" + power,
          .stage = kStage,
          .input = "first tangent " + power + " rad beside the up vector",
          .hardness = 1 / beside,
          .hardness_is = "1 over the angle (1/rad)",
          .promise = kFinite,
          .unit = "of a unit frame",
          .run = [beside] {
            const glm::dvec3 tangent = glm::normalize(glm::dvec3(beside, 1, 0));
            return Reached{.error = askew(sweep::first_frame(tangent, {0, 1, 0})), .bound = 16 * kRounding};
          }};
}

StabilityCase helix_drift(int turns, const std::string& power) {
  constexpr int kStepsATurn = 16;
  return {.name = "frames_helix_drift_" + power,
          .stage = kStage,
          .input = "helix of " + power + " turns, 16 steps a turn: is the frame a frame still?",
          .hardness = static_cast<double>(turns),
          .hardness_is = "turns",
          .promise = kDouble,
          .unit = "of a unit frame",
          .run = [turns] {
            // Step by step: stations of a whole curve would be 1.6 million.
            const double climb = 0.05;
            sweep::Frame frame{};
            // A step's 8 roundings, which go either way: they grow as the root of the steps.
            Reached reached{.bound = 8 * kRounding * std::sqrt(static_cast<double>(turns * kStepsATurn))};
            const auto at = [&](int i) {
              const double a = 2 * static_cast<double>(quad_pi()) * (i % kStepsATurn) / kStepsATurn;
              const double all = 2 * static_cast<double>(quad_pi()) * i / kStepsATurn;
              return sweep::TangentPoint{{std::cos(a), climb * all, std::sin(a)},
                                         glm::normalize(glm::dvec3(-std::sin(a), climb, std::cos(a)))};
            };
            sweep::TangentPoint here = at(0);
            frame = sweep::first_frame(here.tangent, {0, 1, 0});
            for (int i = 1; i <= turns * kStepsATurn; ++i) {
              const sweep::TangentPoint next = at(i);
              frame.normal = sweep::double_reflection(frame.normal, here, next);
              here = next;
              if (i % kStepsATurn != 0) continue;
              frame.tangent = here.tangent;
              frame.binormal = glm::cross(frame.tangent, frame.normal);
              reached.error = worse(reached.error, askew(frame));
            }
            return reached;
          }};
}

// The angle after many turns against the closed form; double reflection errs by a known power of the step.
StabilityCase helix_angle(int turns, const std::string& power) {
  return {.name = "frames_helix_angle_" + power,
          .stage = kStage,
          .input = "helix of " + power + " turns, 64 steps a turn: the normal's angle at its end",
          .hardness = static_cast<double>(turns),
          .hardness_is = "turns",
          .promise = "frames along a trajectory are of fourth order",
          .unit = "rad",
          .run = [turns] {
            const double climb = 0.25;
            const sweep::Curve3 curve = sweep::helix(1, 2 * static_cast<double>(quad_pi()) * climb, turns);
            const auto frames =
                sweep::rotation_minimizing_frames(curve, sweep::place_stations(curve, 64 * turns));
            // A whole number of turns: Frenet's frame is the first one again.
            const Quad c = climb;
            const Quad turned = -2 * quad_pi() * turns * c / sqrtq(1 + c * c);
            const sweep::Frame& first = frames.front().out.frame;
            const sweep::Frame& last = frames.back().in.frame;
            const double angle = sweep::angle_to(first, last.normal);
            const Quad off = remainderq(static_cast<Quad>(angle) - turned, 2 * quad_pi());
            // h^4 a step of h = 2 pi / 64, times a constant below tau k^2 / 20 a metre (Wang et al. 2008).
            const double h = static_cast<double>(quad_pi()) / 32;
            return Reached{.error = static_cast<double>(fabsq(off)),
                           .bound = h * h * h * h * climb / 20 * 2 * static_cast<double>(quad_pi()) * turns};
          }};
}

// A step of no length, and one that is lost in the rounding of a far place.
StabilityCase short_step(double step, const std::string& power) {
  return {.name = "frames_short_step_" + power,
          .stage = kStage,
          .input = "a step of " + power + " m between tangents a quarter turn apart",
          .hardness = 1 / std::max(step, 1e-300),
          .hardness_is = "1 m over the step",
          .promise = kFinite,
          .unit = "of a unit frame",
          .run = [step] {
            const sweep::TangentPoint from{{1, 2, 3}, {0, 0, 1}};
            const sweep::TangentPoint to{{1 + step, 2, 3}, {1, 0, 0}};
            const glm::dvec3 normal = sweep::double_reflection({0, 1, 0}, from, to);
            return Reached{.error = askew({normal, glm::cross(to.tangent, normal), to.tangent}),
                           .bound = 16 * kRounding};
          }};
}

}  // namespace

std::vector<StabilityCase> frame_cases() {
  return {straight(100, "1e2"),       straight(10000, "1e4"),     inflection(1e-3, "1e_3"),
          inflection(1e-9, "1e_9"),   inflection(1e-15, "1e_15"), half_turn(1e-3, "1e_3"),
          half_turn(1e-8, "1e_8"),    half_turn(1e-16, "1e_16"),  along_up(1e-3, "1e_3"),
          along_up(1e-9, "1e_9"),     along_up(1e-300, "1e_300"), helix_drift(100, "1e2"),
          helix_drift(100000, "1e5"), helix_angle(10, "1e1"),     helix_angle(200, "2e2"),
          short_step(1e-9, "1e_9"),   short_step(0, "0")};
}

}  // namespace sweepkit::report
