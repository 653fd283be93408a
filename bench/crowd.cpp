// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Many objects of one mesh: what the tree over them costs to build, and a ray to find its way, from 1 object
// to a million of very unlike sizes. One thread. Times a ray hold the object's own accelerator too: beside
// the line of 1 object they tell what the crowd adds.
//
//   bench_crowd [MOST]    up to MOST objects, 1000000 without it

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "harness.hpp"
#include "sweepkit/scene/scene.hpp"
#include "sweepkit/sweep/primitives.hpp"
#include "sweepkit/sweep/sweep.hpp"
#include "tracer.hpp"

namespace {

using namespace sweepkit;
using render::Hit;
using render::Ray;
using render::Tracer;

constexpr int kSide = 128;  // of the picture, in 4 x 4 packets
constexpr std::size_t kPacket = 16;
constexpr std::size_t kRays = std::size_t{kSide} * kSide;

// In a cube of 1 m, a fifth of its middle to a fifth of its edge filled; the largest a hundred times the
// smallest, the small ones many.
scene::Scene crowd_of(const sweep::Mesh& mesh, std::size_t count) {
  scene::Scene scene;
  scene.meshes.push_back({mesh.positions(), mesh.normals(), mesh.texcoords(), mesh.triangles, mesh.patches,
                          mesh.areas, mesh.origin});
  std::mt19937 random(1);
  std::uniform_real_distribution<double> real(0, 1);
  const double spacing = std::cbrt(1 / static_cast<double>(count));
  for (std::size_t i = 0; i < count; ++i) {
    const double size = count == 1 ? 0.4 : spacing * 2 * std::pow(100, -real(random));
    const double turn = 2 * std::numbers::pi * real(random);
    const double c = size * std::cos(turn);
    const double s = size * std::sin(turn);
    const glm::dvec3 at = count == 1 ? glm::dvec3(0.5) : glm::dvec3(real(random), real(random), real(random));
    scene.objects.push_back({"torus",
                             0,
                             {},
                             glm::dmat4({c, s, 0, 0}, {0, 0, size, 0}, {s, -c, 0, 0}, glm::dvec4(at, 1)),
                             static_cast<std::uint32_t>(i)});
  }
  return scene;
}

// Through a picture of the cube, packet after packet.
std::vector<Ray> picture_rays() {
  std::vector<Ray> rays;
  const glm::dvec3 eye(0.5, 0.5, 2.5);
  for (int block = 0; block < kSide * kSide / 16; ++block) {
    for (int k = 0; k < 16; ++k) {
      const int x = block % (kSide / 4) * 4 + k % 4;
      const int y = block / (kSide / 4) * 4 + k / 4;
      const glm::dvec3 at((x + 0.5) / kSide, (y + 0.5) / kSide, 1);
      rays.push_back({eye, glm::normalize(at - eye)});
    }
  }
  return rays;
}

std::vector<Ray> random_rays() {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> real(0, 1);
  std::normal_distribution<double> normal;
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < kRays; ++i) {
    const glm::dvec3 from(real(random), real(random), real(random));
    rays.push_back({from, glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)))});
  }
  return rays;
}

std::uint64_t sum_of(const std::vector<Hit>& hits) {
  std::uint64_t sum = 0;
  for (const Hit& hit : hits) sum = sum * 31 + hit.object + 7 * hit.triangle;
  return sum;
}

void measure(const sweep::Mesh& mesh, std::size_t count) {
  using Clock = std::chrono::steady_clock;
  const scene::Scene scene = crowd_of(mesh, count);
  const Clock::time_point start = Clock::now();
  const Tracer tracer(scene, count > 1, render::Accelerator::kSeads);
  const double build = std::chrono::duration<double>(Clock::now() - start).count();

  std::vector<Hit> hits(kRays);
  std::uint64_t expected = 0;
  const std::vector<Ray> picture = picture_rays();
  const std::vector<Ray> around = random_rays();
  for (std::size_t i = 0; i < kRays; ++i) hits[i] = tracer.nearest(picture[i]);
  expected = sum_of(hits);
  const auto check = [&] { return sum_of(hits) == expected ? "" : "other hits"; };
  const bench::Comparison comparison = bench::compare(
      "crowd_" + std::to_string(count),
      {{"picture",
        [&] {
          for (std::size_t i = 0; i < kRays; ++i) hits[i] = tracer.nearest(picture[i]);
        },
        check},
       {"picture_packets",
        [&] {
          for (std::size_t i = 0; i < kRays; i += kPacket)
            tracer.nearest(std::span(picture).subspan(i, kPacket), std::span(hits).subspan(i, kPacket));
        },
        check},
       {"random",
        [&] {
          for (const Ray& ray : around) bench::keep(tracer.nearest(ray));
        },
        [] { return ""; }},
       {"random_blocked",
        [&] {
          for (const Ray& ray : around) bench::keep(tracer.is_blocked(ray, 10));
        },
        [] { return ""; }}},
      5);
  std::printf("%s, ns a ray:", comparison.name.c_str());
  for (const bench::Result& result : comparison.results)
    std::printf(" %s %.0f", result.name.c_str(), 1e9 * result.seconds.median / static_cast<double>(kRays));
  std::printf("\n");
  std::printf("  %zu objects: built in %.1f ms, %.0f ns and %.0f bytes of tree an object\n", count,
              1e3 * build, 1e9 * build / static_cast<double>(count),
              static_cast<double>(tracer.object_tree().bytes()) / static_cast<double>(count));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::size_t most = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1000000;
    const sweep::Mesh torus = sweep::sweep(sweep::circle_contour(0.12), sweep::circle_trajectory(0.38),
                                           {.tessellation = {12, 32}, .has_half_edges = false});
    for (std::size_t count = 1; count <= most; count *= count == 1 ? 10 : 100) measure(torus, count);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "crowd: %s\n", error.what());
    return 1;
  }
}
