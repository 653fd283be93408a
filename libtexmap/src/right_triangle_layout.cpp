// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on the right-triangular subdivision of [Akdemir98, section 2.2, Fig. 1]. The paper takes the
// triangles in the order of its sweep meshes; departs from it in that the order is found here, for any mesh:
// triangles are paired (triangle_pairing.cpp) and the pairs, quadrilaterals with four neighbours each, are
// spread over the grid of cells from a first one outwards. A pair may lie in any free cell, so the cells are
// as many as the pairs, and nothing is ever moved again. Of all places where a pair would lie beside one of
// its neighbours with the shared edge in one place, that is taken first where most of its edges would; first
// come, first served among equals, which grows round patches. Where no such place is left, a new patch starts
// in the next free cell.
//
// A pair's corners c0 to c3 run counter-clockwise, the right angles at c0 and c2, the diagonal from c1 to c3;
// its side s runs from corner s to the next. Sides of cells are numbered in the same way: below, right,
// above, left. Turned by r, a pair has its corner s, and its side s, at the cell's (s + r) mod 4. Turns by
// one and three have the other diagonal. The side s of one pair meets the side s' of its neighbour across the
// cell's side S where s + r = S and s' + r' = S + 2.

#include "sweepkit/texmap/right_triangle_layout.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "triangle_edges.hpp"
#include "triangle_pairing.hpp"

namespace sweepkit::texmap {
namespace {

constexpr std::uint32_t kNone = kNoTwin;

using Triangles = std::span<const std::array<std::uint32_t, 3>>;

std::uint32_t next_corner(std::uint32_t edge) {
  return edge % 3 == 2 ? edge - 2 : edge + 1;
}

// Two triangles by their edges along the diagonal; side s of the pair is an edge of the mesh.
struct Pair {
  std::uint32_t first, second;

