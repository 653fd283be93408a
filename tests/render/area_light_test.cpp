// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "draw.hpp"
#include "light_samples.hpp"

namespace sweepkit::render {
namespace {

using test::Stage;

// A floor seen from above under a plate whose edge lies over x = 0 at height 1, and a light straight above
// the edge at height 2. `camera` looks at the penumbra.
std::string half_plane(const std::string& light) {
  return R"({"sweepkit": 1, "camera": {"eye": [0, 0.9, 0], "target": [0, 0, 0], "up": [0, 0, -1], "fov_deg": 100, "width": 201, "height": 21},
    "lights": [)" +
         light + R"(],
    "objects": [{"name": "floor", "plane": {"size": [40, 40]}}, {"name": "plate", "translate": [-15, 1, 0], "plane": {"size": [30, 40]}}]})";
}

// What a pixel of `half_plane` sees of the light, by its colour with and without the plate.
struct Penumbra {
  Picture with;
  Picture without;

  explicit Penumbra(const std::string& light)
      : with(Stage(half_plane(light)).draw({.shadows = Shadows::kHard})) {
    Stage open(half_plane(light));
    open.model.scene.objects.pop_back();
    without = open.draw({.shadows = Shadows::kHard});
  }
  double share(int x, int y) const {
    return static_cast<double>(with.image.color(x, y).r) / static_cast<double>(without.image.color(x, y).r);
  }
};

// The share of a unit disc on the far side of a chord at `distance` from its middle.
double beyond_chord(double distance) {
  const double d = std::clamp(distance, -1.0, 1.0);
  return (std::acos(d) - d * std::sqrt(1 - d * d)) / std::numbers::pi;
}

TEST(AreaLight, ThrowsThePenumbraOfAHalfPlaneInClosedForm) {
  constexpr double kRadius = 0.4;
  const Penumbra penumbra(R"({"point": [0, 2, 0], "radius": 0.4})");
  const double half_height = 0.9 * std::tan(50 * std::numbers::pi / 180);
  double squares = 0;
  double sum = 0;
  int count = 0;
  for (int y = 0; y < 21; ++y) {
    for (int x = 0; x < 201; ++x) {
      // The floor's point P; the plane through P and the plate's edge, and its distance from the light's
      // middle, cut a chord out of the sphere's outline: of the cone of half angle asin(radius / |L - P|)
      // about the light, the chord is at tan(angle to the plane) / tan(half angle).
      const double px = half_height * (x + 0.5 - 100.5) / 10.5;
      const double pz = half_height * (y + 0.5 - 10.5) / 10.5;
      const glm::dvec3 to(-px, 2, -pz);
      const glm::dvec3 normal = glm::normalize(glm::dvec3(1, px, 0));  // at right angles to (-px, 1, 0) and z
      const double sine = glm::dot(to, normal) / glm::length(to);
      const double tangent = sine / std::sqrt(1 - sine * sine);
      const double half = std::asin(kRadius / glm::length(to));
      // The light lies above the plate's plane where the sine is over 0: that side is seen.
      const double expected = beyond_chord(-tangent / std::tan(half));
      const double error = penumbra.share(x, y) - expected;
      if (expected == 0 || expected == 1) {
        EXPECT_NEAR(error, 0, 1e-6) << x << ' ' << y;
        continue;
      }
      // No sample set of 16 that has no gap wider than a quarter of the disc is off by more.
      EXPECT_LT(std::abs(error), 0.25) << x << ' ' << y;
      sum += error;
      squares += error * error;
      ++count;
    }
  }
  ASSERT_GT(count, 100);
  // 16 samples at random would be off by at most sqrt(1/4 / 16) = 0.125 a pixel; these, which are spread
  // evenly, by half of that. Turned at random, they are right on average: three standard deviations.
  const double deviation = std::sqrt(squares / count);
  EXPECT_LT(deviation, 0.0625);
  EXPECT_LT(std::abs(sum / count), 3 * 0.0625 / std::sqrt(count));
}

TEST(AreaLight, OfNoRadiusIsAPointLight) {
  const Stage point(half_plane(R"({"point": [0, 2, 0]})"));
  const Stage sphere(half_plane(R"({"point": [0, 2, 0], "radius": 0})"));
  EXPECT_EQ(test::texels(point.draw()), test::texels(sphere.draw()));
  // And one that is very small throws the same shadow: the edge runs through no pixel's middle but x = 0.
  const Penumbra small(R"({"point": [0, 2, 0], "radius": 1e-7})");
  for (int x = 0; x < 201; ++x) {
    if (x == 100) continue;
    EXPECT_NEAR(small.share(x, 10), x > 100 ? 1 : 0, 1e-6) << x;
  }
}

TEST(AreaLight, ShinesAsAPointLightOnWhatIsInsideIt) {
  const Stage point(half_plane(R"({"point": [0, 2, 0]})"));
  const Stage sphere(half_plane(R"({"point": [0, 2, 0], "radius": 1000})"));
  EXPECT_EQ(test::texels(point.draw()), test::texels(sphere.draw()));
}

TEST(AreaLight, TakesASetNumberOfShadowRaysAPoint) {
  const Stage point(half_plane(R"({"point": [0, 2, 0]})"));
  const Stage sphere(half_plane(R"({"point": [0, 2, 0], "radius": 0.1})"));
  const Options options{.shadows = Shadows::kHard};
  EXPECT_EQ(sphere.draw(options).statistics.shadow_rays,
            kLightSamples * point.draw(options).statistics.shadow_rays);
}

// Noise in a penumbra looks like a difference from pixel to pixel; it must not ask for rays without end.
TEST(AreaLight, DoesNotKeepRefinementBusy) {
  const Stage stage(half_plane(R"({"point": [0, 2, 0], "radius": 0.8, "intensity": [0.7, 0.7, 0.7]})"));
  const Picture picture = stage.draw({.adaptive = Adaptive{.most_rays = 256}, .layers = {Layer::kRays}});
  for (const float count : test::eye_rays(picture)) EXPECT_LE(count, 33);
}

TEST(DiscSamples, FillTheDiscEvenly) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    glm::dvec2 sum(0.0);
    double squares = 0;
    for (const glm::dvec2& at : disc_samples(seed)) {
      EXPECT_LE(glm::length(at), 1);
      sum += at;
      squares += glm::dot(at, at);
    }
    // Squared radii are even over [0, 1): one in every 16th, so their mean is off 1/2 by 1/32 at most.
    EXPECT_NEAR(squares / kLightSamples, 0.5, 1.0 / 32 + 1e-12);
    EXPECT_LT(glm::length(sum) / kLightSamples, 0.125);
  }
}

}  // namespace
}  // namespace sweepkit::render
