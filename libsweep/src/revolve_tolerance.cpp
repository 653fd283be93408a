// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// As for a sweep (tolerance.cpp), but the turn's chords are all alike: with n cells over an angle w a row of
// radius r is off by r (1 - cos(w / 2n)). For each way to cut the contour the least n is looked for with
// which the cells of one column, which stand for all, are measured to fit.

#include "revolve_tolerance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "cuts.hpp"
#include "distance.hpp"
#include "number_text.hpp"
#include "sweepkit/error.hpp"
#include "tolerance.hpp"

namespace sweepkit::sweep {
namespace {

// The share of a tolerance that is left to what lies between the samples.
constexpr double kSampleMargin = 1.0 / 64;
// A cell's sides are looked at in so many parts; the margin is what that may miss of a parabola.
constexpr std::size_t kParts = 8;
// Bounds for the contour from the tolerance down to an 8th of it.
constexpr int kBounds = 24;
constexpr int kBoundsAnOctave = 8;

using Cuts = std::vector<std::vector<std::size_t>>;  // an outline

glm::dvec3 turned(const glm::dvec2& p, double angle) {
  return {p.x * std::cos(angle), p.y, -p.x * std::sin(angle)};
}

class TurnFitter {
 public:
  TurnFitter(const std::vector<Section>& dense, double angle_deg)
      : dense_(dense), angle_(angle_deg * std::numbers::pi / 180), is_whole_(angle_deg == 360) {
    for (const Section& section : dense) {
      for (const SectionPoint& point : section.points) radius_ = std::max(radius_, point.position.x);
    }
  }

  struct Fit {
    Cuts cuts;
    int columns = 0;
    double deviation = 0;
  };

  Fit fit(double bound) const {
    std::optional<Fit> best;
    double least = 0;
    std::size_t rows_before = 0;
    for (int k = 0; k <= kBounds; ++k) {
      const double contour_bound = bound * std::exp2(-static_cast<double>(k) / kBoundsAnOctave);
      Cuts cuts;
      std::size_t rows = 0;
      for (const Section& section : dense_) {
        cuts.push_back(cut_section(section, contour_bound));
        rows += cuts.back().size() - 1;
      }
      if (rows == rows_before) continue;
      rows_before = rows;
      const std::optional<Fit> fit = columns_for(std::move(cuts), contour_bound, bound);
      if (!fit) continue;
      const double cells = static_cast<double>(rows) * fit->columns;
      if (!best || cells < least) {
        best = fit;
        least = cells;
      }
    }
    if (!best) {
      throw InputError("tolerance of " + number_text(bound / (1 - kSampleMargin)) +
                       " m would need too many cells round the turn; ask for a larger one");
    }
    return *best;
  }

 private:
  static std::vector<std::size_t> cut_section(const Section& section, double bound) {
    const auto at = [&](std::size_t i) { return glm::dvec3(section.points[i].position, 0); };
    const auto error = [&](std::size_t a, std::size_t b) {
      double worst = 0;
      for (std::size_t k = a + 1; k < b; ++k)
        worst = std::max(worst, distance_to_segment(at(k), at(a), at(b)));
      return worst;
    };
    const auto is_pole = [&](std::size_t i) { return section.points[i].position.x == 0; };
    std::vector<std::size_t> fixed = {0};
    const std::size_t last = section.points.size() - 1;
    for (std::size_t i = 1; i < last; ++i) {
      // The ends of a stretch on the axis, which has no surface, are vertices too.
      if (section.corners[i] || is_pole(i)) fixed.push_back(i);
    }
    fixed.push_back(last);
    std::size_t loop_least = 1;
    if (section.is_closed && fixed.size() <= 3) loop_least = fixed.size() == 2 ? 3 : 2;
    std::vector<std::size_t> cuts = {0};
    for (std::size_t k = 0; k + 1 < fixed.size(); ++k) {
      const bool is_on_axis = fixed[k + 1] == fixed[k] + 1;
      const bool is_lens = is_pole(fixed[k]) && is_pole(fixed[k + 1]) && !is_on_axis;
      const std::vector<std::size_t> piece = cut(
          fixed[k], fixed[k + 1], is_lens ? std::max<std::size_t>(2, loop_least) : loop_least, error, bound);
      cuts.insert(cuts.end(), piece.begin() + 1, piece.end());
    }
    return cuts;
  }

  std::optional<Fit> columns_for(Cuts cuts, double contour_bound, double bound) const {
    const int least = is_whole_ ? 3 : 1;
    const auto columns_at = [&](double error) {
      const double cosine = std::max(-1.0, 1 - error / radius_);
      return std::max(static_cast<double>(least), std::ceil(angle_ / (2 * std::acos(cosine))));
    };
    // What the contour leaves the turn is a first guess; from there by what is measured.
    double guess = columns_at(std::max(bound - contour_bound, 0.02 * bound));
    if (guess > kMaxCells) return std::nullopt;
    auto columns = static_cast<int>(guess);
    Fit fit{std::move(cuts), columns, measure(fit.cuts, columns)};
    while (fit.deviation > bound) {
      columns += std::max(1, columns / 64);
      if (columns > kMaxCells) return std::nullopt;
      fit.columns = columns;
      fit.deviation = measure(fit.cuts, columns);
    }
    while (columns > least) {
      const int fewer = columns - std::max(1, columns / 64);
      const double deviation = measure(fit.cuts, std::max(fewer, least));
      if (deviation > bound) break;
      columns = fit.columns = std::max(fewer, least);
      fit.deviation = deviation;
    }
    return fit;
  }

  double measure(const Cuts& cuts, int columns) const {
    const double cell = angle_ / columns;
    double worst = 0;
    for (std::size_t o = 0; o < cuts.size(); ++o) {
      const auto point = [&](std::size_t i) { return dense_[o].points[i].position; };
      for (std::size_t j = 0; j + 1 < cuts[o].size(); ++j) {
        const std::size_t from = cuts[o][j];
        const std::size_t to = cuts[o][j + 1];
        if (point(from).x == 0 && point(to).x == 0) continue;
        const DistanceCell triangles(turned(point(from), 0), turned(point(from), cell), turned(point(to), 0),
                                     turned(point(to), cell));
        for (std::size_t part = 0; part <= kParts; ++part) {
          const glm::dvec2 here = point(from + (to - from) * part / kParts);
          for (std::size_t k = 0; k <= kParts; ++k) {
            const glm::dvec3 surface = turned(here, cell * static_cast<double>(k) / kParts);
            worst = triangles.worse(surface, worst);
          }
        }
      }
    }
    return worst;
  }

  const std::vector<Section>& dense_;
  double angle_;  // radians
  bool is_whole_;
  double radius_ = 0;
};

}  // namespace

TurnedGrid fit_turned_grid(const std::vector<Section>& dense, double angle_deg, double tolerance) {
  const TurnFitter::Fit fit = TurnFitter(dense, angle_deg).fit(tolerance * (1 - kSampleMargin));
  TurnedGrid grid{{}, fit.columns, fit.deviation};
  for (std::size_t o = 0; o < dense.size(); ++o) grid.sections.push_back(kept_points(dense[o], fit.cuts[o]));
  return grid;
}

}  // namespace sweepkit::sweep
