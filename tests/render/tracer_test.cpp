// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "tracer.hpp"

#include <gtest/gtest.h>

#include <random>
#include <span>

#include "draw.hpp"
#include "sweepkit/sweep/sweep.hpp"

namespace sweepkit::render {
namespace {

const char* const kCrowd = R"({"sweepkit": 1, "objects": [
  {"name": "floor", "plane": {"size": [8, 8]}, "tessellation": {"contour": 3, "trajectory": 5}},
  {"name": "torus", "translate": [0.3, 0.7, 0], "rotate_deg": [30, 20, 10], "scale": [1, 2, 0.5],
   "tessellation": {"contour": 16, "trajectory": 40}, "sweep": {"contour": {"circle": {"radius": 0.2}}, "trajectory": {"circle": {"radius": 0.8}}}},
  {"name": "cone", "translate": [-1, 0, 1], "tessellation": {"contour": 9, "trajectory": 30}, "revolve": {"contour": {"polyline": [[0, 0], [0.7, 0], [0, 1.5]]}}},
  {"name": "same floor", "plane": {"size": [8, 8]}}]})";

std::vector<Ray> rays_at(const scene::Scene& scene, int count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> real(-1, 1);
  std::vector<Ray> rays;
  for (int n = 0; n < count; ++n) {
    const glm::dvec3 origin(4 * real(random), 2 + 2 * real(random), 4 * real(random));
    glm::dvec3 direction(real(random), real(random), real(random));
    switch (n % 4) {
      case 0:
        break;
      case 1:
        direction[n % 3] = n % 8 < 4 ? 0.0 : -0.0;
        break;
      case 2: {  // exactly through a vertex
        const scene::Object& object = scene.objects[static_cast<std::size_t>(n) % scene.objects.size()];
        const scene::MeshView& mesh = scene.meshes[object.mesh];
        const glm::vec3& vertex = mesh.positions[static_cast<std::size_t>(n) % mesh.positions.size()];
        direction =
            glm::dvec3(object.world_from_object * glm::dvec4(glm::dvec3(vertex) + mesh.origin, 1)) - origin;
        break;
      }
      default:
        direction = glm::dvec3(0.0);
        direction[n % 3] = n % 8 < 4 ? 1 : -1;
    }
    rays.push_back({origin, direction});
  }
  return rays;
}

TEST(Tracer, GridsFindTheSameHitsAsALinearScanToTheBit) {
  const test::Stage stage(kCrowd);
  const Tracer grids(stage.model.scene, true, Accelerator::kSeads);
  const Tracer without_tree(stage.model.scene, false, Accelerator::kSeads);
  const Tracer linear(stage.model.scene, false, Accelerator::kLinear);
  int hits = 0;
  for (const Ray& ray : rays_at(stage.model.scene, 20000)) {
    const Hit expected = linear.nearest(ray);
    hits += expected.is_hit() ? 1 : 0;
    for (const Tracer* tracer : {&grids, &without_tree}) {
      const Hit hit = tracer->nearest(ray);
      ASSERT_EQ(hit.object, expected.object);
      ASSERT_EQ(hit.triangle, expected.triangle);
      ASSERT_EQ(hit.t, expected.t);
      ASSERT_EQ(hit.a, expected.a);
      ASSERT_EQ(tracer->is_blocked(ray, 2), linear.is_blocked(ray, 2));
    }
  }
  EXPECT_GT(hits, 5000);
}

// Two triangles in the plane y = 0, seen from above.
const char* const kSheet = R"({"sweepkit": 1, "objects": [
  {"name": "sheet", "plane": {"size": [2, 2]}, "rotate_deg": [0, 30, 0], "translate": [0, 0.7, 0]}]})";

