// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "equal_error.hpp"
#include "picture_methods.hpp"
#include "picture_scene.hpp"
#include "pictures_experiment.hpp"
#include "sweepkit/scene/document.hpp"
#include "sweepkit/texmap/image_error.hpp"

namespace sweepkit::report {
namespace {

// A method whose error halves where its time doubles: 6.02 dB of PSNR for each. 10 dB more than the first
// cost 2^(10 / 6.02) times its time.
TEST(EqualError, InterpolatesInTheLogarithms) {
  const double doubled = 20 * std::log10(2.0);
  const std::vector<ErrorAtTime> knob = {{1, 20}, {2, 20 + doubled}, {4, 20 + 2 * doubled}};
  // Two powers and a division.
  EXPECT_NEAR(seconds_to_reach(knob, 30), std::pow(2, 10 / doubled), 1e-14);
  EXPECT_EQ(seconds_to_reach(knob, 10), 1);
  EXPECT_TRUE(std::isnan(seconds_to_reach(knob, 40)));
  EXPECT_TRUE(std::isnan(seconds_to_reach({}, 40)));
}

TEST(EqualError, LeastSecondsAreThoseOfTheFastestThatReachesIt) {
  const std::vector<ErrorAtTime> any = {{3, 35}, {1, 20}, {2, 31}};
  EXPECT_EQ(least_seconds(any, 30), 2);
  EXPECT_EQ(least_seconds(any, 32), 3);
  EXPECT_TRUE(std::isnan(least_seconds(any, 36)));
}

// A plane of 1 x 1 seen from above, from so far that it is half as wide as the picture's height: 16 x 16 of
// 32 x 32 pixels, by straight lines.
TEST(PictureScene, TheMaskOfAnObjectIsItsPixels) {
  const double distance = 1 / std::tan(20 * std::acos(-1.0) / 180);
  const std::string scene = R"({"sweepkit": 1, "camera": {"eye": [0, )" + std::to_string(distance) +
                            R"(, 0], "target": [0, 0, 0], "up": [0, 0, -1], "fov_deg": 40,
                              "width": 32, "height": 32},
    "objects": [{"name": "square", "plane": {"size": [1, 1]}},
                {"name": "floor", "translate": [0, -1, 0], "plane": {"size": [9, 9]}}]})";
  const PictureScene drawn = make_scene(scene::parse_document(scene, "mask.json"));
  const std::vector<std::uint8_t> square = mask_of(drawn, "square");
  const std::vector<std::uint8_t> floor = mask_of(drawn, "floor");
  ASSERT_EQ(square.size(), 32u * 32);
  for (std::size_t i = 0; i < square.size(); ++i) {
    const std::size_t x = i % 32;
    const std::size_t y = i / 32;
    const bool is_inside = x >= 8 && x < 24 && y >= 8 && y < 24;
    EXPECT_EQ(square[i], is_inside ? 1 : 0) << x << ", " << y;
    EXPECT_EQ(floor[i], is_inside ? 0 : 1) << x << ", " << y;
  }
  const std::vector<std::uint8_t> none = mask_of(drawn, "no such object");
  EXPECT_EQ(std::set<std::uint8_t>(none.begin(), none.end()), std::set<std::uint8_t>{0});
}

TEST(PictureMethods, HaveEveryFilterWithEveryAntialiasing) {
  std::set<std::string> filters;
  std::set<std::pair<std::string, std::string>> settings;
  for (const PictureMethod& method : picture_methods(false)) {
    EXPECT_EQ(method.options.threads, 1);
    EXPECT_TRUE(settings.insert({method.filter, method.setting}).second) << method.filter << method.setting;
    filters.insert(method.filter);
  }
  EXPECT_EQ(filters, (std::set<std::string>{"auto", "bilinear", "ewa", "integral-1", "integral-2",
                                            "integral-3", "plain", "point", "the paper's box", "trilinear"}));
  for (const std::string& filter : filters) {
    if (filter == "plain") continue;
    for (const char* setting : {"off", "3x3", "adaptive 0.12", "adaptive 0.03"})
      EXPECT_EQ(settings.count({filter, setting}), 1u) << filter << ", " << setting;
  }
}

// What is measured of one scene: every method has a row, the rows have what the plots name, and errors fall
// with the samples.
TEST(Pictures, AQuickRunOfASceneHasARowForEveryMethod) {
  const std::string file = SWEEPKIT_SAMPLES "/scenes/vase_and_cup.json";
  const Experiment experiment = measure_pictures({.is_quick = true, .scene = file});
  const std::vector<PictureMethod> methods = picture_methods(true);
  const Table& table = experiment.table;
  ASSERT_EQ(table.rows.size(), methods.size());
  double before = 1;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    ASSERT_EQ(table.rows[i].size(), table.columns.size());
    EXPECT_EQ(std::get<std::string>(table.rows[i][table.column("filter")]), methods[i].filter);
    const auto number = [&](const char* column) {
      return std::get<double>(table.rows[i][table.column(column)]);
    };
    EXPECT_GT(number("seconds"), 0);
    EXPECT_EQ(number("runs"), 5);
    // The one is the other in decibels; both come from the same differences, added up once each.
    EXPECT_NEAR(number("psnr_db"), -20 * std::log10(number("rmse")), 1e-9);
    if (methods[i].filter != "plain") continue;
    EXPECT_LT(number("rmse"), before) << methods[i].setting;
    before = number("rmse");
    EXPECT_LT(number("reference_rmse"), number("rmse"));
  }
  // Off the floor and the mirror too: the whole picture's plots and theirs.
  EXPECT_EQ(experiment.plots.size(), 4u);
  ASSERT_EQ(experiment.derived.size(), 2u);
  EXPECT_EQ(experiment.derived[0].name, "speedups");
  EXPECT_EQ(experiment.derived[0].table.rows.size(), 4u * 5);
  EXPECT_EQ(experiment.derived[1].name, "cost");
  EXPECT_EQ(std::get<double>(experiment.derived[1].table.rows[0][3]), 20.0 / 15);
}

}  // namespace
}  // namespace sweepkit::report
