// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "pixel_error.hpp"
#include "pixel_sampler.hpp"
#include "sweepkit/render/picture_error.hpp"
#include "sweepkit/texmap/image.hpp"

namespace sweepkit::render {

/// Estimates the error of a picture that is drawn, and refines it pixel by pixel until that is small enough.
class PictureRefiner {
 public:
  /// `image` is the sampler's region, `errors` what drawing it has told; with `errors` of one ray each where
  /// it is to be refined.
  PictureRefiner(const PixelSampler& sampler, texmap::Image& image, std::vector<PixelError> errors);

  /// Draws a few pixels again, by many rays, and says how large the error is by those.
  void check();
  /// Refines and checks by turns.
  void reach(const Goal& goal);

  const ErrorEstimate& estimate() const { return estimate_; }
  std::span<const PixelError> errors() const { return errors_; }
  /// The pixels and rays of reach(), those of the checks not counted.
  std::uint64_t refined_pixels() const { return states_.size(); }
  std::uint64_t refining_rays() const { return refining_rays_; }
  const PixelSampler::Counts& counts() const { return counts_; }
  std::size_t bytes() const;

 private:
  /// Where a pixel's error comes from; each has its own measure, and a factor to it that the checks find.
  enum Cause { kTexture, kEdge, kRefined, kCauses };
  /// A pixel to be checked; its squared error times `weight` is a part of the whole picture's sum.
  struct Check {
    std::size_t pixel;
    double weight;
    Cause cause;
  };
  struct Candidate {
    double worth;  // of one more ray: what it lowers the squared error by
    std::size_t pixel;
  };

  Cause cause_of(std::size_t pixel) const;
  double measure_of(std::size_t pixel, Cause cause) const;
  double expected_of(std::size_t pixel) const;
  std::vector<Check> choose_checks() const;
  double rays_of_check() const;  // about, for one more
  double squared_error(PixelSampler::Thread& thread, const Check& check) const;
  void refine(PixelSampler::Thread& thread, std::size_t pixel);
  // The best candidates until the squared errors' sum is `target` or `most_rays` are cast, in rounds.
  bool lower_to(double target, const std::function<std::uint64_t()>& most_rays);
  std::vector<Candidate> candidates(double least) const;

  const PixelSampler& sampler_;
  texmap::Image& image_;
  std::vector<PixelError> errors_;
  std::vector<float> contrasts_;  // in the picture: the variance of a pixel and its least like neighbour
  std::array<double, kCauses> factors_{1, 1, 1};
  std::vector<std::uint32_t> slots_;  // by pixel, where it is refined: its place in states_
  std::vector<ColorSums> states_;
  ErrorEstimate estimate_;
  PixelSampler::Counts counts_;
  PixelSampler::Counts check_counts_;
  std::uint64_t refining_rays_ = 0;
  std::uint64_t checks_ = 0;
  std::size_t most_checks_;  // for each cause
  double rays_a_second_ = 0;
};

}  // namespace sweepkit::render