TEST(Tracer, ARayThatLeavesAFlatObjectForGoodLeavesAllOfIt) {
  const test::Stage stage(kSheet);
  for (const Accelerator accelerator : {Accelerator::kSeads, Accelerator::kSweep, Accelerator::kLinear}) {
    const Tracer tracer(stage.model.scene, false, accelerator);
    const Ray down{{0.1, 2, 0.2}, {0.01, -1, 0.02}};
    const Hit hit = tracer.nearest(down);
    ASSERT_TRUE(hit.is_hit());
    // From just above the sheet down through it: rounding may put the start of a ray that leaves it there.
    const Ray leaving{{0.1, 0.7 + 1e-16, 0.2}, {0.3, -1e-18, 0.1}, hit.object, hit.triangle};
    EXPECT_FALSE(tracer.nearest(leaving).is_hit());
    EXPECT_FALSE(tracer.is_blocked(leaving, 9));
    // One that leaves no triangle for good, to a light that only a shading normal sees, is blocked by it.
    const Ray through{{0.1, 0.8, 0.2}, {0.01, -1, 0.02}, hit.object};
    EXPECT_EQ(tracer.nearest(through).object, hit.object);
    EXPECT_TRUE(tracer.is_blocked(through, 9));
  }
}

// Of very unlike sizes, turned, flattened, mirrored, on top of each other.
const char* const kInstances = R"({"sweepkit": 1, "objects": [
  {"name": "floor", "plane": {"size": [30, 30]}},
  {"name": "torus", "tessellation": {"contour": 8, "trajectory": 16}, "scale": [1, 0.7, 1],
   "sweep": {"contour": {"circle": {"radius": 0.2}}, "trajectory": {"circle": {"radius": 0.8}}},
   "instances": [{}, {}, {"translate": [0, 2, 0], "scale": 1e-3}, {"translate": [1, 1, 1], "rotate_deg": [10, 20, 30], "scale": [1, 1e-3, 1]},
     {"translate": [-2, 1, 0], "scale": -1}, {"translate": [3, 0.1, 3], "rotate_deg": [90, 0, 0], "scale": 0.3},
     {"translate": [-3, 0.1, 3], "rotate_deg": [80, 0, 0], "scale": 0.1}, {"translate": [0, 1, -3], "scale": 2}]}]})";

TEST(Tracer, InstancesAreMetAsIfTheyWereObjects) {
  const test::Stage stage(kInstances);
  const Tracer tree(stage.model.scene, true, Accelerator::kSeads);
  const Tracer linear(stage.model.scene, false, Accelerator::kLinear);
  int hits = 0;
  for (const Ray& ray : rays_at(stage.model.scene, 20000)) {
    const Hit expected = linear.nearest(ray);
    const Hit hit = tree.nearest(ray);
    hits += expected.is_hit() && expected.object > 0 ? 1 : 0;
    ASSERT_EQ(hit.object, expected.object);
    ASSERT_EQ(hit.triangle, expected.triangle);
    ASSERT_EQ(hit.t, expected.t);
    ASSERT_EQ(tree.is_blocked(ray, 2), linear.is_blocked(ray, 2));
  }
  EXPECT_GT(hits, 2000);
  std::size_t built = 0;
  for (const auto& accelerator : tree.accelerators()) built += accelerator ? 1 : 0;
  EXPECT_EQ(built, 2u) << "instances share theirs";
}

TEST(Tracer, PacketsFindTheSameHitsAsTheirRaysAloneToTheBit) {
  for (const char* text : {kCrowd, kInstances}) {
    const test::Stage stage(text);
    for (const bool has_tree : {true, false}) {
      const Tracer tracer(stage.model.scene, has_tree, Accelerator::kSeads);
      std::vector<Ray> rays = rays_at(stage.model.scene, 8000);
      std::vector<Hit> hits(ObjectTree::kMostRays);
      for (std::size_t first = 0; first < rays.size(); first += ObjectTree::kMostRays) {
        const std::span<Ray> packet =
            std::span(rays).subspan(first, first % 96 == 0 ? 7 : ObjectTree::kMostRays);
        for (Ray& ray : packet) ray.origin = packet[0].origin;
        tracer.nearest(packet, hits);
        for (std::size_t i = 0; i < packet.size(); ++i) {
          const Hit alone = tracer.nearest(packet[i]);
          ASSERT_EQ(hits[i].object, alone.object);
          ASSERT_EQ(hits[i].triangle, alone.triangle);
          ASSERT_EQ(hits[i].t, alone.t);
          ASSERT_EQ(hits[i].c, alone.c);
        }
      }
    }
  }
}

