// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// White furnaces: what neither swallows nor gives light cannot be told from a white surround.

#include "stability/scene_text.hpp"
#include "stability/stability_case.hpp"
#include "sweepkit/render/render.hpp"

namespace sweepkit::report {
namespace {

texmap::Image draw(const std::string& material, const std::string& object, int depth) {
  const MadeScene made(
      R"({"sweepkit": 1, "camera": {"eye": [0, 2, 5], "target": [0, 0, 0], "width": 24, "height": 24},
      "background": [1, 1, 1], "ambient": [1, 1, 1], "depth": )" +
          std::to_string(depth) + R"(, "materials": {"m": {)" + material +
          R"(}}, "objects": [{"name": "o", "material": "m", )" + object + "}]}",
      {.filter = texmap::Filter::kAuto, .has_smooth_shadows = true});
  render::Options options;
  options.threads = 1;
  return render::render(made.model.scene, made.plan, options).image;
}

constexpr const char* kBall =
    R"("tessellation": {"contour": 16, "trajectory": 32},
       "revolve": {"contour": {"arc": {"radius": 1.2, "from_deg": -90, "to_deg": 90}}})";
constexpr const char* kTorus =
    R"("tessellation": {"contour": 12, "trajectory": 24},
       "sweep": {"contour": {"circle": {"radius": 0.5}}, "trajectory": {"circle": {"radius": 1.2}}})";

// Every pixel is to be this white.
StabilityCase furnace(const std::string& name, const std::string& input, double hardness,
                      const std::string& hardness_is, const std::string& material, const std::string& object,
                      int depth) {
  return {.name = "materials_" + name,
          .stage = "materials",
          .input = input + ", all white around",
          .hardness = hardness,
          .hardness_is = hardness_is,
          .promise = "colours by the scene's own sum of terms: what swallows nothing is white in white",
          .unit = "of white",
          .run = [=] {
            const texmap::Image image = draw(material, object, depth);
            // A level multiplies and adds a handful of doubles; the picture is float32.
            Reached reached{.bound = 0x1p-23};
            for (int y = 0; y < image.height; ++y) {
              for (int x = 0; x < image.width; ++x) {
                for (glm::length_t k = 0; k < 3; ++k)
                  reached.error =
                      worse(reached.error, std::abs(static_cast<double>(image.color(x, y)[k]) - 1));
              }
            }
            return reached;
          }};
}

}  // namespace

std::vector<StabilityCase> material_cases() {
  const std::string black = R"("diffuse": [0, 0, 0], )";
  return {
      furnace("diffuse_1", "diffuse 1, everything else 0", 1, "levels", R"("diffuse": [1, 1, 1])", kBall, 2),
      furnace("mirror_1_convex", "a ball that mirrors all", 2, "levels", black + R"("reflect": 1)", kBall, 2),
      furnace("mirror_1_torus", "a torus that mirrors all, 30 levels", 30, "levels",
              black + R"("reflect": 1)", kTorus, 30),
      furnace("clear_1", "a ball that lets all through, index 1", 0x1p53,
              "1 over the index's difference from 1, at least", black + R"("transmit": 1, "ior": 1)", kBall,
              8),
      furnace("clear_beside_1", "a ball that lets all through, index 1.000001", 1e6,
              "1 over the index's difference from 1", black + R"("transmit": 1, "ior": 1.000001)", kBall, 8),
      furnace("shininess_1e6", "diffuse 1, a highlight of power 1e6 without a light", 1e6, "power",
              R"("diffuse": [1, 1, 1], "specular": [1, 1, 1], "shininess": 1000000)", kBall, 2),
      furnace("nothing_at_depth_0", "mirror 0 and transmit 0 beside diffuse 1, depth 1", 1, "levels",
              R"("diffuse": [1, 1, 1], "reflect": 0, "transmit": 0)", kTorus, 1)};
}

}  // namespace sweepkit::report
