// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Which triangles of a leaf a ray may meet, 16 lanes at once. For inclusion once an instruction set, as
// lanes-inl.hpp.
//
// Symbols: a lane holds vertex P = (i, j) of the leaf's block; Q = (i+1, j) is the next lane, R = (i, j+1) the
// one a row further; S = (i+1, j+1). P x Q is the edge function of the ray (the origin, after shearing) and
// the edge from P to Q. So every edge is looked at once, by the same numbers for both of its triangles.

#if defined(SWEEPKIT_LEAF_TEST_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWEEPKIT_LEAF_TEST_INL
#undef SWEEPKIT_LEAF_TEST_INL
#else
#define SWEEPKIT_LEAF_TEST_INL
#endif

#include "box_tree.hpp"
#include "culling_ray.hpp"
#include "lanes-inl.hpp"
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
HWY_INLINE GridLeaf grid_leaf(const LeafGrid& grid, std::uint32_t x, std::uint32_t y) {
  const auto [columns, rows] = kLeafShapes[grid.shape];
  return {std::min(x * columns, grid.columns - columns), std::min(y * rows, grid.rows - rows)};
}

struct LeafTriangle {
  std::uint32_t index;
  sweep::Triangle vertices;
};

/// Bit `lane` is the triangle (R, P, Q) of the cell at lane's vertex, bit 16 + lane its (Q, S, R).
HWY_INLINE LeafTriangle triangle_of(const LeafGrid& grid, const GridLeaf& leaf, std::uint32_t bit) {
  const std::uint32_t lane = bit & 15;
  const std::uint32_t wide = kLeafShapes[grid.shape].columns + 1;
  const std::uint32_t i = leaf.column + lane % wide;
  const std::uint32_t j = leaf.row + lane / wide;
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
HWY_INLINE float edge_error(const CullingRay& ray, float extent) {
  const float farthest = extent + 2 * ray.shear_error;
  return ray.shear_error * (8 * farthest + 2 * ray.shear_error);
}

struct Sheared {
  Lanes x;
  Lanes y;
};

HWY_INLINE Sheared shear(const Lanes& x, const Lanes& y, const Lanes& z, const CullingRay& ray) {
  const Lanes dx = x - set(ray.origin[0]);
  const Lanes dy = y - set(ray.origin[1]);
  const Lanes dz = z - set(ray.origin[2]);
  Lanes sheared[2];
  for (int k = 0; k < 2; ++k) {
    sheared[k] = multiply_add(dx, set(ray.across[k][0]), set(ray.correction[k]));
    sheared[k] = multiply_add(dy, set(ray.across[k][1]), sheared[k]);
    sheared[k] = multiply_add(dz, set(ray.across[k][2]), sheared[k]);
  }
  return {sheared[0], sheared[1]};
}

/// The edge function of the edge from a to b.
HWY_INLINE Lanes edge(const Sheared& a, const Sheared& b) { return difference_of_products(a.x, b.y, a.y, b.x); }

/// Bits of the lanes where all three may have one sign.
HWY_INLINE std::uint32_t may_agree(const Lanes& u, const Lanes& v, const Lanes& w, float error) {
  return ~less_and_greater(min(min(u, v), w), set(-error), max(max(u, v), w), set(error));
}

/// Lane k + `step` in lane k; what is shifted in at the end is of no use.
HWY_INLINE Lanes later(const Lanes& lanes, std::uint32_t step) {
  alignas(64) float buffer[2 * kWidth];
  store(lanes, buffer);
  store(lanes, buffer + kWidth);
  return load(buffer + step);
}

HWY_INLINE std::uint32_t triangles_near(const TreeView& view, const LeafGrid& grid, const GridLeaf& leaf,
                                        const CullingRay& ray, float extent) {
  const float* from =
      &view.mesh->positions[grid.first_vertex + std::size_t{leaf.row} * grid.stride + leaf.column].x;
  const std::int32_t* offsets = grid.offsets.data();
  const std::uint32_t row = kLeafShapes[grid.shape].columns + 1;
  const Sheared p = shear(gather(from, offsets), gather(from + 1, offsets), gather(from + 2, offsets), ray);
  const Sheared q = {later(p.x, 1), later(p.y, 1)};
  const Sheared r = {later(p.x, row), later(p.y, row)};
  const Lanes pq = edge(p, q);
  const Lanes rp = edge(r, p);
  const Lanes qr = edge(q, r);
  const float error = edge_error(ray, extent);
  const std::uint32_t lower = may_agree(pq, rp, qr, error);
  // (Q, S, R) turned round, as (R, S, Q): the same signs, all of them other.
  const std::uint32_t upper = may_agree(later(pq, row), later(rp, 1), qr, error);
  const std::uint32_t cells = kCellLanes[grid.shape];
  return (lower & cells) | (upper & cells) << 16;
}

HWY_INLINE std::uint32_t loose_triangles_near(const TreeView& view, std::uint32_t leaf, const CullingRay& ray,
                                              float extent) {
  const std::vector<std::uint32_t>& loose = view.tree->loose;
  const std::size_t first = std::size_t{kWidth} * leaf;
  const auto count = static_cast<std::uint32_t>(std::min<std::size_t>(kWidth, loose.size() - first));
  alignas(64) float vertices[3][3][kWidth];
  for (std::uint32_t lane = 0; lane < kWidth; ++lane) {
    const sweep::Triangle& triangle = view.mesh->triangles[loose[first + std::min(lane, count - 1)]];
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const glm::vec3& p = view.mesh->positions[triangle[corner]];
      for (glm::length_t axis = 0; axis < 3; ++axis) vertices[corner][axis][lane] = p[axis];
    }
  }
  Sheared corners[3];
  for (std::size_t k = 0; k < 3; ++k)
    corners[k] = shear(load(vertices[k][0]), load(vertices[k][1]), load(vertices[k][2]), ray);
  const std::uint32_t near = may_agree(edge(corners[0], corners[1]), edge(corners[1], corners[2]),
                                       edge(corners[2], corners[0]), edge_error(ray, extent));
  return near & ((1u << count) - 1);
}

}  // namespace sweepkit::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
