// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A sweep folds where its surface runs backwards along the trajectory: with S_t the derivative by arc length
//   S_t . T = 1 - x p kN - y q kB < 0,
// x, y the section's, p, q the profile's, kN, kB the curvature (rows.cpp). 1 - S_t . T is how far the
// contour reaches over the radius of curvature. Mitres slide points along their legs: so the way from row to
// row is looked at as well. Both grow in proportion to the contour, whence the cure.

#include "sweepkit/sweep/finding.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iterator>
#include <numbers>

#include "counted_sweep.hpp"
#include "dense_sweep.hpp"
#include "halving.hpp"
#include "morph.hpp"
#include "number_text.hpp"
#include "outline_crossing.hpp"
#include "outline_sampler.hpp"
#include "section.hpp"
#include "spine.hpp"
#include "stations.hpp"

namespace sweepkit::sweep {
namespace {

// Rows and columns that are looked at, whatever the mesh has.
constexpr int kRows = 768;
constexpr int kColumns = 96;
// Between rows the trajectory bends by no more than half of this, except in a cusp.
constexpr double kRowsTurn = 10 * std::numbers::pi / 180;
// Of curves of many segments not every segment is looked at as closely.
constexpr std::size_t kMostLeastRows = 16384;
// Rounding, and a contour that reaches the centre of curvature exactly, is no fold.
constexpr double kFolds = 1 + 1e-9;
// A direction this near to the tangent tells where the section points with an error of a thousandth.
constexpr double kLeastSine = 1e-3;
// float32 keeps 24 bits; what it loses is a fault where it shows as a thousandth of the object.
constexpr double kFloatStep = 1.0 / (1 << 24);
constexpr double kLostShare = 1e-3;
// Normals are no part of that: a section's outline alone becomes uneven.
constexpr double kLostWidth = 1e-2;

std::string metres(double length) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g m", length);
  return text;
}

// To three or four digits.
std::string rounded_down(double factor) {
  const double unit = std::pow(10.0, std::floor(std::log10(factor)) - 3);
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", std::floor(factor / unit * kFolds) * unit);
  return text;
}

// The worst place of every stretch of rows where `badness` is above `limit`.
void add_stretches(std::vector<Finding>& findings, const Spine& spine, double limit,
                   const std::function<double(std::size_t)>& badness,
                   const std::function<Finding(std::size_t, double)>& describe) {
  const std::size_t count = spine.rows.size();
  for (std::size_t j = 0; j < count;) {
    double worst = badness(j);
    if (!(worst > limit)) {
      ++j;
      continue;
    }
    const std::size_t first = j;
    std::size_t place = j;
    for (; j < count; ++j) {
      const double here = badness(j);
      if (!(here > limit)) break;
      if (here > worst) {
        worst = here;
        place = j;
      }
    }
    Finding finding = describe(place, worst);
    finding.t = spine.shares[place];
    finding.from = spine.shares[first];
    finding.to = spine.shares[j - 1];
    finding.severity = worst;
    findings.push_back(std::move(finding));
  }
}

struct Checked : CountedSweep {
  glm::dvec2 point(std::size_t outline, std::size_t column, std::size_t row) const {
    const Morph& morph = morphs[outline];
    return point_at(morph, key_weights(morph, spine.shares[row]), column, true).position;
  }
};

// 1 - S_t . T at a row, and the way to the next in the same sense; the largest of all columns.
struct Fold {
  double badness = 0;
  glm::dvec2 point{0.0};
};

Fold fold_at(const Checked& checked, std::size_t j) {
  const std::vector<Row>& rows = checked.spine.rows;
  const Row& row = rows[j];
  Fold fold;
  const auto take = [&](double badness, const glm::dvec2& point) {
    if (badness > fold.badness) fold = {badness, point};
  };
  const bool has_next = j + 1 < rows.size();
  const glm::dvec3 way = has_next ? rows[j + 1].center - row.center : glm::dvec3(0.0);
  const double way_squared = glm::dot(way, way);
  for (std::size_t o = 0; o < checked.morphs.size(); ++o) {
    const Morph& morph = checked.morphs[o];
    const KeyWeights weights = key_weights(morph, checked.spine.shares[j]);
    const KeyWeights next_weights =
        has_next && morph.changes() ? key_weights(morph, checked.spine.shares[j + 1]) : weights;
    for (std::size_t i = 0; i <= morph.columns(); ++i) {
      const glm::dvec2 p = point_at(morph, weights, i, true).position;
      for (const RowSide* side : {&row.in, &row.out}) {
        take(-(p.x * glm::dot(side->x_rate, side->frame.tangent) +
               p.y * glm::dot(side->y_rate, side->frame.tangent)),
             p);
      }
      // On the mitre of a corner the next row belongs to the next leg; the last row of a loop is the first.
      if (has_next && way_squared > 0 && !(checked.spine.is_closed && j + 2 == rows.size())) {
        const glm::dvec2 q = point_at(morph, next_weights, i, true).position;
        const glm::dvec3 step = position_of(rows[j + 1], q) - position_of(row, p);
        // A part of 1 of it is the trajectory's own.
        if (row.is_corner || rows[j + 1].is_corner) take(1 - glm::dot(step, way) / way_squared, p);
      }
    }
  }
  return fold;
}

void find_folds(std::vector<Finding>& findings, const Checked& checked) {
  std::vector<Fold> folds;
  folds.reserve(checked.spine.rows.size());
  for (std::size_t j = 0; j < checked.spine.rows.size(); ++j) folds.push_back(fold_at(checked, j));
  add_stretches(
      findings, checked.spine, kFolds, [&](std::size_t j) { return folds[j].badness; },
      [&](std::size_t j, double worst) {
        const Row& row = checked.spine.rows[j];
        const glm::dvec3 arm = position_of(row, folds[j].point) - row.center;
        Finding finding{.kind = FindingKind::kFold, .point = position_of(row, folds[j].point)};
        const double reach = glm::length(arm);
        finding.problem = "the contour reaches " + metres(reach) + " where the trajectory leaves it " +
                          metres(reach / worst) + ", and folds over";
        finding.cure = "the contour fits when made " + rounded_down(1 / worst) + " times as large";
        return finding;
      });
}

void find_lost_directions(std::vector<Finding>& findings, const Checked& checked, const Curve3& trajectory,
                          const Orientation& orientation) {
  const Spine& spine = checked.spine;
  const bool has_up = orientation.frames == Frames::kFixedUp && !orientation.guide;
  const auto sine = [&](std::size_t j) {
    const Frame& frame = spine.rows[j].out.frame;
    if (has_up) return glm::length(glm::cross(glm::normalize(orientation.up), frame.tangent));
    const Curve3& guide = *orientation.guide;
    const glm::dvec3 target =
        guide.evaluate(guide.locate(guide.length() * spine.shares[j])).position - spine.rows[j].center;
    const double length = glm::length(target);
    return length > 0 ? glm::length(glm::cross(target / length, frame.tangent)) : 0;
  };
  if (has_up || orientation.guide) {
    add_stretches(
        findings, spine, 1 - kLeastSine, [&](std::size_t j) { return 1 - sine(j); },
        [&](std::size_t j, double) {
          Finding finding{.kind = FindingKind::kNoDirection, .point = spine.rows[j].center};
          finding.problem = has_up
                                ? "the trajectory runs along \"up\", which tells no direction there"
                                : "the guide lies on the trajectory's own line, and tells no direction there";
          finding.cure =
              has_up ? "choose another \"up\", or rotation-minimizing frames" : "move the guide aside";
          return finding;
        });
  } else if (orientation.frames == Frames::kFrenet) {
    bool is_straight = true;
    for (const Row& row : spine.rows) {
      const CurvePoint<3> here = trajectory.evaluate(trajectory.locate(
          trajectory.length() * spine.shares[static_cast<std::size_t>(&row - spine.rows.data())]));
      const double speed = glm::length(here.first);
      const double bend = glm::length(glm::cross(here.first, here.second));
      is_straight = is_straight && bend <= 1e-9 * speed * speed * speed / trajectory.length();
    }
    if (is_straight) {
      Finding finding{.kind = FindingKind::kNoDirection, .to = 1, .point = spine.rows.front().center};
      finding.problem =
          "the trajectory is straight: it has no centre of curvature for Frenet frames to point at";
      finding.cure = "choose rotation-minimizing or fixed-up frames";
      findings.push_back(std::move(finding));
    }
  }
}

std::vector<Finding> find_cusps(const Checked& checked) {
  std::vector<Finding> findings;
  const std::vector<Row>& rows = checked.spine.rows;
  for (std::size_t j = 0; j + 1 < rows.size(); ++j) {
    const double cosine = glm::dot(rows[j].out.frame.tangent, rows[j + 1].in.frame.tangent);
    if (cosine > -0.5) continue;  // less than two thirds of a turn back between rows this near is a bend
    Finding finding{.kind = FindingKind::kCusp,
                    .t = checked.spine.shares[j],
                    .from = checked.spine.shares[j],
                    .to = checked.spine.shares[j + 1],
                    .point = rows[j].center,
                    .severity = std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi};
    finding.problem =
        "the trajectory turns by " + number_text(std::round(finding.severity)) + " degrees almost in a point";
    finding.cure = "draw the turn as a bend or as a corner";
    findings.push_back(std::move(finding));
  }
  return findings;
}

// Any contour folds where the trajectory has a cusp: that is told, and no cure by size.
void leave_out_folds_at(std::vector<Finding> cusps, std::vector<Finding>& findings) {
  std::erase_if(findings, [&](const Finding& fold) {
    return std::any_of(cusps.begin(), cusps.end(),
                       [&](const Finding& cusp) { return fold.from <= cusp.to && cusp.from <= fold.to; });
  });
  findings.insert(findings.end(), std::make_move_iterator(cusps.begin()),
                  std::make_move_iterator(cusps.end()));
}

void find_contour_crossings(std::vector<Finding>& findings, std::span<const Curve2> contour) {
  for (const Curve2& outline : contour) {
    const std::vector<Station> stations = place_stations(outline, 4 * kColumns);
    std::vector<glm::dvec2> points;
    points.reserve(stations.size());
    for (const Station& station : stations) points.push_back(outline.evaluate(station.out).position);
    if (outline.is_closed()) points.pop_back();
    const std::optional<OutlineCrossing> crossing = find_crossing(points, outline.is_closed());
    if (!crossing) continue;
    Finding finding{.kind = FindingKind::kContourCrossing,
                    .t = stations[crossing->first].length / outline.length(),
                    .point = glm::dvec3(crossing->point, 0)};
    finding.from = finding.to = finding.t;
    finding.other = stations[crossing->second].length / outline.length();
    finding.problem = "the contour goes through itself at " + number_text(crossing->point.x) + ", " +
                      number_text(crossing->point.y);
    finding.cure = "draw it without the loop";
    findings.push_back(std::move(finding));
  }
}

// Places between two contours of a morph that are looked at.
constexpr int kMorphLooks = 16;

// Where the section goes through itself between contours that do not.
void find_folded_morphs(std::vector<Finding>& findings, const Checked& checked) {
  for (const Morph& morph : checked.morphs) {
    const auto crossing_at = [&](double t) {
      const Section section = section_at(morph, t);
      std::vector<glm::dvec2> points;
      points.reserve(section.points.size());
      for (const SectionPoint& point : section.points) points.push_back(point.position);
      if (section.is_closed) points.pop_back();
      return find_crossing(points, section.is_closed);
    };
    for (std::size_t k = 0; k + 1 < morph.keys.size(); ++k) {
      const double from = morph.at[k];
      const double to = morph.at[k + 1];
      if (crossing_at(from) || crossing_at(to)) continue;
      std::vector<double> crossed;
      for (int i = 1; i < kMorphLooks; ++i) {
        const double t = from + (to - from) * i / kMorphLooks;
        if (crossing_at(t)) crossed.push_back(t);
      }
      if (crossed.empty()) continue;
      const double t = crossed[crossed.size() / 2];
      const std::vector<double>& shares = checked.spine.shares;
      const auto row =
          static_cast<std::size_t>(std::lower_bound(shares.begin(), shares.end() - 1, t) - shares.begin());
      Finding finding{.kind = FindingKind::kFoldedMorph,
                      .t = t,
                      .from = crossed.front(),
                      .to = crossed.back(),
                      .point = position_of(checked.spine.rows[row], crossing_at(t)->point),
                      .severity = static_cast<double>(crossed.size()) / (kMorphLooks - 1)};
      finding.problem = "on its way from the contour at t = " + number_text(from) +
                        " to that at t = " + number_text(to) + " the section goes through itself";
      finding.cure = "give a contour between them, at t = " + number_text(t);
      findings.push_back(std::move(finding));
    }
  }
}

double largest_scale(const Spine& spine) {
  double scale = 0;
  for (const Row& row : spine.rows)
    scale = std::max({scale, glm::length(row.x_axis), glm::length(row.y_axis)});
  return scale;
}

// Stations by length, and more where the trajectory bends sharply.
std::vector<Station> look_at_bends(const Curve3& trajectory, std::span<const int> least_cells) {
  std::vector<Piece> pieces = segment_pieces(trajectory);
  const auto most_of_a_bend =
      static_cast<int>(std::clamp<std::size_t>(kMostLeastRows / pieces.size(), 1, kLeastLooks));
  std::vector<int> cells;
  cells.reserve(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i)
    cells.push_back(std::max(least_cells[i], std::min(most_of_a_bend, pieces[i].least_cells)));
  for (;;) {
    const std::vector<Station> stations = place_stations<3>(trajectory, pieces, cells);
    std::vector<glm::dvec3> tangents;
    tangents.reserve(stations.size());
    for (const Station& station : stations) tangents.push_back(trajectory.tangent(station.out));
    const HalfErrors turns(cells,
                           [&](std::size_t i) { return glm::distance(tangents[i - 1], tangents[i + 1]); });
    const std::vector<bool> is_halved = halve_rough(cells, turns, pieces, kRowsTurn);
    if (is_halved.empty()) break;
    pieces = halved(pieces, is_halved);
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) pieces[i].least_cells = cells[i];
  return place_stations<3>(trajectory, pieces, share_cells(pieces, kRows));
}

void find_lost_precision(std::vector<Finding>& findings, const glm::dvec3& middle, double size,
                         double width) {
  const double lost_in_width = 0.5 * size * kFloatStep;
  if (lost_in_width > kLostWidth * width) {
    Finding finding{.kind = FindingKind::kPrecision, .to = 1, .point = middle, .severity = lost_in_width};
    finding.problem = "the section of " + metres(width) + " belongs to an object of " + metres(size) +
                      ", of which float32 loses " + metres(lost_in_width);
    finding.cure = "make the section wider, or several objects of it";
    findings.push_back(std::move(finding));
  }
  const double lost = glm::length(middle) * kFloatStep;
  if (!(lost > kLostShare * size)) return;
  Finding finding{.kind = FindingKind::kPrecision, .to = 1, .point = middle, .severity = lost};
  finding.problem = "the object of " + metres(size) + " lies " + metres(glm::length(middle)) +
                    " from the origin, where float32, which viewers compute with, loses " + metres(lost);
  finding.cure = "move it to the origin";
  findings.push_back(std::move(finding));
}

}  // namespace

