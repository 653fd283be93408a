// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "grid_deviation.hpp"

#include <algorithm>
#include <array>

#include "distance.hpp"

namespace sweepkit::sweep {
namespace {

// A cell's sides are looked at in so many parts, the worst cells' again in more. A cell of very many is so
// small that the middles of its sides and diagonal are its worst places.
constexpr std::size_t kParts = 4;
constexpr std::size_t kPartsOfMany = 2;
constexpr std::size_t kManyCells = 200000;
constexpr std::size_t kPartsOfWorst = 16;
constexpr std::size_t kWorstCells = 300;
// Parts as few as 4 miss no half of what there is.
constexpr double kLittle = 0.5;

// Places of the dense sweep in a row of cells.
struct CellSamples {
  std::vector<std::size_t> columns;
  std::vector<std::size_t> first_of_cell;  // in `columns`; one more than cells
  std::vector<std::size_t> rows;
  std::vector<std::vector<glm::dvec3>> points;  // a row, a column
};

// A cell of a grid and what is missed there.
struct Missed {
  double distance;
  std::size_t outline, column, row;
};

class DeviationMeasurer {
 public:
  DeviationMeasurer(const DenseSweep& dense, const std::vector<std::vector<double>>& lengths)
      : dense_(dense), lengths_(lengths) {}

  double measure(const Grid& grid) const {
    const std::size_t parts = cells_of(grid) > kManyCells ? kPartsOfMany : kParts;
    std::vector<Missed> missed;
    double most = 0;
    for_each_row_of_cells(grid, parts, [&](std::size_t outline, std::size_t row, const CellSamples& samples) {
      for (std::size_t i = 0; i + 1 < samples.first_of_cell.size(); ++i) {
        const double little = kLittle * most;
        const double distance = missed_in(samples, i, little);
        if (distance <= little) continue;
        missed.push_back({distance, outline, i, row});
        most = std::max(most, distance);
      }
    });
    const std::size_t count = std::min(kWorstCells, missed.size());
    const auto worst = missed.begin() + static_cast<std::ptrdiff_t>(count);
    std::partial_sort(missed.begin(), worst, missed.end(),
                      [](const Missed& a, const Missed& b) { return a.distance > b.distance; });
    for (const Missed& cell : std::span(missed).first(count)) most = std::max(most, look_closely(grid, cell));
    return most;
  }

 private:
  // Where two triangles are as far from the surface it has a ridge, and its worst place lies on that: looked
  // for in the cell, then about the worst found.
  double look_closely(const Grid& grid, const Missed& cell) const {
    const std::vector<std::size_t>& columns = grid.columns[cell.outline];
    const std::array<std::size_t, 2> across = {columns[cell.column], columns[cell.column + 1]};
    const std::array<std::size_t, 2> along = {grid.rows[cell.row], grid.rows[cell.row + 1]};
    const auto point = [&](std::size_t column, std::size_t row) {
      return dense_.position({cell.outline, column}, row);
    };
    const DistanceCell triangles(point(across[0], along[0]), point(across[1], along[0]),
                                 point(across[0], along[1]), point(across[1], along[1]));
    double worst = 0;
    std::array<std::size_t, 4> window = {across[0], across[1], along[0], along[1]};
    std::vector<std::size_t> sample_columns;
    std::vector<std::size_t> sample_rows;
    for (int round = 0; round < 2; ++round) {
      sample_columns.clear();
      sample_rows.clear();
      add_parts(lengths_[cell.outline], window[0], window[1], kPartsOfWorst, sample_columns);
      add_parts(dense_.spine.shares, window[2], window[3], kPartsOfWorst, sample_rows);
      sample_columns.push_back(window[1]);
      sample_rows.push_back(window[3]);
      for (std::size_t k = 0; k < sample_rows.size(); ++k) {
        for (std::size_t c = 0; c < sample_columns.size(); ++c) {
          const double distance = triangles.worse(point(sample_columns[c], sample_rows[k]), worst);
          if (distance <= worst) continue;
          worst = distance;
          window = {sample_columns[c - std::min<std::size_t>(c, 1)],
                    sample_columns[std::min(c + 1, sample_columns.size() - 1)],
                    sample_rows[k - std::min<std::size_t>(k, 1)],
                    sample_rows[std::min(k + 1, sample_rows.size() - 1)]};
        }
      }
    }
    return worst;
  }

