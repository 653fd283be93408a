// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Normal maps against closed forms: what a normal that is known gives under a light that is known.

#include "normal_maps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "draw.hpp"
#include "sweepkit/sweep/tangents.hpp"

namespace sweepkit::render {
namespace {

// Colours are float32 of numbers up to 1, from a map and tangents in float32: a few roundings of 6e-8 each.
constexpr double kRounding = 1e-6;

texmap::Image normal_image(int width, int height, const auto& normal_at) {
  texmap::Image image = texmap::make_float_image(width, height);
  auto out = std::get<std::vector<float>>(image.texels).begin();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const glm::dvec3 normal =
          glm::normalize(glm::dvec3(normal_at((x + 0.5) / width, 1 - (y + 0.5) / height)));
      for (glm::length_t k = 0; k < 3; ++k) *out++ = static_cast<float>(0.5 * (normal[k] + 1));
    }
  }
  return image;
}

texmap::Image constant(const glm::dvec3& normal) {
  return normal_image(2, 2, [&](double, double) { return normal; });
}

// A scene whose one texture, the map, is given as an image.
struct MappedStage {
  MappedStage(const std::string& text, texmap::Image map)
      : document(scene::parse_document(text, "test.json")) {
    scene::Plan unread = test::plan_for(document, {});
    unread.textures.assign(1, false);
    model = scene::build(document, unread);
    model.scene.textures[0] = texmap::ImageTexture{std::make_shared<const texmap::Image>(std::move(map))};
  }
  Picture draw(const Options& options = {}) const {
    return render(model.scene, test::plan_for(document, options), options);
  }
  scene::Document document;
  scene::Model model;
};

