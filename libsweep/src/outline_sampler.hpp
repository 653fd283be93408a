// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "matching.hpp"
#include "morph.hpp"
#include "section.hpp"
#include "stations.hpp"
#include "sweepkit/sweep/curve.hpp"
#include "sweepkit/sweep/options.hpp"

namespace sweepkit::sweep {

/// A loop's contour that covers itself when turned is divided alike in so many parts at most, and comes home
/// turned by one of them. Of a circle's symmetry no more is made use of, or no column could be left out.
inline constexpr int kMostPeriods = 12;

/// An outline, or several that it changes between, ready to be divided into columns.
class OutlineSampler {
 public:
  struct Key {
    double at;
    const Curve2* curve;  ///< kept as a pointer
  };
  enum class PiecesBy { kCorners, kSegments };

  /// Precondition: at least one key, ascending. Throws InputError as make_section() does, and where open and
  /// closed outlines are mixed.
  OutlineSampler(const std::vector<Key>& keys, const SectionOptions& options, PiecesBy by);

  /// What is divided evenly: for several keys the pieces between the corners of all of them, as long as the
  /// longest of them there.
  std::span<const Piece> pieces() const { return pieces_; }
  /// Is one key's contour walked against its drawing, so that its columns come in the pieces' reverse order?
  bool is_backward() const { return is_backward_; }
  bool is_closed() const { return walks_.front().curve().is_closed(); }
  double length() const;

  Morph sample(std::span<const int> cells) const;

  /// Cuts the pieces so that they repeat n times, n at most `most` the turns of a circle that bring the
  /// outline onto itself. One that changes has none.
  void make_periodic(int most);
  int periods() const { return periods_; }
  /// Gives pieces that repeat the largest of their values.
  template <class Value>
  void make_periods_equal(std::vector<Value>& values) const {
    const std::size_t period = values.size() / static_cast<std::size_t>(periods_);
    for (std::size_t i = period; i < values.size(); ++i)
      values[i % period] = std::max(values[i % period], values[i]);
    for (std::size_t i = period; i < values.size(); ++i) values[i] = values[i % period];
  }
  /// Has two pieces for every one of which is_halved says so. Precondition: periods are halved alike.
  void halve_pieces(const std::vector<bool>& is_halved);

 private:
  Morph sample_one(std::span<const int> cells) const;
  std::vector<double> places(std::span<const int> cells) const;

  std::vector<double> at_;
  std::vector<Walk> walks_;
  std::vector<RisingMap> maps_;  // from the first key's walk to each key's
  std::vector<double> breaks_;   // ends of the pieces on the first key's walk, 0 to 1; of several keys
  std::vector<Piece> pieces_;
  SectionOptions options_;
  bool is_backward_ = false;  // of one key
  int periods_ = 1;
};

/// The outlines of a contour and of what it changes into.
struct ContourSamplers {
  std::vector<OutlineSampler> outlines;
  std::vector<std::size_t> outer_of;  ///< as nest_outlines() says
};

/// Keeps pointers to the curves. Throws InputError as nest_outlines() and OutlineSampler do, for keys that
/// are not ascending between 0 and 1, and where a key has other numbers of outlines or holes than the
/// contour.
ContourSamplers make_samplers(std::span<const Curve2> contour, std::span<const MorphKey> morph,
                              double crease_deg, UvBy by, OutlineSampler::PiecesBy pieces_by);

/// Every outline in columns, `cells` in all shared among their pieces by length, at least one each.
std::vector<Morph> sample(const ContourSamplers& samplers, int cells);

/// The same with the columns of contours that cover themselves when turned alike in all of those parts, at
/// most kMostPeriods: as few more than `cells` as that takes.
std::vector<Morph> sample_periodically(ContourSamplers samplers, int cells);

}  // namespace sweepkit::sweep
