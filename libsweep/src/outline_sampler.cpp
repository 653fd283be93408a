// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "outline_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "nesting.hpp"
#include "number_text.hpp"
#include "sweepkit/error.hpp"
#include "symmetry.hpp"

namespace sweepkit::sweep {
namespace {

// Breaks nearer than this on a contour are one vertex.
constexpr double kSameBreak = 1e-7;

// A section that is walked by a common parameter: tangents by it.
void scale_tangents(Section& section, const std::vector<double>& speed_in,
                    const std::vector<double>& speed_out) {
  for (std::size_t i = 0; i < section.points.size(); ++i) {
    section.points[i].tangent_in *= speed_in[i];
    section.points[i].tangent_out *= speed_out[i];
  }
}

void check_keys(std::span<const MorphKey> morph) {
  double before = 0;
  for (const MorphKey& key : morph) {
    if (!(key.at > before && key.at <= 1)) {
      throw InputError("morph goes on at t = " + number_text(key.at) + " after t = " + number_text(before) +
                       "; let its t ascend, above 0 (where the contour itself is) and at most 1");
    }
    before = key.at;
  }
}

glm::dvec2 middle_of(const Curve2& outline) {
  constexpr int kSamples = 32;
  glm::dvec2 sum(0.0);
  for (int i = 0; i < kSamples; ++i) {
    sum += outline.evaluate(outline.locate(outline.length() * i / kSamples)).position;
  }
  return sum / static_cast<double>(kSamples);
}

// Which outline of a key each outline of the contour becomes: an outer one an outer one, a hole a hole of the
// same, the nearest first come.
std::vector<std::size_t> partners(std::span<const Curve2> contour, std::span<const std::size_t> outer_of,
                                  const MorphKey& key) {
  const std::string place = "morph at t = " + number_text(key.at);
  const std::vector<std::size_t> key_outer_of = nest_outlines(key.contour);
  const auto holes = [](std::span<const std::size_t> outers) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < outers.size(); ++i) count += outers[i] != i ? 1 : 0;
    return count;
  };
  if (key.contour.size() != contour.size() || holes(outer_of) != holes(key_outer_of)) {
    throw InputError(place + " has " + std::to_string(key.contour.size()) + " outlines, " +
                     std::to_string(holes(key_outer_of)) + " of them holes, but the contour has " +
                     std::to_string(contour.size()) + " and " + std::to_string(holes(outer_of)) +
                     "; let every contour have as many");
  }
  constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> partner(contour.size(), kNone);
  std::vector<bool> is_taken(contour.size(), false);
  // Outer ones first: a hole looks only inside of its outer one's partner.
  for (const bool is_hole : {false, true}) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      if ((outer_of[i] != i) != is_hole) continue;
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t j = 0; j < key.contour.size(); ++j) {
        if (is_taken[j] || (key_outer_of[j] != j) != is_hole) continue;
        if (is_hole && key_outer_of[j] != partner[outer_of[i]]) continue;
        const double distance = glm::length(middle_of(contour[i]) - middle_of(key.contour[j]));
        if (distance < nearest) {
          nearest = distance;
          partner[i] = j;
        }
      }
      if (partner[i] == kNone) {
        throw InputError(place +
                         " has its holes in other outlines than the contour; let every contour have as "
                         "many in each");
      }
      is_taken[partner[i]] = true;
    }
  }
  return partner;
}

}  // namespace

