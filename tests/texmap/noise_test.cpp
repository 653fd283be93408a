// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/texmap/noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace sweepkit::texmap {
namespace {

constexpr std::array kBases = {NoiseBasis::kPerlin2002, NoiseBasis::kPerlin1985};

// Places from a wide region, so that they have no lattice cell in common.
class Places {
 public:
  explicit Places(unsigned seed) : random_(seed) {}
  glm::dvec3 next() { return {real_(random_), real_(random_), real_(random_)}; }

 private:
  std::mt19937 random_;
  std::uniform_real_distribution<double> real_{-1e4, 1e4};
};

TEST(Noise, IsZeroAtWholeCoordinatesAndWithinItsBound) {
  Places places(1);
  for (const NoiseBasis basis : kBases) {
    double largest = 0;
    for (int n = 0; n < 20000; ++n) {
      largest = std::max(largest, std::abs(noise(places.next(), basis)));
      EXPECT_EQ(noise(glm::floor(places.next()), basis), 0);
    }
    // Gradients are unit vectors, or of length sqrt(2) along edges; a cell's corners are sqrt(3)/2 from its
    // middle.
    EXPECT_LE(largest, basis == NoiseBasis::kPerlin2002 ? 1.0364 : 0.8661);
    EXPECT_GT(largest, 0.5);  // and does use its range
  }
}

TEST(Noise, IsContinuousWithItsSlopeAcrossLatticePlanes) {
  const double h = 1e-5;
  for (const NoiseBasis basis : kBases) {
    for (const double y : {0.3, -4.7, 12.1}) {
      for (const int plane : {-3, 0, 5}) {
        const double before = (noise({plane - h, y, 0.4}, basis) - noise({plane - 2 * h, y, 0.4}, basis)) / h;
        const double after = (noise({plane + 2 * h, y, 0.4}, basis) - noise({plane + h, y, 0.4}, basis)) / h;
        // Slopes 3 h apart differ by 3 h times the second derivative, which is below 6 (cubic fade) or, at
        // the plane itself, 0 (quintic): 2e-4.
        EXPECT_NEAR(before, after, 1e-3);
      }
    }
  }
}

TEST(Noise, HasNoMeanAndDoesNotComeRoundAfter256) {
  Places places(2);
  for (const NoiseBasis basis : kBases) {
    double sum = 0;
    double same = 0;
    for (int n = 0; n < 20000; ++n) {
      const glm::dvec3 p = places.next();
      sum += noise(p, basis);
      same += noise(p, basis) == noise(p + glm::dvec3(256, 0, 0), basis) ? 1 : 0;
    }
    EXPECT_NEAR(sum / 20000, 0, 0.01);  // its deviation is below 0.27, so that of the mean 0.002
    EXPECT_LT(same / 20000, 0.2);       // one in twelve corners alike by chance
  }
}

TEST(FractalNoise, LosesNothingAtAPointAndEverythingUnderAWideFootprint) {
  Places places(3);
  for (const NoiseBasis basis : kBases) {
    for (const bool is_flat : {false, true}) {
      const Octaves octaves{.count = 5, .basis = basis, .is_flat = is_flat};
      for (int n = 0; n < 100; ++n) {
        const glm::dvec3 p = places.next();
        EXPECT_EQ(fractal_sum(p, 0, octaves).lost.variance, 0);
        EXPECT_EQ(turbulence(p, 0, octaves).lost.variance, 0);
        EXPECT_EQ(fractal_sum(p, 1e4, octaves).mean, 0);
        EXPECT_EQ(turbulence(p, 1e4, octaves).mean, turbulence({}, HUGE_VAL, octaves).mean);
        EXPECT_EQ(fractal_sum(p, std::nan(""), octaves).mean, 0);
      }
    }
  }
}

// What the octaves' values are like over all of space, against sums over places. 200,000 of them hold the
// mean of numbers of deviation s to 5 s / 447 with room, and the deviation of a power of them is taken from
// the sample itself.
TEST(FractalNoise, HasTheMeanAndTheSpreadThatItSays) {
  constexpr int kCount = 200000;
  Places places(4);
  for (const NoiseBasis basis : kBases) {
    for (const bool is_flat : {false, true}) {
      for (const bool is_turbulent : {false, true}) {
        const Octaves octaves{.count = 1, .basis = basis, .is_flat = is_flat};
        const auto value = is_turbulent ? turbulence : fractal_sum;
        const FilteredNoise all = value({}, HUGE_VAL, octaves);
        std::array<double, 5> sums{};
        std::array<double, 5> squares{};
        for (int n = 0; n < kCount; ++n) {
          const double x = value(places.next(), 0, octaves).mean - all.mean;
          double power = 1;
          for (std::size_t k = 1; k <= 4; ++k) {
            power *= x;
            sums[k] += power / kCount;
            squares[k] += power * power / kCount;
          }
        }
        const std::array<double, 5> expected = {0, 0, all.lost.variance, all.lost.third,
                                                all.lost.fourth + 3 * all.lost.variance * all.lost.variance};
        for (std::size_t k = 1; k <= 4; ++k) {
          EXPECT_NEAR(sums[k], expected[k], 5 * std::sqrt(squares[k] / kCount)) << "order " << k;
        }
      }
    }
  }
}

TEST(FractalNoise, FadesWithoutAJerk) {
  const Octaves octaves{.count = 8};
  Places places(5);
  for (int n = 0; n < 20; ++n) {
    const glm::dvec3 p = places.next();
    double before = turbulence(p, 1e-8, octaves).mean;
    // In steps of 2 % the fade of an octave changes by 1.02^2 - 1 at most, times its strength and value; the
    // strengths of all sum to 2, but only those that fade at that size, some three of them, change.
    double extent = 1e-8;
    while (extent < 1e3) {
      const double here = turbulence(p, extent, octaves).mean;
      EXPECT_NEAR(here, before, 0.04);
      before = here;
      extent *= 1.02;
    }
  }
}

// The mean over a tent on a plane, by 16 x 16 points of it, against what is foretold from the middle alone.
TEST(FractalNoise, ForetellsTheMeanUnderAFootprint) {
  constexpr int kSide = 16;
  constexpr int kCount = 400;
  for (const double width : {0.1, 0.3, 0.6, 1.0, 2.0}) {
    Places places(6);
    const Octaves octaves{.count = 1};
    double filtered = 0;
    double point = 0;
    for (int n = 0; n < kCount; ++n) {
      const glm::dvec3 p = places.next();
      double mean = 0;
      double weights = 0;
      for (int i = 0; i < kSide * kSide; ++i) {
        const int row = i / kSide;
        const glm::dvec2 t((2 * (i % kSide) + 1.0) / kSide - 1, (2 * row + 1.0) / kSide - 1);
        const double weight = (1 - std::abs(t.x)) * (1 - std::abs(t.y));
        mean += weight * fractal_sum(p + width * glm::dvec3(t, 0), 0, octaves).mean;
        weights += weight;
      }
      mean /= weights;
      filtered += std::pow(fractal_sum(p, width * width / 3, octaves).mean - mean, 2) / kCount;
      point += std::pow(fractal_sum(p, 0, octaves).mean - mean, 2) / kCount;
    }
    // Half the error of the point itself, everywhere; where the octave is nearly gone, less than a third.
    EXPECT_LT(std::sqrt(filtered), (width < 1 ? 0.75 : 0.5) * std::sqrt(point)) << width;
  }
}

TEST(FractalNoise, ComesRoundWhereItIsToldTo) {
  const Octaves octaves{.count = 6, .is_flat = true, .period_x = 3, .period_y = 5};
  std::mt19937 random(7);
  std::uniform_int_distribution<int> whole(0, 1 << 20);
  for (int n = 0; n < 200; ++n) {
    // Dyadic places, and a step in front that keeps them so in every octave.
    const glm::dvec3 p(whole(random) / 1048576.0, whole(random) / 1048576.0, 0);
    const double here = turbulence(p, 0, octaves).mean;
    // Past the seam the sums of place and shift round otherwise: 4 ulp of 200 times a slope of 4.
    EXPECT_NEAR(here, turbulence(p + glm::dvec3(3, 0, 0), 0, octaves).mean, 1e-12);
    EXPECT_NEAR(here, turbulence(p + glm::dvec3(0, 5, 0), 0, octaves).mean, 1e-12);
  }
}

}  // namespace
}  // namespace sweepkit::texmap