std::string scene_of(const std::string& object, const std::string& material, const std::string& more,
                     const std::string& eye = "[0, 3, 0.01]") {
  return R"({"sweepkit": 1, "camera": {"eye": )" + eye +
         R"(, "target": [0, 0, 0], "fov_deg": 10, "width": 16, "height": 16}, "ambient": [0, 0, 0],
    "textures": {"map": {"image": "none.png"}},
    "materials": {"m": {"diffuse": [1, 1, 1])" +
         material + R"(, "normal_map": "map"}}, )" + more +
         R"(, "objects": [{"name": "o", "material": "m", )" + object + "}]}";
}

std::string light(const glm::dvec3& to) {
  return R"("lights": [{"directional": [)" + std::to_string(-to.x) + "," + std::to_string(-to.y) + "," +
         std::to_string(-to.z) + "]}]";
}

glm::dvec3 direction_of(const scene::Model& model) {
  return -glm::normalize(std::get<scene::DirectionalLight>(model.scene.lights[0]).direction);
}

// Where u and v grow on the first triangle, and its normal, in the world.
struct Frame {
  glm::dvec3 u, v, n;
};
Frame frame_of(const scene::Model& model) {
  const scene::MeshView& mesh = model.scene.meshes[0];
  const auto& [a, b, c] = mesh.triangles[0];
  const glm::dmat3 linear(model.scene.objects[0].world_from_object);
  const glm::dvec3 e1 = linear * glm::dvec3(mesh.positions[b] - mesh.positions[a]);
  const glm::dvec3 e2 = linear * glm::dvec3(mesh.positions[c] - mesh.positions[a]);
  const glm::dvec2 s(mesh.texcoords[b] - mesh.texcoords[a]);
  const glm::dvec2 t(mesh.texcoords[c] - mesh.texcoords[a]);
  const double area = s.x * t.y - s.y * t.x;
  const glm::dmat3 normals = glm::transpose(glm::inverse(linear));
  return {glm::normalize((t.y * e1 - s.y * e2) / area), glm::normalize((s.x * e2 - t.x * e1) / area),
          glm::normalize(normals * glm::dvec3(mesh.normals[a]))};
}

void expect_all(const Picture& picture, double expected, double bound = kRounding) {
  for (const float value : test::texels(picture)) ASSERT_NEAR(value, expected, bound);
}

const std::string kPlane = R"("plane": {"size": [4, 4]})";

TEST(NormalMap, OneThatSaysStraightUpEverywhereGivesTheSameBytesAsNone) {
  const std::string torus =
      R"("sweep": {"contour": {"circle": {"radius": 0.5}}, "trajectory": {"circle": {"radius": 1.2}}})";
  for (const char* terms : {R"(, "specular": [1, 1, 1])", R"(, "reflect": 0.5)",
                            R"(, "reflect": 1, "transmit": 1, "ior": 1.5, "fresnel": "exact")"}) {
    const MappedStage stage(scene_of(torus, terms, light({1, 2, 1}), "[0, 9, 9]"), constant({0, 0, 1}));
    scene::Model plain = scene::build(stage.document, [&] {
      scene::Plan unread = test::plan_for(stage.document, {});
      unread.textures.assign(1, false);
      return unread;
    }());
    scene::Document without = stage.document;
    without.materials[0].normal_map.reset();
    plain.scene.materials[0].normal_map.reset();
    for (const Options& options : {Options{}, Options{.adaptive = Adaptive{}}}) {
      EXPECT_EQ(test::texels(stage.draw(options)),
                test::texels(render(plain.scene, test::plan_for(without, options), options)))
          << terms;
    }
  }
}

TEST(NormalMap, ATiltedNormalOnAPlaneGivesItsCosine) {
  for (const glm::dvec3& normal : {glm::dvec3(0.3, 0, 1), glm::dvec3(0, 0.4, 1), glm::dvec3(-0.2, 0.5, 1)}) {
    for (const glm::dvec3& to : {glm::dvec3(0, 1, 0), glm::dvec3(0.5, 1, 0), glm::dvec3(0.2, 1, -0.6)}) {
      const MappedStage stage(scene_of(kPlane, "", light(to)), constant(normal));
      const Frame frame = frame_of(stage.model);
      const glm::dvec3 n = glm::normalize(normal.x * frame.u + normal.y * frame.v + normal.z * frame.n);
      for (const Filter filter : {Filter::kPoint, Filter::kIntegral1, Filter::kAuto})
        expect_all(stage.draw({.filter = filter}), glm::dot(n, direction_of(stage.model)));
    }
  }
}

TEST(NormalMap, StrengthStretchesTheSlope) {
  const MappedStage stage(scene_of(kPlane, R"(, "normal_strength": 2)", light({0, 1, 0})),
                          constant({0.3, 0.1, 1}));
  expect_all(stage.draw(), 1 / std::sqrt(1 + 0.6 * 0.6 + 0.2 * 0.2));
  const MappedStage none(scene_of(kPlane, R"(, "normal_strength": 0)", light({0, 1, 0})),
                         constant({0.3, 0.1, 1}));
  expect_all(none.draw(), 1);
}

TEST(NormalMap, FollowsPlacementsThatStretchAndMirror) {
  const glm::dvec3 normal(0.3, 0.5, 1);
  for (const char* scale : {"[3, 1, 1]", "[1, 2, 0.5]", "[-1, 1, 1]", "[1, 1, -2]", "[-1, 1, -1]"}) {
    const MappedStage stage(scene_of(kPlane + R"(, "scale": )" + scale, "", light({0.4, 1, 0.3})),
                            constant(normal));
    const Frame frame = frame_of(stage.model);
    const glm::dvec3 n = glm::normalize(normal.x * frame.u + normal.y * frame.v + normal.z * frame.n);
    SCOPED_TRACE(scale);
    expect_all(stage.draw(), glm::dot(n, direction_of(stage.model)));
  }
}

TEST(NormalMap, FollowsTexcoordsThatAreMirrored) {
  const glm::dvec3 normal(0.3, 0.5, 1);
  MappedStage stage(scene_of(kPlane, "", light({0.4, 1, 0.3})), constant(normal));
  scene::MeshView& mesh = stage.model.scene.meshes[0];
  std::vector<glm::vec2> mirrored(mesh.texcoords.begin(), mesh.texcoords.end());
  for (glm::vec2& uv : mirrored) uv.x = 1 - uv.x;
  mesh.texcoords = mirrored;
  const std::vector<glm::vec4> tangents =
      sweep::find_tangents(mesh.positions, mesh.normals, mesh.texcoords, mesh.triangles);
  mesh.tangents = tangents;
  const Frame frame = frame_of(stage.model);
  const glm::dvec3 n = glm::normalize(normal.x * frame.u + normal.y * frame.v + normal.z * frame.n);
  expect_all(stage.draw(), glm::dot(n, direction_of(stage.model)));
}

TEST(NormalMap, TurnsRoundAsAWholeOnTheOtherSide) {
  const glm::dvec3 normal(0.3, 0.2, 1);
  const MappedStage stage(scene_of(kPlane, "", light({0.2, -1, 0.1}), "[0, -3, 0.01]"), constant(normal));
  const Frame frame = frame_of(stage.model);
  const glm::dvec3 n = -glm::normalize(normal.x * frame.u + normal.y * frame.v + normal.z * frame.n);
  expect_all(stage.draw(), glm::dot(n, direction_of(stage.model)));
}

// h = A sin(2 pi k u) over u of 4 m has the normal (-dh/du / 4, 0, 1) made unit. Between texels a wide the
// map is interpolated: off by no more than a^2 / 8 times the second derivative of the normal by u, which for
// the slope's phase is at most S (1 + 3 S^2) (2 pi k)^2, S the largest slope.
TEST(NormalMap, ABakedSineWaveShadesAsTheDisplacedSurface) {
  constexpr int kTexels = 1024;
  constexpr int kWaves = 5;
  constexpr double kSlope = 0.5;
  const auto normal_at = [](double u, double) {
    return glm::dvec3(-kSlope * std::cos(2 * std::numbers::pi * kWaves * u), 0, 1);
  };
  const MappedStage stage(scene_of(kPlane, "", light({0.5, 1, 0.3}), "[0, 12, 0.01]"),
                          normal_image(kTexels, 1, normal_at));
  const Frame frame = frame_of(stage.model);
  const Picture picture = stage.draw({.filter = Filter::kBilinear, .layers = {Layer::kUv}});
  const auto& uv = std::get<std::vector<float>>(picture.layers[0].image.texels);
  const double phase = 2 * std::numbers::pi * kWaves / kTexels;
  const double bound = kSlope * (1 + 3 * kSlope * kSlope) * phase * phase / 8 + kRounding;
  for (std::size_t i = 0; i < uv.size() / 2; ++i) {
    const glm::dvec3 t = glm::normalize(normal_at(static_cast<double>(uv[2 * i]), 0));
    const glm::dvec3 n = t.x * frame.u + t.z * frame.n;
    ASSERT_NEAR(test::texels(picture)[3 * i], glm::dot(n, direction_of(stage.model)), bound);
  }
}

// From far away the waves are finer than pixels: the mean of their normals points up.
TEST(NormalMap, IsFilteredOverWhatThePixelCovers) {
  const auto normal_at = [](double u, double) {
    return glm::dvec3(std::cos(2 * std::numbers::pi * 64 * u), 0, 1);
  };
  const MappedStage stage(scene_of(R"("plane": {"size": [400, 400]}, "uv": {"repeat": [100, 100]})", "",
                                   light({0.5, 1, 0.3}), "[0, 900, 0.01]"),
                          normal_image(1024, 4, normal_at));
  // Pixels are 9.8 m of waves of 1/16 m: what is left of them is below 1/150.
  expect_all(stage.draw({.filter = Filter::kEwa}),
             glm::dot(frame_of(stage.model).n, direction_of(stage.model)), 1e-3);
}

TEST(NormalMap, NoLightComesFromBelowTheSurface) {
  for (const Shadows shadows : {Shadows::kHard, Shadows::kSmooth}) {
    const MappedStage stage(scene_of(kPlane, R"(, "specular": [1, 1, 1])", light({1, -0.1, 0})),
                            constant({5, 0, 1}));
    ASSERT_GT(std::abs(frame_of(stage.model).u.x), 0.99)
        << "the map's normal sees the light or its mirror image";
    expect_all(stage.draw({.shadows = shadows}), 0);
    const MappedStage other(scene_of(kPlane, R"(, "specular": [1, 1, 1])", light({-1, -0.1, 0})),
                            constant({5, 0, 1}));
    expect_all(other.draw({.shadows = shadows}), 0);
  }
}

TEST(NormalMap, NoMirroredRayGoesBelowTheSurface) {
  const auto normal_at = [](double u, double v) {
    return glm::dvec3(8 * std::sin(40 * u), 8 * std::cos(50 * v), 1);
  };
  // Everything below the mirror is red, all above is blue.
  const std::string text = R"({"sweepkit": 1, "camera": {"eye": [0, 3, 4], "target": [0, 0, 0], "fov_deg": 20,
    "width": 48, "height": 48}, "ambient": [1, 1, 1], "background": [0, 0, 1],
    "textures": {"map": {"image": "none.png"}},
    "materials": {"m": {"diffuse": [0, 0, 0], "reflect": 1, "normal_map": "map"}, "red": {"diffuse": [1, 0, 0]}},
    "objects": [{"name": "mirror", "material": "m", "plane": {"size": [90, 90]}},
                {"name": "below", "material": "red", "translate": [0, -0.5, 0], "plane": {"size": [900, 900]}}]})";
  const MappedStage stage(text, normal_image(64, 64, normal_at));
  const Picture picture = stage.draw();
  const std::vector<float>& colors = test::texels(picture);
  for (std::size_t i = 0; i < colors.size(); i += 3) {
    ASSERT_EQ(colors[i], 0) << "red";
    ASSERT_EQ(colors[i + 2], 1) << "blue";
  }
}

