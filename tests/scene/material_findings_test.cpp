// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "scene_text.hpp"
#include "sweepkit/scene/check.hpp"

namespace sweepkit::scene {
namespace {

std::vector<MaterialFinding> findings_of(const std::string& material) {
  return check_materials(parse(scene_text("\"materials\": {\"m\": {" + material + "}}")));
}

TEST(MaterialFindings, TellSharesOfMoreThanOneWithPlaceAndCure) {
  const auto findings = findings_of(R"("diffuse": [0.5, 0.9, 0.1], "reflect": 0.2, "transmit": 0.15)");
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].material, "m");
  EXPECT_EQ(findings[0].place.pointer, "/materials/m");
  EXPECT_EQ(findings[0].place.line, 1);
  EXPECT_NEAR(findings[0].sum, 1.25, 1e-6);
  EXPECT_EQ(findings[0].problem,
            "diffuse 0.9, reflect 0.2 and transmit 0.15 come to 1.25: more light than falls on it");
  EXPECT_EQ(findings[0].cure, "0.8 times each of them fits");
}

TEST(MaterialFindings, OfFresnelsSharesOnlyTheLargerCounts) {
  EXPECT_TRUE(
      findings_of(R"("diffuse": [0, 0, 0], "reflect": 1, "transmit": 1, "fresnel": "exact")").empty());
  EXPECT_TRUE(
      findings_of(R"("diffuse": [0, 0, 0], "reflect": 1, "transmit": 1, "fresnel": "schlick")").empty());
  const auto findings =
      findings_of(R"("diffuse": [0.3, 0.3, 0.3], "reflect": 1, "transmit": 0.5, "fresnel": "schlick")");
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(
      findings[0].problem,
      "diffuse 0.3 and the larger of reflect 1 and transmit 0.5 come to 1.3: more light than falls on it");
}

TEST(MaterialFindings, SharesThatComeToOneInTheFileAreNotMoreInFloat32) {
  for (const char* material : {R"("diffuse": [0.92, 0.92, 0.92], "reflect": 0.08)",
                               R"("diffuse": [0.7, 0.7, 0.7], "reflect": 0.1, "transmit": 0.2)", ""})
    EXPECT_TRUE(findings_of(material).empty()) << material;
}

}  // namespace
}  // namespace sweepkit::scene