// A camera far from a small scene that is far from the origin: boxes have room for what rounding does to it.
TEST(Tracer, FarAwayTheTreeLosesNoHit) {
  const test::Stage stage(R"({"sweepkit": 1, "objects": [
    {"name": "ball", "translate": [1e6, 0, -1e6], "tessellation": {"contour": 12, "trajectory": 24}, "revolve": {"contour": {"arc": {"radius": 1, "from_deg": -90, "to_deg": 90}}},
     "instances": [{}, {"translate": [0.1, 3, 0], "scale": [1, 1, 1]}, {"translate": [0, -3, 0], "rotate_deg": [0, 1e-4, 0]}]}]})");
  const Tracer tree(stage.model.scene, true, Accelerator::kSeads);
  const Tracer linear(stage.model.scene, false, Accelerator::kLinear);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> real(-1, 1);
  int hits = 0;
  for (int n = 0; n < 20000; ++n) {
    const glm::dvec3 from = 1e6 * glm::dvec3(real(random), real(random), real(random));
    const glm::dvec3 at(1e6 + 1.2 * real(random), 4 * real(random), -1e6 + 1.2 * real(random));
    const Ray ray{from, glm::normalize(at - from)};
    const Hit expected = linear.nearest(ray);
    ASSERT_EQ(tree.nearest(ray).t, expected.t);
    hits += expected.is_hit() ? 1 : 0;
  }
  EXPECT_GT(hits, 5000);
}

TEST(Tracer, TiesGoToTheLowerObject) {
  const test::Stage stage(kCrowd);  // two floors in one place
  const Tracer tracer(stage.model.scene, true, Accelerator::kSeads);
  EXPECT_EQ(tracer.nearest({{3, 1, 3}, {0, -1, 0}}).object, 0u);
}

// A closed sphere seen from inside has no way out, through a vertex, an edge or a face, at the origin or far
// from it.
TEST(Tracer, AClosedSphereLeaksNoRay) {
  const sweep::Mesh sphere = sweep::revolve(
      sweep::Curve2({sweep::ArcSegment<2>{{0, 0}, {1, 0}, {0, 1}, -90, 90}}), {.tessellation = {100, 200}});
  for (const glm::dvec3& offset : {glm::dvec3(0.0), glm::dvec3(1e3, 0, -1e3)}) {
    scene::Scene scene;
    scene.meshes.push_back({sphere.positions(),
                            sphere.normals(),
                            sphere.texcoords(),
                            sphere.triangles,
                            sphere.patches,
                            sphere.areas,
                            {}});
    glm::dmat4 placement(1.0);
    placement[3] = glm::dvec4(offset, 1);
    scene.objects.push_back({"sphere", 0, {}, placement});
    const Tracer tracer(scene, false, Accelerator::kSeads);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> real(0, 1);
    int misses = 0;
    for (int n = 0; n < 100000; ++n) {
      const sweep::Triangle& t = sphere.triangles[random() % sphere.triangles.size()];
      const glm::dvec3 a(sphere.positions()[t[0]]);
      const glm::dvec3 b(sphere.positions()[t[1]]);
      const glm::dvec3 c(sphere.positions()[t[2]]);
      const double s = real(random);
      const glm::dvec3 aim = n % 3 == 0 ? a : n % 3 == 1 ? (1 - s) * a + s * b : (a + b + c) / 3.0;
      const glm::dvec3 from(0.4 * real(random) - 0.2, 0.4 * real(random) - 0.2, 0.4 * real(random) - 0.2);
      if (!tracer.nearest({offset + from, aim - from}).is_hit()) ++misses;
    }
    EXPECT_EQ(misses, 0);
  }
}

TEST(Tracer, ARayWithoutNumbersHitsNothing) {
  const test::Stage stage(kCrowd);
  const Tracer tracer(stage.model.scene, true, Accelerator::kSeads);
  const double nan = std::nan("");
  EXPECT_FALSE(tracer.nearest({{nan, 0, 0}, {0, -1, 0}}).is_hit());
  EXPECT_FALSE(tracer.nearest({{0, 1, 0}, {nan, nan, nan}}).is_hit());
}

}  // namespace
}  // namespace sweepkit::render
