// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "stations.hpp"

#include <gtest/gtest.h>

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

TEST(Stations, RefusesCountsOutOfRange) {
  EXPECT_NO_THROW(check_cells(1, "contour"));
  EXPECT_NO_THROW(check_cells(kMaxCells, "contour"));
  for (const int cells : {0, -3, kMaxCells + 1}) EXPECT_THROW(check_cells(cells, "contour"), InputError);
}

}  // namespace
}  // namespace sweepkit::sweep
