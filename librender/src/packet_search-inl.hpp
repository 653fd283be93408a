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

#include "exact_test-inl.hpp"
#include "sweep_search-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sweepkit::render::HWY_NAMESPACE {

/// Coordinates count from `middle`, a point of the mesh's box that the rays go by; so rounding is relative to
/// the mesh and not to a far eye.
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
  float middle[3];
  float shear_error;
  // By ray: at z the ray's x and y are offset + slope * z.
  alignas(64) float offsets[2][kWidth];
  alignas(64) float slopes[2][kWidth];
  alignas(64) float inverses[2][kWidth];
  alignas(64) float limits[kWidth];    // z
  alignas(64) double lengths[kWidth];  // z of the direction
  ExactRays exact;
  std::uint32_t are_exact;  // bit by ray: follows z most, so that ShearedRay's axes are these
  double before;            // z from the origin to `middle`
  double slack;

  float limit(std::uint32_t ray, double t) const {
    return static_cast<float>(std::min(t * lengths[ray] - before + slack, 0x1p100));
  }
};

// Rays that go apart more than this, z for z, are better off alone.
inline constexpr float kWidestPacket = 0.25F;
// An origin so far away, in units of the mesh's reach, that the bounds for double would hide the mesh.
inline constexpr double kFarthestOrigin = 16;

