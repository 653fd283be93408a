// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tree_walk.hpp"

namespace sweepkit::render {
namespace {

using test::Grove;
using test::Stage;

// A slab of glass from y = -0.2 to y = 0, its two faces far wider than what is seen; a floor at y = -1.
std::string slab_scene(const std::string& glass, const std::string& eye = "[0.3, 1.5, 2]",
                       const std::string& target = "[0, 0, 0]", const std::string& more = "") {
  return R"({"sweepkit": 1, "camera": {"eye": )" + eye + R"(, "target": )" + target +
         R"(, "fov_deg": 50, "width": 33, "height": 33}, "background": [1, 1, 1], "ambient": [0, 0, 0], "depth": 4,
    "materials": {"glass": {"diffuse": [0, 0, 0], )" +
         glass + R"(}, "dark": {"diffuse": [0, 0, 0]}, "white": {"diffuse": [1, 1, 1]}}, "objects": [
      {"name": "slab", "material": "glass", "parts": [{"plane": {"size": [1000, 1000]}},
        {"plane": {"size": [1000, 1000]}, "rotate_deg": [180, 0, 0], "translate": [0, -0.2, 0]}]})" +
         more + "]}";
}
const char* const kFloor =
    R"(, {"name": "floor", "material": "dark", "translate": [0, -1, 0], "plane": {"size": [1000, 1000]}})";

glm::dvec3 place_of(const Grove& grove, const TreeNode& node) {
  return surface_point(grove.tracer, node.hit, node.direction).position;
}

TEST(Refraction, GoesThroughASlabAsSnellSays) {
  const Stage stage(slab_scene(R"("transmit": 1, "ior": 1.5)", "[0.3, 1.5, 2]", "[0, 0, 0]", kFloor));
  const Grove grove(stage);
  for (int y = 0; y < 33; ++y) {
    const TreeRow row = grove.row(y);
    for (int x = 0; x < 33; ++x) {
      const TreeNode* node = &row.nodes[static_cast<std::size_t>(row.root(x))];
      const glm::dvec3 d = node->direction;
      ASSERT_LT(d.y, 0);
      // Where it meets y = 0, and below: along the plane by the tangent of the angle inside.
      const glm::dvec3 eye = stage.model.scene.camera.eye;
      const glm::dvec3 along = glm::normalize(glm::dvec3(d.x, 0, d.z));
      const double sine = std::hypot(d.x, d.z);
      const double inside = std::tan(std::asin(sine / 1.5));
      const glm::dvec3 top = eye + d * (eye.y / -d.y);
      const glm::dvec3 bottom = top + glm::dvec3(0, -0.2, 0) + 0.2 * inside * along;
      const glm::dvec3 floor = bottom + glm::dvec3(0, -0.8, 0) + 0.8 * (sine / -d.y) * along;
      const glm::dvec3 expected[] = {top, bottom, floor};
      std::int32_t index = row.root(x);
      for (int level = 0; level < 3; ++level) {
        ASSERT_GE(index, 0);
        node = &row.nodes[static_cast<std::size_t>(index)];
        EXPECT_EQ(node->medium, level == 1 ? 0u : kNone);
        // The float32 mesh has the faces at -0.2 rounded, 3e-9 off; the tangents are at most 3.
        EXPECT_LT(glm::length(place_of(grove, *node) - expected[level]), 3e-8)
            << x << ' ' << y << ' ' << level;
        EXPECT_EQ(row.reflection(index), kNotTraced);
        index = row.refraction(index);
      }
      // It leaves parallel to how it came.
      EXPECT_LT(glm::length(node->direction - d), 1e-14);
    }
  }
}

TEST(Refraction, AnIndexOfOneGoesStraightToTheBit) {
  const Stage stage(slab_scene(R"("transmit": 1, "ior": 1)", "[0.3, 1.5, 2]", "[0, 0, 0]", kFloor));
  const Grove grove(stage);
  const TreeRow row = grove.row(7);
  for (const TreeNode& node : row.nodes) {
    const bool is_eyes = std::any_of(row.roots.begin(), row.roots.end(), [&](std::int32_t root) {
      return row.nodes[static_cast<std::size_t>(root)].direction == node.direction;
    });
    EXPECT_TRUE(is_eyes);
  }
  EXPECT_EQ(row.nodes.size(), 3u * 33);
}

TEST(Refraction, GoesThroughABallAsSnellSays) {
  // Through a ball a ray stays in the plane of its centre; it turns by twice the angle between outside and
  // inside. Facets bend it by their chord against the ball, so the error falls with the cells' size squared.
  const auto worst = [](int cells) {
    const Stage stage(
        R"({"sweepkit": 1, "camera": {"eye": [0, 0.4, 5], "target": [0, 0, 0], "fov_deg": 16, "width": 31, "height": 31},
      "ambient": [0, 0, 0], "depth": 2, "materials": {"glass": {"diffuse": [0, 0, 0], "transmit": 1, "ior": 1.5}},
      "objects": [{"name": "ball", "material": "glass", "tessellation": {"contour": )" +
        std::to_string(cells) + R"(, "trajectory": )" + std::to_string(2 * cells) +
        R"(}, "revolve": {"contour": {"arc": {"radius": 1, "from_deg": -90, "to_deg": 90}}}}]})");
    const Grove grove(stage);
    double largest = 0;
    int count = 0;
    for (int y = 0; y < 31; ++y) {
      const TreeRow row = grove.row(y);
      for (int x = 0; x < 31; ++x) {
        const std::int32_t root = row.root(x);
        if (root < 0) continue;
        const std::int32_t inner = row.refraction(root);
        if (inner < 0) continue;
        const TreeNode& in = row.nodes[static_cast<std::size_t>(root)];
        const TreeNode& out = row.nodes[static_cast<std::size_t>(inner)];
        const SurfacePoint point = surface_point(grove.tracer, out.hit, out.direction);
        const glm::dvec3 normal = bent_normal(point, out.direction);
        const glm::dvec3 leaving = refracted(point, out.direction, normal, 1.5);
        // Closed form about the centre 0: impact parameter b, angles asin b and asin b / 1.5.
        const glm::dvec3 eye = stage.model.scene.camera.eye;
        const glm::dvec3 d = in.direction;
        const glm::dvec3 nearest = eye - glm::dot(eye, d) * d;
        const double b = glm::length(nearest);
        if (b > 0.9) continue;  // near the rim the turn's slope grows without bound
        ++count;
        const double turn = 2 * (std::asin(b) - std::asin(b / 1.5));
        const glm::dvec3 to_axis = b > 0 ? -nearest / b : glm::dvec3(0.0);
        const glm::dvec3 expected = std::cos(turn) * d + std::sin(turn) * to_axis;
        largest = std::max(largest, glm::length(leaving - expected));
      }
    }
    EXPECT_GT(count, 400);
    return largest;
  };
  const double coarse = worst(48);
  const double fine = worst(192);
  EXPECT_LT(coarse, 0.01);
  EXPECT_LT(fine, coarse / 12);  // 16, were the pixels' rays at the worst places both times
}

TEST(Refraction, IsTotalReflectionFromTheCriticalAngleOn) {
  // The eye is inside the slab, looking up at its upper face from below.
  for (const char* fresnel : {"none", "schlick", "exact"}) {
    const Stage stage(slab_scene(
        R"("reflect": 0.25, "transmit": 0.75, "ior": 1.5, "fresnel": ")" + std::string(fresnel) + '"',
        "[0, -0.15, 0]", "[0.1, -0.05, 0]"));
    const Grove grove(stage);
    int total = 0;
    int open = 0;
    for (int y = 0; y < 33; ++y) {
      const TreeRow row = grove.row(y);
      for (int x = 0; x < 33; ++x) {
        const std::int32_t root = row.root(x);
        const TreeNode& node = row.nodes[static_cast<std::size_t>(root)];
        if (!(node.direction.y > 0)) continue;
        const double sine = std::hypot(node.direction.x, node.direction.z);
        const Shares shares = row.shares[static_cast<std::size_t>(root)];
        EXPECT_EQ(node.medium, 0u);
        if (sine > 1 / 1.5) {
          ++total;
          EXPECT_EQ(row.refraction(root), kNotTraced);
          EXPECT_GE(row.reflection(root), 0);
          EXPECT_EQ(shares.refracted, 0);
          EXPECT_EQ(shares.mirrored, std::string(fresnel) == "none" ? 1 : 0.25);
        } else {
          ++open;
          EXPECT_EQ(row.refraction(root), kEscaped);
        }
      }
    }
    EXPECT_GT(total, 100);
    EXPECT_GT(open, 100);
  }
}

TEST(Refraction, DimsBeersWayThroughASlab) {
  const Stage stage(slab_scene(R"("transmit": 1, "ior": 1.5, "absorption": [0, 2, 10])"));
  const Picture picture = stage.draw();
  const EyeRays rays(stage.model.scene.camera, 33, 33);
  for (int y = 0; y < 33; ++y) {
    for (int x = 0; x < 33; ++x) {
      const glm::dvec3 d = rays.through(x, y).direction;
      const double metres = 0.2 / std::cos(std::asin(std::hypot(d.x, d.z) / 1.5));
      const glm::vec3 color = picture.image.color(x, y);
      EXPECT_NEAR(color.r, 1, 1e-6);
      EXPECT_NEAR(color.g, std::exp(-2 * metres), 1e-6);
      EXPECT_NEAR(color.b, std::exp(-10 * metres), 1e-6);
    }
  }
}

TEST(Refraction, DimsFromAnEyeInsideAndOnWhatIsInside) {
  // From y = -0.05 to a lamp-white ball's place at y = -0.15, both inside the slab.
  const Stage stage(
      slab_scene(R"("transmit": 1, "ior": 1.5, "absorption": [0, 2, 10])", "[0, -0.05, 0]", "[0, -0.19, 0]"));
  const Picture picture = stage.draw();
  const glm::vec3 color = picture.image.color(16, 16);
  EXPECT_NEAR(color.g, std::exp(-2 * 0.15), 1e-6);
  EXPECT_NEAR(color.b, std::exp(-10 * 0.15), 1e-6);
  Stage lit(slab_scene(
      R"("transmit": 1, "ior": 1.5, "absorption": [0, 2, 10])", "[0, 1, 0]", "[0, 0, 0]",
      R"(, {"name": "sheet", "material": "white", "translate": [0, -0.1, 0], "plane": {"size": [100, 100]}})"));
  lit.model.scene.ambient = glm::vec3(1);
  const glm::vec3 inside = lit.draw().image.color(16, 16);
  EXPECT_NEAR(inside.g, std::exp(-2 * 0.1), 1e-6);
  EXPECT_NEAR(inside.b, std::exp(-10 * 0.1), 1e-6);
}

TEST(Refraction, EverySurfaceHasTwoSides) {
  // The same sheet with its outer side up and down, seen from above under a light from above: ambient,
  // diffuse, highlight, mirror and what shows through are the same.
  const auto draw = [](const char* turn) {
    return Stage(
               R"({"sweepkit": 1, "camera": {"eye": [0.3, 1.5, 2], "target": [0, 0, 0], "width": 33, "height": 33},
      "background": [0.2, 0.4, 0.6], "ambient": [0.1, 0.1, 0.1], "depth": 4, "lights": [{"point": [1, 3, -1], "intensity": [0.5, 0.5, 0.5]}],
      "materials": {"m": {"diffuse": [0.3, 0.2, 0.1], "specular": [0.5, 0.5, 0.5], "reflect": 0.3, "transmit": 0.4},
                    "floor": {"diffuse": [0.7, 0.7, 0.7]}},
      "objects": [{"name": "sheet", "material": "m", "rotate_deg": )" +
               std::string(turn) +
               R"(, "plane": {"size": [2, 2]}}, {"name": "floor", "material": "floor", "translate": [0, -0.5, 0], "plane": {"size": [4, 4]}}]})")
        .draw();
  };
  const Picture up = draw("[0, 0, 0]");
  const Picture down = draw("[180, 0, 0]");
  for (std::size_t i = 0; i < test::texels(up).size(); ++i)
    EXPECT_NEAR(test::texels(up)[i], test::texels(down)[i], 1e-6);
}

TEST(Refraction, AGlazeMirrorsTheSameOnBothSides) {
  // Nothing is inside of what transmits nothing: no total reflection from there.
  for (const char* turn : {"[0, 0, 0]", "[180, 0, 0]"}) {
    const Picture picture =
        Stage(R"({"sweepkit": 1, "camera": {"eye": [0, 2, 0], "target": [0, 0, 0], "width": 9, "height": 9},
      "background": [1, 1, 1], "ambient": [0, 0, 0], "materials": {"m": {"diffuse": [0, 0, 0], "reflect": 1, "ior": 1.5, "fresnel": "exact"}},
      "objects": [{"name": "sheet", "material": "m", "rotate_deg": )" +
              std::string(turn) + R"(, "plane": {"size": [20, 20]}}]})")
            .draw();
    EXPECT_NEAR(picture.image.color(4, 4).r, 0.04, 1e-7);
  }
}

TEST(Refraction, DrawsTheSamePictureForAnyThreadsAndAccelerator) {
  const Stage stage(slab_scene(R"("reflect": 1, "transmit": 1, "ior": 1.5, "fresnel": "exact")",
                               "[0.3, 1.5, 2]", "[0, 0, 0]", kFloor));
  const Picture one = stage.draw({.threads = 1});
  EXPECT_EQ(test::texels(one), test::texels(stage.draw({.threads = 3})));
  EXPECT_EQ(test::texels(one), test::texels(stage.draw({.accelerator = Accelerator::kLinear})));
  EXPECT_GT(one.statistics.refracted_rays, 2u * 33 * 33);
}

}  // namespace
}  // namespace sweepkit::render