const char* name_of(FindingKind kind) {
  switch (kind) {
    case FindingKind::kFold:
      return "fold";
    case FindingKind::kCrossing:
      return "crossing";
    case FindingKind::kContourCrossing:
      return "contour crossing";
    case FindingKind::kFoldedMorph:
      return "folded morph";
    case FindingKind::kCusp:
      return "cusp";
    case FindingKind::kNoDirection:
      return "no direction";
    default:
      return "precision";
  }
}

std::vector<Finding> check_sweep(std::span<const Curve2> contour, const Curve3& given,
                                 const SweepOptions& options) {
  const ContourSamplers samplers = make_samplers(contour, options.morph, options.crease_deg, options.uv.by,
                                                 OutlineSampler::PiecesBy::kCorners);
  const auto [trajectory, least_cells] = join_corners(given, samplers, options);
  const std::vector<Station> stations = look_at_bends(trajectory, least_cells);
  const Checked checked{make_counted_sweep(samplers, kColumns, trajectory, stations, options)};
  std::vector<Finding> findings;
  find_folds(findings, checked);
  leave_out_folds_at(find_cusps(checked), findings);
  find_folded_morphs(findings, checked);
  find_lost_directions(findings, checked, trajectory, options.orientation);
  find_contour_crossings(findings, contour);
  for (const MorphKey& key : options.morph) find_contour_crossings(findings, key.contour);
  glm::dvec3 low = checked.spine.rows.front().center;
  glm::dvec3 high = low;
  for (const Row& row : checked.spine.rows) {
    low = glm::min(low, row.center);
    high = glm::max(high, row.center);
  }
  const double width = 2 * reach_of(checked.morphs) * largest_scale(checked.spine);
  find_lost_precision(findings, 0.5 * (low + high), glm::length(high - low) + width, width);
  return findings;
}

std::vector<Finding> check_revolve(std::span<const Curve2> contour, const RevolveOptions&) {
  std::vector<Finding> findings;
  find_contour_crossings(findings, contour);
  glm::dvec2 low = contour.front().evaluate({0, 0}).position;
  glm::dvec2 high = low;
  for (const Curve2& outline : contour) {
    for (const Station& station : place_stations(outline, kColumns)) {
      const glm::dvec2 p = outline.evaluate(station.out).position;
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
  const double size = std::hypot(2 * high.x, high.y - low.y);
  find_lost_precision(findings, {0, 0.5 * (low.y + high.y), 0}, size, glm::length(high - low));
  return findings;
}

}  // namespace sweepkit::sweep
