// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Blinn78], "Simulation of wrinkled surfaces": a height h over the plane has the normal
// (-dh/dx, -dh/dy, 1), made unit. Departs from it in keeping the normals as an image.

#include "sweepkit/texmap/normal_image.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "sweepkit/texmap/shrink.hpp"

namespace sweepkit::texmap {
namespace {

std::uint16_t to_sample(double value) {
  return static_cast<std::uint16_t>(std::lround(65535 * std::clamp(value, 0.0, 1.0)));
}

// Where a difference along one side begins and ends.
struct Stencil {
  int before;
  int after;
  int steps;
};

Stencil stencil(int at, int size, bool repeats) {
  if (repeats) return {(at + size - 1) % size, (at + 1) % size, 2};
  const int before = std::max(at - 1, 0);
  const int after = std::min(at + 1, size - 1);
  return {before, after, std::max(after - before, 1)};
}

double height(const Image& image, int x, int y) {
  const glm::dvec3 color(image.color(x, y));
  return (color.r + color.g + color.b) / 3;
}

}  // namespace

Image shrink_normals(const Image& image, glm::ivec2 size) {
  Image small = shrink(image, size);
  if (small.channels < 3) return small;
  const auto make_unit = [&](auto& texels, double one) {
    for (std::size_t i = 0; i < texels.size(); i += static_cast<std::size_t>(small.channels)) {
      glm::dvec3 normal = 2.0 * glm::dvec3(texels[i], texels[i + 1], texels[i + 2]) / one - 1.0;
      const double length = glm::length(normal);
      // Two halves of 16 bits that cancel out leave their rounding.
      normal = length > 1e-4 ? normal / length : glm::dvec3(0, 0, 1);
      for (std::size_t k = 0; k < 3; ++k) {
        const double value = 0.5 * (normal[static_cast<glm::length_t>(k)] + 1);
        if constexpr (std::is_integral_v<std::decay_t<decltype(texels[0])>>) {
          texels[i + k] = to_sample(value);
        } else {
          texels[i + k] = static_cast<float>(value);
        }
      }
    }
  };
  if (auto* integers = std::get_if<std::vector<std::uint16_t>>(&small.texels)) {
    make_unit(*integers, 65535);
  } else {
    make_unit(std::get<std::vector<float>>(small.texels), 1);
  }
  return small;
}

Image normals_from_heights(const Image& image, const HeightField& field) {
  Image normals{image.width, image.height, 3, std::vector<std::uint16_t>()};
  auto& texels = std::get<std::vector<std::uint16_t>>(normals.texels);
  texels.reserve(3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  for (int y = 0; y < image.height; ++y) {
    const Stencil down = stencil(y, image.height, field.repeats_down);
    for (int x = 0; x < image.width; ++x) {
      const Stencil across = stencil(x, image.width, field.repeats_across);
      const double dx = height(image, across.after, y) - height(image, across.before, y);
      const double dy = height(image, x, down.before) - height(image, x, down.after);  // y upwards
      const glm::dvec3 normal =
          glm::normalize(glm::dvec3(-field.depth * dx / (across.steps * field.texel.x),
                                    -field.depth * dy / (down.steps * field.texel.y), 1));
      for (glm::length_t k = 0; k < 3; ++k) texels.push_back(to_sample(0.5 * (normal[k] + 1)));
    }
  }
  return normals;
}

}  // namespace sweepkit::texmap
