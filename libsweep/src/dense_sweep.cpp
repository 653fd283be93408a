// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "dense_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "distance.hpp"
#include "halving.hpp"
#include "number_text.hpp"
#include "section.hpp"
#include "stations.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::sweep {
namespace {

// A chord over two cells is off by four times as much as one over one: looked at in pairs, the cells are
// finer than asked for. Every step of density makes them four times as many.
constexpr double kDensityStep = 1.0 / 16;
// Finer than this nothing is divided: some 16 times what a mesh may have along a side.
constexpr std::size_t kMostDense = std::size_t{1} << 19;
// Directions whose extreme columns are looked at.
constexpr int kDirections = 12;

[[noreturn]] void refuse(const char* what, double tolerance) {
  throw InputError("tolerance of " + number_text(tolerance) + " m would need too many cells along the " +
                   what + "; ask for a larger one");
}

std::size_t total(const std::vector<int>& cells) {
  std::size_t sum = 0;
  for (const int count : cells) sum += static_cast<std::size_t>(count);
  return sum;
}

// `straight` of a straight piece; fewer where there are so many pieces that each is short, but so many that
// no bend is missed.
std::vector<int> least_cells(std::span<const Piece> pieces, int straight) {
  constexpr int kLeastOfABend = 3;
  const auto share = static_cast<int>(std::clamp<std::size_t>(kMostDense / 4 / pieces.size(), 1, 1024));
  std::vector<int> cells;
  cells.reserve(pieces.size());
  for (const Piece& piece : pieces) {
    const int least = std::min(piece.least_cells, std::max(share, kLeastOfABend));
    cells.push_back(std::max(least, std::min(share, straight)));
  }
  return cells;
}

// Chords of it are within `bound`; `tolerance` is what a message names.
Morph sample_outline(OutlineSampler outline, double bound, double tolerance, int straight) {
  std::vector<int> cells = least_cells(outline.pieces(), straight);
  outline.make_periods_equal(cells);
  for (;;) {
    if (total(cells) > kMostDense) refuse("contour", tolerance);
    Morph morph = outline.sample(cells);
    HalfErrors errors(cells, [&](std::size_t station) {
      // A contour walked backwards has its pieces the other way round.
      const std::size_t i = outline.is_backward() ? morph.columns() - station : station;
      double worst = 0;
      for (const Section& key : morph.keys) {
        const auto at = [&](std::size_t k) { return glm::dvec3(key.points[k].position, 0); };
        worst = std::max(worst, distance_to_segment(at(i), at(i - 1), at(i + 1)));
      }
      return worst;
    });
    outline.make_periods_equal(errors.left);
    outline.make_periods_equal(errors.right);
    const std::vector<bool> is_halved = halve_rough(cells, errors, outline.pieces(), bound);
    if (is_halved.empty()) return morph;
    outline.halve_pieces(is_halved);
  }
}

double largest(const Law& law) {
  // A law has no more turns than its points; 1,024 looks miss none that a profile shows.
  double value = 0;
  for (int i = 0; i <= 1024; ++i) value = std::max(value, law.at(i / 1024.0).value);
  return value;
}

bool is_without_turn(const SweepOptions& options) {
  return options.twist_deg.is_constant() && !options.orientation.guide &&
         options.orientation.frames == Frames::kRotationMinimizing;
}

// Does the section of a straight stretch change?
bool changes_on_the_way(const Curve3& trajectory, const SweepOptions& options) {
  return trajectory.is_closed() || !is_without_turn(options) || !options.morph.empty() ||
         !options.profile.x.is_constant() || !options.profile.y.is_constant();
}

// What follows from a dense sweep's spine.
void place_rows(DenseSweep& dense) {
  dense.weights.clear();
  dense.closing_columns.clear();
  dense.repeat_columns.clear();
  for (std::size_t i = 0; i < dense.morphs.size(); ++i) {
    const Morph& morph = dense.morphs[i];
    dense.weights.emplace_back();
    for (std::size_t j = 0; morph.changes() && j < dense.spine.shares.size(); ++j) {
      dense.weights.back().push_back(key_weights(morph, dense.spine.shares[j]));
    }
    dense.closing_columns.push_back(closing_columns(morph, dense.spine, dense.outer_of[i] != i));
    dense.repeat_columns.push_back(morph.columns() / static_cast<std::size_t>(dense.spine.symmetry));
  }
}

}  // namespace