// Where a ray goes to, far away, depends on the normal alone, and so does how it turns from pixel to pixel: a
// plane that leans sends the same of a distant background back, or through, as a flat one with such a map.
TEST(NormalMap, RaysLeaveAFlatPlaneAsTheyLeaveOneThatLeans) {
  constexpr double kLean = 15;  // degrees
  texmap::Image sky = texmap::make_float_image(64, 32);
  auto& texels = std::get<std::vector<float>>(sky.texels);
  for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<float>(i * i % 97) / 97;
  for (const char* terms : {R"(, "reflect": 1)", R"(, "transmit": 1, "ior": 1.5)"}) {
    const std::string material = std::string(R"(, "specular": [0, 0, 0])") + terms;
    MappedStage mapped(scene_of(kPlane, material, light({0, 1, 0})),
                       constant({std::tan(kLean * std::numbers::pi / 180), 0, 1}));
    ASSERT_GT(frame_of(mapped.model).u.x, 0.999);
    MappedStage leaning(scene_of(kPlane + R"(, "rotate_deg": [0, 0, )" + std::to_string(-kLean) + "]",
                                 material, light({0, 1, 0})),
                        constant({0, 0, 1}));
    for (MappedStage* stage : {&mapped, &leaning}) {
      stage->model.scene.materials[0].diffuse = glm::vec3(0.0f);
      stage->document.environment = scene::TextureEntry{"background", scene::ImageEntry{}, {}};
      stage->model.scene.environment = texmap::ImageTexture{std::make_shared<const texmap::Image>(sky)};
    }
    for (const Filter filter : {Filter::kBilinear, Filter::kEwa}) {
      const Picture flat = mapped.draw({.filter = filter});
      const Picture other = leaning.draw({.filter = filter});
      double largest = 0;
      for (std::size_t i = 0; i < test::texels(flat).size(); ++i) {
        ASSERT_NEAR(test::texels(flat)[i], test::texels(other)[i], 1e-5) << terms;
        largest = std::max(largest,
                           static_cast<double>(std::abs(test::texels(flat)[i] - test::texels(flat)[i % 3])));
      }
      EXPECT_GT(largest, 0.1) << "there is something to be seen";
    }
  }
}