  std::uint32_t side(std::uint32_t s) const {
    const std::uint32_t diagonal = s == 1 || s == 2 ? second : first;
    const std::uint32_t after = next_corner(diagonal);
    return s == 1 || s == 3 ? after : next_corner(after);
  }
};

class Grid {
 public:
  Grid(std::span<const std::uint32_t> twins, std::span<const std::uint32_t> pairing, std::size_t lone)
      : twins_(twins), pair_of_(pairing.size(), kNone) {
    for (std::uint32_t t = 0; t < pairing.size(); ++t) {
      if (pairing[t] == kNone || pair_of_[t] != kNone) continue;
      const std::uint32_t partner = twins[pairing[t]];
      pair_of_[t] = pair_of_[partner / 3] = static_cast<std::uint32_t>(pairs_.size());
      pairs_.push_back({pairing[t], partner});
    }
    const std::size_t cells = std::max<std::size_t>(pairs_.size() + (lone + 1) / 2, 1);
    columns_ = static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<double>(cells))));
    rows_ = static_cast<std::uint32_t>((cells + columns_ - 1) / columns_);
    pair_in_.assign(std::size_t{columns_} * rows_, kNone);
    place_of_.assign(pairs_.size(), Place{});
  }

  std::uint32_t columns() const { return columns_; }
  std::uint32_t rows() const { return rows_; }

  void place_all() {
    std::uint32_t next_cell = 0;
    for (std::uint32_t pair = 0; pair < pairs_.size(); ++pair) {
      if (place_of_[pair].cell != kNone) continue;
      while (pair_in_[next_cell] != kNone) ++next_cell;
      put({pair, next_cell, 0});
      grow();
    }
  }

  // Writes the halves of a pair, in the letters of HalfCell.
  void write(std::vector<HalfCell>& halves) const {
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const Place& place = place_of_[i];
      const auto half = [&](std::uint32_t diagonal, std::uint32_t corner) {
        const std::uint32_t opposite = (diagonal % 3 + 2) % 3;
        halves[diagonal / 3] = {place.cell, static_cast<std::uint8_t>((corner + place.turn) % 4),
                                static_cast<std::uint8_t>(opposite), 0};
      };
      half(pairs_[i].first, 0);
      half(pairs_[i].second, 2);
    }
  }

  bool is_free(std::uint32_t cell) const { return pair_in_[cell] == kNone; }
  std::uint32_t cell_count() const { return static_cast<std::uint32_t>(pair_in_.size()); }

  // The cell across a side of a cell.
  std::optional<std::uint32_t> beside(std::uint32_t cell, std::uint32_t side) const {
    const std::uint32_t column = cell % columns_;
    switch (side) {
      case 0:
        return cell >= columns_ ? std::optional(cell - columns_) : std::nullopt;
      case 1:
        return column + 1 < columns_ ? std::optional(cell + 1) : std::nullopt;
      case 2:
        return cell + columns_ < pair_in_.size() ? std::optional(cell + columns_) : std::nullopt;
      default:
        return column > 0 ? std::optional(cell - 1) : std::nullopt;
    }
  }

 private:
  struct Place {
    std::uint32_t cell = kNone;
    std::uint32_t turn = 0;
  };
  struct Candidate {
    std::uint32_t pair, cell, turn;
  };

  // The cell's side on which a placed pair has an edge, or none where that is its diagonal.
  std::optional<std::uint32_t> cell_side(std::uint32_t edge, std::uint32_t pair, std::uint32_t turn) const {
    for (std::uint32_t s = 0; s < 4; ++s) {
      if (pairs_[pair].side(s) == edge) return (s + turn) % 4;
    }
    return std::nullopt;
  }

  // Of the candidate's edges, those that would be continuous.
  std::uint32_t count_matches(const Candidate& candidate) const {
    std::uint32_t matches = 0;
    for (std::uint32_t s = 0; s < 4; ++s) {
      const std::uint32_t twin = twins_[pairs_[candidate.pair].side(s)];
      if (twin == kNone || pair_of_[twin / 3] == kNone) continue;
      const std::uint32_t other = pair_of_[twin / 3];
      const std::uint32_t side = (s + candidate.turn) % 4;
      const std::optional<std::uint32_t> cell = beside(candidate.cell, side);
      if (!cell || place_of_[other].cell != *cell) continue;
      const std::optional<std::uint32_t> facing = cell_side(twin, other, place_of_[other].turn);
      if (facing && *facing == (side + 2) % 4) ++matches;
    }
    return matches;
  }

  void put(const Candidate& chosen) {
    pair_in_[chosen.cell] = chosen.pair;
    place_of_[chosen.pair] = {chosen.cell, chosen.turn};
    for (std::uint32_t s = 0; s < 4; ++s) {
      const std::uint32_t twin = twins_[pairs_[chosen.pair].side(s)];
      if (twin == kNone) continue;
      const std::uint32_t other = pair_of_[twin / 3];
      if (other == kNone || place_of_[other].cell != kNone) continue;
      const std::uint32_t side = (s + chosen.turn) % 4;
      const std::optional<std::uint32_t> cell = beside(chosen.cell, side);
      if (!cell || pair_in_[*cell] != kNone) continue;
      const std::uint32_t own = *cell_side(twin, other, 0);
      const Candidate candidate{other, *cell, (side + 6 - own) % 4};
      waiting_[count_matches(candidate)].push_back(candidate);
    }
  }

  // Takes the waiting candidates, those with the most continuous edges first, until none is left. Whoever
  // gains an edge while it waits comes again with the count it then has.
  void grow() {
    for (;;) {
      std::size_t most = waiting_.size();
      while (most > 0 && heads_[most - 1] == waiting_[most - 1].size()) --most;
      if (most == 0) break;
      std::vector<Candidate>& best = waiting_[most - 1];
      const Candidate chosen = best[heads_[most - 1]++];
      if (place_of_[chosen.pair].cell == kNone && pair_in_[chosen.cell] == kNone) put(chosen);
    }
    for (std::vector<Candidate>& list : waiting_) list.clear();
    heads_.fill(0);
  }

  std::span<const std::uint32_t> twins_;
  std::vector<Pair> pairs_;
  std::vector<std::uint32_t> pair_of_;  // by triangle
  std::vector<std::uint32_t> pair_in_;  // by cell
  std::vector<Place> place_of_;         // by pair
  std::uint32_t columns_ = 0;
  std::uint32_t rows_ = 0;
  std::array<std::vector<Candidate>, 5> waiting_;  // by count of continuous edges
  std::array<std::size_t, 5> heads_{};
};

