// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Which triangles of a mesh go through each other: a binary tree of boxes over blocks of triangles, ordered
// along a Morton curve, held against itself. Two triangles cross where an edge of one goes through the
// other's inside, both its ends farther from its plane than rounding can have moved them: float32 moves a
// corner by 2^-24 of the mesh's extent, and the plane of a triangle of height h at a distance r by r / h
// times as much again.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

#include "number_text.hpp"
#include "sweepkit/sweep/finding.hpp"

namespace sweepkit::sweep {
namespace {

constexpr std::size_t kBlock = 4;  // triangles a leaf
constexpr std::size_t kMostFindings = 16;
// Crossings this near in both t's, as cells of so many to the whole, are one finding.
constexpr int kBins = 48;

struct Box3 {
  glm::vec3 low{std::numeric_limits<float>::infinity()};
  glm::vec3 high{-std::numeric_limits<float>::infinity()};

  void add(const glm::vec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  void add(const Box3& box) {
    low = glm::min(low, box.low);
    high = glm::max(high, box.high);
  }
  bool meets(const Box3& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y &&
           low.z <= other.high.z && other.low.z <= high.z;
  }
};

struct Hit {
  double t, other;
  glm::dvec3 point;
  double depth;
};

struct PositionHash {
  std::size_t operator()(const std::array<float, 3>& p) const {
    std::size_t hash = 0;
    for (const float value : p) {
      hash = (hash ^ std::hash<float>{}(value)) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 29;
    }
    return hash;
  }
};

// Ten bits of each coordinate, interleaved.
std::uint32_t morton(const glm::dvec3& unit) {
  const auto spread = [](double x) {
    auto v = static_cast<std::uint32_t>(std::clamp(x * 1024, 0.0, 1023.0));
    v = (v * 0x00010001u) & 0xFF0000FFu;
    v = (v * 0x00000101u) & 0x0F00F00Fu;
    v = (v * 0x00000011u) & 0xC30C30C3u;
    v = (v * 0x00000005u) & 0x49249249u;
    return v;
  };
  return spread(unit.x) | spread(unit.y) << 1 | spread(unit.z) << 2;
}

class CrossingFinder {
 public:
  explicit CrossingFinder(const Mesh& mesh) : mesh_(mesh) {
    weld();
    for (const glm::vec3& p : mesh.positions()) whole_.add(p);
    const glm::dvec3 extent = glm::dvec3(whole_.high) - glm::dvec3(whole_.low);
    rounding_ = 4 * std::ldexp(std::max({extent.x, extent.y, extent.z}), -24);
    order_blocks();
    build();
  }

  std::vector<Hit> find() {
    visit(1, 1);
    return std::move(hits_);
  }

 private:
  // Vertices at one place are one; v of a place is that of a wall's vertex there.
  void weld() {
    const std::size_t count = mesh_.n_vertices();
    std::unordered_map<std::array<float, 3>, std::uint32_t, PositionHash> places;
    places.reserve(count);
    place_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      const glm::vec3& p = mesh_.positions()[i];
      const std::array<float, 3> key = {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f};
      place_[i] = places.emplace(key, static_cast<std::uint32_t>(places.size())).first->second;
    }
    v_.assign(places.size(), 0);
    for (const GridPatch& patch : mesh_.patches) {
      double most = 0;
      for (std::uint32_t k = 0; k < patch.vertex_count(); ++k)
        most = std::max(most, static_cast<double>(mesh_.texcoords()[patch.first_vertex + k].y));
      v_range_ = std::max(v_range_, most);
    }
    for (const GridPatch& patch : mesh_.patches) {
      for (std::uint32_t k = 0; k < patch.vertex_count(); ++k) {
        const std::uint32_t vertex = patch.first_vertex + k;
        v_[place_[vertex]] = static_cast<double>(mesh_.texcoords()[vertex].y) / v_range_;
      }
    }
  }

  glm::vec3 corner(std::size_t triangle, std::size_t k) const {
    return mesh_.positions()[mesh_.triangles[triangle][k]];
  }

