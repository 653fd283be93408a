// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Error estimate: sampling of the pixels with a probability that grows with the error expected, the sum
// weighted by its inverse [Hansen43]. What is expected comes from the picture alone and needs no ray:
// variances of the rays of a pixel, and what its neighbours show. A wrong expectation makes the estimate
// noisy and never wrong on average, as half of the checks are spread evenly. A checked pixel is drawn twice
// more, by rays of their own, A and B: the mean of (p - A)(p - B) is its squared error, for the errors of A
// and B have nothing to do with each other.
//
// Refinement: as refinement.cpp has it, 4 rays, then twice as many, the pixel first whose squared error one
// more ray lowers most. It goes on from the rays that are there.

#include "picture_refiner.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "pixel_pattern.hpp"
#include "position_hash.hpp"

namespace sweepkit::render {
namespace {

using Clock = std::chrono::steady_clock;

// For each cause. The relative error of the estimate is then about 1 / sqrt(192) times the spread of the
// ratios of true and expected squared errors, which is about 2: a seventh, and half of that for the root.
constexpr std::size_t kChecks = 192;
// Where there is no time for so many; the estimate is then off by about half.
constexpr std::size_t kFewestChecks = 16;
// Of the time that is left after the first check: the most for the last one.
constexpr double kShareOfLastCheck = 0.25;
// Rays of a check's A and of its B. The error left of 16 rays is well below that of one; a refined pixel is
// checked by as many rays as it has, for else their noise would hide its error, and by this many at least.
constexpr int kCheckRays = 16;
constexpr int kFewestRefinedCheckRays = 32;
// Where little error is left, what is found may come to nothing by chance. The rays' own variance is not
// wrong by more than this.
constexpr double kLeastOfRefined = 0.1;
// The squared error is lowered to no less than this part of it before it is checked again, so that a wrong
// expectation does not refine far beyond the goal.
constexpr double kStep = 0.25;
constexpr int kMostChecks = 16;
// Squared errors that are no longer worth telling apart: that of levels of 16 bits.
constexpr double kLeast = 1e-10;
constexpr std::uint32_t kNoSlot = std::numeric_limits<std::uint32_t>::max();

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double mean_of_rgb(const glm::dvec3& color) {
  return (color.r + color.g + color.b) / 3;
}

glm::dvec3 color_of(const texmap::Image& image, std::size_t pixel) {
  const float* texel =
      std::get<std::vector<float>>(image.texels).data() + pixel * static_cast<std::size_t>(image.channels);
  return {texel[0], texel[1], texel[2]};
}

std::vector<float> contrasts_of(const texmap::Image& image) {
  const auto width = static_cast<std::size_t>(image.width);
  std::vector<float> contrasts(width * static_cast<std::size_t>(image.height));
  const auto compare = [&](std::size_t i, std::size_t j) {
    const glm::dvec3 difference = color_of(image, i) - color_of(image, j);
    const auto variance = static_cast<float>(mean_of_rgb(difference * difference) / 4);
    // Written so that what is no number counts for nothing.
    if (variance > contrasts[i]) contrasts[i] = variance;
    if (variance > contrasts[j]) contrasts[j] = variance;
  };
  for (std::size_t i = 0; i < contrasts.size(); ++i) {
    if (i % width > 0) compare(i - 1, i);
    if (i >= width) compare(i - width, i);
  }
  return contrasts;
}

std::uint64_t rays_to_add(const PixelError& error) {
  return error.rays > 1 ? error.rays : static_cast<std::uint64_t>(kFewestRefiningRays);
}

}  // namespace

PictureRefiner::PictureRefiner(const PixelSampler& sampler, texmap::Image& image,
                               std::vector<PixelError> errors)
    : sampler_(sampler),
      image_(image),
      errors_(std::move(errors)),
      contrasts_(contrasts_of(image)),
      most_checks_(kChecks) {}

PictureRefiner::Cause PictureRefiner::cause_of(std::size_t pixel) const {
  if (errors_[pixel].rays > 1) return kRefined;
  return errors_[pixel].edge > contrasts_[pixel] / 4 ? kEdge : kTexture;
}

double PictureRefiner::measure_of(std::size_t pixel, Cause cause) const {
  switch (cause) {
    case kRefined:
      return errors_[pixel].refined + kLeast;
    case kEdge:
      return errors_[pixel].edge + kLeast;
    default:
      return contrasts_[pixel] + kLeast;
  }
}

double PictureRefiner::expected_of(std::size_t pixel) const {
  const Cause cause = cause_of(pixel);
  return factors_[cause] * measure_of(pixel, cause);
}

std::vector<PictureRefiner::Check> PictureRefiner::choose_checks() const {
  std::array<std::size_t, kCauses> counts{};
  std::array<double, kCauses> sums{};
  for (std::size_t i = 0; i < errors_.size(); ++i) {
    const Cause cause = cause_of(i);
    ++counts[cause];
    sums[cause] += measure_of(i, cause);
  }
  std::vector<Check> checks;
  // Systematic sampling: marks at equal distances along the chances added up, the first one by chance.
  std::array<double, kCauses> passed{};
  std::array<double, kCauses> next{};
  for (std::size_t c = 0; c < kCauses; ++c) next[c] = fractions_of(scatter(checks_ * kCauses + c)).x;
  for (std::size_t i = 0; i < errors_.size(); ++i) {
    const Cause cause = cause_of(i);
    if (counts[cause] <= most_checks_) {
      checks.push_back({i, 1, cause});
      continue;
    }
    const double expected = static_cast<double>(most_checks_) * (0.5 * measure_of(i, cause) / sums[cause] +
                                                                 0.5 / static_cast<double>(counts[cause]));
    passed[cause] += expected;
    int marks = 0;
    for (; next[cause] < passed[cause]; next[cause] += 1) ++marks;
    if (marks > 0) checks.push_back({i, marks / expected, cause});
  }
  return checks;
}

double PictureRefiner::squared_error(PixelSampler::Thread& thread, const Check& check) const {
  const int count = check.cause == kRefined
                        ? std::max(kFewestRefinedCheckRays, static_cast<int>(errors_[check.pixel].rays))
                        : kCheckRays;
  const std::span<const glm::dvec2> pattern = pixel_pattern();
  std::array<glm::dvec2, kMostRefiningRays> places;
  std::array<glm::dvec3, 2> left;
  const auto width = static_cast<std::size_t>(image_.width);
  const std::size_t column = check.pixel % width;
  const std::size_t row = check.pixel / width;
  const std::uint64_t seed = seed_of(glm::dvec2(static_cast<double>(column) + sampler_.region().x,
                                                static_cast<double>(row) + sampler_.region().y));
  for (std::size_t half = 0; half < 2; ++half) {
    // The pattern moved and wrapped around is as even, and independent of the one in its place.
    const glm::dvec2 shift = fractions_of(scatter(seed ^ scatter(2 * checks_ + half + 1)));
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
      places[i] = glm::fract(pattern[i] + shift);
    ColorSums sums;
    thread.add(sums, check.pixel, std::span(places).first(static_cast<std::size_t>(count)),
               side_of_sample(count));
    left[half] = color_of(image_, check.pixel) - glm::dvec3(sums.sum) / static_cast<double>(count);
  }
  return mean_of_rgb(left[0] * left[1]);
}

void PictureRefiner::check() {
  const Clock::time_point start = Clock::now();
  const std::uint64_t rays_before = check_counts_.rays.eye;
  const std::vector<Check> checks = choose_checks();
  std::vector<double> found(checks.size());
  sampler_.for_each(
      checks.size(),
      [&](PixelSampler::Thread& thread, std::size_t i) { found[i] = squared_error(thread, checks[i]); },
      check_counts_);
  // One after the other, so that the sums are the same for any threads.
  std::array<double, kCauses> errors{};
  for (std::size_t i = 0; i < checks.size(); ++i) errors[checks[i].cause] += checks[i].weight * found[i];
  std::array<double, kCauses> measures{};
  for (std::size_t i = 0; i < errors_.size(); ++i) {
    const Cause cause = cause_of(i);
    measures[cause] += measure_of(i, cause);
  }
  double sum = 0;
  for (std::size_t c = 0; c < kCauses; ++c) {
    // Below 0 by chance alone.
    errors[c] = std::max(errors[c], c == kRefined ? kLeastOfRefined * measures[c] : 0.0);
    sum += errors[c];
    if (measures[c] > 0) factors_[c] = std::max(errors[c] / measures[c], 1e-6);
  }
  ++checks_;
  const double seconds = seconds_since(start);
  const std::uint64_t rays = check_counts_.rays.eye - rays_before;
  rays_a_second_ = static_cast<double>(rays) / std::max(seconds, 1e-9);
  estimate_.rmse = std::sqrt(sum / static_cast<double>(errors_.size()));
  estimate_.checked_pixels += checks.size();
  estimate_.checking_rays += rays;
  estimate_.seconds += seconds;
}

void PictureRefiner::refine(PixelSampler::Thread& thread, std::size_t pixel) {
  PixelError& error = errors_[pixel];
  const auto before = error.rays > 1 ? std::size_t{error.rays} : 0;
  const auto count = before + static_cast<std::size_t>(rays_to_add(error));
  ColorSums& state = states_[slots_[pixel]];
  const double n = static_cast<double>(count);
  thread.add(state, pixel, pixel_pattern().subspan(before, count - before),
             side_of_sample(static_cast<int>(count)));
  const glm::dvec4 spread = state.squares - state.sum * state.sum / n;
  const double variance =
      (mean_of_rgb(glm::dvec3(spread)) + kPriorRays * static_cast<double>(error.edge)) / (n - 1 + kPriorRays);
  error.rays = static_cast<std::uint32_t>(count);
  error.refined = static_cast<float>(variance / (n * std::sqrt(n)));
  const auto channels = static_cast<std::size_t>(image_.channels);
  float* texel = std::get<std::vector<float>>(image_.texels).data() + pixel * channels;
  for (std::size_t c = 0; c < channels; ++c)
    texel[c] = static_cast<float>(state.sum[static_cast<glm::length_t>(c)] / n);
}

std::vector<PictureRefiner::Candidate> PictureRefiner::candidates(double least) const {
  std::vector<Candidate> found;
  for (std::size_t i = 0; i < errors_.size(); ++i) {
    const PixelError& error = errors_[i];
    if (2 * error.rays > static_cast<std::uint32_t>(kMostRefiningRays)) continue;
    // Of one ray's error a quarter is left by four; twice as many rays leave 2^-1.5.
    const double gain = expected_of(i) * (error.rays > 1 ? 1 - std::sqrt(0.125) : 0.75);
    if (gain > least) found.push_back({gain / static_cast<double>(rays_to_add(error)), i});
  }
  std::ranges::sort(found, [](const Candidate& a, const Candidate& b) {
    return a.worth != b.worth ? a.worth > b.worth : a.pixel < b.pixel;
  });
  return found;
}

bool PictureRefiner::lower_to(double target, const std::function<std::uint64_t()>& most_rays) {
  bool has_refined = false;
  if (slots_.empty()) slots_.assign(errors_.size(), kNoSlot);
  while (true) {
    double expected = 0;
    for (std::size_t i = 0; i < errors_.size(); ++i) expected += expected_of(i);
    const double excess = expected - target;
    std::uint64_t budget = most_rays();
    if (!(excess > 0.02 * expected) || budget == 0) return has_refined;
    // What is passed over comes to a hundredth of the excess. A round does half, for what it finds changes
    // what is best to be done next.
    double wanted = std::max(excess / 2, std::min(excess, 0.02 * expected));
    std::vector<std::size_t> chosen;
    for (const Candidate& candidate : candidates(0.01 * excess / static_cast<double>(errors_.size()))) {
      const std::uint64_t rays = rays_to_add(errors_[candidate.pixel]);
      if (wanted <= 0 || rays > budget) break;
      wanted -= candidate.worth * static_cast<double>(rays);
      budget -= rays;
      refining_rays_ += rays;
      if (slots_[candidate.pixel] == kNoSlot) {
        slots_[candidate.pixel] = static_cast<std::uint32_t>(states_.size());
        states_.emplace_back();
      }
      chosen.push_back(candidate.pixel);
    }
    if (chosen.empty()) return has_refined;
    // Neighbours in the picture look at the same textures.
    std::ranges::sort(chosen);
    const Clock::time_point start = Clock::now();
    const std::uint64_t before = counts_.rays.eye;
    sampler_.for_each(
        chosen.size(), [&](PixelSampler::Thread& thread, std::size_t i) { refine(thread, chosen[i]); },
        counts_);
    rays_a_second_ = static_cast<double>(counts_.rays.eye - before) / std::max(seconds_since(start), 1e-9);
    has_refined = true;
  }
}

double PictureRefiner::rays_of_check() const {
  std::array<std::size_t, kCauses> counts{};
  double refining = 0;
  for (std::size_t i = 0; i < errors_.size(); ++i) {
    const Cause cause = cause_of(i);
    ++counts[cause];
    if (cause == kRefined) refining += errors_[i].rays;
  }
  const auto pixels = [&](Cause cause) { return static_cast<double>(std::min(counts[cause], kChecks)); };
  // Those with the largest errors are checked more often and have more rays: twice the mean or so.
  const double of_refined =
      std::max<double>(kFewestRefinedCheckRays,
                       2 * refining / static_cast<double>(std::max<std::size_t>(1, counts[kRefined])));
  return 2 * (kCheckRays * (pixels(kTexture) + pixels(kEdge)) + of_refined * static_cast<double>(kChecks));
}

void PictureRefiner::reach(const Goal& goal) {
  const auto pixels = static_cast<double>(errors_.size());
  if (goal.error > 0) {
    const auto no_limit = [] { return std::numeric_limits<std::uint64_t>::max(); };
    for (int i = 0; i < kMostChecks && estimate_.rmse > goal.error; ++i) {
      const double sum = estimate_.rmse * estimate_.rmse * pixels;
      if (!lower_to(std::max(kStep * sum, 0.9 * goal.error * goal.error * pixels), no_limit)) break;
      check();
    }
  }
  if (goal.seconds_left) {
    const double first = goal.seconds_left();
    const auto check_seconds = [&] { return rays_of_check() / rays_a_second_; };
    const auto budget = [&]() -> std::uint64_t {
      // The last check comes after it.
      const double left = goal.seconds_left() - std::min(check_seconds(), kShareOfLastCheck * first);
      if (!(left > 0.02 * first)) return 0;
      return static_cast<std::uint64_t>(0.5 * left * rays_a_second_);
    };
    if (lower_to(0, budget)) {
      const double affordable = static_cast<double>(kChecks) * goal.seconds_left() / check_seconds();
      most_checks_ = static_cast<std::size_t>(
          std::clamp(affordable, static_cast<double>(kFewestChecks), static_cast<double>(kChecks)));
      check();
    }
  }
}

std::size_t PictureRefiner::bytes() const {
  return errors_.capacity() * sizeof(errors_[0]) + contrasts_.capacity() * sizeof(contrasts_[0]) +
         slots_.capacity() * sizeof(slots_[0]) + states_.capacity() * sizeof(states_[0]);
}

}  // namespace sweepkit::render
