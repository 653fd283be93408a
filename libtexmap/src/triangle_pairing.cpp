// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Pairing triangles is a matching of the mesh's dual graph, whose nodes are triangles and whose arcs are
// shared edges. Of a closed mesh every node has three arcs and no arc is a bridge, so a perfect matching
// exists [Petersen 1891, Die Theorie der regulaeren graphs]. Two steps:
//   greedy   edges in order of how far the pair is from a rectangle; leaves about a tenth of a curved mesh
//            alone
//   augment  from each triangle left alone an alternating path to another one [Edmonds 1965, Paths, trees,
//            and flowers], odd cycles shrunk on the way
// Shrunk cycles are kept as a forest of disjoint sets [Gabow 1976, An efficient implementation of Edmonds'
// algorithm], so that a search takes hardly more than a step for each arc it sees. Departs from both in a
// bound: all searches together see kMostVisits arcs a triangle, so that the time stays linear. A tree grown
// to its end in vain takes no part in any later path and is closed.
//
// Symbols of the search: mate (partner in the matching), parent (the node from which an odd node was reached,
// or across the arc that closed its cycle), base (the node that a shrunk cycle goes by; by way of others).

#include "triangle_pairing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "triangle_edges.hpp"

namespace sweepkit::texmap {
namespace {

constexpr std::uint32_t kNone = kNoTwin;
constexpr std::size_t kMostVisits = 300;

using Triangles = std::span<const std::array<std::uint32_t, 3>>;

std::vector<std::array<float, 3>> corner_angles(std::span<const glm::vec3> positions, Triangles triangles) {
  std::vector<std::array<float, 3>> angles(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 at(positions[triangles[t][k]]);
      const glm::dvec3 a = glm::dvec3(positions[triangles[t][(k + 1) % 3]]) - at;
      const glm::dvec3 b = glm::dvec3(positions[triangles[t][(k + 2) % 3]]) - at;
      angles[t][k] = static_cast<float>(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
    }
  }
  return angles;
}

// How far the quadrilateral about an edge is from a rectangle: the squares of what its four angles lack.
float cost_of(const std::vector<std::array<float, 3>>& angles, std::uint32_t edge, std::uint32_t twin) {
  constexpr float kRight = std::numbers::pi_v<float> / 2;
  const std::array<float, 3>& a = angles[edge / 3];
  const std::array<float, 3>& b = angles[twin / 3];
  const std::uint32_t k = edge % 3;
  const std::uint32_t m = twin % 3;
  float cost = 0;
  for (const float angle : {a[(k + 2) % 3], b[(m + 2) % 3], a[k] + b[(m + 1) % 3], a[(k + 1) % 3] + b[m]}) {
    cost += (angle - kRight) * (angle - kRight);
  }
  return cost;
}

class Matching {
 public:
  explicit Matching(std::span<const std::uint32_t> twins)
      : twins_(twins), mate_(twins.size() / 3, kNone), nodes_(twins.size() / 3) {
    for (std::uint32_t t = 0; t < nodes_.size(); ++t) nodes_[t].base = t;
  }

  bool is_alone(std::uint32_t t) const { return mate_[t] == kNone; }
  std::uint32_t mate(std::uint32_t t) const { return mate_[t]; }
  void join(std::uint32_t a, std::uint32_t b) {
    mate_[a] = b;
    mate_[b] = a;
  }

  // Looks for a path from every triangle left alone, while there are visits left.
  void augment() {
    visits_left_ = kMostVisits * mate_.size();
    for (std::uint32_t t = 0; t < mate_.size() && visits_left_ > 0; ++t) {
      if (is_alone(t)) augment_from(t);
    }
  }

 private:
  enum class Kind : std::uint8_t { kUnseen, kOdd, kEven };
  struct Node {
    std::uint32_t parent = kNone;
    std::uint32_t base = 0;
    std::uint32_t stamp = 0;  // of the last walk that passed
    Kind kind = Kind::kUnseen;
    bool is_closed = false;
  };

  std::uint32_t base_of(std::uint32_t t) {
    while (nodes_[t].base != t) t = nodes_[t].base = nodes_[nodes_[t].base].base;
    return t;
  }

  void make_even(std::uint32_t t) {
    nodes_[t].kind = Kind::kEven;
    queue_.push_back(t);
  }

