// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/scene/model.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <numbers>

#include "object_mesh.hpp"
#include "scene_bounds.hpp"
#include "sweepkit/scene/image_store.hpp"
#include "sweepkit/scene/turntable.hpp"
#include "sweepkit/strict_math.hpp"
#include "sweepkit/texmap/image_file.hpp"

namespace sweepkit::scene {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

StoredImage read_image(const ImageEntry& source, ImageStore* images) {
  if (images != nullptr) return images->read(source.file, source.color_space);
  return {std::make_shared<const texmap::Image>(texmap::read_image(source.file, source.color_space)), true};
}

// Counts what it cost in the ledger's row: nothing where another scene has paid already.
texmap::Texture load_texture(const TextureEntry& entry, const Plan& plan, bool is_sampled, ImageStore* images,
                             Cost& cost) {
  if (const auto* procedural = std::get_if<texmap::Procedural>(&entry.source)) {
    cost.calls += 1;
    return *procedural;
  }
  const auto& source = std::get<ImageEntry>(entry.source);
  try {
    if (is_sampled) {
      auto file = texmap::open_image(source.file, source.color_space, plan.texture_memory);
      cost.calls += 1;
      cost.bytes += texmap::bytes_held(*file);
      return texmap::ImageTexture{nullptr, source.wrap, std::move(file)};
    }
    StoredImage stored = read_image(source, images);
    if (stored.is_new) {
      cost.calls += 1;
      cost.bytes += stored.image->bytes();
    }
    return texmap::ImageTexture{std::move(stored.image), source.wrap};
  } catch (const InputError& error) {
    throw InputError(entry.place, source.file.string() + ": " + error.problem());
  }
}

// A three-quarter view from above that holds the sphere about everything.
void frame(Scene& scene) {
  const Bounds bounds = bounds_of(scene);
  const double radius = bounds.radius();
  Camera& camera = scene.camera;
  camera.target = bounds.center();
  const double half_height = std::tan(0.5 * camera.fov_deg * std::numbers::pi / 180);
  const double half_width = half_height * scene.width / scene.height;
  const double distance = radius / std::sin(std::atan(std::min(half_height, half_width)));
  camera.eye = camera.target + distance * glm::normalize(glm::dvec3(0.55, 0.5, 1.0));
}

// Of the mesh that comes next: the entry, or its instances.
void add_objects(Scene& scene, const ObjectEntry& entry) {
  const glm::dmat4 placed = to_matrix(entry.placement);
  if (entry.instances.empty()) {
    scene.objects.push_back({entry.name, scene.meshes.size(), entry.material, placed});
    return;
  }
  std::uint32_t instance = 0;
  for (const Placement& placement : entry.instances) {
    scene.objects.push_back(
        {entry.name, scene.meshes.size(), entry.material, to_matrix(placement) * placed, instance++});
  }
}

std::size_t count_objects(const Document& document) {
  std::size_t count = 0;
  for (const ObjectEntry& entry : document.objects) count += std::max(entry.instances.size(), std::size_t{1});
  return count;
}

}  // namespace

std::optional<double> deviation_of(const Model& model, const Object& object) {
  const std::optional<double>& own = model.meshes[object.mesh]->deviation;
  if (!own) return std::nullopt;
  return sweep::largest_stretch(glm::dmat3(object.world_from_object)) * *own;
}

Model build(const Document& document, const Plan& plan, ImageStore* images) {
  Model model;
  Scene& scene = model.scene;
  scene.width = document.width;
  scene.height = document.height;
  scene.background = document.background;
  scene.ambient = document.ambient;
  scene.depth = document.depth;
  scene.materials = document.materials;
  scene.lights = document.lights;
  scene.has_dimmed_shadows = plan.needs_part(Part::kDimmedShadows);

  scene.objects.reserve(count_objects(document));
  Clock::time_point start = Clock::now();
  for (const ObjectEntry& entry : document.objects) {
    add_objects(scene, entry);
    add_mesh_of(entry, document, plan, model);
  }
  model.mesh_seconds = seconds_since(start);
  start = Clock::now();
  const bool has_samplers = plan.needs_part(Part::kTiles) || plan.needs_part(Part::kTables);
  for (std::size_t i = 0; i < document.textures.size(); ++i) {
    scene.textures.emplace_back();
    scene.texture_names.push_back(document.textures[i].name);
    const auto* file = std::get_if<ImageEntry>(&document.textures[i].source);
    scene.texture_sources.push_back(file != nullptr ? ImageSource{file->file, file->color_space}
                                                    : ImageSource{});
    if (!plan.textures[i]) continue;
    scene.textures.back() =
        load_texture(document.textures[i], plan, has_samplers, images, model.ledger[Part::kTextures]);
  }
  if (plan.needs_part(Part::kEnvironment)) {
    scene.environment = std::get<texmap::ImageTexture>(
        load_texture(*document.environment, plan, true, images, model.ledger[Part::kEnvironment]));
  }
  model.texture_seconds = seconds_since(start);
  scene.camera = document.camera;
  if (!document.has_view) frame(scene);
  look_from(scene, document, scene.camera);
  return model;
}

}  // namespace sweepkit::scene
