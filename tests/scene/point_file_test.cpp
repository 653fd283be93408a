// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "point_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "number_token.hpp"
#include "outline_measures.hpp"

namespace sweepkit::scene {
namespace {

std::string fault(const std::string& text) {
  return refusal([&] { read_points(text, "p.csv"); });
}

TEST(PointFile, ReadsEverySeparatorAndLineEnd) {
  const std::vector<glm::dvec3> points = {{0, 1, 0}, {2.5, -3, 0}, {400, 0.5, 0}};
  for (const char* text : {"0,1\n2.5,-3\n4e2,.5\n", "0;1\r\n2.5;-3\r\n4e2;.5", "0 1\n2.5 -3\n400 +0.5",
                           "0\t1\r2.5\t-3\r400\t0.5\r", "  0 ,  1\n\n2.5 , -3  \n\t400 ,\t.5\n\n",
                           "# points\n0, 1 # first\n2.5, -3\n#\n400, 5e-1",
                           "\xEF\xBB\xBF"
                           "0,1\n2.5,-3\n400,0.5\n"}) {
    const PointFile read = read_points(text, "p.csv");
    EXPECT_EQ(read.columns, 2) << text;
    EXPECT_EQ(read.points, points) << text;
  }
}

TEST(PointFile, ReadsThreeColumns) {
  const PointFile read = read_points("1,2,3\n4 5 6\n7;8;-9", "p.csv");
  EXPECT_EQ(read.columns, 3);
  EXPECT_EQ(read.points, (std::vector<glm::dvec3>{{1, 2, 3}, {4, 5, 6}, {7, 8, -9}}));
}

TEST(PointFile, TheFirstLineMayBeAHeaderOrAName) {
  for (const char* text : {"x,y\n1,2\n3,4", "\"x (m)\";\"y\"\n1;2\n3;4", "NACA 2412\n 1.0 2.0\n 3.0 4.0\n",
                           "# made by hand\nx y\n1 2\n3 4", "easting,northing,\n1,2\n3,4"}) {
    EXPECT_EQ(read_points(text, "p.dat").points, (std::vector<glm::dvec3>{{1, 2, 0}, {3, 4, 0}})) << text;
  }
}

TEST(PointFile, NumbersAreCorrectlyRounded) {
  const PointFile read = read_points("0.1 123456789.012345678\n9007199.254740993 -1e-320\n1e-999 -0", "p");
  EXPECT_EQ(read.points[0], glm::dvec3(0.1, 123456789.012345678, 0));
  EXPECT_EQ(read.points[1], glm::dvec3(9007199.254740993, -1e-320, 0));
  EXPECT_EQ(read.points[2], glm::dvec3(0));
}

TEST(PointFile, FaultsAreToldWithLineAndColumn) {
  EXPECT_EQ(fault(""), "p.csv: has no points; give x y or x y z, a point a line");
  EXPECT_EQ(fault("x,y\n# none\n"), "p.csv: has no points; give x y or x y z, a point a line");
  EXPECT_EQ(fault("1,2\n3,x4\n"), "p.csv:2:3: needs a number, got \"x4\"; put # before what is no point");
  EXPECT_EQ(fault("1,2\n3,4m\n"), "p.csv:2:3: needs a number, got \"4m\"; put # before what is no point");
  EXPECT_EQ(fault("1,2\n3,0x4\n"), "p.csv:2:3: needs a number, got \"0x4\"; put # before what is no point");
  EXPECT_EQ(fault("nan,2\n"), "p.csv:1:1: needs a number, got \"nan\"; put # before what is no point");
  EXPECT_EQ(fault("1,-Inf\n"), "p.csv:1:3: needs a number, got \"-Inf\"; put # before what is no point");
  EXPECT_EQ(fault("1,2\nx,y\n"), "p.csv:2:1: needs a number, got \"x\"; put # before what is no point");
  EXPECT_EQ(fault("1,2\n3,,4\n"), "p.csv:2:3: needs a number here; the field is empty");
  EXPECT_EQ(fault("1,2\n3,\n"), "p.csv:2:3: needs a number here; the field is empty");
  EXPECT_EQ(fault("1,2\r\n3\r\n"), "p.csv:2:1: needs 2 or 3 numbers a line, got 1");
  EXPECT_EQ(fault("1,2,3,4\n"),
            "p.csv:1:7: has more than 3 columns; a point is x y or x y z, apart by , ; or blanks");
  EXPECT_EQ(fault("1,2\n3,4,5\n"), "p.csv:2:1: needs 2 numbers as the lines before, got 3");
  EXPECT_EQ(fault("1,1e10\n"), "p.csv:1:3: needs to be at most 1e+09 m from 0, got 1e10");
  EXPECT_EQ(fault("1,-1e999\n"), "p.csv:1:3: needs to be at most 1e+09 m from 0, got -1e999");
}

TEST(PointFile, LednicersOrderIsRefusedByName) {
  EXPECT_EQ(
      fault("CLARK Y\n 3. 3.\n\n0 0\n.5 .1\n1 0\n\n0 0\n.5 -.1\n1 0\n"),
      "p.csv: lists its two surfaces apart (Lednicer's order); give one run round the airfoil (Selig's)");
}

TEST(PointFile, MorePointsThanMemoryAreRefused) {
  std::string text;
  for (std::size_t i = 0; i <= kMostPoints; ++i) text += "1 2\n";
  EXPECT_EQ(fault(text), "p.csv:1000001:1: has more than 1000000 points; thin them out");
}

TEST(NumberToken, TakesTheNumberAndLeavesTheRest) {
  const auto take = [](std::string_view text) {
    const std::optional<double> value = take_number(text);
    return std::pair(value, std::string(text));
  };
  EXPECT_EQ(take("12px"), (std::pair<std::optional<double>, std::string>(12, "px")));
  EXPECT_EQ(take("-.5e1em"), (std::pair<std::optional<double>, std::string>(-5, "em")));
  EXPECT_EQ(take("+3"), (std::pair<std::optional<double>, std::string>(3, "")));
  for (const char* none : {"", "-", "+-1", "--1", "nan", "-inf", ".", "e5", "x"}) {
    EXPECT_EQ(take(none), (std::pair<std::optional<double>, std::string>(std::nullopt, none))) << none;
  }
}

TEST(NumberToken, TellsTooLargeFromTooSmall) {
  const double infinity = std::numeric_limits<double>::infinity();
  const auto take = [](std::string_view text) { return *take_number(text); };
  EXPECT_EQ(take("1e999"), infinity);
  EXPECT_EQ(take("-1e999"), -infinity);
  EXPECT_EQ(take("1e99999999999999999999"), infinity);
  EXPECT_EQ(take("1" + std::string(400, '0')), infinity);
  EXPECT_EQ(take("0." + std::string(400, '0') + "1e800"), infinity);
  EXPECT_EQ(take("1e-999"), 0);
  EXPECT_EQ(take("1e-99999999999999999999"), 0);
  EXPECT_EQ(take("0." + std::string(400, '0') + "1"), 0);
  EXPECT_EQ(take("0e99999999999999999999"), 0);
}

}  // namespace
}  // namespace sweepkit::scene