  template <class Visit>
  void for_each_row_of_cells(const Grid& grid, std::size_t parts, const Visit& visit) const {
    CellSamples samples;
    for (std::size_t o = 0; o < grid.columns.size(); ++o) {
      sample_columns(samples, o, grid.columns[o], parts);
      for (std::size_t j = 0; j + 1 < grid.rows.size(); ++j) {
        sample_rows(samples, o, grid.rows[j], grid.rows[j + 1], parts);
        visit(o, j, samples);
      }
    }
  }

  void sample_columns(CellSamples& samples, std::size_t outline, std::span<const std::size_t> columns,
                      std::size_t parts) const {
    samples.columns.clear();
    samples.first_of_cell.clear();
    for (std::size_t i = 0; i + 1 < columns.size(); ++i) {
      samples.first_of_cell.push_back(samples.columns.size());
      add_parts(lengths_[outline], columns[i], columns[i + 1], parts, samples.columns);
    }
    samples.first_of_cell.push_back(samples.columns.size());
    samples.columns.push_back(columns.back());
  }

  void sample_rows(CellSamples& samples, std::size_t outline, std::size_t first, std::size_t last,
                   std::size_t parts) const {
    samples.rows.clear();
    add_parts(dense_.spine.shares, first, last, parts, samples.rows);
    samples.rows.push_back(last);
    samples.points.resize(samples.rows.size());
    for (std::size_t k = 0; k < samples.rows.size(); ++k) {
      samples.points[k].clear();
      for (const std::size_t column : samples.columns)
        samples.points[k].push_back(dense_.position({outline, column}, samples.rows[k]));
    }
  }

  // The larger of `worst` and what a cell misses.
  static double missed_in(const CellSamples& samples, std::size_t cell, double worst) {
    const std::size_t from = samples.first_of_cell[cell];
    const std::size_t to = samples.first_of_cell[cell + 1];
    const DistanceCell triangles(samples.points.front()[from], samples.points.front()[to],
                                 samples.points.back()[from], samples.points.back()[to]);
    for (const std::vector<glm::dvec3>& line : samples.points) {
      for (std::size_t c = from; c <= to; ++c) worst = triangles.worse(line[c], worst);
    }
    return worst;
  }

  const DenseSweep& dense_;
  const std::vector<std::vector<double>>& lengths_;
};

}  // namespace

std::size_t cells_of(const Grid& grid) {
  std::size_t cells = 0;
  for (const std::vector<std::size_t>& columns : grid.columns)
    cells += (columns.size() - 1) * (grid.rows.size() - 1);
  return cells;
}

std::vector<double> chord_lengths(const Section& section) {
  std::vector<double> lengths = {0};
  for (std::size_t i = 1; i < section.points.size(); ++i) {
    lengths.push_back(lengths.back() +
                      glm::length(section.points[i].position - section.points[i - 1].position));
  }
  return lengths;
}

void add_parts(std::span<const double> lengths, std::size_t first, std::size_t last, std::size_t parts,
               std::vector<std::size_t>& places) {
  const auto at = [&](std::size_t place) { return lengths.begin() + static_cast<std::ptrdiff_t>(place); };
  places.push_back(first);
  for (std::size_t part = 1; part < parts && places.back() + 1 < last; ++part) {
    const double share = static_cast<double>(part) / static_cast<double>(parts);
    const double length = lengths[first] + (lengths[last] - lengths[first]) * share;
    const auto after = std::upper_bound(at(places.back() + 1), at(last - 1), length);
    auto place = static_cast<std::size_t>(after - lengths.begin());
    if (place > places.back() + 1 && length - lengths[place - 1] < lengths[place] - length) --place;
    places.push_back(place);
  }
}

double deviation_of(const Grid& grid, const DenseSweep& dense,
                    const std::vector<std::vector<double>>& lengths) {
  return DeviationMeasurer(dense, lengths).measure(grid);
}

}  // namespace sweepkit::sweep
