// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace sweepkit::texmap {

/// A triangle list with (u,v) at its vertices, as plain arrays. Precondition: indices inside both.
struct MappedSurface {
  std::span<const glm::vec3> positions;  ///< metres
  std::span<const glm::vec2> texcoords;
  std::span<const std::array<std::uint32_t, 3>> triangles;
};

/// How the map from the texture to one triangle, which is affine, lengthens a step along each principal axis
/// of the texture, as [BierSloan86] and section 2.2 of the paper measure a mapping by. A triangle without
/// area in (u,v) is reached by no step: its arcs are infinite.
struct TriangleDistortion {
  double u_arc = 0;    ///< |dP/du|: metres on the surface a unit of u
  double v_arc = 0;    ///< |dP/dv|
  double area = 0;     ///< of the surface, square metres
  double uv_area = 0;  ///< signed: negative where the texture is mirrored

  /// The larger arc of two perpendicular steps over the smaller, at least 1; infinite where one has none.
  double aspect_ratio() const;
};

std::vector<TriangleDistortion> find_distortion(const MappedSurface& surface);

/// A number over all triangles, each weighted by its surface area.
struct Spread {
  double mean = 1;
  double median = 1;
  double percentile_95 = 1;
  double worst = 1;  ///< of any triangle of positive area
};

/// The distortion of a whole mapping. All ratios are at least 1, and 1 is best.
struct Distortion {
  /// Homogeneity of resolution [BierSloan86]: along each axis, the largest arc of a step over the smallest.
  double u_homogeneity = 1;
  double v_homogeneity = 1;
  /// The same between the percentiles 2.5 and 97.5 by area, which one bad triangle does not spoil.
  double u_homogeneity_95 = 1;
  double v_homogeneity_95 = 1;
  Spread aspect_ratio;
  /// Texels a square metre, over those where they are fewest, percentiles 97.5 and 2.5 by area.
  double density_95 = 1;
  double area = 0;  ///< square metres
  std::size_t degenerate_triangles =
      0;  ///< with surface area but without area in (u,v); not in the ratios' percentiles
  std::size_t mirrored_triangles = 0;
};

/// Sums up. Triangles without surface area do not count.
Distortion summarize(std::span<const TriangleDistortion> triangles);

/// The arcs of one triangle against those of the whole: the larger of u_arc and v_arc, each over or under its
/// own area-weighted geometric mean, whichever is above 1. 1 everywhere on a homogeneous mapping.
std::vector<double> find_inhomogeneity(std::span<const TriangleDistortion> triangles);

/// Edges that two triangles share (corners of equal position are one place), and those of them with the same
/// (u,v) on both sides.
struct EdgeContinuity {
  std::size_t interior_edges = 0;
  std::size_t continuous_edges = 0;
};
EdgeContinuity count_continuous_edges(const MappedSurface& surface);

/// The share of the (u,v) area covered by the mapping that more than one triangle covers, 0 to 1, counted at
/// the middles of kOverlapSide x kOverlapSide cells over its bounding box. Triangles that share an edge do
/// not overlap there.
inline constexpr int kOverlapSide = 1024;
double find_overlap(const MappedSurface& surface);

}  // namespace sweepkit::texmap
