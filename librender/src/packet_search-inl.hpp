// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The search for up to 16 rays of one origin. For inclusion once an instruction set, as lanes-inl.hpp.
//
// Nodes are tested against the pyramid about all of the rays, a lane a child; a leaf's box against the rays,
// a lane each; its triangles against every ray that is left, a lane a vertex. Symbols: axes[2], z here, is
// the axis that the rays follow most; z counts from the origin in their sense; slopes are x and y for each z.

#if defined(SWEEPKIT_PACKET_SEARCH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWEEPKIT_PACKET_SEARCH_INL
#undef SWEEPKIT_PACKET_SEARCH_INL
#else
#define SWEEPKIT_PACKET_SEARCH_INL
#endif

#include <cstddef>
#include <memory>

#include "sweep_search-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sweepkit::render::HWY_NAMESPACE {

struct Packet {
  std::uint32_t count;
  int axes[3];
  float sense;  // of z: 1 or -1
  // Of the pyramid: x - slope * z of a box's corner is compared with a bound. First the sides of least x and
  // y, then those of greatest. `z_plane` and `plane` are floats from a node's start.
  float slope[2][2];
  float bound[2][2];
  std::uint32_t plane[2][2];
  std::uint32_t z_plane[2][2];
  std::uint32_t z_near;
  std::uint32_t z_far;
  float z_shift;  // z = sense * plane + z_shift
  float moved;    // by how much boxes are enlarged
  float origin[3];
  float lost[3];
  float shear_error;
  // By ray.
  alignas(64) float slopes[2][kWidth];
  alignas(64) float inverses[2][kWidth];
  alignas(64) float limits[kWidth];  // z
  double lengths[kWidth];            // z of the direction
  double slack;

  float limit(std::uint32_t ray, double t) const {
    return static_cast<float>(std::min(t * lengths[ray] + slack, 0x1p100));
  }
};

// Rays that go apart more than this, z for z, are better off alone.
inline constexpr float kWidestPacket = 0.25F;
// An origin so far away, in units of the mesh's reach, that float32 hides too much of the mesh.
inline constexpr double kFarthestOrigin = 16;

