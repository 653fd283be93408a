// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "read_look.hpp"

#include <algorithm>

namespace sweepkit::scene {
namespace {

constexpr Range kPositive{.low = 1e-9, .high = 1e9};

// Colours and those keys that only some kinds have.
void read_colors(const Node& node, texmap::Procedural& procedural) {
  constexpr std::size_t kMost = 256;
  for (const Node& color : node.items()) procedural.colors.push_back(color.color(1));
  const std::string got = std::to_string(procedural.colors.size());
  if (procedural.colors.size() < 2) node.fail("needs at least 2 colours, got " + got);
  if (procedural.colors.size() > kMost) node.fail("needs at most 256 colours, got " + got);
  if (procedural.kind == texmap::ProceduralKind::kChecker && procedural.colors.size() > 2)
    node.fail("a checker has 2 colours, got " + got);
}

void read_widths(const Node& node, texmap::Procedural& procedural) {
  if (procedural.colors.empty()) node.fail("needs \"colors\" beside it, one for each width");
  for (const Node& width : node.items()) procedural.widths.push_back(width.number(kPositive));
  if (procedural.widths.size() != procedural.colors.size()) {
    node.fail("needs one width for each of the " + std::to_string(procedural.colors.size()) +
              " colours, got " + std::to_string(procedural.widths.size()));
  }
}

texmap::Procedural read_procedural(const Node& kind, ObjectReader& reader) {
  using texmap::ProceduralKind;
  constexpr Range kShare{.low = 0, .high = 1};
  texmap::Procedural procedural;
  procedural.kind = static_cast<ProceduralKind>(
      kind.choice({texmap::kProceduralNames.begin(), texmap::kProceduralNames.end()}));
  procedural.on = texmap::default_on(procedural.kind);
  if (const auto node = reader.find("on"))
    procedural.on = static_cast<texmap::ProceduralOn>(node->choice({"uv", "position"}));
  if (const auto node = reader.find("scale")) procedural.scale = node->number(kPositive);
  if (const auto node = reader.find("colors")) read_colors(*node, procedural);
  const auto number = [&](const char* key, double& value, const Range& range) {
    if (const auto node = reader.find(key)) value = node->number(range);
  };
  const auto turbulence = [&] {
    if (const auto node = reader.find("turbulence"))
      procedural.turbulence = node->number({.low = 0, .high = 1000});
  };
  switch (procedural.kind) {
    case ProceduralKind::kChecker:
      return procedural;
    case ProceduralKind::kTiles:
      number("grout", procedural.grout, kShare);
      return procedural;
    case ProceduralKind::kBands:
      if (const auto node = reader.find("widths")) read_widths(*node, procedural);
      return procedural;
    case ProceduralKind::kBrick:
      number("mortar", procedural.mortar, kShare);
      number("ratio", procedural.ratio, {.low = 0.1, .high = 100});
      number("bond", procedural.bond, kShare);
      return procedural;
    case ProceduralKind::kMarble:
      turbulence();
      break;
    case ProceduralKind::kWood:
      number("rings", procedural.rings, {.low = 0.01, .high = 1e6});
      number("grain", procedural.grain, kShare);
      turbulence();
      break;
    case ProceduralKind::kClouds:
      number("coverage", procedural.coverage, kShare);
      break;
    case ProceduralKind::kGranite:
    case ProceduralKind::kNoise:
      break;
  }
  if (const auto node = reader.find("octaves")) procedural.octaves = node->integer(1, 16);
  if (const auto node = reader.find("basis"))
    procedural.basis = static_cast<texmap::NoiseBasis>(node->choice({"perlin-2002", "perlin-1985"}));
  return procedural;
}

TextureEntry read_texture(const std::string& name, const Node& node, const std::filesystem::path& folder) {
  ObjectReader reader(node);
  TextureEntry entry{name, ImageEntry{}, node.place()};
  const std::optional<Node> image = reader.find("image");
  const std::optional<Node> procedural = reader.find("procedural");
  if (image && procedural) procedural->fail("a texture is an \"image\" or a \"procedural\", not both");
  if (!image && !procedural) node.fail("needs \"image\" or \"procedural\"");
  if (image) {
    ImageEntry source{folder / image->text()};
    entry.place = image->place();
    if (const auto wrap = reader.find("wrap"))
      source.wrap = static_cast<texmap::Wrap>(wrap->choice({"repeat", "clamp", "mirror"}));
    if (const auto space = reader.find("color_space")) {
      source.color_space = static_cast<texmap::ColorSpace>(space->choice({"srgb", "linear"}));
    }
    entry.source = source;
  } else {
    entry.source = read_procedural(*procedural, reader);
  }
  reader.finish();
  return entry;
}

}  // namespace

std::vector<TextureEntry> read_textures(const Node& node, const std::filesystem::path& folder) {
  std::vector<TextureEntry> textures;
  for (const auto& [name, texture] : ObjectReader(node).members()) {
    textures.push_back(read_texture(name, texture, folder));
  }
  return textures;
}

namespace {

std::size_t find_texture(const Node& node, const std::vector<TextureEntry>& textures) {
  const auto found = std::find_if(textures.begin(), textures.end(),
                                  [&](const TextureEntry& entry) { return entry.name == node.text(); });
  if (found == textures.end()) {
    std::vector<std::string> names;
    names.reserve(textures.size());
    for (const TextureEntry& entry : textures) names.push_back(entry.name);
    node.fail(unknown_name("texture", node.text(), names));
  }
  return static_cast<std::size_t>(found - textures.begin());
}

void read_normal_map(ObjectReader& reader, const std::vector<TextureEntry>& textures, Material& material) {
  const std::optional<Node> map = reader.find("normal_map");
  const std::optional<Node> strength = reader.find("normal_strength");
  if (strength && !map) strength->fail("needs \"normal_map\" beside it");
  if (!map) return;
  material.normal_map = find_texture(*map, textures);
  if (!std::holds_alternative<ImageEntry>(textures[*material.normal_map].source)) {
    map->fail("needs an image: \"" + map->text() +
              "\" is procedural; sweepkit bake --normals makes an image of it");
  }
  if (strength) material.normal_strength = static_cast<float>(strength->number({.low = 0, .high = 1000}));
}

}  // namespace

Material read_material(const std::string& name, const Node& node, const std::vector<TextureEntry>& textures) {
  ObjectReader reader(node);
  Material material{.name = name};
  if (const auto diffuse = reader.find("diffuse")) material.diffuse = diffuse->color(1);
  if (const auto texture = reader.find("texture")) material.texture = find_texture(*texture, textures);
  if (const auto specular = reader.find("specular")) material.specular = specular->color(1);
  if (const auto shininess = reader.find("shininess")) {
    material.shininess = static_cast<float>(shininess->number({.low = 0, .high = 1e6}));
  }
  if (const auto reflect = reader.find("reflect"))
    material.reflect = static_cast<float>(reflect->number({.low = 0, .high = 1}));
  if (const auto transmit = reader.find("transmit"))
    material.transmit = static_cast<float>(transmit->number({.low = 0, .high = 1}));
  // A bubble in water has 0.75, germanium 4.
  if (const auto ior = reader.find("ior"))
    material.ior = static_cast<float>(ior->number({.low = 0.1, .high = 10}));
  // Up to what nothing passes a micrometre of.
  if (const auto absorption = reader.find("absorption")) material.absorption = absorption->color(1e9);
  if (const auto fresnel = reader.find("fresnel"))
    material.fresnel = static_cast<Fresnel>(fresnel->choice({"none", "schlick", "exact"}));
  read_normal_map(reader, textures, material);
  reader.finish();
  return material;
}

Light read_light(const Node& node) {
  ObjectReader reader(node);
  const std::optional<Node> point = reader.find("point");
  const std::optional<Node> directional = reader.find("directional");
  const std::optional<Node> radius = reader.find("radius");
  glm::vec3 intensity(1.0f);
  if (const auto value = reader.find("intensity")) intensity = value->color();
  reader.finish();
  if (point && directional) directional->fail("a light is \"point\" or \"directional\", not both");
  if (radius && !point) radius->fail("only a \"point\" light has a radius");
  if (point) {
    return PointLight{point->vector<3>(kCoordinate), intensity,
                      radius ? radius->number({.low = 0, .high = kExtent.high, .unit = kExtent.unit}) : 0};
  }
  if (!directional) node.fail("needs \"point\" or \"directional\"");
  const glm::dvec3 direction = directional->vector<3>(kCoordinate);
  if (glm::length(direction) < kExtent.low) directional->fail("needs a direction that is not zero");
  return DirectionalLight{direction, intensity};
}

}  // namespace sweepkit::scene
