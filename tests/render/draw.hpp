// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <memory>
#include <string>

#include "sweepkit/render/render.hpp"
#include "sweepkit/scene/document.hpp"
#include "sweepkit/scene/model.hpp"
#include "sweepkit/scene/plan.hpp"

namespace sweepkit::render::test {

inline scene::Plan plan_for(const scene::Document& document, const Options& options, bool leaves_out = true) {
  return scene::plan(
      document, {.product = scene::Request::Product::kPicture,
                 .filter = options.filter,
                 .is_supersampled = options.supersampling > 1,
                 .is_refined = options.adaptive.has_value() || options.goal.has_value(),
                 .estimates_error = options.estimates_error,
                 .has_smooth_shadows = options.shadows == Shadows::kSmooth,
                 .has_layers = !options.layers.empty(),
                 .shows_texcoords = std::ranges::find(options.layers, Layer::kUv) != options.layers.end(),
                 .has_neighbours = options.footprint != Footprint::kDifferentials,
                 .has_differentials = options.footprint != Footprint::kNeighbours,
                 .leaves_out = leaves_out});
}

/// A scene drawn from the start, with all that it cost.
struct Drawn {
  scene::Plan plan;
  Picture picture;
  scene::Ledger ledger;
};

inline Drawn draw(const std::string& text, const Options& options, bool leaves_out = true) {
  const scene::Document document = scene::parse_document(text, "test.json");
  Drawn drawn{.plan = plan_for(document, options, leaves_out)};
  const scene::Model model = scene::build(document, drawn.plan);
  drawn.picture = render(model.scene, drawn.plan, options);
  drawn.ledger = model.ledger;
  drawn.ledger.add(drawn.picture.ledger);
  return drawn;
}

/// A scene from text, ready to be drawn again and again; its parts may be changed in between.
struct Stage {
  explicit Stage(const std::string& text) : document(scene::parse_document(text, "test.json")) {
    model = scene::build(document, plan_for(document, {}));
  }
  Picture draw(const Options& options = {}) const {
    return render(model.scene, plan_for(document, options), options);
  }

  /// A float texture in place of one of the scene's, which names a procedural.
  void set_texture(std::size_t index, texmap::Image image) {
    model.scene.textures[index] =
        texmap::ImageTexture{std::make_shared<const texmap::Image>(std::move(image)), texmap::Wrap::kRepeat};
    document.textures[index].source = scene::ImageEntry{};
  }

  scene::Document document;
  scene::Model model;
};

inline const std::vector<float>& texels(const Picture& picture) {
  return std::get<std::vector<float>>(picture.image.texels);
}

/// The layer of eye rays a pixel.
inline const std::vector<float>& eye_rays(const Picture& picture) {
  const auto layer = std::ranges::find(picture.layers, Layer::kRays, &PictureLayer::layer);
  return std::get<std::vector<float>>(layer->image.texels);
}

}  // namespace sweepkit::render::test