// The corner with the largest angle: opposite the longest edge.
std::uint32_t widest_corner(std::span<const glm::vec3> positions,
                            const std::array<std::uint32_t, 3>& triangle) {
  std::uint32_t widest = 0;
  double longest = -1;
  for (std::uint32_t k = 0; k < 3; ++k) {
    const glm::dvec3 edge =
        glm::dvec3(positions[triangle[(k + 1) % 3]]) - glm::dvec3(positions[triangle[(k + 2) % 3]]);
    const double length = glm::dot(edge, edge);
    if (length > longest) {
      longest = length;
      widest = k;
    }
  }
  return widest;
}

// Triangles without a partner take half a cell each, in what the pairs have left: beside a neighbour if that
// can be, else wherever there is room.
class LoneTriangles {
 public:
  LoneTriangles(const Grid& grid, std::span<const std::uint32_t> twins, std::vector<HalfCell>& halves)
      : grid_(grid), twins_(twins), halves_(halves), taken_(grid.cell_count(), 0) {}

  bool put_beside_neighbour(std::uint32_t t, std::uint32_t b) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t twin = twins_[3 * t + k];
      if (k == (b + 1) % 3 || twin == kNone || halves_[twin / 3].cell == kNone) continue;
      // Corner m of the neighbour lies at its cell's corner c + m - b; its legs begin at b - 1 and at b.
      const HalfCell& other = halves_[twin / 3];
      const std::uint32_t from_b = (twin % 3 + 3 - other.b) % 3;
      if (from_b == 1) continue;  // its hypotenuse
      const std::uint32_t side = (other.corner + (from_b == 0 ? 0u : 3u)) % 4;
      const std::optional<std::uint32_t> cell = grid_.beside(other.cell, side);
      if (!cell) continue;
      // The leg that ends at B begins at the cell's corner before it.
      const std::uint32_t own_side = (side + 2) % 4;
      const std::uint32_t corner = k == b ? own_side : (own_side + 1) % 4;
      if (put(t, b, *cell, corner)) return true;
    }
    return false;
  }

  void put_anywhere(std::uint32_t t, std::uint32_t b) {
    for (;; ++next_) {
      for (std::uint32_t corner = 0; corner < 4; ++corner) {
        if (put(t, b, next_, corner)) return;
      }
    }
  }

 private:
  bool put(std::uint32_t t, std::uint32_t b, std::uint32_t cell, std::uint32_t corner) {
    // Of a cell's halves those at opposite corners go together.
    const bool fits = taken_[cell] == 0 || taken_[cell] == 1u << (corner + 2) % 4;
    if (!grid_.is_free(cell) || !fits) return false;
    taken_[cell] |= static_cast<std::uint8_t>(1u << corner);
    halves_[t] = {cell, static_cast<std::uint8_t>(corner), static_cast<std::uint8_t>(b), 0};
    return true;
  }

  const Grid& grid_;
  std::span<const std::uint32_t> twins_;
  std::vector<HalfCell>& halves_;
  std::vector<std::uint8_t> taken_;  // by cell: a bit for each corner that holds a right angle
  std::uint32_t next_ = 0;
};

