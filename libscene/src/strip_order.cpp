// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Made for the index codec of EXT_meshopt_compression, as its specification describes it.

#include "strip_order.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gltf_meshopt.hpp"

namespace sweepkit::scene {
namespace {

using sweep::GridPatch;
using sweep::Triangle;

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

class Walk {
 public:
  explicit Walk(const MeshView& mesh)
      : mesh_(mesh),
        places_(to_grid(mesh.positions, position_grid(mesh.positions, kBits))),
        new_index_(mesh.positions.size(), kNone) {
    order_.vertices.reserve(mesh.positions.size());
    order_.triangles.reserve(mesh.triangles.size());
  }

  MeshOrder walk() && {
    walk_loose();
    const auto largest = std::max_element(
        mesh_.patches.begin(), mesh_.patches.end(),
        [](const GridPatch& a, const GridPatch& b) { return a.triangle_count() < b.triangle_count(); });
    for (const GridPatch& patch : mesh_.patches) {
      if (&patch != &*largest) walk_patch(patch, true);
    }
    if (largest != mesh_.patches.end()) walk_patch(*largest, false);
    for (std::uint32_t vertex = 0; vertex < new_index_.size(); ++vertex) take(vertex);
    for (Triangle& triangle : order_.triangles) {
      for (std::uint32_t& vertex : triangle) vertex = new_index_[vertex];
    }
    return std::move(order_);
  }

 private:
  // Which way to go is told well by steps of 1 / 4095 of the box.
  static constexpr int kBits = 12;

  void take(std::uint32_t vertex) {
    if (new_index_[vertex] != kNone) return;
    new_index_[vertex] = static_cast<std::uint32_t>(order_.vertices.size());
    order_.vertices.push_back(vertex);
  }

  void add(const Triangle& triangle) { order_.triangles.push_back(triangle); }

  // Caps and meshes from files.
  void walk_loose() {
    std::vector<bool> is_of_patch(mesh_.triangles.size());
    for (const GridPatch& patch : mesh_.patches) {
      const auto first = is_of_patch.begin() + patch.first_triangle;
      std::fill(first, first + patch.triangle_count(), true);
    }
    std::vector<Triangle> loose;
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      if (!is_of_patch[i]) loose.push_back(mesh_.triangles[i]);
    }
    if (loose.empty()) return;
    for (const Triangle& triangle : in_cache_order(loose, mesh_.positions.size())) {
      for (const std::uint32_t vertex : triangle) take(vertex);
      add(triangle);
    }
  }

  // A line of vertices or cells: a row, or a column.
  static std::uint32_t lines(const GridPatch& patch, bool by_rows) {
    return by_rows ? patch.rows : patch.columns;
  }

  template <class Visit>
  static void each_vertex(const GridPatch& patch, bool by_rows, std::uint32_t line, const Visit& visit) {
    const std::uint32_t count = (by_rows ? patch.columns : patch.rows) + 1;
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t column = by_rows ? i : line;
      const std::uint32_t row = by_rows ? line : i;
      if (patch.has_first_pole && row == 0 && column == 0) continue;
      if (patch.has_last_pole && row == patch.rows && column == patch.columns) continue;
      visit(patch.vertex(column, row));
    }
  }

  template <class Visit>
  void each_triangle(const GridPatch& patch, bool by_rows, std::uint32_t line, const Visit& visit) const {
    const std::uint32_t count = by_rows ? patch.columns : patch.rows;
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t column = by_rows ? i : line;
      const std::uint32_t row = by_rows ? line : i;
      const std::uint32_t at_poles = (patch.has_first_pole && row == 0 ? 1u : 0u) +
                                     (patch.has_last_pole && row + 1 == patch.rows ? 1u : 0u);
      const std::uint32_t in_cell = 2 - at_poles;
      const std::uint32_t first = patch.first_triangle_of_row(row) + in_cell * column;
      for (std::uint32_t k = 0; k < in_cell; ++k) visit(mesh_.triangles[first + k]);
    }
  }

  // Bits of a difference along the lines, on average over some of them.
  double cost(const GridPatch& patch, bool by_rows) const {
    constexpr std::uint32_t kEnough = 64;
    double bits = 0;
    double count = 0;
    for (std::uint32_t line = 0; line <= lines(patch, by_rows);
         line += std::max(1u, lines(patch, by_rows) / kEnough)) {
      std::uint32_t before = kNone;
      each_vertex(patch, by_rows, line, [&](std::uint32_t vertex) {
        if (before != kNone) {
          count += 1;
          for (std::size_t axis = 0; axis < 3; ++axis) {
            const int step = int{places_[vertex][axis]} - int{places_[before][axis]};
            const float turn =
                mesh_.normals[vertex][static_cast<int>(axis)] - mesh_.normals[before][static_cast<int>(axis)];
            bits += std::log2(1.0 + std::abs(step)) + std::log2(1.0 + 127.0 * std::abs(turn));
          }
        }
        before = vertex;
      });
    }
    return bits / std::max(count, 1.0);
  }

  // The codec's next new vertex falls a line behind in a patch; `catches_up`: not in this one, so that the
  // patch that follows has its vertices next too. The first line of cells then numbers both its lines as
  // they are met.
  void walk_patch(const GridPatch& patch, bool catches_up) {
    const bool by_rows = cost(patch, true) <= cost(patch, false);
    if (catches_up) {
      each_triangle(patch, by_rows, 0, [&](const Triangle& triangle) {
        for (const std::uint32_t vertex : triangle) take(vertex);
      });
    }
    for (std::uint32_t line = 0; line <= lines(patch, by_rows); ++line) {
      each_vertex(patch, by_rows, line, [&](std::uint32_t vertex) { take(vertex); });
    }
    for (std::uint32_t line = 0; line < lines(patch, by_rows); ++line) {
      each_triangle(patch, by_rows, line, [&](const Triangle& triangle) { add(triangle); });
    }
  }

  const MeshView& mesh_;
  std::vector<ShortPosition> places_;
  std::vector<std::uint32_t> new_index_;
  MeshOrder order_;
};

}  // namespace

MeshOrder strip_order(const MeshView& mesh) {
  return Walk(mesh).walk();
}

}  // namespace sweepkit::scene