  void order_blocks() {
    const std::size_t blocks = (mesh_.triangles.size() + kBlock - 1) / kBlock;
    const glm::dvec3 low(whole_.low);
    const glm::dvec3 extent = glm::max(glm::dvec3(whole_.high) - low, glm::dvec3(1e-300));
    std::vector<std::pair<std::uint32_t, std::uint32_t>> codes(blocks);
    for (std::size_t b = 0; b < blocks; ++b) {
      const Box3 box = box_of_block(static_cast<std::uint32_t>(b));
      codes[b] = {morton((0.5 * (glm::dvec3(box.low) + glm::dvec3(box.high)) - low) / extent),
                  static_cast<std::uint32_t>(b)};
    }
    std::sort(codes.begin(), codes.end());
    order_.reserve(blocks);
    for (const auto& [code, block] : codes) order_.push_back(block);
  }

  Box3 box_of_block(std::uint32_t block) const {
    Box3 box;
    const std::size_t first = block * kBlock;
    const std::size_t end = std::min(first + kBlock, mesh_.triangles.size());
    for (std::size_t t = first; t < end; ++t) {
      for (std::size_t k = 0; k < 3; ++k) box.add(corner(t, k));
    }
    return box;
  }

  // Node 1 is the root, 2 n and 2 n + 1 are the children of n; the leaves are a power of two.
  void build() {
    leaves_ = 1;
    while (leaves_ < order_.size()) leaves_ *= 2;
    boxes_.resize(2 * leaves_);
    for (std::size_t i = 0; i < order_.size(); ++i) boxes_[leaves_ + i] = box_of_block(order_[i]);
    for (std::size_t n = leaves_ - 1; n > 0; --n) {
      boxes_[n] = boxes_[2 * n];
      boxes_[n].add(boxes_[2 * n + 1]);
    }
  }

  void visit(std::size_t a, std::size_t b) {
    if (!boxes_[a].meets(boxes_[b])) return;
    if (a >= leaves_) {
      hold_against(order_[a - leaves_], order_[b - leaves_], a == b);
      return;
    }
    visit(2 * a, 2 * b);
    visit(2 * a, 2 * b + 1);
    if (a != b) visit(2 * a + 1, 2 * b);
    visit(2 * a + 1, 2 * b + 1);
  }

  void hold_against(std::uint32_t block, std::uint32_t other, bool is_same) {
    const std::size_t first = block * kBlock;
    const std::size_t end = std::min(first + kBlock, mesh_.triangles.size());
    const std::size_t other_first = other * kBlock;
    const std::size_t other_end = std::min(other_first + kBlock, mesh_.triangles.size());
    for (std::size_t s = first; s < end; ++s) {
      for (std::size_t t = is_same ? s + 1 : other_first; t < other_end; ++t) {
        if (is_apart(s, t) || shares_place(s, t)) continue;
        hold(s, t);
        hold(t, s);
      }
    }
  }

  bool is_apart(std::size_t s, std::size_t t) const {
    for (int axis = 0; axis < 3; ++axis) {
      const auto range = [&](std::size_t triangle) {
        return std::minmax({corner(triangle, 0)[axis], corner(triangle, 1)[axis], corner(triangle, 2)[axis]});
      };
      const auto a = range(s);
      const auto b = range(t);
      if (a.second < b.first || b.second < a.first) return true;
    }
    return false;
  }

  bool shares_place(std::size_t s, std::size_t t) const {
    for (const std::uint32_t a : mesh_.triangles[s]) {
      for (const std::uint32_t b : mesh_.triangles[t]) {
        if (place_[a] == place_[b]) return true;
      }
    }
    return false;
  }

  double t_of(std::size_t triangle) const {
    double sum = 0;
    for (const std::uint32_t vertex : mesh_.triangles[triangle]) sum += v_[place_[vertex]];
    return sum / 3;
  }

