// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Duktape, a small engine for ECMAScript 5.1, is known to this file alone. ECharts draws without a browser
// where it finds no window, and asks only for timers, which no still picture needs.

#include "sweepkit/report/plot_drawer.hpp"

#include <duktape.h>

#include "sweepkit/error.hpp"

namespace sweepkit::report {
namespace {

constexpr const char* kSurroundings =
    "var self = this, global = this;"
    "var console = {log: function() {}, warn: function() {}, error: function() {}};"
    "function setTimeout() { return 0; } function clearTimeout() {}";

[[noreturn]] void end_by(void*, const char* message) {
  throw OutputError(std::string("the plots cannot be drawn: ") +
                    (message != nullptr ? message : "out of memory"));
}

}  // namespace

struct PlotDrawer::Engine {
  Engine() : context(duk_create_heap(nullptr, nullptr, nullptr, nullptr, end_by)) {
    if (context == nullptr) end_by(nullptr, nullptr);
  }
  ~Engine() { duk_destroy_heap(context); }
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  std::string run(const std::string& script) const {
    const bool has_failed = duk_peval_lstring(context, script.data(), script.size()) != 0;
    std::string result = duk_safe_to_string(context, -1);
    duk_pop(context);
    if (has_failed) end_by(nullptr, result.c_str());
    return result;
  }

  duk_context* context;
};

PlotDrawer::PlotDrawer(const std::string& script) : engine_(std::make_unique<Engine>()) {
  engine_->run(kSurroundings);
  engine_->run(script);
}

PlotDrawer::~PlotDrawer() = default;

std::string PlotDrawer::svg(const std::string& plot) {
  return engine_->run("sweepkitPlots.svg(" + plot + ")");
}

}  // namespace sweepkit::report
