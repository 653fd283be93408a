// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A grid of columns and rows, as coarse as a tolerance allows. The contour takes a share of the tolerance:
// its columns are the fewest whose chords are within that (cuts.cpp). Then the rows are the fewest between
// which no cell of those columns misses the surface by more than the tolerance. Shares are tried until the
// cells become more again. Where the section turns or changes, columns are tried narrower too than their bend
// asks for. In the end all cells are measured.
//
// Between rows the extreme columns are looked at: with t fixed a point of the surface is linear in the
// section's (x, y), so its distance from a chord is convex in them and largest at a corner of the convex
// hull. What cells miss beyond that, by bending both ways or by being twisted, some of them tell.

#include "tolerance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "cuts.hpp"
#include "distance.hpp"

namespace sweepkit::sweep {
namespace {

// Rows whose columns are looked at, of a contour that changes.
constexpr std::size_t kMorphRows = 17;
// The share of a tolerance that is left to what lies between the samples.
constexpr double kSampleMargin = 1.0 / 64;
// Shares of the tolerance that the contour takes, so many to an octave; no further when so many in turn are
// worse.
constexpr int kShares = 48;
constexpr int kSharesAnOctave = 8;
constexpr int kWorseShares = 5;
constexpr int kMostHalvings = 6;
// Cells of a row that are looked at while rows are chosen; all of them in the end.
constexpr std::size_t kCellsEvenly = 16;
constexpr std::size_t kCellsWidest = 8;
// A cell's sides are looked at in so many parts.
constexpr std::size_t kParts = 4;
// Of the places under a chord up to so many are looked at: an arc is farthest from its chord near the middle.
// Where a measurement tells that this missed something - a turn as sharp as a needle's - more and more are.
constexpr std::size_t kLooks = 7;
constexpr std::size_t kMostLooks = std::size_t{1} << 20;

class GridFitter {
 public:
  explicit GridFitter(const DenseSweep& dense) : dense_(dense) {
    for (const ColumnPlace& place : extreme_columns(dense_.morphs)) {
      std::vector<glm::dvec3> line(dense_.spine.rows.size());
      for (std::size_t j = 0; j < line.size(); ++j) line[j] = dense_.position(place, j);
      along_.push_back(std::move(line));
    }
    sample_extreme_rows();
    for (const Morph& morph : dense_.morphs) lengths_.push_back(chord_lengths(morph.keys.front()));
  }

  Grid fit(double tolerance, double largest_share) const {
    const double bound = tolerance * (1 - kSampleMargin);
    Grid best = fit_columns(bound, std::numeric_limits<double>::infinity(), largest_share);
    if (!dense_.changes) return best;
    // What a twisted cell misses grows with its width, however straight its sides are: narrower columns may
    // need so many rows less that it pays.
    double width = widest_column(best);
    for (int halved = 0; halved < kMostHalvings; ++halved) {
      width /= 2;
      Grid narrower = fit_columns(bound, width, largest_share);
      if (best.deviation <= bound && !(narrower.deviation <= bound && cells_of(narrower) < cells_of(best)))
        break;
      best = std::move(narrower);
    }
    return best;
  }

 private:
  Grid fit_columns(double bound, double width, double largest_share) const {
    Grid best;
    double best_share = largest_share;
    std::size_t least = std::numeric_limits<std::size_t>::max();
    int worse = 0;
    std::vector<std::vector<std::size_t>> before;
    for (int k = 0; k <= kShares && worse < kWorseShares; ++k) {
      const double share = largest_share * std::exp2(-static_cast<double>(k) / kSharesAnOctave);
      Grid grid{cut_columns(share * bound, width)};
      if (grid.columns == before) continue;
      before = grid.columns;
      grid.rows = cut_rows(grid.columns, bound);
      ++worse;
      if (cells_of(grid) < least) {
        least = cells_of(grid);
        best = std::move(grid);
        best_share = share;
        worse = 0;
      }
    }
    best.deviation = deviation_of(best, dense_, lengths_);
    // Some places chose the cuts; what all of them show may ask for a little less, and for a closer look.
    double target = bound;
    std::size_t looks = kLooks;
    while (best.deviation > bound && target > 1e-2 * bound) {
      target *= std::clamp(0.99 * bound / best.deviation, 0.5, 0.98);
      looks = std::min(8 * looks, kMostLooks);
      best.columns = cut_columns(best_share * target, width, looks);
      best.rows = cut_rows(best.columns, target, looks);
      best.deviation = deviation_of(best, dense_, lengths_);
    }
    return best;
  }

  double widest_column(const Grid& grid) const {
    double widest = 0;
    for (std::size_t o = 0; o < grid.columns.size(); ++o) {
      const std::vector<std::size_t>& columns = grid.columns[o];
      for (std::size_t i = 0; i + 1 < columns.size(); ++i)
        widest = std::max(widest, lengths_[o][columns[i + 1]] - lengths_[o][columns[i]]);
    }
    return widest;
  }

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

