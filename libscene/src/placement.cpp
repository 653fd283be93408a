// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "cos_sin_deg.hpp"
#include "sweepkit/scene/document.hpp"

namespace sweepkit::scene {

glm::dmat4 to_matrix(const Placement& placement) {
  const glm::dvec2 x = cos_sin_deg(placement.rotate_deg.x);
  const glm::dvec2 y = cos_sin_deg(placement.rotate_deg.y);
  const glm::dvec2 z = cos_sin_deg(placement.rotate_deg.z);
  // Columns: glm stores a matrix by them.
  const glm::dmat3 about_x({1, 0, 0}, {0, x[0], x[1]}, {0, -x[1], x[0]});
  const glm::dmat3 about_y({y[0], 0, -y[1]}, {0, 1, 0}, {y[1], 0, y[0]});
  const glm::dmat3 about_z({z[0], z[1], 0}, {-z[1], z[0], 0}, {0, 0, 1});
  const glm::dmat3 linear = about_z * about_y * about_x;
  return {glm::dvec4(linear[0] * placement.scale.x, 0), glm::dvec4(linear[1] * placement.scale.y, 0),
          glm::dvec4(linear[2] * placement.scale.z, 0), glm::dvec4(placement.translate, 1)};
}

}  // namespace sweepkit::scene
