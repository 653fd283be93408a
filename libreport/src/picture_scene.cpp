// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "picture_scene.hpp"

namespace sweepkit::report {

PictureScene make_scene(scene::Document document) {
  scene::Model model = scene::build(document, plan_for(document, {}));
  return {std::move(document), std::move(model)};
}

PictureScene read_scene(const std::filesystem::path& file, int side) {
  scene::Document document = scene::read_document(file);
  document.width = side;
  document.height = side;
  return make_scene(std::move(document));
}

scene::Plan plan_for(const scene::Document& document, const render::Options& options, bool leaves_out) {
  return scene::plan(document, {.product = scene::Request::Product::kPicture,
                                .filter = options.filter,
                                .is_supersampled = options.supersampling > 1,
                                .is_refined = options.adaptive.has_value(),
                                .has_smooth_shadows = options.shadows == render::Shadows::kSmooth,
                                .has_differentials = options.footprint != render::Footprint::kNeighbours,
                                .leaves_out = leaves_out});
}

render::Picture draw(const PictureScene& scene, const render::Options& options) {
  return render::render(scene.model.scene, plan_for(scene.document, options), options);
}

// The scene is drawn black, without light and mirrors, and the object white.
std::vector<std::uint8_t> mask_of(const PictureScene& scene, const std::string& object) {
  scene::Document flat = scene.document;
  for (scene::Material& material : flat.materials) {
    material.reflect = 0;
    material.transmit = 0;
    material.texture.reset();
  }
  flat.lights.clear();
  flat.environment.reset();
  flat.has_ambient = true;
  scene::Scene shown = scene.model.scene;
  shown.lights.clear();
  shown.ambient = glm::vec3(1.0f);
  shown.background = glm::vec3(0.0f);
  shown.materials.assign(2, {.diffuse = glm::vec3(0.0f)});
  shown.materials[1].diffuse = glm::vec3(1.0f);
  for (scene::Object& entry : shown.objects) entry.material = entry.name == object ? 1 : 0;
  const render::Options options{.filter = render::Filter::kPoint, .threads = 1};
  const texmap::Image image = render::render(shown, plan_for(flat, options), options).image;
  std::vector<std::uint8_t> mask;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) mask.push_back(image.color(x, y).r > 0.5f ? 1 : 0);
  }
  return mask;
}

}  // namespace sweepkit::report