/// False where the rays are better off, or only right, alone.
HWY_INLINE bool make_packet(const TreeView& view, std::span<const Ray> rays, std::span<const Hit> best,
                            Packet& packet) {
  const BoxTree& tree = *view.tree;
  const double* const origin = glm::value_ptr(rays.front().origin);
  const double* const center = glm::value_ptr(rays[rays.size() / 2].direction);
  const double size[3] = {std::abs(center[0]), std::abs(center[1]), std::abs(center[2])};
  const int z = size[0] > size[1] ? (size[0] > size[2] ? 0 : 2) : (size[1] > size[2] ? 1 : 2);
  const int x = (z + 1) % 3;
  const int y = (x + 1) % 3;
  const double farthest = std::max({std::abs(origin[0]), std::abs(origin[1]), std::abs(origin[2])});
  if (!(farthest <= kFarthestOrigin * tree.reach)) return false;
  const double sense = center[z] < 0 ? -1 : 1;

  packet.count = static_cast<std::uint32_t>(rays.size());
  packet.sense = static_cast<float>(sense);
  packet.axes[0] = x;
  packet.axes[1] = y;
  packet.axes[2] = z;
  alignas(64) double directions[2][kWidth];
  for (std::uint32_t i = 0; i < kWidth; ++i) {
    const double* const d = glm::value_ptr(rays[i < packet.count ? i : 0].direction);  // operator[] branches
    directions[0][i] = d[x];
    directions[1][i] = d[y];
    packet.lengths[i] = sense * d[z];
  }

  // Where the rays come to the box, or in it where they begin. The corners of the box are float32.
  const double* const low_corner = glm::value_ptr(tree.box.low);
  const double* const high_corner = glm::value_ptr(tree.box.high);
  const auto in_box = [&](int axis, double at) {
    return static_cast<float>(std::min(std::max(at, low_corner[axis]), high_corner[axis]));
  };
  const double z_begin = sense > 0 ? std::max(origin[z], low_corner[z]) : std::min(origin[z], high_corner[z]);
  packet.middle[2] = in_box(z, z_begin);
  packet.before = sense * (static_cast<double>(packet.middle[2]) - origin[z]);
  const double along = packet.before / size[z];
  for (int k = 0; k < 2; ++k) {
    const int axis = packet.axes[k];
    packet.middle[k] = in_box(axis, origin[axis] + along * center[axis]);
  }

  const RayTag tag;
  const auto one = hn::Set(tag, 1.0);
  const auto before = hn::Set(tag, packet.before);
  const auto least_length = hn::Set(tag, 0x1p-60);
  const auto greatest_length = hn::Set(tag, 0x1p60);
  const auto steepest = hn::Set(tag, 2.0);
  bool are_good = true;
  packet.are_exact = 0;
  // ShearedRay's x and y change places where z is followed backward.
  const int turned[2] = {sense < 0 ? 1 : 0, sense < 0 ? 0 : 1};
  packet.exact.origin[0] = origin[packet.axes[turned[0]]];
  packet.exact.origin[1] = origin[packet.axes[turned[1]]];
  packet.exact.origin[2] = origin[z];
  const auto signed_one = hn::Set(tag, sense);
  for (std::size_t from = 0; from < kWidth; from += kRayLanes) {
    const auto length = hn::Load(tag, packet.lengths + from);
    auto is_good = hn::And(hn::Ge(length, least_length), hn::Le(length, greatest_length));
    hn::Store(hn::Div(signed_one, length), tag, packet.exact.scales + from);
    auto is_exact = is_good;
    for (int k = 0; k < 2; ++k) {
      const auto slope = hn::Div(hn::Load(tag, directions[k] + from), length);
      hn::Store(hn::Mul(slope, signed_one), tag, packet.exact.shears[turned[k]] + from);
      is_exact = hn::And(is_exact, hn::Lt(hn::Abs(slope), one));
      // What lies more across z than twice along it is not good, nor what is no number.
      is_good = hn::And(is_good, hn::Le(hn::Abs(slope), steepest));
      const auto start = hn::Set(tag, origin[packet.axes[k]] - static_cast<double>(packet.middle[k]));
      const hn::Rebind<float, RayTag> floats;
      hn::Store(hn::DemoteTo(floats, slope), floats, packet.slopes[k] + from);
      hn::Store(hn::DemoteTo(floats, hn::Add(start, hn::Mul(slope, before))), floats,
                packet.offsets[k] + from);
    }
    are_good = are_good && hn::AllTrue(tag, is_good);
    packet.are_exact |= bits_of_rays(is_exact) << from;
  }
  if (!are_good) return false;
  float low[2];
  float high[2];
  for (int k = 0; k < 2; ++k) {
    const Lanes slopes = load(packet.slopes[k]);
    const Lanes sizes = max(slopes, set(0) - slopes);
    // A slope of less than 2u is as good as one of 2u: it moves nothing by more than the boxes are enlarged.
    store(copy_sign(set(1) / max(sizes, set(0x1p-23F)), slopes), packet.inverses[k]);
    low[k] = -greatest(set(0) - slopes);
    high[k] = greatest(slopes);
  }
  if (high[0] - low[0] > kWidestPacket || high[1] - low[1] > kWidestPacket) return false;

  // As in reach(), twice as wide, since slopes are up to 2.
  const double error = 0x1p-44 * (farthest + tree.reach);
  const double moved = kFloatRounding * (48 * tree.extent + 2 * tree.reach) + error;
  packet.moved = static_cast<float>(moved);
  packet.slack = 4 * moved;
  packet.shear_error = static_cast<float>(20 * kFloatRounding * tree.extent + error);
  const auto low_plane = [](int axis) { return kWidth * static_cast<std::uint32_t>(axis); };
  const auto high_plane = [&](int axis) { return low_plane(axis) + 3 * kWidth; };
  packet.z_near = sense > 0 ? low_plane(z) : high_plane(z);
  packet.z_far = sense > 0 ? high_plane(z) : low_plane(z);
  packet.z_shift = -packet.sense * packet.middle[2];
  const double around = 4 * moved + 48 * kFloatRounding * tree.reach;
  for (int k = 0; k < 2; ++k) {
    const int axis = packet.axes[k];
    packet.plane[k][0] = high_plane(axis);
    packet.plane[k][1] = low_plane(axis);
    // The corner farthest on the inner side of each plane.
    packet.z_plane[k][0] = low[k] >= 0 ? packet.z_near : packet.z_far;
    packet.z_plane[k][1] = high[k] >= 0 ? packet.z_far : packet.z_near;
    const Lanes offsets = load(packet.offsets[k]);
    const float slopes[2] = {low[k], high[k]};
    const float sides[2] = {-greatest(set(0) - offsets), greatest(offsets)};
    for (int side = 0; side < 2; ++side) {
      packet.slope[k][side] = -slopes[side] * packet.sense;
      const double bound = static_cast<double>(packet.middle[k]) + static_cast<double>(sides[side]) +
                           static_cast<double>(packet.slope[k][side]) * static_cast<double>(packet.middle[2]);
      packet.bound[k][side] = static_cast<float>(bound + (side == 0 ? -around : around));
    }
  }
  // Where there is no ray nothing is before its end.
  alignas(64) double ends[kWidth];
  for (std::uint32_t i = 0; i < kWidth; ++i) ends[i] = i < packet.count ? best[i].t : -0x1p200;
  const auto added = hn::Set(tag, packet.slack - packet.before);
  const auto farthest_limit = hn::Set(tag, 0x1p100);
  for (std::size_t from = 0; from < kWidth; from += kRayLanes) {
    const auto end = hn::Mul(hn::Load(tag, ends + from), hn::Load(tag, packet.lengths + from));
    const auto limit = hn::Max(hn::Min(hn::Add(end, added), farthest_limit), hn::Neg(farthest_limit));
    const hn::Rebind<float, RayTag> floats;
    hn::Store(hn::DemoteTo(floats, limit), floats, packet.limits + from);
  }
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
    const Lanes offsets = load(packet.offsets[k]);
    const Lanes a = (set(planes[axis] - packet.middle[k] - packet.moved) - offsets) * inverse;
    const Lanes b = (set(planes[axis + 3 * kWidth] - packet.middle[k] + packet.moved) - offsets) * inverse;
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
  Survivors survivors;

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
        const Corners corners[3] = {to_look_up(p[packet.sense < 0 ? 1 : 0]),
                                    to_look_up(p[packet.sense < 0 ? 0 : 1]), to_look_up(p[2])};
        for (int k = 0; k < 3; ++k) p[k] = p[k] - set(packet.middle[k]);
        p[2] = p[2] * set(packet.sense);
        survivors.count = 0;
        const std::uint32_t others = packet.are_exact == 0xFFFF ? 0 : ~0u;
        for (; active != 0; active &= active - 1) {
          const auto i = static_cast<std::uint32_t>(std::countr_zero(active));
          const Sheared turned = {
              multiply_add(p[2], set(-packet.slopes[0][i]), p[0] - set(packet.offsets[0][i])),
              multiply_add(p[2], set(-packet.slopes[1][i]), p[1] - set(packet.offsets[1][i]))};
          survivors.add(i, cell_triangles_near<kBlock.columns + 1>(turned, kCellLanes[kShape], error));
        }
        for (std::uint32_t from = 0; from < survivors.count; from += kRayLanes) {
          ExactHits hits;
          test_exactly<kBlock.columns + 1>(corners, grid.is_turned, packet.exact, survivors, from, hits);
          const std::uint32_t end = std::min(survivors.count - from, std::uint32_t{kRayLanes});
          std::uint32_t left = (hits.are_hits | hits.are_unsure | others) & ((1u << end) - 1);
          for (; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::uint32_t>(std::countr_zero(left));
            const auto i = static_cast<std::uint32_t>(survivors.rays[from + lane]);
            const auto bit = static_cast<std::uint32_t>(survivors.bits[from + lane]);
            if ((hits.are_hits >> lane & packet.are_exact >> i & 1) != 0) {
              if (!(hits.t[lane] <= best[i].t)) continue;
              is_found |= keep(i, triangle_of<kShape>(grid, leaf, bit).index,
                               {.t = hits.t[lane],
                                .a = hits.weights[0][lane],
                                .b = hits.weights[1][lane],
                                .c = hits.weights[2][lane]});
            } else {
              is_found |= take(i, triangle_of<kShape>(grid, leaf, bit));
            }
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
    const auto& positions = view.mesh->positions;
    const auto& [a, b, c] = triangle.vertices;
    Hit found;
    return ShearedRay(rays[i]).meets(positions[a], positions[b], positions[c], best[i].t, found) &&
           keep(i, triangle.index, found);
  }
  HWY_INLINE bool keep(std::uint32_t i, std::uint32_t triangle, const Hit& found) {
    if (rays[i].leaves(view.object, triangle)) return false;
    keep_nearer(best[i], found, view.object, triangle);
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
