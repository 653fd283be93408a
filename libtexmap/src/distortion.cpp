// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on the two measures of [BierSloan86, Two-part texture mapping, "Evaluating a mapping"] as [Akdemir98,
// section 2.2] words them. Departs from them in that they are read off the map's derivatives, which are
// constant on a triangle, and not from steps that are measured here and there; and in the percentiles by
// area, since the largest ratio of a surface with a pole says no more than how small its last triangle is.
//
// Symbols: P position, d1, d2 the (u,v) of a triangle's corners 1 and 2 from corner 0, e1, e2 their positions
// from there. P(u,v) is linear, so e1 = d1.u Pu + d1.v Pv, e2 = d2.u Pu + d2.v Pv, solved for Pu and Pv.

#include "sweepkit/texmap/distortion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "triangle_edges.hpp"
#include "uv_raster.hpp"

namespace sweepkit::texmap {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool is_mapped(const TriangleDistortion& t) {
  return t.area > 0 && t.uv_area != 0;
}

// The values below which given shares of the surface's area lie.
class ByArea {
 public:
  template <class Value>
  ByArea(std::span<const TriangleDistortion> triangles, Value&& value) {
    for (const TriangleDistortion& t : triangles) {
      if (!is_mapped(t)) continue;
      values_.push_back({value(t), t.area});
      area_ += t.area;
    }
    std::sort(values_.begin(), values_.end(), [](const Weighted& a, const Weighted& b) {
      return a.value != b.value ? a.value < b.value : a.area < b.area;
    });
  }

  double percentile(double share) const {
    double below = 0;
    for (const Weighted& v : values_) {
      below += v.area;
      if (below >= share * area_) return v.value;
    }
    return values_.empty() ? 1 : values_.back().value;
  }
  double lowest() const { return values_.empty() ? 1 : values_.front().value; }
  double highest() const { return values_.empty() ? 1 : values_.back().value; }
  double mean() const {
    double sum = 0;
    for (const Weighted& v : values_) sum += v.area / area_ * v.value;
    return values_.empty() ? 1 : sum;
  }
  /// Of the middle 95 % of the area.
  double ratio_95() const { return percentile(0.975) / percentile(0.025); }

 private:
  struct Weighted {
    double value, area;
  };
  std::vector<Weighted> values_;
  double area_ = 0;
};

}  // namespace

double TriangleDistortion::aspect_ratio() const {
  const double least = std::min(u_arc, v_arc);
  if (uv_area == 0 || !(least > 0)) return kInfinity;
  return std::max(u_arc, v_arc) / least;
}

std::vector<TriangleDistortion> find_distortion(const MappedSurface& surface) {
  std::vector<TriangleDistortion> all;
  all.reserve(surface.triangles.size());
  for (const auto& [a, b, c] : surface.triangles) {
    const glm::dvec3 e1 = glm::dvec3(surface.positions[b]) - glm::dvec3(surface.positions[a]);
    const glm::dvec3 e2 = glm::dvec3(surface.positions[c]) - glm::dvec3(surface.positions[a]);
    const glm::dvec2 d1 = glm::dvec2(surface.texcoords[b]) - glm::dvec2(surface.texcoords[a]);
    const glm::dvec2 d2 = glm::dvec2(surface.texcoords[c]) - glm::dvec2(surface.texcoords[a]);
    const double whole = d1.x * d2.y - d1.y * d2.x;
    TriangleDistortion t{kInfinity, kInfinity, 0.5 * glm::length(glm::cross(e1, e2)), 0.5 * whole};
    if (whole != 0) {
      t.u_arc = glm::length(d2.y * e1 - d1.y * e2) / std::abs(whole);
      t.v_arc = glm::length(d1.x * e2 - d2.x * e1) / std::abs(whole);
    }
    all.push_back(t);
  }
  return all;
}

