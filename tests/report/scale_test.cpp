// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include "accelerators_experiment.hpp"
#include "child_output.hpp"
#include "scale_experiment.hpp"
#include "scale_scenes.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/report/scale_step.hpp"
#include "sweepkit/scene/document.hpp"
#include "traced_mesh.hpp"

namespace sweepkit::report {
namespace {

TEST(ChildOutput, IsWhatTheProgramWrote) {
  EXPECT_EQ(child_output("/bin/sh", {"-c", "printf 'one\\ntwo'"}), "one\ntwo");
  EXPECT_EQ(child_output("/bin/sh", {"-c", "exit 3"}), std::nullopt);
  EXPECT_EQ(child_output("/no/such/program", {}), std::nullopt);
}

TEST(TracedMesh, ATrefoilHasAboutAsManyTrianglesAsAskedFor) {
  for (const double triangles : {1e3, 1e4, 1e5}) {
    // Whole cells round and along: at most half a ring's 2 x 60 triangles off.
    EXPECT_NEAR(static_cast<double>(trefoil_of(triangles).triangles.size()), triangles, 60) << triangles;
  }
}

TEST(ScaleScenes, HaveAboutAsManyTrianglesAsAskedFor) {
  for (const int objects : {1, 4}) {
    const scene::Document document =
        scene::parse_document(knots_scene(1e4, objects, "noise.png"), "scale.json");
    ASSERT_EQ(document.objects.size(), static_cast<std::size_t>(objects));
    double triangles = 0;
    for (const scene::ObjectEntry& object : document.objects)
      triangles += 2.0 * object.pieces[0].tessellation.contour * object.pieces[0].tessellation.trajectory;
    // Rounded to whole cells along: half of one in a hundred at most.
    EXPECT_NEAR(triangles, 1e4, 100) << objects;
    EXPECT_EQ(document.textures.size(), 1u);
  }
}

class ScaleStepRun : public testing::Test {
 protected:
  ScaleStepRun() { std::ofstream(file_) << knots_scene(2e5, 1, ""); }
  ~ScaleStepRun() override { std::filesystem::remove(file_); }
  std::filesystem::path file_ = testing::TempDir() + "scale_step_test.json";
};

// 100,000 vertices of a position, a normal and (u,v), 32 bytes, and 200,000 triangles of 12: 5.6 MB, besides
// what it takes to make them. Were the memory that the process held before counted too, ten times as much
// could not be told from it.
TEST_F(ScaleStepRun, TellsTheMeshesMemory) {
  std::istringstream words(run_scale_step({.work = "generate", .scene = file_}));
  double median = 0;
  double least = 0;
  double most = 0;
  double runs = 0;
  double bytes = 0;
  words >> median >> least >> most >> runs >> bytes;
  ASSERT_TRUE(words) << words.str();
  EXPECT_LE(least, median);
  EXPECT_LE(median, most);
  EXPECT_GE(runs, 5);
#ifndef __SANITIZE_ADDRESS__  // which keeps what is freed
  EXPECT_GT(bytes, 5.6e6);
  EXPECT_LT(bytes, 5.6e7);
#endif
}

TEST_F(ScaleStepRun, RefusesAnUnknownWork) {
  EXPECT_THROW(run_scale_step({.work = "paint", .scene = file_}), InputError);
}

// The table keeps every step, and one whose process cannot be run is a failure in it.
TEST(Scale, AStepThatCannotBeRunIsAFailure) {
  const Experiment experiment = measure_scale({.is_quick = true, .program = "/no/such/program"});
  const Table& table = experiment.table;
  EXPECT_EQ(table.rows.size(), 3u * (4 + 4 + 4) + 2 * 4);
  for (const std::vector<Cell>& row : table.rows) {
    ASSERT_EQ(row.size(), table.columns.size());
    EXPECT_TRUE(std::isnan(std::get<double>(row[table.column("seconds")])));
    EXPECT_TRUE(std::isnan(std::get<double>(row[table.column("bytes")])));
  }
  for (const Plot& plot : experiment.plots) {
    table.column(plot.x);
    table.column(plot.y);
    std::set<std::string> works;
    for (const std::vector<Cell>& row : table.rows) {
      if (std::get<std::string>(row[table.column(plot.only)]) == plot.only_is)
        works.insert(std::get<std::string>(row[table.column(plot.by)]));
    }
    EXPECT_GE(works.size(), 2u) << plot.name;
  }
}

}  // namespace
}  // namespace sweepkit::report