std::vector<Morph> sample_densely(const ContourSamplers& samplers, double bound, double tolerance,
                                  int straight) {
  std::vector<Morph> morphs;
  morphs.reserve(samplers.outlines.size());
  for (const OutlineSampler& outline : samplers.outlines) {
    morphs.push_back(sample_outline(outline, bound, tolerance, straight));
  }
  return morphs;
}

void make_periodic(ContourSamplers& samplers) {
  for (OutlineSampler& outline : samplers.outlines) outline.make_periodic(kMostPeriods);
}

std::vector<ColumnPlace> extreme_columns(const std::vector<Morph>& morphs) {
  std::vector<ColumnPlace> extreme;
  for (int k = 0; k < kDirections; ++k) {
    const double a = 2 * std::numbers::pi * k / kDirections;
    const glm::dvec2 direction(std::cos(a), std::sin(a));
    double farthest = -std::numeric_limits<double>::infinity();
    ColumnPlace place{};
    for (std::size_t o = 0; o < morphs.size(); ++o) {
      for (const Section& key : morphs[o].keys) {
        for (std::size_t i = 0; i < key.points.size(); ++i) {
          const double along = glm::dot(key.points[i].position, direction);
          if (along > farthest) {
            farthest = along;
            place = {o, i};
          }
        }
      }
    }
    const bool is_known = std::any_of(extreme.begin(), extreme.end(), [&](const ColumnPlace& other) {
      return other.outline == place.outline && other.column == place.column;
    });
    if (!is_known) extreme.push_back(place);
  }
  return extreme;
}

JoinedTrajectory join_corners(const Curve3& trajectory, const ContourSamplers& samplers,
                              const SweepOptions& options) {
  std::optional<double> reach;
  return join_corners(trajectory, options.joints, options.miter_limit, [&](double length) {
    if (!reach) reach = reach_of(sample(samplers, kShapeCells));
    const double t = length / trajectory.length();
    return *reach * std::max(options.profile.x.at(t).value, options.profile.y.at(t).value);
  });
}

glm::dvec3 DenseSweep::position(const ColumnPlace& place, std::size_t row) const {
  const Morph& morph = morphs[place.outline];
  const std::size_t closing = row + 1 == spine.rows.size() ? closing_columns[place.outline] : 0;
  const std::size_t column = closing > 0 ? (place.column + closing) % morph.columns() : place.column;
  if (!morph.changes()) return position_of(spine.rows[row], morph.keys.front().points[column].position);
  return position_of(spine.rows[row], point_at(morph, weights[place.outline][row], column, true).position);
}

DenseSweep make_dense_sweep(const ContourSamplers& samplers, const Curve3& given, const SweepOptions& options,
                            double tolerance, int density) {
  DenseSweep dense;
  dense.outer_of = samplers.outer_of;
  const double size = std::max(largest(options.profile.x), largest(options.profile.y));
  const double bound = kDenseShare * tolerance * std::pow(kDensityStep, density);
  // Inside too: the cells are twisted where the section turns or changes.
  const int straight = kLeastLooks << (2 * density);
  dense.morphs = sample_densely(samplers, bound / size, tolerance, straight);
  const std::vector<ColumnPlace> extreme = extreme_columns(dense.morphs);
  const Curve3 trajectory = join_corners(given, samplers, options).curve;
  std::vector<Piece> pieces = segment_pieces(trajectory);
  dense.changes = changes_on_the_way(trajectory, options);
  std::vector<int> cells = least_cells(pieces, dense.changes ? straight : 1);
  for (;;) {
    if (total(cells) > kMostDense) refuse("trajectory", tolerance);
    dense.spine = make_spine(trajectory, place_stations<3>(trajectory, pieces, cells), dense.morphs, options,
                             kMostPeriods);
    place_rows(dense);
    const HalfErrors errors(cells, [&](std::size_t j) {
      double worst = 0;
      for (const ColumnPlace& place : extreme) {
        worst = std::max(worst, distance_to_segment(dense.position(place, j), dense.position(place, j - 1),
                                                    dense.position(place, j + 1)));
      }
      return worst;
    });
    const std::vector<bool> is_halved = halve_rough(cells, errors, pieces, bound);
    if (is_halved.empty()) return dense;
    pieces = halved(pieces, is_halved);
  }
}

}  // namespace sweepkit::sweep
