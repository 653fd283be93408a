// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Made for the index codec of EXT_meshopt_compression, as its specification describes it.

#include "strip_order.hpp"

#include <algorithm>
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
        normals_(to_octahedron(mesh.normals)),
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
    for (Triangle& triangle : order_.triangles) {
      for (std::uint32_t& vertex : triangle) vertex = new_index_[vertex];
    }
    drop_unused_vertices(order_);
    return std::move(order_);
  }

 private:
  // Which way is smaller is told well by steps of 1 / 4095 of the box.
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
  static void each_vertex(const GridPatch& patch, bool by_rows, std::uint32_t line, bool is_back,
                          const Visit& visit) {
    const std::uint32_t count = (by_rows ? patch.columns : patch.rows) + 1;
    for (std::uint32_t step = 0; step < count; ++step) {
      const std::uint32_t i = is_back ? count - 1 - step : step;
      const std::uint32_t column = by_rows ? i : line;
      const std::uint32_t row = by_rows ? line : i;
      if (patch.has_first_pole && row == 0 && column == 0) continue;
      if (patch.has_last_pole && row == patch.rows && column == patch.columns) continue;
      visit(patch.vertex(column, row));
    }
  }

  template <class Visit>
  void each_triangle(const GridPatch& patch, bool by_rows, std::uint32_t line, bool is_back,
                     const Visit& visit) const {
    const std::uint32_t count = by_rows ? patch.columns : patch.rows;
    for (std::uint32_t step = 0; step < count; ++step) {
      const std::uint32_t i = is_back ? count - 1 - step : step;
      const std::uint32_t column = by_rows ? i : line;
      const std::uint32_t row = by_rows ? line : i;
      const std::uint32_t at_poles = (patch.has_first_pole && row == 0 ? 1u : 0u) +
                                     (patch.has_last_pole && row + 1 == patch.rows ? 1u : 0u);
      const std::uint32_t in_cell = 2 - at_poles;
      const std::uint32_t first = patch.first_triangle_of_row(row) + in_cell * column;
      for (std::uint32_t k = 0; k < in_cell; ++k) {
        visit(mesh_.triangles[first + (is_back ? in_cell - 1 - k : k)]);
      }
    }
  }

  // Bytes that the codecs make of it, walked that way.
  std::size_t cost(const GridPatch& patch, bool by_rows, bool to_and_fro) const {
    constexpr std::size_t kRestart = 3;  // a line's first triangle
    std::vector<ShortPosition> places;
    std::vector<ByteVector> normals;
    places.reserve(patch.vertex_count());
    normals.reserve(patch.vertex_count());
    for (std::uint32_t line = 0; line <= lines(patch, by_rows); ++line) {
      each_vertex(patch, by_rows, line, to_and_fro && line % 2 == 0, [&](std::uint32_t vertex) {
        places.push_back(places_[vertex]);
        normals.push_back(normals_[vertex]);
      });
    }
    return kRestart * lines(patch, by_rows) +
           pack_vertices(std::as_bytes(std::span(places)), sizeof(ShortPosition)).size() +
           pack_vertices(std::as_bytes(std::span(normals)), sizeof(ByteVector)).size();
  }

  // The codec's next new vertex falls a line behind in a patch; `catches_up`: not in this one, so that the
  // patch that follows has its vertices next too. The first line of cells then numbers both its lines as
  // they are met. Such a patch is walked to and fro: a line of cells then starts at an edge that the codec
  // still knows, and its vertices are numbered as it meets them. Where the next vertex is a line behind that
  // would take it away from where it is.
  void walk_patch(const GridPatch& patch, bool catches_up) {
    const bool by_rows = cost(patch, true, catches_up) <= cost(patch, false, catches_up);
    if (catches_up) {
      each_triangle(patch, by_rows, 0, false, [&](const Triangle& triangle) {
        for (const std::uint32_t vertex : triangle) take(vertex);
      });
    }
    for (std::uint32_t line = 0; line <= lines(patch, by_rows); ++line) {
      // The line of cells before this line of vertices meets it as new.
      each_vertex(patch, by_rows, line, catches_up && line % 2 == 0,
                  [&](std::uint32_t vertex) { take(vertex); });
    }
    for (std::uint32_t line = 0; line < lines(patch, by_rows); ++line) {
      each_triangle(patch, by_rows, line, catches_up && line % 2 == 1,
                    [&](const Triangle& triangle) { add(triangle); });
    }
  }

  const MeshView& mesh_;
  std::vector<ShortPosition> places_;
  std::vector<ByteVector> normals_;
  std::vector<std::uint32_t> new_index_;
  MeshOrder order_;
};

}  // namespace

void drop_unused_vertices(MeshOrder& order) {
  std::vector<std::uint32_t> new_index(order.vertices.size(), kNone);
  for (const Triangle& triangle : order.triangles) {
    for (const std::uint32_t vertex : triangle) new_index[vertex] = 0;
  }
  std::uint32_t count = 0;
  for (std::uint32_t vertex = 0; vertex < new_index.size(); ++vertex) {
    if (new_index[vertex] == kNone) continue;
    order.vertices[count] = order.vertices[vertex];
    new_index[vertex] = count++;
  }
  order.vertices.resize(count);
  for (Triangle& triangle : order.triangles) {
    for (std::uint32_t& vertex : triangle) vertex = new_index[vertex];
  }
}

MeshOrder strip_order(const MeshView& mesh) {
  return Walk(mesh).walk();
}

}  // namespace sweepkit::scene
