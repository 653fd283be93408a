// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// MTL is older than the materials of glTF and nearer to Whitted's: diffuse, specular and exponent go over as
// they are. It has no share that is mirrored, for which the specular colour stands (illum 3 and above), and
// its transparency is a number beside it. Textures have repeat and clamp; a mirrored one is written as the
// four of it that repeat, with (u,v) halved.

#include "obj_materials.hpp"

#include <algorithm>
#include <array>

#include "message_text.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/scene/bake_over.hpp"
#include "sweepkit/scene/texel_density.hpp"
#include "sweepkit/texmap/image_file.hpp"

namespace sweepkit::scene {
namespace {

// The image in the lower left, where 0 <= u, v < 1, and its reflections right of it and above.
texmap::Image mirrored_image(const texmap::Image& image) {
  texmap::Image out{2 * image.width, 2 * image.height, image.channels, {}};
  const auto fill = [&](const auto& from) {
    std::decay_t<decltype(from)> texels;
    texels.reserve(4 * from.size());
    const auto channels = static_cast<std::size_t>(image.channels);
    for (int y = 0; y < out.height; ++y) {
      const int row = y < image.height ? image.height - 1 - y : y - image.height;
      for (int x = 0; x < out.width; ++x) {
        const int column = x < image.width ? x : out.width - 1 - x;
        const std::size_t at = (static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
                                static_cast<std::size_t>(column)) *
                               channels;
        texels.insert(texels.end(), from.begin() + static_cast<std::ptrdiff_t>(at),
                      from.begin() + static_cast<std::ptrdiff_t>(at + channels));
      }
    }
    out.texels = std::move(texels);
  };
  std::visit(fill, image.texels);
  return out;
}

bool is_blank(char c) {
  return static_cast<unsigned char>(c) <= 0x20 || c == 0x7F;
}

}  // namespace

std::string as_word(std::string name) {
  std::replace_if(name.begin(), name.end(), is_blank, '_');
  return name;
}

std::string UniqueNames::unique(const std::string& name) {
  const std::string word = as_word(name);
  std::string candidate = word;
  // Where a word was last left: a million instances have a million names.
  std::uint64_t& number = numbers_[word];
  while (!taken_.insert(candidate).second) {
    number = std::max<std::uint64_t>(number + 1, 2);
    candidate = word + "_" + std::to_string(number);
  }
  return candidate;
}

ObjMaterials::ObjMaterials(const Scene& scene, const Plan& plan, const std::string& stem,
                           const MeshOutputOptions& options)
    : scene_(scene),
      plan_(plan),
      options_(options),
      images_(options.images != nullptr ? *options.images : own_images_),
      stem_(as_word(stem)),
      are_needed_(std::any_of(scene.objects.begin(), scene.objects.end(),
                              [](const Object& object) { return object.material.has_value(); })) {}

std::string ObjMaterials::add_file(std::vector<std::byte> png) {
  std::string name = stem_ + "_" + std::to_string(image_files_.size()) + ".png";
  image_files_.push_back({name, std::move(png)});
  return name;
}

ObjMaterials::Image ObjMaterials::write_image(const Object& object, std::size_t texture) {
  if (const auto* image = std::get_if<texmap::ImageTexture>(&scene_.textures[texture])) {
    const bool is_normal_map = std::ranges::any_of(
        scene_.materials, [&](const Material& material) { return material.normal_map == texture; });
    if (image->wrap == texmap::Wrap::kMirror) {
      return {.file = add_file(texmap::encode_image(
                  mirrored_image(*image->image), texmap::ImageFormat::kPng,
                  is_normal_map ? texmap::ColorSpace::kLinear : texmap::ColorSpace::kSrgb)),
              .uv_factor = 0.5f};
    }
    return {.file = add_file(*images_.encoded(image->image, {.is_normal_map = is_normal_map})),
            .is_clamped = image->wrap == texmap::Wrap::kClamp};
  }
  const auto& procedural = std::get<texmap::Procedural>(scene_.textures[texture]);
  const auto count = [&](const texmap::Image& image) {
    ledger_[Part::kBakes].calls += 1;
    ledger_[Part::kBakes].bytes += image.bytes();
  };
  const MeshView& mesh = scene_.meshes[object.mesh];
  const glm::ivec2 size = bake_size_of(mesh, glm::dmat3(object.world_from_object), procedural,
                                       {.size = options_.bake_size, .density = options_.texel_density});
  if (texmap::repeats_in_unit_square(procedural)) {
    const StoredImage baked = images_.bake(procedural, size, options_.threads);
    if (baked.is_new) count(*baked.image);
    return {.file = add_file(*images_.encoded(baked.image))};
  }
  texmap::BakedTexture baked = bake_over(mesh, procedural, {size.x, size.y, options_.threads});
  count(baked.image);
  return {.file = add_file(texmap::encode_image(baked.image, texmap::ImageFormat::kPng)),
          .is_clamped = true,
          .transforms = std::move(baked.transforms)};
}

const ObjMaterials::Image* ObjMaterials::image_of(const Object& object, std::size_t texture) {
  const auto* procedural = std::get_if<texmap::Procedural>(&scene_.textures[texture]);
  const bool is_over_mesh = procedural != nullptr && !texmap::repeats_in_unit_square(*procedural);
  const std::pair key(texture, is_over_mesh ? std::optional(object.mesh) : std::nullopt);
  const auto found = image_entries_.find(key);
  if (found != image_entries_.end()) return &found->second;
  return &image_entries_.emplace(key, write_image(object, texture)).first->second;
}

const ObjMaterials::Image* ObjMaterials::normals_of(const Object& object, const Material& material,
                                                    const Image* colors) {
  if (!material.normal_map || !plan_.textures[*material.normal_map]) return nullptr;
  const Image* normals = image_of(object, *material.normal_map);
  if (colors == nullptr || (colors->transforms.empty() && colors->uv_factor == normals->uv_factor))
    return normals;
  throw InputError("the material " + in_quotes(material.name) +
                   (colors->transforms.empty()
                        ? " has a texture and a normal map of which one alone is mirrored"
                        : " has a normal map, and colours that are baked with (u,v) of their own") +
                   ", and .obj has one (u,v) for both; write a .glb, or leave the normal map out");
}

ObjMaterials::Use ObjMaterials::use(const Object& object) {
  static const std::vector<texmap::UvTransform> kNone;
  if (!are_needed_) return {"", &kNone};
  const Material material = object.material ? scene_.materials[*object.material] : Material{};
  const bool has_texture = material.texture && plan_.textures[*material.texture];
  const Image* image = has_texture ? image_of(object, *material.texture) : nullptr;
  const Image* normals = normals_of(object, material, image);
  const auto [entry, is_new] = entries_.try_emplace({object.material, image});
  if (is_new) {
    entry->second = {names_.unique(object.material ? material.name : "default"), image, normals};
    write_material(material, entry->second);
  }
  if (image == nullptr) return {entry->second.name, &kNone, normals != nullptr ? normals->uv_factor : 1};
  return {entry->second.name, &image->transforms, image->uv_factor};
}

void ObjMaterials::write_material(const Material& material, const Entry& entry) {
  const auto line = [&](const char* key, std::initializer_list<float> values) {
    library_.text(key);
    for (const float value : values) {
      library_.text(" ");
      library_.number(static_cast<double>(value));
    }
    library_.text("\n");
  };
  const auto color = [&](const char* key, const glm::vec3& c) { line(key, {c.r, c.g, c.b}); };
  constexpr float kMostExponent = 1000;  // of the format
  const bool has_fresnel = material.fresnel != Fresnel::kNone;
  const bool has_highlight = material.specular != glm::vec3(0.0f);
  library_.text("\nnewmtl " + entry.name + "\n");
  color("Ka", material.diffuse);
  color("Kd", material.diffuse);
  color("Ks", glm::max(material.specular, glm::vec3(material.reflect)));
  line("Ns", {std::min(material.shininess, kMostExponent)});
  line("Ni", {material.ior});
  line("d", {1 - material.transmit});
  if (material.transmit > 0) color("Tf", glm::vec3(material.transmit));
  const int illum = material.transmit > 0  ? (has_fresnel ? 7 : 6)
                    : material.reflect > 0 ? (has_fresnel ? 5 : 3)
                    : has_highlight        ? 2
                                           : 1;
  library_.text("illum " + std::to_string(illum) + "\n");
  const auto map = [&](const char* key, const Image* image) {
    if (image != nullptr)
      library_.text(std::string(key) + (image->is_clamped ? "-clamp on " : "") + image->file + "\n");
  };
  map("map_Kd ", entry.image);
  map("norm ", entry.normals);
}

std::vector<NamedBytes> ObjMaterials::take_files(const std::string& title) {
  std::vector<NamedBytes> files = std::move(image_files_);
  if (!are_needed_) return files;
  ByteWriter whole;
  whole.text("# " + title + "\n");
  whole.bytes.insert(whole.bytes.end(), library_.bytes.begin(), library_.bytes.end());
  files.push_back({file(), std::move(whole.bytes)});
  return files;
}

}  // namespace sweepkit::scene
