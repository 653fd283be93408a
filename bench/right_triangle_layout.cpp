// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Meshes laid out over right triangles: how many triangles stay alone, how many edges stay continuous, in how
// long. One thread, median of five, of the processor. Every layout is checked: no half of a cell taken twice.
//
// Usage: bench_right_triangle_layout

#include "sweepkit/texmap/right_triangle_layout.hpp"

#include <cstdio>
#include <ctime>
#include <exception>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "harness.hpp"
#include "mesh_shapes.hpp"

namespace {

using namespace sweepkit;
using texmap::test::Shape;

// A grid whose points are shaken by up to a fifth of a cell and whose diagonals fall or rise at random.
Shape shaken_plane(std::uint32_t side) {
  std::mt19937_64 random(1);
  const auto shake = [&] { return 0.4f * (static_cast<float>(random() % 1024) / 1024 - 0.5f); };
  Shape shape = texmap::test::plane(side, side);
  for (glm::vec3& p : shape.positions) p += glm::vec3(shake(), shake(), 0);
  for (std::size_t i = 0; i + 1 < shape.triangles.size(); i += 2) {
    if (random() % 2 == 0) continue;
    const auto [r, p, q] = shape.triangles[i];
    const std::uint32_t s = shape.triangles[i + 1][1];
    shape.triangles[i] = {p, q, s};
    shape.triangles[i + 1] = {s, r, p};
  }
  return shape;
}

Shape shuffled(Shape shape) {
  texmap::test::shuffle(shape, 1);
  return shape;
}

void tell(const std::string& name, const Shape& shape) {
  texmap::RightTriangleLayout layout;
  std::vector<double> seconds;
  for (int round = 0; round < 5; ++round) {
    const std::clock_t start = std::clock();
    layout = texmap::lay_out_right_triangles(shape.positions, shape.triangles);
    seconds.push_back(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  std::vector<bool> taken(std::size_t{4} * layout.columns * layout.rows, false);
  for (const texmap::HalfCell& half : layout.halves) {
    const std::size_t place = std::size_t{4} * half.cell + half.corner;
    if (taken[place]) throw std::runtime_error(name + ": two triangles in one half of a cell");
    taken[place] = true;
  }
  std::printf(
      "%-34s %9zu %6zu %8u %10.1f %8.3f\n", name.c_str(), shape.triangles.size(), layout.lone_triangles,
      layout.island_count,
      100.0 * static_cast<double>(layout.continuous_edges) / static_cast<double>(layout.interior_edges),
      bench::spread(seconds).median);
}

void run() {
  using namespace texmap::test;
  std::printf("%-34s %9s %6s %8s %10s %8s\n", "mesh", "triangles", "alone", "islands", "continuous",
              "seconds");
  tell("plane 100 x 100", plane(100, 100));
  tell("plane 1000 x 10", plane(1000, 10));
  tell("torus 64 x 128", torus(64, 128));
  tell("torus 64 x 128, soup, any order", shuffled(soup_of(torus(64, 128))));
  tell("icosphere, 5 times cut", icosphere(5));
  tell("icosphere, 7 times cut", icosphere(7));
  tell("icosphere, 7 times cut, any order", shuffled(icosphere(7)));
  tell("shaken plane, any diagonals", shaken_plane(700));
  tell("torus 1000 x 500", torus(1000, 500));
  tell("torus 1000 x 500, soup, any order", shuffled(soup_of(torus(1000, 500))));
}

}  // namespace

int main() {
  try {
    run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_right_triangle_layout: %s\n", error.what());
    return 1;
  }
}
