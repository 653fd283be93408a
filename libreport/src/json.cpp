// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// JSON has no infinity and no NaN: a failed number is null.

#include <cmath>
#include <nlohmann/json.hpp>

#include "front.hpp"
#include "sweepkit/report/report.hpp"

namespace sweepkit::report {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

Json cell(const Cell& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  return number(std::get<double>(value));
}

std::string text_of(const Cell& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  return Json(std::get<double>(value)).dump();
}

Json& curve_named(Json& curves, const std::string& name) {
  for (Json& curve : curves) {
    if (curve["name"] == name) return curve;
  }
  curves.push_back({{"name", name}, {"points", Json::array()}});
  return curves.back();
}

// A point is [x, y, label, row], where `row` is that of the table, counted from 0.
Json curves_of(const Experiment& experiment, const Plot& plot) {
  const Table& table = experiment.table;
  const std::size_t x = table.column(plot.x);
  const std::size_t y = table.column(plot.y);
  Json curves = Json::array();
  std::vector<PlotPoint> all;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const std::vector<Cell>& cells = table.rows[row];
    if (!plot.only.empty() && text_of(cells[table.column(plot.only)]) != plot.only_is) continue;
    all.push_back({std::get<double>(cells[x]), std::get<double>(cells[y])});
    const std::string label = plot.label.empty() ? "" : text_of(cells[table.column(plot.label)]);
    curve_named(curves, text_of(cells[table.column(plot.by)]))["points"].push_back(
        {number(all.back().x), number(all.back().y), label, row});
  }
  Json drawn = {{"curves", std::move(curves)}};
  if (plot.has_front) {
    for (const PlotPoint& point : front_of(std::move(all))) drawn["front"].push_back({point.x, point.y});
  }
  return drawn;
}

Json axis(const Table& table, const std::string& column, bool is_log) {
  return {{"column", column}, {"title", table.columns[table.column(column)].title}, {"log", is_log}};
}

Json plot_of(const Experiment& experiment, const Plot& plot, bool has_curves) {
  Json json = {{"name", plot.name},
               {"title", plot.title},
               {"x", axis(experiment.table, plot.x, plot.is_x_log)},
               {"y", axis(experiment.table, plot.y, plot.is_y_log)},
               {"by", plot.by},
               {"lines", plot.has_lines}};
  if (!plot.only.empty()) json["only"] = {{"column", plot.only}, {"is", plot.only_is}};
  if (!plot.label.empty())
    json["label"] = experiment.table.columns[experiment.table.column(plot.label)].title;
  if (has_curves) json.update(curves_of(experiment, plot));
  return json;
}

Json experiment_json(const Experiment& experiment, bool has_plots) {
  Json json = {{"name", experiment.name}, {"title", experiment.title}, {"what", experiment.what},
               {"how", experiment.how},   {"columns", Json::array()},  {"rows", Json::array()},
               {"plots", Json::array()}};
  for (const Column& column : experiment.table.columns) {
    json["columns"].push_back({{"name", column.name}, {"title", column.title}});
  }
  for (const std::vector<Cell>& row : experiment.table.rows) {
    Json cells = Json::array();
    for (const Cell& value : row) cells.push_back(cell(value));
    json["rows"].push_back(std::move(cells));
  }
  for (const Plot& plot : experiment.plots) json["plots"].push_back(plot_of(experiment, plot, has_plots));
  return json;
}

}  // namespace

std::string plot_json(const Experiment& experiment, const Plot& plot) {
  return plot_of(experiment, plot, true).dump();
}

std::string to_json(const Report& report, bool has_plots) {
  const Machine& machine = report.machine;
  Json json = {{"sweepkit", report.version},
               {"date", report.date},
               {"quick", report.is_quick},
               {"machine",
                {{"processor", machine.processor},
                 {"threads", machine.threads},
                 {"memory_gib", machine.memory_gib},
                 {"system", machine.system},
                 {"compiler", machine.compiler}}},
               {"experiments", Json::array()}};
  for (const Experiment& experiment : report.experiments) {
    json["experiments"].push_back(experiment_json(experiment, has_plots));
  }
  return json.dump();
}

}  // namespace sweepkit::report
