// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace sweepkit::report {

/// A number or a word. A number that is not finite is a failure: it is shown as one and never dropped.
using Cell = std::variant<double, std::string>;

struct Column {
  std::string name;   ///< in the CSV file, such as "seconds"; stays the same for good
  std::string title;  ///< for people, with its unit: "time for one evaluation (s)"
};

/// Everything an experiment measured. What a plot or a page shows is a row of it.
struct Table {
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;  ///< each as long as `columns`

  /// Precondition: there is such a column.
  std::size_t column(const std::string& name) const;
};

/// A drawing of a table's rows: a curve for each value of column `by`, through (x, y) in the rows' order.
struct Plot {
  std::string name;  ///< of its file, without ending
  std::string title;
  std::string x;
  std::string y;
  std::string by;
  std::string only;     ///< a column, or "": all rows
  std::string only_is;  ///< rows with this text in it
  std::string label;    ///< the column that tells a point's setting, or ""
  bool is_x_log = true;
  bool is_y_log = true;
  bool has_lines = true;  ///< through the points of a curve, which have an order then
  /// Draws the front of the points that none is both cheaper and more exact than.
  bool has_front = false;
};

struct Experiment {
  std::string name;   ///< "frames"; of its CSV file too
  std::string title;  ///< "Frames along a trajectory"
  std::string what;   ///< a paragraph: what is measured, against which reference
  std::string how;    ///< a paragraph: how, on how many threads
  Table table;
  std::vector<Plot> plots;
  /// Other tables worked out of the same measurements, shown after this one; with no `derived` of their own.
  std::vector<Experiment> derived;
};

/// How much time a run may take, and on what it works.
struct Effort {
  bool is_quick = false;
  std::filesystem::path samples;  ///< the folder of the sample scenes
  std::filesystem::path scene;    ///< measured in place of the samples where it is not empty
  std::filesystem::path program;  ///< sweepkit itself, which measures steps in processes of their own
  /// Of the experiment, 0 to 1; may be empty.
  std::function<void(double)> on_progress;

  void tell(double done) const {
    if (on_progress) on_progress(done);
  }
};

}  // namespace sweepkit::report
