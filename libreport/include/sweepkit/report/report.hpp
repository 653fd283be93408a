// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sweepkit/report/experiment.hpp"

namespace sweepkit::report {

/// Where and with what a report was made.
struct Machine {
  std::string processor;  ///< its model
  unsigned threads = 0;   ///< that run at once
  double memory_gib = 0;
  std::string system;
  std::string compiler;  ///< with its version, and how it was told to round
};

Machine this_machine();

struct Report {
  std::string version;  ///< of sweepkit
  std::string date;     ///< UTC, ISO 8601
  bool is_quick = false;
  Machine machine;
  std::vector<Experiment> experiments;
};

/// An experiment that can be run by its name.
struct Runnable {
  std::string name;
  std::string title;
  std::function<Experiment(const Effort&)> run;
  bool needs_scenes = false;  ///< Effort::samples or Effort::scene
};

/// All there are, in the order in which a report shows them.
const std::vector<Runnable>& runnables();

/// RFC 4180: a line of column names, then the rows. Numbers are the shortest that read back the same; a
/// failed one is "nan", "inf" or "-inf".
std::string to_csv(const Table& table);

/// A plot's curves out of its table, as JSON of the form that tools/report/src/plots.js draws.
std::string plot_json(const Experiment& experiment, const Plot& plot);

/// Everything in the report, as JSON. With `has_plots` the plots' curves too, for the page.
std::string to_json(const Report& report, bool has_plots = false);

}  // namespace sweepkit::report
