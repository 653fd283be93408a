// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Which triangles of a leaf a ray may meet, 16 lanes at once. For inclusion once an instruction set, as
// lanes-inl.hpp.
//
// Symbols: a lane holds vertex P = (i, j) of the leaf's block; Q = (i+1, j) is the next lane, R = (i, j+1)
// the one a row further; S = (i+1, j+1). P x Q is the edge function of the ray (the origin, after shearing)
// and the edge from P to Q. So every edge is looked at once, by the same numbers for both of its triangles.

#if defined(SWEEPKIT_LEAF_TEST_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWEEPKIT_LEAF_TEST_INL
#undef SWEEPKIT_LEAF_TEST_INL
#else
#define SWEEPKIT_LEAF_TEST_INL
#endif

#include <glm/gtc/type_ptr.hpp>

#include "box_tree.hpp"
#include "culling_ray.hpp"
#include "lanes-inl.hpp"
#include "leaf_vertices-inl.hpp"
#include "sweep_kernels.hpp"
#include "sweepkit/sweep/grid_patch.hpp"

HWY_BEFORE_NAMESPACE();
namespace sweepkit::render::HWY_NAMESPACE {

/// A leaf of a grid: its first cell.
struct GridLeaf {
  std::uint32_t column;
  std::uint32_t row;
};

/// The last leaves of a row and column are moved back into the grid: then no lane is outside of it, and a
/// triangle tested twice is found twice the same.
template <std::uint32_t kShape>
HWY_INLINE GridLeaf grid_leaf(const LeafGrid& grid, std::uint32_t x, std::uint32_t y) {
  constexpr std::uint32_t kColumns = kLeafShapes[kShape].columns;
  constexpr std::uint32_t kRows = kLeafShapes[kShape].rows;
  return {std::min(x * kColumns, grid.columns - kColumns), std::min(y * kRows, grid.rows - kRows)};
}

struct LeafTriangle {
  std::uint32_t index;
  sweep::Triangle vertices;
};

/// Bit `lane` is the triangle (R, P, Q) of the cell at lane's vertex, bit 16 + lane its (Q, S, R).
template <std::uint32_t kShape>
HWY_INLINE LeafTriangle triangle_of(const LeafGrid& grid, const GridLeaf& leaf, std::uint32_t bit) {
  const std::uint32_t lane = bit & 15;
  constexpr std::uint32_t kWide = kLeafShapes[kShape].columns + 1;
  const std::uint32_t i = leaf.column + lane % kWide;
  const std::uint32_t j = leaf.row + lane / kWide;
  const std::uint32_t p = grid.first_vertex + j * grid.stride + i;
  const std::uint32_t r = p + grid.stride;
  const std::uint32_t index = grid.first_triangle + 2 * (j * grid.columns + i);
  if (bit < 16) {
    return {index, grid.is_turned ? sweep::Triangle{p + 1, p, r} : sweep::Triangle{r, p, p + 1}};
  }
  return {index + 1, grid.is_turned ? sweep::Triangle{r, r + 1, p + 1} : sweep::Triangle{p + 1, r + 1, r}};
}

/// Lanes that hold the first vertex of a cell, by shape.
inline constexpr std::array<std::uint32_t, kLeafShapes.size()> kCellLanes = [] {
  std::array<std::uint32_t, kLeafShapes.size()> lanes{};
  for (std::size_t shape = 0; shape < kLeafShapes.size(); ++shape) {
    const auto [columns, rows] = kLeafShapes[shape];
    for (std::uint32_t j = 0; j < rows; ++j) {
      for (std::uint32_t i = 0; i < columns; ++i) lanes[shape] |= 1u << (j * (columns + 1) + i);
    }
  }
  return lanes;
}();

/// An edge function further from 0 than this has the sign of the exact one, for the triangles that the ray
/// meets: their vertices lie no further from it than the box is large. 8 e m for the errors e of both
/// vertices' x and y, 2 e^2 for their products; rounding the products is within the first.
HWY_INLINE float edge_error(float shear_error, float extent) {
  const float farthest = extent + 2 * shear_error;
  return shear_error * (8 * farthest + 2 * shear_error);
}

struct Sheared {
  Lanes x;
  Lanes y;
};

HWY_INLINE Sheared shear(const Lanes p[3], const CullingRay& ray) {
  const Lanes z = p[2] - set(ray.origin[2]);
  return {multiply_add(z, set(ray.shear[0]), p[0] - set(ray.origin[0]) + set(ray.lost[0])),
          multiply_add(z, set(ray.shear[1]), p[1] - set(ray.origin[1]) + set(ray.lost[1]))};
}

/// The edge function of the edge from a to b.
HWY_INLINE Lanes edge(const Sheared& a, const Sheared& b) {
  return difference_of_products(a.x, b.y, a.y, b.x);
}

/// Bits of the lanes where all three may have one sign.
HWY_INLINE std::uint32_t may_agree(const Lanes& u, const Lanes& v, const Lanes& w, float error) {
  return ~less_and_greater(min(min(u, v), w), set(-error), max(max(u, v), w), set(error));
}

/// The triangles of a block whose vertices are `p`, a row of them `kRow` long.
template <std::uint32_t kRow>
HWY_INLINE std::uint32_t cell_triangles_near(const Sheared& p, std::uint32_t cells, float error) {
  const Sheared q = {later<1>(p.x), later<1>(p.y)};
  const Sheared r = {later<kRow>(p.x), later<kRow>(p.y)};
  const Lanes pq = edge(p, q);
  const Lanes rp = edge(r, p);
  const Lanes qr = edge(q, r);
  const std::uint32_t lower = may_agree(pq, rp, qr, error);
  // (Q, S, R) turned round, as (R, S, Q): the same signs, all of them other.
  const std::uint32_t upper = may_agree(later<kRow>(pq), later<1>(rp), qr, error);
  return (lower & cells) | (upper & cells) << 16;
}

/// The first vertex of a leaf.
HWY_INLINE const float* leaf_start(const TreeView& view, const LeafGrid& grid, const GridLeaf& leaf) {
  return &view.mesh->positions[grid.first_vertex + std::size_t{leaf.row} * grid.stride + leaf.column].x;
}

template <std::uint32_t kShape>
HWY_INLINE std::uint32_t triangles_near(const TreeView& view, const LeafGrid& grid, const GridLeaf& leaf,
                                        const CullingRay& ray, float extent) {
  constexpr LeafShape kBlock = kLeafShapes[kShape];
  Lanes vertices[3];
  load_vertices<kBlock.columns, kBlock.rows>(leaf_start(view, grid, leaf), grid, ray.axes, vertices);
  return cell_triangles_near<kBlock.columns + 1>(shear(vertices, ray), kCellLanes[kShape],
                                                 edge_error(ray.shear_error, extent));
}

HWY_INLINE std::uint32_t loose_triangles_near(const TreeView& view, std::uint32_t leaf, const CullingRay& ray,
                                              float extent) {
  const std::vector<std::uint32_t>& loose = view.tree->loose;
  const std::size_t first = std::size_t{kWidth} * leaf;
  const auto count = static_cast<std::uint32_t>(std::min<std::size_t>(kWidth, loose.size() - first));
  alignas(64) float vertices[3][3][kWidth];  // by corner and sheared axis
  for (std::uint32_t lane = 0; lane < kWidth; ++lane) {
    const sweep::Triangle& triangle = view.mesh->triangles[loose[first + std::min(lane, count - 1)]];
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const float* const p = glm::value_ptr(view.mesh->positions[triangle[corner]]);
      for (std::size_t k = 0; k < 3; ++k) vertices[corner][k][lane] = p[ray.axes[k]];
    }
  }
  Sheared corners[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const Lanes loaded[3] = {load(vertices[k][0]), load(vertices[k][1]), load(vertices[k][2])};
    corners[k] = shear(loaded, ray);
  }
  const std::uint32_t near = may_agree(edge(corners[0], corners[1]), edge(corners[1], corners[2]),
                                       edge(corners[2], corners[0]), edge_error(ray.shear_error, extent));
  return near & ((1u << count) - 1);
}

}  // namespace sweepkit::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