  // The edges of one triangle against the other's inside.
  void hold(std::size_t edges, std::size_t face) {
    const glm::dvec3 a(corner(face, 0));
    const glm::dvec3 ab = glm::dvec3(corner(face, 1)) - a;
    const glm::dvec3 ac = glm::dvec3(corner(face, 2)) - a;
    const glm::dvec3 n = glm::cross(ab, ac);
    const double n_squared = glm::dot(n, n);
    if (!(n_squared > 0)) return;
    const double length = std::sqrt(n_squared);
    const double height =
        length / std::sqrt(std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(ac - ab, ac - ab)}));
    std::array<glm::dvec3, 3> from_a;
    std::array<double, 3> above;
    for (std::size_t k = 0; k < 3; ++k) {
      from_a[k] = glm::dvec3(corner(edges, k)) - a;
      above[k] = glm::dot(from_a[k], n) / length;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3;
      if (!(above[k] * above[l] < 0)) continue;
      const double depth = std::min(std::abs(above[k]), std::abs(above[l]));
      const double farthest = std::max(glm::length(from_a[k]), glm::length(from_a[l]));
      if (depth <= rounding_ * (1 + farthest / height)) continue;
      const glm::dvec3 hit = from_a[k] + above[k] / (above[k] - above[l]) * (from_a[l] - from_a[k]);
      const double at_b = glm::dot(glm::cross(hit, ac), n) / n_squared;
      const double at_c = glm::dot(glm::cross(ab, hit), n) / n_squared;
      if (!(at_b > 0 && at_c > 0 && at_b + at_c < 1)) continue;
      const double s = t_of(edges);
      const double t = t_of(face);
      hits_.push_back({std::min(s, t), std::max(s, t), hit + a + mesh_.origin, depth});
    }
  }

  const Mesh& mesh_;
  std::vector<std::uint32_t> place_;  // of a vertex
  std::vector<double> v_;             // of a place, 0 to 1
  double v_range_ = 1e-300;
  Box3 whole_;
  double rounding_ = 0;
  std::vector<std::uint32_t> order_;
  std::size_t leaves_ = 1;
  std::vector<Box3> boxes_;
  std::vector<Hit> hits_;
};

// Hits in bins of (t, other) that touch are one crossing.
std::vector<std::vector<Hit>> group(const std::vector<Hit>& hits) {
  std::map<std::pair<int, int>, std::vector<Hit>> bins;
  const auto bin = [](double t) { return std::min(static_cast<int>(t * kBins), kBins - 1); };
  for (const Hit& hit : hits) bins[{bin(hit.t), bin(hit.other)}].push_back(hit);
  std::vector<std::vector<Hit>> groups;
  while (!bins.empty()) {
    std::vector<std::pair<int, int>> open = {bins.begin()->first};
    std::vector<Hit> members = std::move(bins.begin()->second);
    bins.erase(bins.begin());
    while (!open.empty()) {
      const auto [i, j] = open.back();
      open.pop_back();
      for (int x = i - 1; x <= i + 1; ++x) {
        for (int y = j - 1; y <= j + 1; ++y) {
          const auto near = bins.find({x, y});
          if (near == bins.end()) continue;
          members.insert(members.end(), near->second.begin(), near->second.end());
          bins.erase(near);
          open.emplace_back(x, y);
        }
      }
    }
    groups.push_back(std::move(members));
  }
  return groups;
}

}  // namespace

std::vector<Finding> find_crossings(const Mesh& mesh) {
  if (mesh.triangles.size() < 2) return {};
  std::vector<Finding> findings;
  for (const std::vector<Hit>& hits : group(CrossingFinder(mesh).find())) {
    const Hit& deepest = *std::max_element(hits.begin(), hits.end(),
                                           [](const Hit& a, const Hit& b) { return a.depth < b.depth; });
    Finding finding{.kind = FindingKind::kCrossing,
                    .t = deepest.t,
                    .from = deepest.t,
                    .to = deepest.t,
                    .other = deepest.other,
                    .point = deepest.point,
                    .severity = deepest.depth};
    for (const Hit& hit : hits) {
      finding.from = std::min(finding.from, hit.t);
      finding.to = std::max(finding.to, hit.t);
    }
    char depth[32];
    std::snprintf(depth, sizeof depth, "%.2g m", deepest.depth);
    finding.problem = "parts of the surface go through each other by " + std::string(depth) + " or more";
    finding.cure = "move the trajectory apart there, or make the contour smaller";
    findings.push_back(std::move(finding));
  }
  std::stable_sort(findings.begin(), findings.end(),
                   [](const Finding& a, const Finding& b) { return a.severity > b.severity; });
  if (findings.size() > kMostFindings) findings.resize(kMostFindings);
  return findings;
}

}  // namespace sweepkit::sweep
