// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A floor seen from above, under ambient light alone: every pixel is ambient times diffuse, 0.5 * 0.8.
#include <cmath>
#include <cstdio>

#include "sweepkit/render/render.hpp"
#include "sweepkit/scene/model.hpp"

using namespace sweepkit;

int main() {
  const scene::Document document = scene::parse_document(
      R"({"sweepkit": 1, "ambient": [0.5, 0.5, 0.5],
          "camera": {"eye": [0, 1, 0], "target": [0, 0, 0], "up": [0, 0, -1], "width": 16, "height": 16},
          "objects": [{"name": "floor", "plane": {"size": [10, 10]}}]})",
      "floor.json");
  const scene::Plan plan = scene::plan(document, {});
  const scene::Model model = scene::build(document, plan);
  const render::Picture picture = render::render(model.scene, plan);
  double worst = 0;
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x)
      worst = std::fmax(worst, std::abs(static_cast<double>(picture.image.color(x, y).g) - 0.5 * 0.8));
  }
  std::printf("render: %d x %d pixels, within %.1e\n", picture.image.width, picture.image.height, worst);
  return worst < 1e-7 ? 0 : 1;  // a unit in the last place of 0.4 in float32 is 3e-8
}