/// False where the rays are better off, or only right, alone.
HWY_INLINE bool make_packet(const TreeView& view, std::span<const Ray> rays, std::span<const Hit> best,
                            Packet& packet) {
  const BoxTree& tree = *view.tree;
  const glm::dvec3 origin = rays.front().origin;
  const glm::dvec3 middle = rays[rays.size() / 2].direction;
  const glm::dvec3 size = glm::abs(middle);
  const int z = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  const int x = (z + 1) % 3;
  const int y = (x + 1) % 3;
  const double farthest = std::max({std::abs(origin.x), std::abs(origin.y), std::abs(origin.z)});
  if (!(farthest <= kFarthestOrigin * tree.reach)) return false;
  const double sense = middle[z] < 0 ? -1 : 1;

  packet.count = static_cast<std::uint32_t>(rays.size());
  alignas(64) float directions[3][kWidth];
  double largest = 0;
  for (std::uint32_t i = 0; i < kWidth; ++i) {
    const double* const d = glm::value_ptr(rays[i < packet.count ? i : 0].direction);  // operator[] branches
    largest = std::max({largest, std::abs(d[x]), std::abs(d[y]), std::abs(d[z])});
    directions[0][i] = static_cast<float>(d[x]);
    directions[1][i] = static_cast<float>(d[y]);
    directions[2][i] = static_cast<float>(sense * d[z]);
    packet.lengths[i] = sense * d[z];
  }
  const Lanes lengths = load(directions[2]);
  std::uint32_t are_good = less_equal(set(0x1p-60F), lengths) & less_equal(lengths, set(0x1p60F));
  float low[2];
  float high[2];
  for (int k = 0; k < 2; ++k) {
    const Lanes slopes = load(directions[k]) / lengths;
    const Lanes sizes = max(slopes, set(0) - slopes);
    // What lies more across z than twice along it is not good, nor what is no number.
    are_good &= less_equal(sizes, set(2));
    store(slopes, packet.slopes[k]);
    // A slope of less than 2u is as good as one of 2u: it moves nothing by more than the boxes are enlarged.
    store(copy_sign(set(1) / max(sizes, set(0x1p-23F)), slopes), packet.inverses[k]);
    low[k] = -greatest(set(0) - slopes);
    high[k] = greatest(slopes);
  }
  if (are_good != 0xFFFF || !(largest < 0x1p60) || high[0] - low[0] > kWidestPacket ||
      high[1] - low[1] > kWidestPacket) {
    return false;
  }

  // As in reach(): 24u of where boxes and origin lie, and what double rounds; slopes up to 2.
  const double error = 0x1p-44 * (farthest + tree.reach);
  const double moved = 48 * kFloatRounding * (tree.reach + farthest) + error;
  packet.moved = static_cast<float>(moved);
  packet.slack = 4 * moved;
  packet.sense = static_cast<float>(sense);
  packet.axes[0] = x;
  packet.axes[1] = y;
  packet.axes[2] = z;
  for (int k = 0; k < 3; ++k) {
    const double at = origin[packet.axes[k]];
    packet.origin[k] = static_cast<float>(at);
    packet.lost[k] = static_cast<float>(static_cast<double>(packet.origin[k]) - at);
  }
  const auto low_plane = [](int axis) { return kWidth * static_cast<std::uint32_t>(axis); };
  const auto high_plane = [&](int axis) { return low_plane(axis) + 3 * kWidth; };
  packet.z_near = sense > 0 ? low_plane(z) : high_plane(z);
  packet.z_far = sense > 0 ? high_plane(z) : low_plane(z);
  packet.z_shift = static_cast<float>(-sense * origin[z]);
  for (int k = 0; k < 2; ++k) {
    const int axis = packet.axes[k];
    packet.plane[k][0] = high_plane(axis);
    packet.plane[k][1] = low_plane(axis);
    // The corner farthest on the inner side of each plane.
    packet.z_plane[k][0] = low[k] >= 0 ? packet.z_near : packet.z_far;
    packet.z_plane[k][1] = high[k] >= 0 ? packet.z_far : packet.z_near;
    const float slopes[2] = {low[k], high[k]};
    for (int side = 0; side < 2; ++side) {
      packet.slope[k][side] = -slopes[side] * packet.sense;
      const double bound = origin[axis] + static_cast<double>(packet.slope[k][side]) * origin[z];
      packet.bound[k][side] = static_cast<float>(bound + (side == 0 ? -4 * moved : 4 * moved));
    }
  }
  double across = tree.extent;
  for (int axis = 0; axis < 3; ++axis)
    across += std::abs(origin[axis] - 0.5 * (tree.box.low[axis] + tree.box.high[axis]));
  packet.shear_error = static_cast<float>(20 * kFloatRounding * across + error);
  // Where there is no ray nothing is before its end.
  for (std::uint32_t i = 0; i < kWidth; ++i)
    packet.limits[i] = i < packet.count ? packet.limit(i, best[i].t) : -1;
  return true;
}

/// The children whose boxes reach into the pyramid between 0 and z = `limit`, and where they begin.
HWY_INLINE std::uint32_t passed(const BoxNode& node, const Packet& packet, float limit, Lanes& enter) {
  const float* planes = node.low[0];
  const Lanes sense = set(packet.sense);
  const Lanes near = multiply_add(load(planes + packet.z_near), sense, set(packet.z_shift));
  const Lanes far = multiply_add(load(planes + packet.z_far), sense, set(packet.z_shift));
  enter = max(near - set(packet.moved), set(0.0F));
  std::uint32_t bits = less_equal(enter, min(far + set(packet.moved), set(limit)));
  for (int k = 0; k < 2; ++k) {
    const Lanes least = multiply_add(load(planes + packet.z_plane[k][0]), set(packet.slope[k][0]),
                                     load(planes + packet.plane[k][0]));
    const Lanes most = multiply_add(load(planes + packet.z_plane[k][1]), set(packet.slope[k][1]),
                                    load(planes + packet.plane[k][1]));
    bits &= less_equal(set(packet.bound[k][0]), least) & less_equal(most, set(packet.bound[k][1]));
  }
  return bits;
}

/// The rays that pass a child's box before their ends.
HWY_INLINE std::uint32_t rays_through(const BoxNode& node, std::uint32_t child, const Packet& packet) {
  const float* planes = node.low[0] + child;
  const float z[2] = {planes[packet.z_near] * packet.sense + packet.z_shift - packet.moved,
                      planes[packet.z_far] * packet.sense + packet.z_shift + packet.moved};
  Lanes enter = set(std::max(z[0], 0.0F));
  Lanes leave = min(set(z[1]), load(packet.limits));
  for (int k = 0; k < 2; ++k) {
    const std::uint32_t axis = kWidth * static_cast<std::uint32_t>(packet.axes[k]);
    const Lanes inverse = load(packet.inverses[k]);
    const Lanes a = set(planes[axis] - packet.origin[k] - packet.moved) * inverse;
    const Lanes b = set(planes[axis + 3 * kWidth] - packet.origin[k] + packet.moved) * inverse;
    enter = max(enter, min(a, b));
    leave = min(leave, max(a, b));
  }
  return less_equal(enter, leave);
}

