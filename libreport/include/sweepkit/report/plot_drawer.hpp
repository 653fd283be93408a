// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

namespace sweepkit::report {

/// Draws plots as SVG by the very script that draws them on the page: ECharts, run without a browser.
class PlotDrawer {
 public:
  /// `script` is what tools/report bundles. Throws OutputError where it does not run.
  explicit PlotDrawer(const std::string& script);
  ~PlotDrawer();

  /// Of a plot_json(). Throws OutputError where the script fails.
  std::string svg(const std::string& plot);

 private:
  struct Engine;
  std::unique_ptr<Engine> engine_;
};

}  // namespace sweepkit::report