OutlineSampler::OutlineSampler(const std::vector<Key>& keys, const SectionOptions& options, PiecesBy by)
    : options_(options) {
  // Enough to know which way a contour runs.
  constexpr int kCells = 128;
  const bool is_one = keys.size() == 1;
  for (const Key& key : keys) {
    at_.push_back(key.at);
    if (key.curve->is_closed() != keys.front().curve->is_closed()) {
      throw InputError(
          "morph at t = " + number_text(key.at) + " goes from " +
          (key.curve->is_closed() ? "an open contour to a closed" : "a closed contour to an open") +
          " one; let all be closed or all open");
    }
    // One contour alone is asked with the cells it gets.
    const bool is_backward =
        !is_one && is_drawn_backwards(*key.curve, place_stations(*key.curve, kCells), options.is_hole);
    walks_.emplace_back(*key.curve, is_backward);
  }
  const Curve2& first = *keys.front().curve;
  if (is_one) {
    pieces_ = by == PiecesBy::kCorners ? smooth_pieces(first) : segment_pieces(first);
    if (by == PiecesBy::kSegments) {
      is_backward_ = is_drawn_backwards(first, place_stations(first, kCells), options.is_hole);
    }
    return;
  }

  maps_.push_back({{{0, 0}, {1, 1}}});
  for (std::size_t k = 1; k < walks_.size(); ++k) {
    const RisingMap step = match(walks_[k - 1], walks_[k]);
    const RisingMap& before = maps_.back();
    // step(before(x)); before goes beyond 1 where its contour starts elsewhere.
    const auto through = [&](double x) {
      const double y = before.at(x);
      const double turns = std::floor(y);
      return turns + step.at(y - turns);
    };
    std::vector<double> xs;
    for (const glm::dvec2& knot : before.knots) xs.push_back(knot.x);
    for (const glm::dvec2& knot : step.knots) {
      for (const double turns : {-1.0, 0.0, 1.0, 2.0}) {
        const double y = knot.x + turns;
        if (y > before.knots.front().y && y < before.knots.back().y) xs.push_back(before.inverse(y));
      }
    }
    std::sort(xs.begin(), xs.end());
    RisingMap map;
    for (const double x : xs) {
      if (!map.knots.empty() && x <= map.knots.back().x + kSameBreak * 1e-3) continue;
      map.knots.emplace_back(x, through(x));
    }
    map.knots.back() = {1, map.knots.front().y + before.knots.back().y - before.knots.front().y};
    maps_.push_back(std::move(map));
  }

  breaks_ = {0, 1};
  for (std::size_t k = 0; k < walks_.size(); ++k) {
    for (const glm::dvec2& knot : maps_[k].knots) breaks_.push_back(knot.x);
    for (const Walk::Corner& corner : walks_[k].corners()) {
      for (const double turns : {-1.0, 0.0, 1.0, 2.0, 3.0}) {
        const double y = corner.at + turns;
        if (y >= maps_[k].knots.front().y && y <= maps_[k].knots.back().y) {
          breaks_.push_back(maps_[k].inverse(y));
        }
      }
    }
  }
  std::sort(breaks_.begin(), breaks_.end());
  std::vector<double> kept;
  for (const double x : breaks_) {
    if (kept.empty() || x > kept.back() + kSameBreak) kept.push_back(x);
  }
  kept.back() = 1;
  breaks_ = std::move(kept);
  for (std::size_t i = 0; i + 1 < breaks_.size(); ++i) {
    double length = 0;
    for (std::size_t k = 0; k < walks_.size(); ++k) {
      length = std::max(length,
                        walks_[k].curve().length() * (maps_[k].at(breaks_[i + 1]) - maps_[k].at(breaks_[i])));
    }
    pieces_.push_back({i, 0, length, by == PiecesBy::kSegments ? kLeastLooks : 1});
  }
}

double OutlineSampler::length() const {
  double length = 0;
  for (const Piece& piece : pieces_) length += piece.length;
  return length;
}

void OutlineSampler::make_periodic(int most) {
  if (walks_.size() > 1 || !is_closed()) return;
  const Curve2& curve = walks_.front().curve();
  periods_ = symmetry_of(curve, most);
  if (periods_ == 1) return;
  const double period = curve.length() / periods_;
  // Joints that repeat but for rounding are one.
  const double same = 1e-9 * curve.length();
  std::vector<double> offsets;
  offsets.reserve(pieces_.size());
  for (const Piece& piece : pieces_) {
    const double offset = std::fmod(piece.start, period);
    offsets.push_back(offset > period - same ? 0 : offset);
  }
  std::sort(offsets.begin(), offsets.end());
  offsets.erase(
      std::unique(offsets.begin(), offsets.end(), [&](double a, double b) { return b - a <= same; }),
      offsets.end());
  std::vector<Piece> pieces;
  pieces.reserve(offsets.size() * static_cast<std::size_t>(periods_));
  auto joint = pieces_.begin();
  for (int k = 0; k < periods_; ++k) {
    for (const double offset : offsets) {
      double start = k * period + offset;
      while (std::next(joint) != pieces_.end() && std::next(joint)->start <= start + same) ++joint;
      if (std::abs(joint->start - start) <= same) start = joint->start;
      if (!pieces.empty()) pieces.back().length = start - pieces.back().start;
      pieces.push_back({joint->first, start, curve.length() - start, joint->least_cells});
    }
  }
  pieces_ = std::move(pieces);
}

void OutlineSampler::halve_pieces(const std::vector<bool>& is_halved) {
  pieces_ = halved(pieces_, is_halved);
  if (breaks_.empty()) return;
  std::vector<double> breaks;
  breaks.reserve(pieces_.size() + 1);
  for (std::size_t i = 0; i < is_halved.size(); ++i) {
    breaks.push_back(breaks_[i]);
    if (is_halved[i]) breaks.push_back(0.5 * (breaks_[i] + breaks_[i + 1]));
  }
  breaks.push_back(1);
  breaks_ = std::move(breaks);
}