Distortion summarize(std::span<const TriangleDistortion> triangles) {
  Distortion d;
  for (const TriangleDistortion& t : triangles) {
    d.area += t.area;
    if (t.area > 0 && t.uv_area == 0) ++d.degenerate_triangles;
    if (t.area > 0 && t.uv_area < 0) ++d.mirrored_triangles;
  }
  const ByArea u(triangles, [](const TriangleDistortion& t) { return t.u_arc; });
  d.u_homogeneity = u.highest() / u.lowest();
  d.u_homogeneity_95 = u.ratio_95();
  const ByArea v(triangles, [](const TriangleDistortion& t) { return t.v_arc; });
  d.v_homogeneity = v.highest() / v.lowest();
  d.v_homogeneity_95 = v.ratio_95();
  const ByArea aspect(triangles, [](const TriangleDistortion& t) { return t.aspect_ratio(); });
  d.aspect_ratio = {aspect.mean(), aspect.percentile(0.5), aspect.percentile(0.95), aspect.highest()};
  const ByArea density(triangles, [](const TriangleDistortion& t) { return std::abs(t.uv_area) / t.area; });
  d.density_95 = density.ratio_95();
  return d;
}

std::vector<double> find_inhomogeneity(std::span<const TriangleDistortion> triangles) {
  double area = 0;
  double u_log = 0;
  double v_log = 0;
  for (const TriangleDistortion& t : triangles) {
    // A step may have no length along one axis only on a triangle without area.
    if (!is_mapped(t)) continue;
    area += t.area;
    u_log += t.area * std::log(t.u_arc);
    v_log += t.area * std::log(t.v_arc);
  }
  const double u_mean = std::exp(area > 0 ? u_log / area : 0);
  const double v_mean = std::exp(area > 0 ? v_log / area : 0);
  std::vector<double> all;
  all.reserve(triangles.size());
  for (const TriangleDistortion& t : triangles) {
    all.push_back(is_mapped(t)
                      ? std::max({t.u_arc / u_mean, u_mean / t.u_arc, t.v_arc / v_mean, v_mean / t.v_arc})
                      : kInfinity);
  }
  return all;
}

EdgeContinuity count_continuous_edges(const MappedSurface& surface) {
  const std::vector<std::uint32_t> twins = find_twins(surface.positions, surface.triangles);
  const auto uv = [&](std::uint32_t edge, std::uint32_t end) {
    return surface.texcoords[surface.triangles[edge / 3][(edge % 3 + end) % 3]];
  };
  EdgeContinuity count;
  for (std::uint32_t e = 0; e < twins.size(); ++e) {
    if (twins[e] == kNoTwin || e > twins[e]) continue;
    ++count.interior_edges;
    if (uv(e, 0) == uv(twins[e], 1) && uv(e, 1) == uv(twins[e], 0)) ++count.continuous_edges;
  }
  return count;
}

double find_overlap(const MappedSurface& surface) {
  glm::dvec2 low(kInfinity);
  glm::dvec2 high(-kInfinity);
  for (const auto& triangle : surface.triangles) {
    for (const std::uint32_t vertex : triangle) {
      low = glm::min(low, glm::dvec2(surface.texcoords[vertex]));
      high = glm::max(high, glm::dvec2(surface.texcoords[vertex]));
    }
  }
  const glm::dvec2 cells = static_cast<double>(kOverlapSide) / glm::max(high - low, glm::dvec2(1e-300));
  std::vector<std::uint8_t> cover(std::size_t{kOverlapSide} * kOverlapSide, 0);
  for (const auto& triangle : surface.triangles) {
    std::array<glm::dvec2, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = (glm::dvec2(surface.texcoords[triangle[k]]) - low) * cells;
    for_each_texel(p, kOverlapSide, kOverlapSide, [&](int x, int y) {
      std::uint8_t& count = cover[static_cast<std::size_t>(y) * kOverlapSide + static_cast<std::size_t>(x)];
      if (count < 2) ++count;
    });
  }
  const auto covered = cover.size() - static_cast<std::size_t>(std::count(cover.begin(), cover.end(), 0));
  const auto doubly = std::count(cover.begin(), cover.end(), 2);
  return covered == 0 ? 0 : static_cast<double>(doubly) / static_cast<double>(covered);
}

}  // namespace sweepkit::texmap