  void augment_from(std::uint32_t root) {
    make_even(root);
    seen_.push_back(root);
    std::uint32_t end = kNone;
    for (std::size_t head = 0; head < queue_.size() && end == kNone && visits_left_ > 0; ++head) {
      end = grow(queue_[head]);
    }
    const bool is_in_vain = end == kNone && visits_left_ > 0;
    while (end != kNone) {
      const std::uint32_t before = nodes_[end].parent;
      const std::uint32_t next = mate_[before];
      join(end, before);
      end = next;
    }
    for (const std::uint32_t t : seen_) {
      nodes_[t] = {.base = t, .stamp = nodes_[t].stamp, .is_closed = is_in_vain};
    }
    seen_.clear();
    queue_.clear();
  }

  // Looks at the neighbours of an even node. Returns the lone one at which a path ends, or kNone.
  std::uint32_t grow(std::uint32_t v) {
    for (std::uint32_t k = 0; k < 3 && visits_left_ > 0; ++k) {
      const std::uint32_t twin = twins_[3 * v + k];
      if (twin == kNone) continue;
      const std::uint32_t to = twin / 3;
      --visits_left_;
      if (nodes_[to].is_closed || nodes_[to].kind == Kind::kOdd || base_of(v) == base_of(to)) continue;
      if (nodes_[to].kind == Kind::kEven) {
        const std::uint32_t base = common_base(v, to);
        shrink(v, base, to);
        shrink(to, base, v);
        continue;
      }
      nodes_[to].kind = Kind::kOdd;
      nodes_[to].parent = v;
      seen_.push_back(to);
      if (is_alone(to)) return to;
      make_even(mate_[to]);
      seen_.push_back(mate_[to]);
    }
    return kNone;
  }

  // Where the ways of two even nodes to the root meet: both walk at once, a base at a time.
  std::uint32_t common_base(std::uint32_t a, std::uint32_t b) {
    ++stamp_;
    for (;; std::swap(a, b)) {
      if (a == kNone) continue;
      a = base_of(a);
      if (nodes_[a].stamp == stamp_) return a;
      nodes_[a].stamp = stamp_;
      a = is_alone(a) ? kNone : nodes_[mate_[a]].parent;
    }
  }

  // One side of the odd cycle that the arc from v to `child` closes: its nodes go by `base` from now on, and
  // the odd ones among them, which can now be reached over the arc, become even.
  void shrink(std::uint32_t v, std::uint32_t base, std::uint32_t child) {
    while (base_of(v) != base) {
      nodes_[v].parent = child;
      child = mate_[v];
      if (nodes_[child].kind == Kind::kOdd) make_even(child);
      if (nodes_[v].base == v) nodes_[v].base = base;
      if (nodes_[child].base == child) nodes_[child].base = base;
      v = nodes_[child].parent;
    }
  }

  std::span<const std::uint32_t> twins_;
  std::vector<std::uint32_t> mate_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> seen_, queue_;
  std::uint32_t stamp_ = 0;
  std::size_t visits_left_ = 0;
};

}  // namespace

std::vector<std::uint32_t> pair_triangles(std::span<const glm::vec3> positions, Triangles triangles,
                                          std::span<const std::uint32_t> twins) {
  const std::vector<std::array<float, 3>> angles = corner_angles(positions, triangles);
  struct Choice {
    float cost;
    std::uint32_t edge;
  };
  std::vector<Choice> choices;
  choices.reserve(twins.size() / 2);
  for (std::uint32_t e = 0; e < twins.size(); ++e) {
    if (twins[e] != kNoTwin && e < twins[e]) choices.push_back({cost_of(angles, e, twins[e]), e});
  }
  std::sort(choices.begin(), choices.end(), [](const Choice& a, const Choice& b) {
    return a.cost != b.cost ? a.cost < b.cost : a.edge < b.edge;
  });

  Matching matching(twins);
  for (const Choice& choice : choices) {
    const std::uint32_t a = choice.edge / 3;
    const std::uint32_t b = twins[choice.edge] / 3;
    if (matching.is_alone(a) && matching.is_alone(b)) matching.join(a, b);
  }
  matching.augment();

  // Two triangles may share more than one edge: the best of them is the diagonal, and the same for both.
  std::vector<std::uint32_t> pairing(triangles.size(), kNoTwin);
  for (const Choice& choice : choices) {
    const std::uint32_t a = choice.edge / 3;
    const std::uint32_t b = twins[choice.edge] / 3;
    if (matching.mate(a) != b || pairing[a] != kNoTwin) continue;
    pairing[a] = choice.edge;
    pairing[b] = twins[choice.edge];
  }
  return pairing;
}

}  // namespace sweepkit::texmap
