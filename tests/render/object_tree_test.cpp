// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "object_tree.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace sweepkit::render {
namespace {

// Of a few roundings, as the tracer has it for objects that are not lopsided.
constexpr double kRounding = 64 * std::numeric_limits<double>::epsilon();

struct Crowd {
  std::vector<Box> boxes;
  ObjectTree tree;
};

Crowd crowd_of(std::vector<Box> boxes) {
  std::vector<std::uint32_t> all(boxes.size());
  std::iota(all.begin(), all.end(), 0u);
  double reach = 0;
  for (const Box& box : boxes) {
    for (int axis = 0; axis < 3; ++axis)
      reach = std::max({reach, std::abs(box.low[axis]), std::abs(box.high[axis])});
  }
  ObjectTree tree(boxes, all, kRounding, reach);
  return {std::move(boxes), std::move(tree)};
}

// Sizes from 1e-4 to 1 and flat ones, about `middle`.
std::vector<Box> boxes_about(const glm::dvec3& middle, std::size_t count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> real(0, 1);
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 low = middle + glm::dvec3(real(random), real(random), real(random)) * 4.0;
    glm::dvec3 size = std::pow(10, -4 * real(random)) * glm::dvec3(real(random), real(random), real(random));
    if (i % 5 == 0) size[static_cast<int>(i / 5 % 3)] = 0;
    boxes.push_back({low, low + size});
  }
  return boxes;
}

std::vector<Ray> rays_about(const std::vector<Box>& boxes, int count) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> real(-1, 1);
  std::vector<Ray> rays;
  for (int n = 0; n < count; ++n) {
    const Box& aim = boxes[random() % boxes.size()];
    const glm::dvec3 origin = boxes[0].low + 8.0 * glm::dvec3(real(random), real(random), real(random));
    glm::dvec3 direction = (n % 2 == 0 ? aim.low : 0.5 * (aim.low + aim.high)) - origin;  // a corner exactly
    if (n % 3 == 0) direction = {real(random), real(random), real(random)};
    if (n % 5 == 0) direction[n % 3] = n % 10 == 0 ? 0.0 : -0.0;
    if (n % 15 == 0) direction[(n + 1) % 3] = 0;
    if (direction == glm::dvec3(0.0)) direction.x = 1;
    rays.push_back({origin, direction});
  }
  return rays;
}

