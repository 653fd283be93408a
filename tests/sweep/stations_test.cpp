// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "stations.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "sweepkit/error.hpp"

namespace sweepkit::sweep {
namespace {

TEST(Stations, SharesTheCellsAmongThePiecesByLength) {
  const Curve2 bent = polyline<2>({{0, 0}, {3, 0}, {3, 1}}, false);
  const std::vector<Station> stations = place_stations(bent, 8);
  ASSERT_EQ(stations.size(), 9u);
  EXPECT_TRUE(stations[6].is_corner);
  EXPECT_DOUBLE_EQ(stations[6].length, 3);
}

TEST(Stations, GivesEveryPieceACellHoweverFewAreAskedFor) {
  const Curve2 square = polyline<2>({{0, 0}, {100, 0}, {100, 1}, {0, 1}}, true);
  const std::vector<Station> stations = place_stations(square, 1);
  ASSERT_EQ(stations.size(), 5u);
  for (const Station& station : stations) EXPECT_TRUE(station.is_corner);
}

TEST(Stations, GivesEveryPieceItsExactShareWhereThereIsOne) {
  const Curve2 bent = polyline<2>({{0, 0}, {9, 0}, {9, 1}, {4, 1}}, false);
  for (int times = 1; times <= 40; ++times) {
    const std::vector<Station> stations = place_stations(bent, 15 * times);
    EXPECT_TRUE(stations[static_cast<std::size_t>(9 * times)].is_corner);
    EXPECT_TRUE(stations[static_cast<std::size_t>(10 * times)].is_corner);
  }
}

TEST(Stations, LeavesNoCellMoreThanTwiceAsLongAsAnother) {
  // With cells enough for the shortest piece: a cell is only split while it is the longest.
  const Curve2 curve = polyline<2>({{0, 0}, {1, 0}, {1, 7}, {4, 7}, {4, 7.3}}, false);
  for (int cells = 60; cells <= 500; ++cells) {
    const std::vector<Station> stations = place_stations(curve, cells);
    double shortest = 100;
    double longest = 0;
    for (std::size_t i = 1; i < stations.size(); ++i) {
      shortest = std::min(shortest, stations[i].length - stations[i - 1].length);
      longest = std::max(longest, stations[i].length - stations[i - 1].length);
    }
    EXPECT_LT(longest, 2 * shortest + 1e-12) << cells;
  }
}

TEST(Stations, KeepsToTheNumberOfCellsForEveryCount) {
  const Curve2 curve = polyline<2>({{0, 0}, {1, 0}, {1, 7}, {4, 7}, {4, 7.1}}, false);
  for (int cells = 4; cells <= 500; ++cells)
    EXPECT_EQ(place_stations(curve, cells).size(), static_cast<std::size_t>(cells) + 1);
}

TEST(Stations, AreEquallyFarApartOnASmoothPiece) {
  const Curve2 curve = bezier_curve<2>({{0, 0}, {9, 0}, {1, 1}, {2, 5}});
  const std::vector<Station> stations = place_stations(curve, 10);
  for (std::size_t i = 0; i < stations.size(); ++i) {
    EXPECT_NEAR(stations[i].length, curve.length() * static_cast<double>(i) / 10, 1e-12 * curve.length());
  }
}

TEST(Stations, WalkedTheOtherWayAreTheSamePlaces) {
  const Curve2 curve = polyline<2>({{0, 0}, {3, 0}, {3, 1}}, false);
  const std::vector<Station> there = place_stations(curve, 8);
  const std::vector<Station> back = reversed(curve, there);
  for (std::size_t i = 0; i < there.size(); ++i) {
    const Station& one = there[i];
    const Station& other = back[there.size() - 1 - i];
    EXPECT_EQ(curve.evaluate(one.in).position, curve.evaluate(other.out).position);
    EXPECT_NEAR(other.length, 4 - one.length, 1e-14);
    EXPECT_NEAR(other.parameter, 1 - one.parameter, 1e-15);
    EXPECT_EQ(one.is_corner, other.is_corner);
  }
}

TEST(Stations, TextureByParameterGivesEverySegmentAnEqualShare) {
  const Curve2 curve = polyline<2>({{0, 0}, {3, 0}, {3, 1}}, false);
  const std::vector<Station> stations = place_stations(curve, 8);  // the corner is station 6
  EXPECT_DOUBLE_EQ(texture_fractions(stations, UvBy::kArcLength)[6], 0.75);
  EXPECT_DOUBLE_EQ(texture_fractions(stations, UvBy::kParameter)[6], 0.5);
  for (const UvBy by : {UvBy::kArcLength, UvBy::kParameter}) {
    EXPECT_EQ(texture_fractions(stations, by).front(), 0);
    EXPECT_EQ(texture_fractions(stations, by).back(), 1);
  }
}

TEST(Stations, RefusesCountsOutOfRange) {
  EXPECT_NO_THROW(check_cells(1, "contour"));
  EXPECT_NO_THROW(check_cells(kMaxCells, "contour"));
  for (const int cells : {0, -3, kMaxCells + 1}) EXPECT_THROW(check_cells(cells, "contour"), InputError);
}

}  // namespace
}  // namespace sweepkit::sweep