Morph OutlineSampler::sample(std::span<const int> cells) const {
  if (walks_.size() == 1) return sample_one(cells);
  const std::vector<double> at = places(cells);
  const std::size_t count = at.size();
  Morph morph;
  morph.at = at_;
  for (std::size_t k = 0; k < walks_.size(); ++k) {
    const Walk& walk = walks_[k];
    const RisingMap& map = maps_[k];
    std::vector<Station> stations(count);
    std::vector<double> speed_in(count);
    std::vector<double> speed_out(count);
    for (std::size_t i = 0; i < count; ++i) {
      const Walk::Place place = walk.place(map.at(at[i]));
      stations[i] = {place.in, place.out, at[i], at[i], place.is_corner};
      // The map is straight between places, since its knots are among the breaks.
      if (i > 0) speed_in[i] = speed_out[i - 1] = (map.at(at[i]) - map.at(at[i - 1])) / (at[i] - at[i - 1]);
    }
    speed_in.front() = walk.curve().is_closed() ? speed_in.back() : speed_out.front();
    speed_out.back() = walk.curve().is_closed() ? speed_out.front() : speed_in.back();
    for (double& speed : speed_in) speed *= walk.curve().length();
    for (double& speed : speed_out) speed *= walk.curve().length();
    Section section = make_section(walk.curve(), stations, walk.direction(), options_);
    scale_tangents(section, speed_in, speed_out);
    morph.keys.push_back(std::move(section));
  }
  // A normal that breaks at one key breaks all the way.
  for (std::size_t i = 0; i < count; ++i) {
    const bool breaks =
        std::any_of(morph.keys.begin(), morph.keys.end(), [i](const Section& key) { return key.breaks[i]; });
    const bool is_corner =
        std::any_of(morph.keys.begin(), morph.keys.end(), [i](const Section& key) { return key.corners[i]; });
    for (Section& key : morph.keys) {
      key.breaks[i] = breaks;
      key.corners[i] = is_corner;
    }
  }
  find_slopes(morph);
  return morph;
}

Morph OutlineSampler::sample_one(std::span<const int> cells) const {
  const Curve2& curve = walks_.front().curve();
  std::vector<Station> stations = place_stations<2>(curve, pieces_, cells);
  Morph morph;
  morph.at = {0};
  if (is_drawn_backwards(curve, stations, options_.is_hole)) {
    morph.keys.push_back(make_section(curve, reversed(curve, std::move(stations)), -1, options_));
  } else {
    morph.keys.push_back(make_section(curve, stations, 1, options_));
  }
  find_slopes(morph);
  return morph;
}

// The columns on the first key's walk.
std::vector<double> OutlineSampler::places(std::span<const int> cells) const {
  std::vector<double> at;
  for (std::size_t i = 0; i + 1 < breaks_.size(); ++i) {
    for (int cell = 0; cell < cells[i]; ++cell) {
      at.push_back(breaks_[i] + (breaks_[i + 1] - breaks_[i]) * cell / cells[i]);
    }
  }
  at.push_back(1);
  return at;
}

ContourSamplers make_samplers(std::span<const Curve2> contour, std::span<const MorphKey> morph,
                              double crease_deg, UvBy by, OutlineSampler::PiecesBy pieces_by) {
  check_keys(morph);
  ContourSamplers samplers;
  samplers.outer_of = nest_outlines(contour);
  std::vector<std::vector<OutlineSampler::Key>> keys;
  for (const Curve2& outline : contour) keys.push_back({{0, &outline}});
  for (const MorphKey& key : morph) {
    const std::vector<std::size_t> partner = partners(contour, samplers.outer_of, key);
    for (std::size_t i = 0; i < contour.size(); ++i) keys[i].push_back({key.at, &key.contour[partner[i]]});
  }
  for (std::size_t i = 0; i < contour.size(); ++i) {
    samplers.outlines.emplace_back(keys[i], SectionOptions{crease_deg, by, samplers.outer_of[i] != i},
                                   pieces_by);
  }
  return samplers;
}

namespace {

// `cells` shared among the pieces of all outlines.
std::vector<int> share_among(const ContourSamplers& samplers, int cells) {
  std::vector<Piece> pieces;
  for (const OutlineSampler& outline : samplers.outlines) {
    pieces.insert(pieces.end(), outline.pieces().begin(), outline.pieces().end());
    // Fewer would enclose nothing.
    if (samplers.outlines.size() > 1 && outline.is_closed() && outline.pieces().size() < 3) {
      for (std::size_t k = pieces.size() - outline.pieces().size(); k < pieces.size(); ++k)
        pieces[k].least_cells = outline.pieces().size() == 1 ? 3 : 2;
    }
  }
  return share_cells(pieces, cells);
}

std::vector<Morph> sample_shares(const ContourSamplers& samplers, std::span<const int> shares) {
  std::vector<Morph> morphs;
  morphs.reserve(samplers.outlines.size());
  for (const OutlineSampler& outline : samplers.outlines) {
    std::vector<int> cells(shares.begin(),
                           shares.begin() + static_cast<std::ptrdiff_t>(outline.pieces().size()));
    outline.make_periods_equal(cells);
    morphs.push_back(outline.sample(cells));
    shares = shares.subspan(outline.pieces().size());
  }
  return morphs;
}

}  // namespace

std::vector<Morph> sample(const ContourSamplers& samplers, int cells) {
  return sample_shares(samplers, share_among(samplers, cells));
}

std::vector<Morph> sample_periodically(ContourSamplers samplers, int cells) {
  for (OutlineSampler& outline : samplers.outlines) outline.make_periodic(kMostPeriods);
  return sample(samplers, cells);
}

}  // namespace sweepkit::sweep