// The texture's node at which a corner of a triangle lies.
glm::uvec2 node_of(const RightTriangleLayout& layout, const HalfCell& half, std::uint32_t corner) {
  // From B the winding goes to the cell's next corner, and from there past the diagonal to the one before B.
  const std::uint32_t from_b = (corner + 3u - half.b) % 3;
  const std::uint32_t cell_corner = from_b == 2 ? (half.corner + 3u) % 4 : (half.corner + from_b) % 4;
  return {half.cell % layout.columns + (cell_corner == 1 || cell_corner == 2 ? 1u : 0u),
          half.cell / layout.columns + (cell_corner >= 2 ? 1u : 0u)};
}

std::uint32_t root_of(std::vector<std::uint32_t>& parents, std::uint32_t t) {
  while (parents[t] != t) t = parents[t] = parents[parents[t]];
  return t;
}

// Counts edges and numbers the islands, in order of their first triangles.
void join_islands(RightTriangleLayout& layout, std::span<const std::uint32_t> twins) {
  std::vector<std::uint32_t> parents(layout.halves.size());
  std::iota(parents.begin(), parents.end(), 0u);
  for (std::uint32_t e = 0; e < twins.size(); ++e) {
    if (twins[e] == kNone || e > twins[e]) continue;
    ++layout.interior_edges;
    const HalfCell& a = layout.halves[e / 3];
    const HalfCell& b = layout.halves[twins[e] / 3];
    const bool is_continuous = node_of(layout, a, e % 3) == node_of(layout, b, next_corner(twins[e]) % 3) &&
                               node_of(layout, a, next_corner(e) % 3) == node_of(layout, b, twins[e] % 3);
    if (!is_continuous) continue;
    ++layout.continuous_edges;
    const std::uint32_t one = root_of(parents, e / 3);
    const std::uint32_t other = root_of(parents, twins[e] / 3);
    parents[std::max(one, other)] = std::min(one, other);
  }
  for (std::uint32_t t = 0; t < parents.size(); ++t) {
    const std::uint32_t root = root_of(parents, t);
    layout.halves[t].island = root == t ? layout.island_count++ : layout.halves[root].island;
  }
}

}  // namespace

std::array<glm::dvec2, 3> RightTriangleLayout::texcoords(std::size_t triangle) const {
  std::array<glm::dvec2, 3> uv;
  for (std::uint32_t k = 0; k < 3; ++k)
    uv[k] = glm::dvec2(node_of(*this, halves[triangle], k)) / glm::dvec2(columns, rows);
  return uv;
}

RightTriangle RightTriangleLayout::right_triangle(std::size_t triangle) const {
  const std::array<glm::dvec2, 3> uv = texcoords(triangle);
  const HalfCell& half = halves[triangle];
  const glm::dvec2& before = uv[(half.b + 2) % 3];
  const glm::dvec2& after = uv[(half.b + 1) % 3];
  const bool falls = half.corner % 2 == 0;
  return texmap::right_triangle(falls ? before : after, uv[half.b], falls ? after : before);
}

RightTriangleLayout lay_out_right_triangles(std::span<const glm::vec3> positions, Triangles triangles) {
  const std::vector<std::uint32_t> twins = find_twins(positions, triangles);
  const std::vector<std::uint32_t> pairing = pair_triangles(positions, triangles, twins);
  RightTriangleLayout layout;
  layout.lone_triangles = static_cast<std::size_t>(std::count(pairing.begin(), pairing.end(), kNone));
  layout.halves.assign(triangles.size(), HalfCell{.cell = kNone});

  Grid grid(twins, pairing, layout.lone_triangles);
  layout.columns = grid.columns();
  layout.rows = grid.rows();
  grid.place_all();
  grid.write(layout.halves);

  LoneTriangles lone(grid, twins, layout.halves);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> left;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (pairing[t] != kNone) continue;
    const std::uint32_t b = widest_corner(positions, triangles[t]);
    if (!lone.put_beside_neighbour(t, b)) left.push_back({t, b});
  }
  for (const auto& [t, b] : left) lone.put_anywhere(t, b);
  join_islands(layout, twins);
  return layout;
}

}  // namespace sweepkit::texmap
