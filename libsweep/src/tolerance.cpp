// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A grid of columns and rows, as coarse as a tolerance allows. Both are cut into chords (cuts.cpp) for a row
// of bounds, so that of every number of cells the least error is known: c along the contour, r along the
// trajectory. What a cell's triangles miss is f (c + r), f about 1 where the surface bends the same way in
// both, less where it is a saddle, more where it is twisted. f is measured, the two numbers are chosen whose
// product is least while f (c + r) fits, and that is repeated with the f it has; in the end all cells are
// measured.
//
// Along the trajectory only the extreme columns are looked at: with t fixed a point of the surface is linear
// in the section's (x, y), so its distance from a chord is convex in them and largest at a corner of the
// convex hull.

#include "tolerance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "cuts.hpp"

namespace sweepkit::sweep {
namespace {

// Rows whose columns are looked at, of a contour that changes.
constexpr std::size_t kMorphRows = 17;
// The share of a tolerance that is left to what lies between the samples.
constexpr double kSampleMargin = 1.0 / 64;
// Bounds from the tolerance down to this share, so many to an octave.
constexpr int kOctaves = 5;
constexpr int kBoundsAnOctave = 8;
// Cells measured while numbers are chosen; all of them in the end.
constexpr std::size_t kCellsSearched = 2000;
// Of so many cells each is so small that the middles of its sides and diagonal tell.
constexpr std::size_t kManyCells = 200000;

double distance_to_triangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                            const glm::dvec3& c) {
  const glm::dvec3 n = glm::cross(b - a, c - a);
  const double n_squared = glm::dot(n, n);
  const glm::dvec3 w = p - a;
  if (n_squared > 0) {
    const double at_c = glm::dot(glm::cross(b - a, w), n) / n_squared;
    const double at_b = glm::dot(glm::cross(w, c - a), n) / n_squared;
    if (at_b >= 0 && at_c >= 0 && at_b + at_c <= 1) return std::abs(glm::dot(w, n)) / std::sqrt(n_squared);
  }
  return std::min({distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

// Places evenly between two, the first included.
void add_parts(std::size_t from, std::size_t to, std::size_t parts, std::vector<std::size_t>& places) {
  for (std::size_t part = 0; part < parts; ++part) {
    const std::size_t place = from + (to - from) * part / parts;
    if (part == 0 || place > places.back()) places.push_back(place);
  }
}

// Columns (an outline) or rows cut to a bound, and the error that leaves.
struct Cut {
  std::vector<std::vector<std::size_t>> places;
  double error = 0;

  std::size_t cells() const {
    std::size_t sum = 0;
    for (const std::vector<std::size_t>& outline : places) sum += outline.size() - 1;
    return sum;
  }
};

class GridFitter {
 public:
  explicit GridFitter(const DenseSweep& dense) : dense_(dense) {
    for (const ColumnPlace& place : extreme_columns(dense_.morphs)) {
      std::vector<glm::dvec3> line(dense_.spine.rows.size());
      for (std::size_t j = 0; j < line.size(); ++j) line[j] = dense_.position(place, j);
      along_.push_back(std::move(line));
    }
    sample_extreme_rows();
  }

  Grid fit(double tolerance) const {
    const double bound = tolerance * (1 - kSampleMargin);
    const std::vector<Cut> columns = all_cuts(bound, [&](double b) { return cut_columns(b); });
    const std::vector<Cut> rows = all_cuts(bound, [&](double b) { return cut_rows(b); });
    double factor = 1;
    std::optional<Grid> best;
    std::size_t least = std::numeric_limits<std::size_t>::max();
    // f settles after a few rounds; each that fits is one to be taken.
    for (int round = 0; round < 10; ++round) {
      const auto [c, r] = cheapest(columns, rows, bound / factor);
      Grid grid{columns[c].places, rows[r].places.front()};
      const std::size_t cells = columns[c].cells() * rows[r].cells();
      grid.deviation = measure(grid, 1 + cells / kCellsSearched);
      if (grid.deviation <= bound) {
        const bool is_better = cells < least;
        if (is_better) {
          best = grid;
          least = cells;
        }
        // Nearly reached, or no better: there is nothing more in it.
        if (!is_better || grid.deviation > 0.98 * bound) break;
      }
      const double error = columns[c].error + rows[r].error;
      if (!(error > 0)) break;
      const double measured = grid.deviation / error;
      // Towards what is measured, and past it where that has been tried.
      factor = std::clamp(measured, factor / 4, factor * 4) * (grid.deviation > bound ? 1.01 : 1);
    }
    if (!best) best = Grid{columns.back().places, rows.back().places.front()};
    best->deviation = measure(*best, 1);
    // The search has measured some of the cells; what all of them show may ask for a little less.
    double scale = 1;
    while (best->deviation > bound && scale > 1e-3) {
      scale *= std::clamp(0.97 * bound / best->deviation, 0.5, 0.97);
      const auto [c, r] = cheapest(columns, rows, scale * bound / factor);
      best = Grid{columns[c].places, rows[r].places.front()};
      best->deviation = measure(*best, 1);
    }
    return *best;
  }

 private:
  void sample_extreme_rows() {
    const std::vector<Row>& rows = dense_.spine.rows;
    std::vector<std::size_t> extreme;
    const auto add_largest = [&](auto&& size) {
      std::size_t largest = 0;
      for (std::size_t j = 1; j < rows.size(); ++j) {
        if (size(rows[j]) > size(rows[largest])) largest = j;
      }
      extreme.push_back(largest);
    };
    add_largest([](const Row& row) { return glm::length(row.x_axis); });
    add_largest([](const Row& row) { return glm::length(row.y_axis); });
    add_largest([](const Row& row) { return glm::length(row.x_axis + row.y_axis); });
    add_largest([](const Row& row) { return glm::length(row.x_axis - row.y_axis); });
    const bool changes = std::any_of(dense_.morphs.begin(), dense_.morphs.end(),
                                     [](const Morph& morph) { return morph.changes(); });
    for (std::size_t k = 0; changes && k < kMorphRows; ++k) {
      extreme.push_back((rows.size() - 1) * k / (kMorphRows - 1));
    }
    std::sort(extreme.begin(), extreme.end());
    extreme.erase(std::unique(extreme.begin(), extreme.end()), extreme.end());
    for (std::size_t o = 0; o < dense_.morphs.size(); ++o) {
      std::vector<std::vector<glm::dvec3>> lines;
      for (const std::size_t row : extreme) {
        std::vector<glm::dvec3> line(dense_.morphs[o].columns() + 1);
        for (std::size_t i = 0; i < line.size(); ++i) line[i] = dense_.position({o, i}, row);
        lines.push_back(std::move(line));
      }
      across_.push_back(std::move(lines));
    }
  }

  // Of the places between, up to so many are looked at: an arc is farthest from its chord near the middle.
  static constexpr std::size_t kLooks = 7;

  static double chord_error(const std::vector<std::vector<glm::dvec3>>& lines, std::size_t a, std::size_t b) {
    const std::size_t looks = std::min(b - a - 1, kLooks);
    double error = 0;
    for (const std::vector<glm::dvec3>& line : lines) {
      for (std::size_t k = 1; k <= looks; ++k) {
        const std::size_t place = a + (b - a) * k / (looks + 1);
        error = std::max(error, distance_to_segment(line[place], line[a], line[b]));
      }
    }
    return error;
  }

  static double largest_error(const std::vector<std::vector<glm::dvec3>>& lines,
                              const std::vector<std::size_t>& cuts) {
    double error = 0;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
      error = std::max(error, chord_error(lines, cuts[i], cuts[i + 1]));
    return error;
  }

  static void append_cuts(std::vector<std::size_t>& all, const std::vector<std::size_t>& cuts) {
    all.insert(all.end(), cuts.begin() + (all.empty() ? 0 : 1), cuts.end());
  }

  std::vector<std::size_t> cut_outline(std::size_t outline, double bound) const {
    const Section& section = dense_.morphs[outline].keys.front();
    const std::size_t last = section.points.size() - 1;
    const std::size_t end = dense_.closing_columns[outline] > 0 ? dense_.repeat_columns[outline] : last;
    std::vector<std::size_t> fixed = {0};
    for (std::size_t i = 1; i < end; ++i) {
      if (section.corners[i]) fixed.push_back(i);
    }
    fixed.push_back(end);
    const auto error = [&](std::size_t a, std::size_t b) { return chord_error(across_[outline], a, b); };
    // A loop has three cells at least; where it is repeated more than once two pieces do.
    std::size_t least = 1;
    if (section.is_closed && end == last && fixed.size() <= 3) least = fixed.size() == 2 ? 3 : 2;
    if (section.is_closed && end < last && fixed.size() == 2) least = 2;
    std::vector<std::size_t> columns;
    for (std::size_t k = 0; k + 1 < fixed.size(); ++k) {
      append_cuts(columns, cut(fixed[k], fixed[k + 1], least, error, bound));
    }
    const std::size_t period = columns.size();
    for (std::size_t turned = end; turned < last; turned += end) {
      for (std::size_t i = 1; i < period; ++i) columns.push_back(turned + columns[i]);
    }
    return columns;
  }

  Cut cut_rows(double bound) const {
    const std::vector<Row>& rows = dense_.spine.rows;
    std::vector<std::size_t> fixed = {0};
    for (std::size_t j = 1; j + 1 < rows.size(); ++j) {
      if (rows[j].is_corner || rows[j].is_pole) fixed.push_back(j);
    }
    fixed.push_back(rows.size() - 1);
    const auto error = [&](std::size_t a, std::size_t b) { return chord_error(along_, a, b); };
    std::size_t loop_least = 1;
    if (dense_.spine.is_closed && fixed.size() <= 3) loop_least = fixed.size() == 2 ? 3 : 2;
    std::vector<std::size_t> cuts;
    for (std::size_t k = 0; k + 1 < fixed.size(); ++k) {
      // Between two poles a single row would have no surface.
      const bool is_lens = rows[fixed[k]].is_pole && rows[fixed[k + 1]].is_pole;
      append_cuts(cuts, cut(fixed[k], fixed[k + 1],
                            is_lens ? std::max<std::size_t>(2, loop_least) : loop_least, error, bound));
    }
    return {{cuts}, largest_error(along_, cuts)};
  }

  Cut cut_columns(double bound) const {
    Cut cut;
    for (std::size_t o = 0; o < dense_.morphs.size(); ++o) {
      cut.places.push_back(cut_outline(o, bound));
      cut.error = std::max(cut.error, largest_error(across_[o], cut.places.back()));
    }
    return cut;
  }

  // From few cells to many, of each number the one with the least error.
  template <class CutTo>
  static std::vector<Cut> all_cuts(double bound, const CutTo& cut_to) {
    std::vector<Cut> cuts;
    for (int k = 0; k <= kOctaves * kBoundsAnOctave; ++k) {
      Cut next = cut_to(bound * std::exp2(-static_cast<double>(k) / kBoundsAnOctave));
      if (!cuts.empty() && next.error >= cuts.back().error) continue;
      if (!cuts.empty() && next.cells() == cuts.back().cells()) {
        cuts.back() = std::move(next);
      } else {
        cuts.push_back(std::move(next));
      }
      if (cuts.back().error == 0) break;
    }
    return cuts;
  }

  // The pair of fewest cells whose errors add up to `bound` at most; the finest of both where none does.
  static std::pair<std::size_t, std::size_t> cheapest(const std::vector<Cut>& columns,
                                                      const std::vector<Cut>& rows, double bound) {
    std::pair<std::size_t, std::size_t> best(columns.size() - 1, rows.size() - 1);
    std::size_t least = std::numeric_limits<std::size_t>::max();
    for (std::size_t c = 0; c < columns.size(); ++c) {
      for (std::size_t r = 0; r < rows.size(); ++r) {
        if (columns[c].error + rows[r].error > bound) continue;
        const std::size_t cells = columns[c].cells() * rows[r].cells();
        if (cells < least) {
          least = cells;
          best = {c, r};
        }
        break;  // more rows are only more
      }
    }
    return best;
  }

  // The largest distance of the dense surface from the triangles of its cells, of every `stride`-th row of
  // cells.
  double measure(const Grid& grid, std::size_t stride) const {
    std::size_t cells = 0;
    for (const std::vector<std::size_t>& outline : grid.columns)
      cells += (outline.size() - 1) * (grid.rows.size() - 1);
    const std::size_t parts = cells > kManyCells ? 2 : 4;
    double worst = 0;
    std::vector<std::size_t> sample_rows;
    std::vector<std::size_t> sample_columns;
    std::vector<std::size_t> first_of_cell;
    std::vector<std::vector<glm::dvec3>> points;
    for (std::size_t o = 0; o < grid.columns.size(); ++o) {
      const std::vector<std::size_t>& columns = grid.columns[o];
      sample_columns.clear();
      first_of_cell.clear();
      for (std::size_t i = 0; i + 1 < columns.size(); ++i) {
        first_of_cell.push_back(sample_columns.size());
        add_parts(columns[i], columns[i + 1], parts, sample_columns);
      }
      first_of_cell.push_back(sample_columns.size());
      sample_columns.push_back(columns.back());
      for (std::size_t j = 0; j + 1 < grid.rows.size(); j += stride) {
        sample_rows.clear();
        add_parts(grid.rows[j], grid.rows[j + 1], parts, sample_rows);
        sample_rows.push_back(grid.rows[j + 1]);
        points.resize(sample_rows.size());
        for (std::size_t k = 0; k < sample_rows.size(); ++k) {
          points[k].clear();
          for (const std::size_t column : sample_columns)
            points[k].push_back(dense_.position({o, column}, sample_rows[k]));
        }
        for (std::size_t i = 0; i + 1 < columns.size(); ++i) {
          const std::size_t from = first_of_cell[i];
          const std::size_t to = first_of_cell[i + 1];
          const glm::dvec3& p = points.front()[from];
          const glm::dvec3& q = points.front()[to];
          const glm::dvec3& r = points.back()[from];
          const glm::dvec3& s = points.back()[to];
          for (const std::vector<glm::dvec3>& line : points) {
            for (std::size_t c = from; c <= to; ++c) {
              worst = std::max(worst, std::min(distance_to_triangle(line[c], r, p, q),
                                               distance_to_triangle(line[c], q, s, r)));
            }
          }
        }
      }
    }
    return worst;
  }

  const DenseSweep& dense_;
  // an outline, a row; of those that change
  std::vector<std::vector<glm::dvec3>> along_;                // extreme columns, a point a row
  std::vector<std::vector<std::vector<glm::dvec3>>> across_;  // an outline: extreme rows, a point a column
};

}  // namespace

Grid fit_grid(const DenseSweep& dense, double tolerance) {
  return GridFitter(dense).fit(tolerance);
}

Morph kept_columns(const Morph& morph, std::span<const std::size_t> columns) {
  Morph kept;
  kept.at = morph.at;
  kept.slopes = morph.slopes;
  for (const Section& key : morph.keys) {
    Section section;
    section.is_closed = key.is_closed;
    for (const std::size_t i : columns) {
      section.points.push_back(key.points[i]);
      section.breaks.push_back(key.breaks[i]);
      section.corners.push_back(key.corners[i]);
      section.fractions.push_back(key.fractions[i]);
    }
    kept.keys.push_back(std::move(section));
  }
  return kept;
}

Spine kept_rows(const Spine& spine, std::span<const std::size_t> rows) {
  Spine kept;
  kept.length = spine.length;
  kept.is_closed = spine.is_closed;
  for (const std::size_t j : rows) {
    kept.rows.push_back(spine.rows[j]);
    kept.breaks.push_back(spine.breaks[j]);
    kept.poles.push_back(spine.poles[j]);
    kept.shares.push_back(spine.shares[j]);
    kept.v.push_back(spine.v[j]);
  }
  kept.runs = split_runs(kept.breaks);
  return kept;
}

}  // namespace sweepkit::sweep