/// What a search through the tree asks of a packet: the same as of a ray.
struct PacketVisitor {
  const TreeView& view;
  std::span<const Ray> rays;
  std::span<Hit> best;
  Packet& packet;
  std::uint32_t are_sheared = 0;  // bit by ray: only rays that come near a triangle are
  alignas(ShearedRay) std::byte sheared[kWidth][sizeof(ShearedRay)];

  PacketVisitor(const TreeView& in, std::span<const Ray> some, std::span<Hit> hits, Packet& p)
      : view(in), rays(some), best(hits), packet(p) {}

  HWY_INLINE float limit() const { return greatest(load(packet.limits)); }
  HWY_INLINE bool is_over() const { return false; }
  HWY_INLINE std::uint32_t passed_children(const BoxNode& node, float limit, Lanes& enter) const {
    return passed(node, packet, limit, enter);
  }
  HWY_INLINE void prefetch_leaves(const Level&, const Place&, std::uint32_t) const {}
  HWY_INLINE bool visit_leaf(const Level& level, const BoxNode& node, std::uint32_t child, std::uint32_t x,
                             std::uint32_t y) {
    std::uint32_t active = rays_through(node, child, packet);
    if (active == 0) return false;
    bool is_found = false;
    const BoxTree& tree = *view.tree;
    if (level.children == Level::Children::kGridLeaves) {
      const LeafGrid& grid = tree.grids[level.grid];
      const float error = edge_error(packet.shear_error, 3 * extent_of(node, child));
      with_shape(grid.shape, [&]<std::uint32_t kShape>() HWY_ATTR {
        constexpr LeafShape kBlock = kLeafShapes[kShape];
        const GridLeaf leaf = grid_leaf<kShape>(grid, x, y);
        Lanes p[3];
        load_vertices<kBlock.columns, kBlock.rows>(leaf_start(view, grid, leaf), grid, packet.axes, p);
        for (int k = 0; k < 3; ++k) p[k] = p[k] - set(packet.origin[k]) + set(packet.lost[k]);
        p[2] = p[2] * set(packet.sense);
        for (; active != 0; active &= active - 1) {
          const auto i = static_cast<std::uint32_t>(std::countr_zero(active));
          const Sheared turned = {multiply_add(p[2], set(-packet.slopes[0][i]), p[0]),
                                  multiply_add(p[2], set(-packet.slopes[1][i]), p[1])};
          std::uint32_t bits = cell_triangles_near<kBlock.columns + 1>(turned, kCellLanes[kShape], error);
          for (; bits != 0; bits &= bits - 1) {
            const auto bit = static_cast<std::uint32_t>(std::countr_zero(bits));
            is_found |= take(i, triangle_of<kShape>(grid, leaf, bit));
          }
        }
      });
      return is_found;
    }
    const std::size_t end = std::min(tree.loose.size(), std::size_t{kWidth} * (x + 1));
    for (; active != 0; active &= active - 1) {
      for (std::size_t k = std::size_t{kWidth} * x; k < end; ++k) {
        const std::uint32_t index = tree.loose[k];
        is_found |=
            take(static_cast<std::uint32_t>(std::countr_zero(active)), {index, view.mesh->triangles[index]});
      }
    }
    return is_found;
  }
  HWY_INLINE bool take(std::uint32_t i, const LeafTriangle& triangle) {
    auto* ray = reinterpret_cast<ShearedRay*>(sheared[i]);
    if ((are_sheared >> i & 1) == 0) {
      std::construct_at(ray, rays[i]);
      are_sheared |= 1u << i;
    }
    NearestSearch search{best[i]};
    if (!test(view, rays[i], *ray, triangle, search)) return false;
    // All of them stored again: a load across a store of one would wait for it to reach the cache.
    store(with_lane(load(packet.limits), i, packet.limit(i, best[i].t)), packet.limits);
    return true;
  }
};

inline void find_nearest_packet(const TreeView& view, std::span<const Ray> rays, std::span<Hit> best) {
  Packet packet;
  if (!make_packet(view, rays, best, packet)) {
    for (std::size_t i = 0; i < rays.size(); ++i) find_nearest(view, rays[i], best[i]);
    return;
  }
  PacketVisitor visitor(view, rays, best, packet);
  search_tree(*view.tree, visitor);
}

}  // namespace sweepkit::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