// The box itself is met, without room for rounding.
bool meets(const Box& box, const Ray& ray, double end) {
  double enter = 0;
  double leave = end;
  for (int axis = 0; axis < 3; ++axis) {
    if (ray.direction[axis] == 0) {
      if (ray.origin[axis] < box.low[axis] || ray.origin[axis] > box.high[axis]) return false;
      continue;
    }
    const double a = (box.low[axis] - ray.origin[axis]) / ray.direction[axis];
    const double b = (box.high[axis] - ray.origin[axis]) / ray.direction[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}

std::vector<int> visited(const Crowd& crowd, const Ray& ray, double end) {
  std::vector<int> times(crowd.boxes.size());
  crowd.tree.walk(ray, end, [&](std::uint32_t object) {
    ++times[object];
    return false;
  });
  return times;
}

TEST(ObjectTree, VisitsEveryBoxThatARayMeetsOnceAndFewOthers) {
  for (const glm::dvec3& middle : {glm::dvec3(0.0), glm::dvec3(1e6, -1e6, 0)}) {
    for (const std::size_t count : {1u, 2u, 3u, 17u, 500u}) {
      const Crowd crowd = crowd_of(boxes_about(middle, count));
      std::size_t met = 0;
      std::size_t others = 0;
      for (const Ray& ray : rays_about(crowd.boxes, 3000)) {
        for (const double end : {kNoEnd, 0.9}) {
          const std::vector<int> times = visited(crowd, ray, end);
          for (std::size_t i = 0; i < count; ++i) {
            ASSERT_LE(times[i], 1);
            if (meets(crowd.boxes[i], ray, end)) {
              ASSERT_EQ(times[i], 1);
              ++met;
            } else {
              others += static_cast<std::size_t>(times[i]);
            }
          }
        }
      }
      EXPECT_GT(met, 500u);
      // Rays aimed at a corner exactly, a third of them, are met or not as rounding has it.
      if (count > 1) {
        EXPECT_LT(others, met) << count;
      }
    }
  }
}

TEST(ObjectTree, PacketsVisitWhatTheirRaysWouldAlone) {
  const Crowd crowd = crowd_of(boxes_about(glm::dvec3(0.0), 300));
  std::vector<Ray> rays = rays_about(crowd.boxes, 3200);
  for (std::size_t first = 0; first < rays.size(); first += ObjectTree::kMostRays) {
    const std::size_t count = first % 3 == 0 ? ObjectTree::kMostRays : 5;
    const std::span<Ray> packet = std::span(rays).subspan(first, count);
    for (Ray& ray : packet) ray.origin = packet[0].origin;
    std::vector<std::uint32_t> masks(crowd.boxes.size());
    crowd.tree.walk(
        packet, [](std::size_t i) { return 1.0 + static_cast<double>(i); },
        [&](std::uint32_t object, std::uint32_t mask) {
          ASSERT_EQ(masks[object], 0u) << "visited twice";
          masks[object] = mask;
        });
    for (std::size_t i = 0; i < count; ++i) {
      const std::vector<int> alone = visited(crowd, packet[i], 1.0 + static_cast<double>(i));
      for (std::size_t object = 0; object < alone.size(); ++object)
        ASSERT_EQ(masks[object] >> i & 1u, static_cast<unsigned>(alone[object]));
    }
  }
}

TEST(ObjectTree, StopsWhenToldAndTurnsBackAtTheEnd) {
  std::vector<Box> boxes;
  for (int i = 0; i < 100; ++i) boxes.push_back({glm::dvec3(i, 0, 0), glm::dvec3(i + 0.5, 1, 1)});
  const Crowd crowd = crowd_of(boxes);
  const Ray ray{{-1, 0.5, 0.5}, {1, 0, 0}};
  int visits = 0;
  crowd.tree.walk(ray, kNoEnd, [&](std::uint32_t object) {
    EXPECT_EQ(object, static_cast<std::uint32_t>(visits)) << "the nearer first";
    return ++visits == 3;
  });
  EXPECT_EQ(visits, 3);
  double end = kNoEnd;
  visits = 0;
  crowd.tree.walk(ray, end, [&](std::uint32_t) {
    end = 1.5;  // met in the first
    ++visits;
    return false;
  });
  EXPECT_EQ(visits, 1);
}

// All in one place, and each half as far away as the one before: neither can be parted evenly.
TEST(ObjectTree, HoldsCrowdsThatCannotBeParted) {
  std::vector<Box> boxes(5000, Box{glm::dvec3(0.0), glm::dvec3(1.0)});
  for (int i = 0; i < 1000; ++i)
    boxes.push_back({glm::dvec3(std::pow(0.5, i)), glm::dvec3(1.5 * std::pow(0.5, i))});
  const Crowd crowd = crowd_of(boxes);
  const std::vector<int> times = visited(crowd, {{-1, -1, -1}, {1, 1, 1}}, kNoEnd);
  EXPECT_EQ(std::accumulate(times.begin(), times.end(), 0), 6000);
}

TEST(ObjectTree, ARayWithoutNumbersVisitsNothing) {
  const Crowd crowd = crowd_of(boxes_about(glm::dvec3(0.0), 20));
  const double nan = std::nan("");
  for (const Ray& ray :
       {Ray{{nan, 0, 0}, {0, -1, 0}}, Ray{{0, 1, 0}, {nan, 1, 0}}, Ray{{kNoEnd, 1, 0}, {1, 1, 0}}}) {
    const std::vector<int> times = visited(crowd, ray, kNoEnd);
    EXPECT_EQ(std::accumulate(times.begin(), times.end(), 0), 0);
    crowd.tree.walk(
        std::span(&ray, 1), [](std::size_t) { return kNoEnd; },
        [](std::uint32_t, std::uint32_t) { ADD_FAILURE() << "visited"; });
  }
  EXPECT_EQ(ObjectTree().bytes(), 0u);
}

}  // namespace
}  // namespace sweepkit::render