TEST(NormalMap, ANormalIsTurnedBackToTheEyeNoFartherThanNeeded) {
  const glm::dvec3 direction(0, 0, -1);
  const glm::dvec3 up(0, 1, 0);
  EXPECT_EQ(facing_eye({0.6, 0, 0.8}, direction, up), glm::dvec3(0.6, 0, 0.8));
  EXPECT_EQ(facing_eye({1, 0, 0}, direction, up), glm::dvec3(1, 0, 0));
  const glm::dvec3 turned = facing_eye({0.6, 0, -0.8}, direction, up);
  EXPECT_NEAR(glm::distance(turned, glm::dvec3(1, 0, 0)), 0, 1e-15);
  EXPECT_EQ(facing_eye(direction, direction, up), up);
}

TEST(NormalMap, APictureIsTheSameForAnyThreadsAndAnyPartOfIt) {
  const auto normal_at = [](double u, double v) { return glm::dvec3(std::sin(60 * u), std::cos(70 * v), 1); };
  const std::string torus =
      R"("sweep": {"contour": {"circle": {"radius": 0.5}}, "trajectory": {"circle": {"radius": 1.2}}})";
  const MappedStage stage(scene_of(torus, R"(, "reflect": 0.5)", light({1, 2, 1}), "[0, 9, 9]"),
                          normal_image(64, 64, normal_at));
  const Picture whole = stage.draw({.threads = 1});
  EXPECT_EQ(test::texels(whole), test::texels(stage.draw({.threads = 3})));
  const Picture part = stage.draw({.crop = Region{3, 5, 4, 6}});
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 4; ++x) ASSERT_EQ(part.image.color(x, y), whole.image.color(x + 3, y + 5));
  }
}

TEST(NormalMap, CostsTangentsAndALookupForEachNodeThatHasOne) {
  const MappedStage stage(scene_of(kPlane, "", light({0, 1, 0})), constant({0.3, 0, 1}));
  const scene::MeshView& mesh = stage.model.scene.meshes[0];
  EXPECT_EQ(stage.model.ledger[scene::Part::kNormalMaps].bytes, 16 * mesh.positions.size());
  const Picture picture = stage.draw({.filter = Filter::kPoint, .shadows = Shadows::kHard});
  EXPECT_EQ(picture.ledger[scene::Part::kNormalMaps].calls, 16u * 16);
  EXPECT_GT(picture.ledger[scene::Part::kNormalMaps].bytes, 0u);
}

}  // namespace
}  // namespace sweepkit::render
