// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A scene whose every length is multiplied - curves, placements, camera, lights - is drawn the same: to the
// byte by powers of two, since every product and quotient is then the same but for its exponent, and within
// few pixels by others, where roundings differ.

#include <gtest/gtest.h>

#include <cmath>

#include "draw.hpp"

namespace sweepkit::render {
namespace {

using test::Stage;
using test::texels;

std::string scaled(const std::string& text, double scale) {
  // Numbers behind @ are lengths.
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] != '@') {
      out += text[i++];
      continue;
    }
    char* end = nullptr;
    const double length = std::strtod(text.c_str() + i + 1, &end);
    char number[40];
    std::snprintf(number, sizeof number, "%.17g", scale * length);
    out += number;
    i = static_cast<std::size_t>(end - text.c_str());
  }
  return out;
}

const char* const kStillLife = R"({"sweepkit": 1,
  "camera": {"eye": [@1, @1.5, @4], "target": [@0, @0.5, @0], "width": SIZE, "height": SIZE},
  "background": [0.2, 0.3, 0.4], "ambient": [0.1, 0.1, 0.1], "depth": 3,
  "lights": [{"point": [@2, @4, @3], "intensity": [0.8, 0.8, 0.8]}, {"directional": [-1, -1, -1], "intensity": [0.2, 0.2, 0.3]}],
  "textures": {"checker": {"procedural": "checker", "scale": 8}},
  "materials": {"floor": {"texture": "checker", "reflect": 0.3}, "shiny": {"diffuse": [0.5, 0.2, 0.1], "specular": [0.5, 0.5, 0.5], "reflect": 0.4}},
  "objects": [
    {"name": "floor", "material": "floor", "plane": {"size": [@10, @10]}},
    {"name": "vase", "material": "shiny", "translate": [@-0.9, @0, @-0.4], "tessellation": {"contour": 30, "trajectory": 60},
     "revolve": {"contour": {"bezier": [[@0, @0], [@0.9, @0.1], [@0, @0.8], [@0.4, @1.3]]}}},
    {"name": "torus", "material": "shiny", "translate": [@0.3, @0.5, @0], "rotate_deg": [60, 10, 0], "tessellation": {"contour": 24, "trajectory": 48},
     "sweep": {"contour": {"circle": {"radius": @0.2}}, "trajectory": {"circle": {"radius": @0.5}}}},
    {"name": "knots", "tessellation": {"contour": 12, "trajectory": 160}, "material": "shiny",
     "sweep": {"contour": {"circle": {"radius": @0.03}}, "trajectory": {"torus_knot": {"p": 2, "q": 3, "radius": @0.2, "tube": @0.08}}},
     "instances": [{"translate": [@0.9, @0.3, @0.9]}, {"translate": [@-0.4, @0.2, @1.2], "rotate_deg": [40, 0, 20], "scale": 0.7}]}]})";

// By any channel, at 8 bits of sRGB as a picture file has them: more than a level.
int pixels_that_differ(const Picture& one, const Picture& other) {
  const auto level = [](float linear) {
    const double v = std::clamp(static_cast<double>(linear), 0.0, 1.0);
    return 255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055);
  };
  int count = 0;
  for (std::size_t pixel = 0; pixel < texels(one).size(); pixel += 3) {
    bool differs = false;
    for (std::size_t c = pixel; c < pixel + 3; ++c)
      differs |= std::abs(level(texels(one)[c]) - level(texels(other)[c])) > 1;
    count += differs ? 1 : 0;
  }
  return count;
}

struct Case {
  Accelerator accelerator;
  int size;  // pixels a side; the linear scan draws a smaller picture in a minute
};

class ScaledPicture : public testing::TestWithParam<Case> {
 protected:
  static Picture drawn(double scale) {
    std::string text = scaled(kStillLife, scale);
    for (std::size_t at; (at = text.find("SIZE")) != std::string::npos;)
      text.replace(at, 4, std::to_string(GetParam().size));
    return Stage(text).draw({.accelerator = GetParam().accelerator});
  }
};

TEST_P(ScaledPicture, IsTheSameBytesAtPowersOfTwo) {
  const Picture one = drawn(1);
  for (const double scale : {0x1p-10, 0x1p10}) EXPECT_EQ(texels(one), texels(drawn(scale))) << scale;
}

// 20 of 512 x 512.
TEST_P(ScaledPicture, IsTheSameButForAFewPixelsAtOtherScales) {
  const Picture one = drawn(1);
  const int pixels = GetParam().size * GetParam().size;
  for (const double scale : {1e-3, 1e3}) {
    const int count = pixels_that_differ(one, drawn(scale));
    EXPECT_LE(count, (20 * pixels + 512 * 512 - 1) / (512 * 512)) << scale;
    std::printf("scaled by %g: %d of %d pixels differ\n", scale, count, pixels);
  }
}

INSTANTIATE_TEST_SUITE_P(Accelerators, ScaledPicture,
                         testing::Values(Case{Accelerator::kSeads, 512}, Case{Accelerator::kSweep, 512},
                                         Case{Accelerator::kLinear, 96}),
                         [](const auto& test) {
                           return std::string(
                               kAcceleratorNames[static_cast<std::size_t>(test.param.accelerator)]);
                         });

}  // namespace
}  // namespace sweepkit::render