  static double chord_error(const std::vector<std::vector<glm::dvec3>>& lines, std::size_t a, std::size_t b,
                            std::size_t looks) {
    const std::size_t places = std::min(b - a - 1, looks);
    double error = 0;
    for (const std::vector<glm::dvec3>& line : lines) {
      for (std::size_t k = 1; k <= places; ++k) {
        const std::size_t place = a + (b - a) * k / (places + 1);
        error = std::max(error, distance_to_segment(line[place], line[a], line[b]));
      }
    }
    return error;
  }

  static void append_cuts(std::vector<std::size_t>& all, const std::vector<std::size_t>& cuts) {
    all.insert(all.end(), cuts.begin() + (all.empty() ? 0 : 1), cuts.end());
  }

  std::vector<std::size_t> cut_outline(std::size_t outline, double bound, double width,
                                       std::size_t looks) const {
    const Section& section = dense_.morphs[outline].keys.front();
    const std::size_t last = section.points.size() - 1;
    const std::size_t end = dense_.closing_columns[outline] > 0 ? dense_.repeat_columns[outline] : last;
    std::vector<std::size_t> fixed = {0};
    for (std::size_t i = 1; i < end; ++i) {
      if (section.corners[i]) fixed.push_back(i);
    }
    fixed.push_back(end);
    const auto error = [&](std::size_t a, std::size_t b) {
      return chord_error(across_[outline], a, b, looks);
    };
    // A loop has three cells at least; where it is repeated more than once two pieces do.
    std::size_t least = 1;
    if (section.is_closed && end == last && fixed.size() <= 3) least = fixed.size() == 2 ? 3 : 2;
    if (section.is_closed && end < last && fixed.size() == 2) least = 2;
    std::vector<std::size_t> columns;
    for (std::size_t k = 0; k + 1 < fixed.size(); ++k) {
      append_cuts(columns, cut(fixed[k], fixed[k + 1], least, error, bound));
    }
    narrow(columns, lengths_[outline], width);
    const std::size_t period = columns.size();
    for (std::size_t turned = end; turned < last; turned += end) {
      for (std::size_t i = 1; i < period; ++i) columns.push_back(turned + columns[i]);
    }
    return columns;
  }

  // A cell of a row of cells, and places in it from one side to the other.
  struct CellColumns {
    std::size_t outline;
    std::vector<std::size_t> columns;
  };

  // Cells spread evenly over those of all outlines, and the widest.
  std::vector<CellColumns> cells_to_look_at(const std::vector<std::vector<std::size_t>>& columns) const {
    struct Candidate {
      double width;
      std::size_t outline, cell;
    };
    std::vector<Candidate> all;
    for (std::size_t o = 0; o < columns.size(); ++o) {
      for (std::size_t i = 0; i + 1 < columns[o].size(); ++i)
        all.push_back({lengths_[o][columns[o][i + 1]] - lengths_[o][columns[o][i]], o, i});
    }
    std::vector<Candidate> chosen;
    const std::size_t stride = (all.size() + kCellsEvenly - 1) / kCellsEvenly;
    for (std::size_t k = 0; k < all.size(); k += stride) chosen.push_back(all[k]);
    if (stride > 1) {
      const std::size_t widest = std::min(kCellsWidest, all.size());
      std::partial_sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(widest), all.end(),
                        [](const Candidate& a, const Candidate& b) { return a.width > b.width; });
      chosen.insert(chosen.end(), all.begin(), all.begin() + static_cast<std::ptrdiff_t>(widest));
    }
    std::vector<CellColumns> cells;
    cells.reserve(chosen.size());
    for (const Candidate& candidate : chosen) {
      const std::vector<std::size_t>& outline = columns[candidate.outline];
      CellColumns cell{candidate.outline, {}};
      add_parts(lengths_[cell.outline], outline[candidate.cell], outline[candidate.cell + 1], kParts,
                cell.columns);
      cell.columns.push_back(outline[candidate.cell + 1]);
      cells.push_back(std::move(cell));
    }
    return cells;
  }

  // By how much some cells between two rows miss the surface; where that is above `bound`, a number above it.
  double cell_error(const std::vector<CellColumns>& cells, std::size_t first, std::size_t last, double bound,
                    std::size_t looks) const {
    double error = chord_error(along_, first, last, looks);
    std::vector<std::size_t> rows;
    add_parts(dense_.spine.shares, first, last, kParts, rows);
    for (const CellColumns& cell : cells) {
      if (error > bound) break;
      const auto point = [&](std::size_t column, std::size_t row) {
        return dense_.position({cell.outline, column}, row);
      };
      const DistanceCell triangles(point(cell.columns.front(), first), point(cell.columns.back(), first),
                                   point(cell.columns.front(), last), point(cell.columns.back(), last));
      // Inside only: the chords of the sides have been looked at.
      for (std::size_t k = 1; k < rows.size(); ++k) {
        for (std::size_t c = 1; c + 1 < cell.columns.size(); ++c)
          error = triangles.worse(point(cell.columns[c], rows[k]), error);
      }
    }
    return error;
  }

