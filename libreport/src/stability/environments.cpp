// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Symbols: u = 1/2 + atan2(x, -z) / 2 pi, v = 3/4 + latitude / 2 pi on the texture that covers the sphere
// twice.

#include <memory>

#include "quad.hpp"
#include "stability/stability_case.hpp"
#include "sweepkit/texmap/latitude_longitude.hpp"
#include "sweepkit/texmap/texture_sampler.hpp"

namespace sweepkit::report {
namespace {

constexpr const char* kStage = "environment";
constexpr glm::dvec2 kSize{64, 32};

glm::dvec3 beside_pole(double angle, double longitude) {
  return {std::sin(angle) * std::sin(longitude), std::cos(angle), -std::sin(angle) * std::cos(longitude)};
}

StabilityCase place(double angle, const std::string& power) {
  return {.name = "environment_place_" + power,
          .stage = kStage,
          .input = "directions " + power + " rad from the pole: their place in the picture",
          .hardness = 1 / angle,
          .hardness_is = "1 over the angle (1/rad)",
          .promise = "texture coordinates: no NaN, within a few units of the last place",
          .unit = "repeats",
          .run = [angle] {
            Reached reached{.bound = 8 * kRounding};
            for (int i = 0; i < 32; ++i) {
              const glm::dvec3 d = beside_pole(angle, 0.2 * i - 3.1);
              const texmap::Footprint at = texmap::over_sphere(d, {1e-3, 0, 0}, {0, 0, 1e-3}, kSize);
              const Quad x = d.x;
              const Quad z = d.z;
              const Quad u = static_cast<Quad>(0.5) + atan2q(x, -z) / (2 * quad_pi());
              const Quad v = static_cast<Quad>(0.75) + atan2q(d.y, hypotq(x, z)) / (2 * quad_pi());
              reached.error = worse(reached.error, static_cast<double>(fabsq(at.uv.x - u)));
              reached.error = worse(reached.error, static_cast<double>(fabsq(at.uv.y - v)));
            }
            return reached;
          }};
}

StabilityCase reach(double angle, const std::string& power) {
  return {.name = "environment_reach_" + power,
          .stage = kStage,
          .input = "a pixel of 1e-3 rad, " + power + " rad from the pole: how long its footprint is",
          .hardness = 1 / std::max(angle, 1e-300),
          .hardness_is = "1 over the angle (1/rad)",
          .promise = "a footprint is no more than 16 texels along for each across",
          .unit = "texels along for each across",
          .run = [angle] {
            Reached reached{.bound = 16 * (1 + 8 * kRounding)};
            for (int i = 0; i < 32; ++i) {
              const glm::dvec3 d = beside_pole(angle, 0.2 * i - 3.1);
              const texmap::Footprint at = texmap::over_sphere(d, {1e-3, 0, 0}, {0, 0, 1e-3}, kSize);
              const double across = kSize.y * 2 * std::max(std::abs(at.dx.y), std::abs(at.dy.y));
              const double along = kSize.x * std::max(std::abs(at.dx.x), std::abs(at.dy.x));
              reached.error = worse(reached.error, along / across);
            }
            return reached;
          }};
}

StabilityCase constant_sky(double angle, const std::string& power) {
  return {.name = "environment_constant_" + power,
          .stage = kStage,
          .input = "a picture of one colour, seen " + power + " rad from the pole",
          .hardness = 1 / std::max(angle, 1e-300),
          .hardness_is = "1 over the angle (1/rad)",
          .promise = "a constant texture comes back constant",
          .unit = "8-bit levels",
          .run = [angle] {
            const texmap::ImageTexture picture{std::make_shared<const texmap::Image>(texmap::Image{
                                                   64, 32, 1, std::vector<std::uint16_t>(64 * 32, 40001)}),
                                               texmap::Wrap::kRepeat};
            Reached reached;
            // The elliptical average divides a sum of weights by their sum: some steps of float32.
            reached.bound = 16 * 0x1p-24 * 255;
            for (const texmap::Filter filter :
                 {texmap::Filter::kTrilinear, texmap::Filter::kIntegral3, texmap::Filter::kEwa}) {
              texmap::TileCache cache(texmap::kDefaultTextureMemory);
              const texmap::TextureSampler sampler(texmap::over_sphere(picture), filter, cache, 0);
              texmap::FilterThread thread(cache);
              for (int i = 0; i < 32; ++i) {
                const texmap::Footprint at =
                    texmap::over_sphere(beside_pole(angle, 0.2 * i - 3.1), {1e-2, 0, 0}, {0, 0, 1e-2}, kSize);
                const double value = static_cast<double>(sampler.sample(at, thread).x);
                reached.error = worse(reached.error, 255 * std::abs(value - 40001 / 65535.0));
              }
            }
            return reached;
          }};
}

}  // namespace

std::vector<StabilityCase> environment_cases() {
  return {place(1e-3, "1e_3"), place(1e-9, "1e_9"), place(1e-300, "1e_300"),    reach(1e-1, "1e_1"),
          reach(1e-6, "1e_6"), reach(0, "0"),       constant_sky(1e-3, "1e_3"), constant_sky(0, "0")};
}

}  // namespace sweepkit::report
