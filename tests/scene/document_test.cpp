// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "scene_text.hpp"
#include "unprivileged.hpp"

namespace sweepkit::scene {
namespace {

std::string read_sample(const std::string& name) {
  std::ifstream stream(std::string(SWEEPKIT_SAMPLES "/scenes/") + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// Every key of the format, most of them other than their default.
const std::string kEverything = R"(// line
{
  "sweepkit": 1, /* block
  of two lines */
  "camera": {"eye": [1, 2, 3], "target": [0, 0.5, 0], "up": [0, 0, 1], "fov_deg": 30, "width": 64, "height": 32},
  "background": [0.1, 0.2, 0.3], "ambient": [0.4, 0.5, 0.6], "depth": 3,
  "lights": [{"point": [1, 2, 3], "radius": 0.5, "intensity": [4, 5, 6]}, {"directional": [0, -1, 0]}],
  "textures": {
    "picture": {"image": "a/b.png", "wrap": "clamp", "color_space": "linear"},
    "stone": {"procedural": "marble", "on": "position", "colors": [[0, 0, 0], [1, 1, 1]], "scale": 2, "turbulence": 3, "octaves": 4},
    "tiles": {"procedural": "tiles", "grout": 0.25},
    "bands": {"procedural": "bands", "colors": [[0, 0, 0], [1, 1, 1]], "widths": [1, 3]},
    "check": {"procedural": "checker"},
    "wall": {"procedural": "brick", "mortar": 0.2, "ratio": 2.5, "bond": 0.25},
    "oak": {"procedural": "wood", "on": "uv", "rings": 12, "grain": 0.1, "turbulence": 0, "octaves": 2, "basis": "perlin-1985"},
    "sky": {"procedural": "clouds", "coverage": 0.3}
  },
  "materials": {
    "m": {"diffuse": [0.1, 0.2, 0.3], "texture": "stone", "specular": [0.4, 0.5, 0.6], "shininess": 7, "reflect": 0.5,
          "transmit": 0.25, "ior": 1.5, "absorption": [1, 2, 3000000], "fresnel": "schlick"},
    "plain": {}
  },
  "objects": [
    {"name": "pipe", "material": "m", "translate": [1, 2, 3], "rotate_deg": [4, 5, 6], "scale": 2,
     "tessellation": {"contour": 8}, "uv": {"by": "parameter", "repeat": [2, 3]}, "crease_deg": 10,
     "sweep": {"contour": {"free": [[0, 0], [1, 0], [0, 1]], "closed": true},
               "trajectory": {"polyline": [[0, 0, 0], [0, 1, 0], [1, 1, 0]]}, "caps": "none"}},
    {"name": "bowl", "revolve": {"contour": {"bezier": [[0, 0], [1, 0], [1, 1]]}, "angle_deg": 90}},
    {"name": "set", "tessellation": {"contour": 5}, "parts": [
      {"plane": {"size": [2, 3]}, "translate": [0, 1, 0], "scale": [1, 2, 3], "tessellation": {"trajectory": 6}},
      {"sweep": {"contour": {"circle": {"radius": 1}},
                 "trajectory": {"beziers": [[[0, 0, 0], [0, 1, 0]], [[0, 1, 0], [0, 2, 0], [1, 2, 0]]]}}}]}
  ]
})";

TEST(Document, HoldsWhatTheFileSays) {
  const Document document = parse(kEverything);
  EXPECT_TRUE(document.has_view);
  EXPECT_EQ(document.camera.eye, glm::dvec3(1, 2, 3));
  EXPECT_EQ(document.camera.target, glm::dvec3(0, 0.5, 0));
  EXPECT_EQ(document.camera.up, glm::dvec3(0, 0, 1));
  EXPECT_EQ(document.camera.fov_deg, 30);
  EXPECT_EQ(document.width, 64);
  EXPECT_EQ(document.height, 32);
  EXPECT_EQ(document.background, glm::vec3(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(document.ambient, glm::vec3(0.4f, 0.5f, 0.6f));
  EXPECT_TRUE(document.has_ambient);
  EXPECT_EQ(document.depth, 3);
  ASSERT_EQ(document.lights.size(), 2u);
  EXPECT_EQ(std::get<PointLight>(document.lights[0]).intensity, glm::vec3(4, 5, 6));
  EXPECT_EQ(std::get<PointLight>(document.lights[0]).radius, 0.5);
  EXPECT_EQ(std::get<DirectionalLight>(document.lights[1]).intensity, glm::vec3(1));

  ASSERT_EQ(document.textures.size(), 8u);
  EXPECT_EQ(document.textures[0].name, "picture");
  const auto& image = std::get<ImageEntry>(document.textures[0].source);
  EXPECT_EQ(image.file, "folder/a/b.png") << "relative to the scene file";
  EXPECT_EQ(image.wrap, texmap::Wrap::kClamp);
  EXPECT_EQ(image.color_space, texmap::ColorSpace::kLinear);
  const auto& marble = std::get<texmap::Procedural>(document.textures[1].source);
  EXPECT_EQ(marble.kind, texmap::ProceduralKind::kMarble);
  EXPECT_EQ(marble.on, texmap::ProceduralOn::kPosition);
  EXPECT_EQ(marble.colors.size(), 2u);
  EXPECT_EQ(marble.scale, 2);
  EXPECT_EQ(marble.turbulence, 3);
  EXPECT_EQ(marble.octaves, 4);
  EXPECT_EQ(std::get<texmap::Procedural>(document.textures[2].source).grout, 0.25);
  EXPECT_EQ(std::get<texmap::Procedural>(document.textures[3].source).widths, (std::vector<double>{1, 3}));
  EXPECT_EQ(std::get<texmap::Procedural>(document.textures[4].source).on, texmap::ProceduralOn::kUv);
  EXPECT_EQ(std::get<texmap::Procedural>(document.textures[5].source),
            (texmap::Procedural{
                .kind = texmap::ProceduralKind::kBrick, .mortar = 0.2, .ratio = 2.5, .bond = 0.25}));
  EXPECT_EQ(std::get<texmap::Procedural>(document.textures[6].source),
            (texmap::Procedural{.kind = texmap::ProceduralKind::kWood,
                                .rings = 12,
                                .grain = 0.1,
                                .turbulence = 0,
                                .octaves = 2,
                                .basis = texmap::NoiseBasis::kPerlin1985}));
  EXPECT_EQ(
      std::get<texmap::Procedural>(document.textures[7].source),
      (texmap::Procedural{
          .kind = texmap::ProceduralKind::kClouds, .on = texmap::ProceduralOn::kPosition, .coverage = 0.3}));

  ASSERT_EQ(document.materials.size(), 2u);
  const Material& material = document.materials[0];
  EXPECT_EQ(material.name, "m");
  EXPECT_EQ(material.diffuse, glm::vec3(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(material.texture, 1u);
  EXPECT_EQ(material.specular, glm::vec3(0.4f, 0.5f, 0.6f));
  EXPECT_EQ(material.shininess, 7);
  EXPECT_EQ(material.reflect, 0.5f);
  EXPECT_EQ(material.transmit, 0.25f);
  EXPECT_EQ(material.ior, 1.5f);
  EXPECT_EQ(material.absorption, glm::vec3(1, 2, 3e6f));
  EXPECT_EQ(material.fresnel, Fresnel::kSchlick);
  EXPECT_EQ(document.materials[1].diffuse, glm::vec3(0.8f));
  EXPECT_EQ(document.materials[1].transmit, 0);
  EXPECT_EQ(document.materials[1].ior, 1);
  EXPECT_EQ(document.materials[1].absorption, glm::vec3(0));
  EXPECT_EQ(document.materials[1].fresnel, Fresnel::kNone);
  ASSERT_EQ(document.material_places.size(), 2u);
  EXPECT_EQ(document.material_places[1].pointer, "/materials/plain");
  EXPECT_FALSE(document.environment);

  ASSERT_EQ(document.objects.size(), 3u);
  const ObjectEntry& pipe = document.objects[0];
  EXPECT_EQ(pipe.material, 0u);
  EXPECT_EQ(pipe.placement.translate, glm::dvec3(1, 2, 3));
  EXPECT_EQ(pipe.placement.rotate_deg, glm::dvec3(4, 5, 6));
  EXPECT_EQ(pipe.placement.scale, glm::dvec3(2));
  ASSERT_EQ(pipe.pieces.size(), 1u);
  EXPECT_EQ(pipe.pieces[0].placement.scale, glm::dvec3(1))
      << "the placement is the object's, not the piece's too";
  EXPECT_EQ(pipe.pieces[0].tessellation.contour, 8);
  EXPECT_EQ(pipe.pieces[0].tessellation.trajectory, 64);
  EXPECT_EQ(pipe.pieces[0].uv.by, sweep::UvBy::kParameter);
  EXPECT_EQ(pipe.pieces[0].uv.repeat, glm::dvec2(2, 3));
  EXPECT_EQ(pipe.pieces[0].crease_deg, 10);
  EXPECT_EQ(pipe.pieces[0].place.pointer, "/objects/0/sweep");
  const auto& swept = std::get<SweepShape>(pipe.pieces[0].shape);
  EXPECT_TRUE(swept.contour.front().is_closed());
  EXPECT_EQ(swept.trajectory.length(), 2);
  EXPECT_EQ(swept.caps, sweep::Caps::kNone);

  const Piece& bowl = document.objects[1].pieces[0];
  EXPECT_FALSE(document.objects[1].material.has_value());
  EXPECT_EQ(std::get<RevolveShape>(bowl.shape).angle_deg, 90);
  EXPECT_EQ(bowl.tessellation.contour, 64);
  EXPECT_EQ(bowl.tessellation.trajectory, 64);

  const ObjectEntry& set = document.objects[2];
  ASSERT_EQ(set.pieces.size(), 2u);
  EXPECT_EQ(std::get<PlaneShape>(set.pieces[0].shape).size, glm::dvec2(2, 3));
  EXPECT_EQ(set.pieces[0].placement.scale, glm::dvec3(1, 2, 3));
  EXPECT_EQ(set.pieces[0].tessellation.contour, 5) << "a part starts from what the object says";
  EXPECT_EQ(set.pieces[0].tessellation.trajectory, 6);
  EXPECT_EQ(std::get<SweepShape>(set.pieces[1].shape).trajectory.segments().size(), 2u);
}

TEST(Document, ABackgroundIsAColourOrAnImageBesideTheSceneFile) {
  const Document document = parse(scene_text(R"("background": {"image": "sky.exr"})"));
  ASSERT_TRUE(document.environment);
  EXPECT_EQ(std::get<ImageEntry>(document.environment->source).file, "folder/sky.exr");
  EXPECT_EQ(document.environment->place.pointer, "/background/image");
}

TEST(Document, DefaultsAreTheFormats) {
  const Document document = parse(scene_text(""));
  EXPECT_FALSE(document.has_view);
  EXPECT_FALSE(document.has_ambient);
  EXPECT_EQ(document.camera.fov_deg, 40);
  EXPECT_EQ(document.width, 512);
  EXPECT_EQ(document.height, 512);
  EXPECT_EQ(document.depth, 6);
  EXPECT_EQ(document.background, glm::vec3(0));
  EXPECT_TRUE(document.lights.empty());
}

TEST(Document, LawsAndOrientationAreRead) {
  const Document document = parse(scene_text("", R"({"name": "a", "sweep": {
      "contour": {"star": {"points": 5, "radius": 1, "inner_radius": 0.5}}, "trajectory": {"helix": {"radius": 2, "pitch": 1, "turns": 3}},
      "profile": {"x": {"points": [[0, 1], [1, 2]]}, "y": 3}, "twist_deg": 90, "frames": "fixed-up", "up": [0, 0, 1]}},
    {"name": "b", "sweep": {"contour": {"rectangle": {"width": 1, "height": 2}}, "trajectory": {"ellipse": {"rx": 3, "ry": 2}},
      "profile": {"bezier": [[0, 1], [0.5, 3], [1, 1]]}, "twist_deg": {"points": [[0, 0], [0.5, 45], [1, 0]]},
      "guide": {"torus_knot": {"p": 2, "q": 3, "radius": 2, "tube": 1}}}})"));
  const auto& first = std::get<SweepShape>(document.objects[0].pieces[0].shape);
  EXPECT_EQ(first.contour.front().segments().size(), 10u);
  EXPECT_EQ(first.profile.x.at(0.5).value, 1.5);
  EXPECT_EQ(first.profile.y.at(0.5).value, 3);
  EXPECT_EQ(first.twist_deg.at(0.5).value, 45) << "a number is the total turn";
  EXPECT_EQ(first.orientation.frames, sweep::Frames::kFixedUp);
  EXPECT_EQ(first.orientation.up, glm::dvec3(0, 0, 1));
  const auto& second = std::get<SweepShape>(document.objects[1].pieces[0].shape);
  EXPECT_EQ(second.profile.x.at(0.5).value, 2);
  EXPECT_EQ(second.profile.y.at(0.5).value, 2);
  EXPECT_EQ(second.twist_deg.at(0.5).value, 45) << "a law is the angle at t";
  EXPECT_TRUE(second.orientation.guide->is_closed());
}

TEST(Document, CellsThatAreLeftOutAreTheShapesOwn) {
  const Document document =
      parse(scene_text("", R"({"name": "a", "plane": {"size": [1, 1]}, "tessellation": {"contour": 3}},
             {"name": "b", "revolve": {"contour": {"line": [[1, 0], [1, 1]]}}, "tessellation": {"contour": 3}})"));
  const sweep::Tessellation plane = document.objects[0].pieces[0].tessellation;
  EXPECT_EQ(plane.contour, 3);
  EXPECT_EQ(plane.trajectory, 1);
  const sweep::Tessellation revolved = document.objects[1].pieces[0].tessellation;
  EXPECT_EQ(revolved.contour, 3);
  EXPECT_EQ(revolved.trajectory, 64);
}

TEST(Document, ACameraMayLeaveTheViewToTheFraming) {
  const Document document = parse(scene_text(R"("camera": {"fov_deg": 25, "width": 100})"));
  EXPECT_FALSE(document.has_view);
  EXPECT_EQ(document.camera.fov_deg, 25);
  EXPECT_EQ(document.width, 100);
}

// Nothing of a scene is optional at its end, so each shorter text is broken; what matters is that each is
// refused in the same orderly way.
TEST(Document, EveryTruncatedPrefixIsRefused) {
  for (const std::string& text :
       {kEverything, read_sample("vase_and_cup.json"), read_sample("textures.json")}) {
    const std::size_t end = text.rfind('}');
    ASSERT_NE(end, std::string::npos);
    for (std::size_t size = 0; size <= end; ++size) {
      const std::string message = fault_of(text.substr(0, size));
      ASSERT_EQ(message.rfind("s.json:", 0), 0u) << size << ": " << message;
      ASSERT_EQ(message.find('\n'), std::string::npos) << message;
    }
  }
}

// One byte at a time is replaced: the text is read or refused, never a crash (the sanitizers watch).
TEST(Document, EveryDamagedByteIsReadOrRefused) {
  for (const char byte : {'\0', '"', '{', ']', '9', '-', 'e', '\\', '\xff', '/'}) {
    for (std::size_t at = 0; at < kEverything.size(); ++at) {
      std::string text = kEverything;
      text[at] = byte;
      const std::string message = fault_of(text);
      ASSERT_EQ(message.find('\n'), std::string::npos) << message;
    }
  }
}

TEST(Document, AByteOrderMarkAndWindowsLineEndsAreRead) {
  EXPECT_EQ(fault_of("\xEF\xBB\xBF{\r\n\"sweepkit\": 3}"),
            "s.json:2:13: /sweepkit: this program reads version 1 of the scene format, got 3");
}

TEST(Document, FilesThatAreNoSceneFilesAreRefused) {
  const auto fault = [](const std::string& file) -> std::string {
    try {
      read_document(file);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(fault("/nowhere/s.json"), "/nowhere/s.json: no such file");
  EXPECT_EQ(fault("/"), "/: is a folder, not a scene file");
  EXPECT_EQ(fault("/dev/zero"), "/dev/zero: is over 256 MiB, too large for a scene file");
  EXPECT_EQ(fault("/dev/null").rfind("/dev/null:1:1: not valid JSON", 0), 0u);
}

TEST(Document, AFileThatMayNotBeReadIsRefused) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "sweepkit_unreadable";
  std::filesystem::create_directory(folder);
  const std::filesystem::path file = folder / "s.json";
  std::ofstream(file) << scene_text("");
  std::filesystem::permissions(file, std::filesystem::perms::none);
  {
    const Unprivileged unprivileged(folder);
    ASSERT_TRUE(unprivileged.is_sound());
    try {
      read_document(file);
      ADD_FAILURE() << "it was read";
    } catch (const InputError& error) {
      EXPECT_EQ(error.problem(), "cannot be read; check its permissions");
    }
  }
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace sweepkit::scene
