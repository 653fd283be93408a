// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "sweepkit/scene/document.hpp"
#include "sweepkit/scene/model.hpp"
#include "sweepkit/scene/plan.hpp"

namespace sweepkit::report {

/// A scene from text, made ready for what is asked of it.
struct MadeScene {
  MadeScene(const std::string& text, const scene::Request& request)
      : document(scene::parse_document(text, "stability.json")),
        plan(scene::plan(document, request)),
        model(scene::build(document, plan)) {}

  scene::Document document;
  scene::Plan plan;
  scene::Model model;
};

}  // namespace sweepkit::report
