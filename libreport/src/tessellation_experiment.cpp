// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "tessellation_experiment.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "test_shapes.hpp"
#include "timing.hpp"

namespace sweepkit::report {
namespace {

struct Setting {
  std::string method;
  std::string text;
  sweep::Tessellation tessellation;
};

// Both numbers double from one setting to the next, or the tolerance falls to a fourth, which takes about as
// many more triangles.
std::vector<Setting> settings_of(const TestShape& shape, double most_triangles) {
  std::vector<Setting> settings;
  const auto add_counts = [&](const char* method, double balance) {
    for (int columns = 4; 2 * balance * columns * columns <= most_triangles; columns *= 2) {
      const int rows = std::max(static_cast<int>(std::lround(balance * columns)), 3);
      settings.push_back(
          {method, std::to_string(columns) + " x " + std::to_string(rows), shape.counts(columns, rows)});
    }
  };
  add_counts("counts, equal", 1);
  if (shape.balance != 1) add_counts("counts, balanced", shape.balance);
  for (double share = 0x1p-6; share > 1e-6; share /= 4) {
    char text[40];
    std::snprintf(text, sizeof text, "within %.2g m", share * shape.size);
    settings.push_back({"tolerance", text, {.tolerance = share * shape.size}});
  }
  return settings;
}

}  // namespace

Experiment measure_tessellation(const Effort& effort) {
  Experiment experiment{
      .name = "tessellation",
      .title = "Cells of a mesh",
      .what =
          "The largest distance from a mesh's walls to the surface that they stand for, by counts of cells "
          "along both directions - equal, or balanced so that both are about as far off - and by tolerance. "
          "The "
          "surface is a formula that shares nothing with the sweep, and its nearest point is found by "
          "Newton's "
          "method in double precision: to 1e-15 of the size. 15 points of every triangle are looked at and "
          "561 "
          "of each of the worst 256, which misses below one percent of the distance. The mesh's own places "
          "are "
          "float32: below 1e-7 of the size nothing can fall.",
      .how = "The time is that of making the mesh, without half-edges. One thread."};
  Table& table = experiment.table;
  table.columns = {{"shape", "shape"},
                   {"method", "method"},
                   {"setting", "cells or tolerance"},
                   {"triangles", "triangles"},
                   {"metres", "largest distance to the surface (m)"},
                   {"reported", "distance that the mesh reports (m)"}};
  for (Column& column : timing_columns("the mesh")) table.columns.push_back(std::move(column));
  const double most_triangles = effort.is_quick ? 4e3 : 500e3;
  const std::vector<TestShape> shapes = test_shapes();
  double done = 0;
  for (const TestShape& shape : shapes) {
    bool is_full = false;  // finer tolerances would take too many triangles
    for (const Setting& setting : settings_of(shape, most_triangles)) {
      if (is_full && setting.tessellation.tolerance) continue;
      const sweep::Mesh mesh = shape.make(setting.tessellation);
      if (setting.tessellation.tolerance)
        is_full = static_cast<double>(mesh.triangles.size()) > most_triangles / 4;
      const Timing timing = time_calls([&] { keep(shape.make(setting.tessellation)); }, effort);
      std::vector<Cell> row{shape.name,
                            setting.method,
                            setting.text,
                            static_cast<double>(mesh.triangles.size()),
                            wall_distance(mesh, shape.distance),
                            mesh.deviation ? Cell(*mesh.deviation) : Cell("")};
      add_timing(row, timing);
      table.rows.push_back(std::move(row));
    }
    effort.tell(++done / static_cast<double>(shapes.size()));
    for (const char* x : {"triangles", "seconds"}) {
      experiment.plots.push_back({.name = "tessellation_" + shape.name + "_by_" + x,
                                  .title = shape.name + ": " + shape.title,
                                  .x = x,
                                  .y = "metres",
                                  .by = "method",
                                  .only = "shape",
                                  .only_is = shape.name,
                                  .label = "setting",
                                  .has_front = true});
    }
  }
  return experiment;
}

}  // namespace sweepkit::report