  std::vector<std::size_t> cut_rows(const std::vector<std::vector<std::size_t>>& columns, double bound,
                                    std::size_t looks = kLooks) const {
    const std::vector<Row>& rows = dense_.spine.rows;
    std::vector<std::size_t> fixed = {0};
    for (std::size_t j = 1; j + 1 < rows.size(); ++j) {
      if (rows[j].is_corner || rows[j].is_pole) fixed.push_back(j);
    }
    fixed.push_back(rows.size() - 1);
    const std::vector<CellColumns> cells = cells_to_look_at(columns);
    const auto error = [&](std::size_t a, std::size_t b) { return cell_error(cells, a, b, bound, looks); };
    std::size_t loop_least = 1;
    if (dense_.spine.is_closed && fixed.size() <= 3) loop_least = fixed.size() == 2 ? 3 : 2;
    std::vector<std::size_t> cuts;
    for (std::size_t k = 0; k + 1 < fixed.size(); ++k) {
      // Between two poles a single row would have no surface.
      const bool is_lens = rows[fixed[k]].is_pole && rows[fixed[k + 1]].is_pole;
      append_cuts(cuts, cut(fixed[k], fixed[k + 1],
                            is_lens ? std::max<std::size_t>(2, loop_least) : loop_least, error, bound));
    }
    return cuts;
  }

  static void narrow(std::vector<std::size_t>& columns, std::span<const double> lengths, double width) {
    std::vector<std::size_t> narrow;
    for (std::size_t i = 0; i + 1 < columns.size(); ++i) {
      const double parts = std::ceil((lengths[columns[i + 1]] - lengths[columns[i]]) / width);
      add_parts(lengths, columns[i], columns[i + 1], static_cast<std::size_t>(std::max(parts, 1.0)), narrow);
    }
    narrow.push_back(columns.back());
    columns = std::move(narrow);
  }

  std::vector<std::vector<std::size_t>> cut_columns(double bound, double width,
                                                    std::size_t looks = kLooks) const {
    std::vector<std::vector<std::size_t>> columns;
    columns.reserve(dense_.morphs.size());
    for (std::size_t o = 0; o < dense_.morphs.size(); ++o)
      columns.push_back(cut_outline(o, bound, width, looks));
    return columns;
  }

  const DenseSweep& dense_;
  std::vector<std::vector<double>> lengths_;  // an outline: of its columns
  // an outline, a row; of those that change
  std::vector<std::vector<glm::dvec3>> along_;                // extreme columns, a point a row
  std::vector<std::vector<std::vector<glm::dvec3>>> across_;  // an outline: extreme rows, a point a column
};

}  // namespace

Grid fit_grid(const DenseSweep& dense, double tolerance, double largest_share) {
  return GridFitter(dense).fit(tolerance, largest_share);
}

bool is_well_measured(const DenseSweep& dense, const Grid& grid, double tolerance) {
  if (grid.deviation > tolerance) return false;
  if (!dense.changes) return true;
  // Three neighbours, one of which may be the rest of a stretch, need so many dense cells. Where there are
  // not many to look at, looking closely costs little.
  constexpr std::size_t kFewCells = 5000;
  const std::size_t enough = cells_of(grid) < kFewCells ? 48 : 18;
  const auto has_few = [enough](const std::vector<std::size_t>& cuts) {
    const std::size_t neighbours = std::min<std::size_t>(3, cuts.size() - 1);
    for (std::size_t i = neighbours; i < cuts.size(); ++i) {
      if (3 * (cuts[i] - cuts[i - neighbours]) < neighbours * enough) return true;
    }
    return false;
  };
  return !has_few(grid.rows) && std::none_of(grid.columns.begin(), grid.columns.end(), has_few);
}

Section kept_points(const Section& section, std::span<const std::size_t> columns) {
  Section kept;
  kept.is_closed = section.is_closed;
  kept.points.reserve(columns.size());
  kept.fractions.reserve(columns.size());
  for (const std::size_t i : columns) {
    kept.points.push_back(section.points[i]);
    kept.fractions.push_back(section.fractions[i]);
    kept.breaks.push_back(section.breaks[i]);
    kept.corners.push_back(section.corners[i]);
  }
  return kept;
}

Morph kept_columns(const Morph& morph, std::span<const std::size_t> columns) {
  Morph kept;
  kept.at = morph.at;
  kept.slopes = morph.slopes;
  kept.keys.reserve(morph.keys.size());
  for (const Section& key : morph.keys) kept.keys.push_back(kept_points(key, columns));
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
