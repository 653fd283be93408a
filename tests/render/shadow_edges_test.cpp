// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "shadow_edges.hpp"

#include <gtest/gtest.h>

#include "draw.hpp"
#include "sweepkit/texmap/image_error.hpp"

namespace sweepkit::render {
namespace {

using test::Stage;

// Three rows of three pixels, a node each, one light; every node sees it or not as `seen` says.
struct Nine {
  std::array<TreeRow, 3> rows;
  RowWindow window{&rows[0], &rows[1], &rows[2]};
  Neighbourhood nodes{};

  explicit Nine(const std::array<std::array<float, 3>, 3>& seen) {
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) {
        nodes[r][c] = static_cast<std::int32_t>(c);
        TreeNode node;
        node.hit.object = 0;
        rows[r].nodes.push_back(node);
        rows[r].visibility.points.push_back({glm::dvec3(0.0), glm::dvec3(0, 1, 0)});
        rows[r].visibility.shares.push_back(seen[r][c]);
      }
    }
  }
};

TEST(SmoothShare, GivesTheTwoSidesOfAnEdgeSevenEighthsAndOneEighth) {
  const Nine lit({{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}}});
  EXPECT_EQ(smooth_share(lit.window, lit.nodes, 0), glm::dvec3(0.875));
  const Nine dark({{{1, 0, 0}, {1, 0, 0}, {1, 0, 0}}});
  EXPECT_EQ(smooth_share(dark.window, dark.nodes, 0), glm::dvec3(0.125));
  EXPECT_EQ(own_share(lit.window, lit.nodes, 0), glm::dvec3(1.0));
  EXPECT_EQ(own_share(dark.window, dark.nodes, 0), glm::dvec3(0.0));
}

TEST(SmoothShare, IsTheSameToTheBitWhereAllSayTheSame) {
  for (const float share : {0.0f, 1.0f, 0.3f, 1 / 3.0f}) {
    const Nine nine({{{share, share, share}, {share, share, share}, {share, share, share}}});
    EXPECT_EQ(smooth_share(nine.window, nine.nodes, 0), glm::dvec3(static_cast<double>(share)));
  }
}

TEST(SmoothShare, NeverCrossesObjectsPiecesOrPathsNorLooksRoundACorner) {
  Nine other_object({{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}}});
  Nine other_piece = other_object;
  Nine other_normal = other_object;
  Nine other_path = other_object;
  Nine turned_away = other_object;
  for (Nine* nine : {&other_object, &other_piece, &other_normal, &other_path, &turned_away}) {
    nine->window = {&nine->rows[0], &nine->rows[1], &nine->rows[2]};
    for (std::size_t r = 0; r < 3; ++r) {
      if (nine == &other_object) nine->rows[r].nodes[2].hit.object = 1;
      if (nine == &other_piece) nine->rows[r].nodes[2].area = 1;
      if (nine == &other_normal) nine->rows[r].visibility.points[2].normal = glm::dvec3(0.6, 0.8, 0);
      if (nine == &other_path) nine->nodes[r][2] = kNotTraced;
      if (nine == &turned_away) nine->rows[r].visibility.shares[2] = kTurnedAway;
    }
    EXPECT_EQ(smooth_share(nine->window, nine->nodes, 0), glm::dvec3(1.0));
  }
}

TEST(SmoothShare, IsByColourWhereLightIsDimmedByColour) {
  Nine nine({{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}});
  for (std::size_t r = 0; r < 3; ++r) {
    nine.rows[r].visibility.channels = 3;
    nine.rows[r].visibility.shares = {1, 0.5f, 0, 1, 0.5f, 0, 0, 0.5f, 1};
  }
  EXPECT_EQ(smooth_share(nine.window, nine.nodes, 0), glm::dvec3(0.875, 0.5, 0.125));
}

// Shadows alone: what throws them hangs above the camera, which looks down.
const char* const kShadows =
    R"({"sweepkit": 1, "camera": {"eye": [0, 1.1, 1.6], "target": [0, 0, -0.6], "fov_deg": 40, "width": 96, "height": 72},
  "lights": [{"point": [1, 4, 0.5]}, {"directional": [1, -2, 0.4], "intensity": [0.4, 0.4, 0.5]}],
  "objects": [{"name": "floor", "plane": {"size": [12, 12]}},
    {"name": "ring", "translate": [0, 1.4, 0], "sweep": {"contour": {"circle": {"radius": 0.1}}, "trajectory": {"circle": {"radius": 0.7}}}},
    {"name": "bar", "translate": [-0.3, 1.8, 0], "rotate_deg": [0, 30, 0], "plane": {"size": [0.3, 4]}}]})";

TEST(SmoothShadows, HaveLessErrorThanHardOnesAgainstABoxOfOnePixel) {
  const Stage stage(kShadows);
  const Picture reference = stage.draw({.supersampling = 24, .shadows = Shadows::kHard});
  const double hard = texmap::rmse(stage.draw({.shadows = Shadows::kHard}).image, reference.image);
  const double smooth = texmap::rmse(stage.draw({.shadows = Shadows::kSmooth}).image, reference.image);
  // sqrt(5/96 / (1/12)) = 0.79 for edges along the pixels, a little more for others.
  EXPECT_LT(smooth, 0.9 * hard);
}

TEST(SmoothShadows, TakeTheSameShadowRaysForAPixel) {
  const Stage stage(kShadows);
  const std::uint64_t hard = stage.draw({.shadows = Shadows::kHard}).statistics.shadow_rays;
  const std::uint64_t smooth = stage.draw({.shadows = Shadows::kSmooth}).statistics.shadow_rays;
  // The border and the rows that bands share come on top: 2 of 96 columns, 6 of 72 rows.
  EXPECT_LT(static_cast<double>(smooth), 1.12 * static_cast<double>(hard));
}

TEST(SmoothShadows, LeaveLitAndDarkSurfacesAsTheyAre) {
  const Stage stage(kShadows);
  const Picture hard = stage.draw({.shadows = Shadows::kHard});
  const Picture smooth = stage.draw({.shadows = Shadows::kSmooth});
  // Where no shadow's edge is within a pixel: a change of colour by less than a tenth.
  int same = 0;
  for (int y = 1; y < 71; ++y) {
    for (int x = 1; x < 95; ++x) {
      bool is_even = true;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const glm::vec3 step = hard.image.color(x + dx, y + dy) - hard.image.color(x, y);
          is_even &= glm::length(step) < 0.1f;
        }
      }
      if (!is_even) continue;
      ++same;
      ASSERT_EQ(hard.image.color(x, y), smooth.image.color(x, y)) << x << ' ' << y;
    }
  }
  EXPECT_GT(same, 2000);
}

}  // namespace
}  // namespace sweepkit::render
