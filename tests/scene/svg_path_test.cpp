// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Path data: every command against points and areas worked out by hand, arcs against the formulas of SVG 2,
// B.2.4 in long double.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "outline_measures.hpp"
#include "svg_values.hpp"

namespace sweepkit::scene {
namespace {

using std::numbers::pi;

std::vector<Outline> drawn(const std::string& data) {
  OutlineBuilder pen;
  read_path_data(data, pen);
  return pen.take();
}

Outline only(const std::string& data) {
  std::vector<Outline> outlines = drawn(data);
  if (outlines.size() != 1) throw std::runtime_error(data + " draws " + std::to_string(outlines.size()));
  return std::move(outlines.front());
}

const sweep::ArcSegment<2>& arc_of(const Outline& outline) {
  return std::get<sweep::ArcSegment<2>>(outline.segments.at(0));
}

TEST(SvgPath, LinesLeadToPointsOrByStepsAlongAxesToo) {
  const std::vector<glm::dvec2> corners = {{1, 2}, {4, 6}, {10, 6}, {10, -3}, {1, 2}};
  for (const char* data :
       {"M1 2L4 6H10V-3Z", "m1 2l3 4h6v-9z", "M 1,2 L 4,6 H 10 V -3 z", "M1 2 4 6 10 6 10-3z",
        "m1 2 3 4 6 0 0-9z", "M1 2L4 6 10 6 10 -3Z", "M1 2l3 4 6 0 0-9Z", "\t\r\nM1\n2\tL4,6 H10 V-3 Z \n"}) {
    const Outline outline = only(data);
    EXPECT_TRUE(outline.is_closed) << data;
    expect_points(controls(outline), corners);
  }
}

TEST(SvgPath, CommandsRepeatForMoreNumbers) {
  const std::vector<glm::dvec2> corners = {{1, 2}, {4, 6}, {7, 6}, {10, 6}, {10, 1}, {10, -3}, {1, 2}};
  for (const char* data : {"M1 2 4 6H7 10V1-3z", "m1 2 3 4h3 3v-5-4z", "M1 2L4 6 7 6 10 6 10 1 10-3z"}) {
    expect_points(controls(only(data)), corners);
  }
}

TEST(SvgPath, NumbersNeedNoBlanksWhereTheyCannotBeMistaken) {
  expect_points(controls(only("M.5.25-.5-.75L1e1-1E-1+2+3e0 1.5e+1.25")),
                {{0.5, 0.25}, {-0.5, -0.75}, {10, -0.1}, {2, 3}, {15, 0.25}}, 1e-15);
  // An arc's flags are one digit each.
  const Outline run_together = only("M1 0a1 1 0 01-1 1");
  EXPECT_EQ(arc_of(run_together).to_deg, 90);
  expect_points({evaluate<2>(run_together.segments[0], 1).position}, {{0, 1}}, 1e-15);
}

TEST(SvgPath, NumbersAreReadToTheirLastDigitOrNearIt) {
  // svgpp sums digits in double: a few units of the last place.
  for (const double value : {0.1, 123.456789012345678, 1e-30, 3.1415926535897931, 9007199254740993.0, 1e30}) {
    char text[64];
    std::snprintf(text, sizeof text, "M0 0L%.17g 0", value);
    EXPECT_NEAR(controls(only(text)).back().x, value, 4 * 2.3e-16 * value) << text;
  }
}

TEST(SvgPath, CurvesHaveTheirControlPoints) {
  expect_points(controls(only("M0 0C0 1 1 1 1 0")), {{0, 0}, {0, 1}, {1, 1}, {1, 0}});
  expect_points(controls(only("M3 4c0 1 1 1 1 0")), {{3, 4}, {3, 5}, {4, 5}, {4, 4}});
  expect_points(controls(only("M0 0Q1 2 2 0")), {{0, 0}, {1, 2}, {2, 0}});
  expect_points(controls(only("M3 4q1 2 2 0 1-2 2 0")), {{3, 4}, {4, 6}, {5, 4}, {6, 2}, {7, 4}});
}

TEST(SvgPath, SmoothCurvesReflectTheControlPointBeforeOfTheirOwnKind) {
  const std::vector<glm::dvec2> wave = {{0, 0}, {0, 1}, {1, 2}, {2, 0}, {3, -2}, {3, -1}, {4, 0}};
  expect_points(controls(only("M0 0C0 1 1 2 2 0S3-1 4 0")), wave);
  expect_points(controls(only("M0 0c0 1 1 2 2 0s1-1 2 0")), wave);
  // After anything else the control point is where the pen stands.
  expect_points(controls(only("M0 0L2 0S3-1 4 0")), {{0, 0}, {2, 0}, {2, 0}, {3, -1}, {4, 0}});
  expect_points(controls(only("M0 0Q1 2 2 0S3-1 4 0")), {{0, 0}, {1, 2}, {2, 0}, {2, 0}, {3, -1}, {4, 0}});

  const std::vector<glm::dvec2> chain = {{0, 0}, {1, 2}, {2, 0}, {3, -2}, {4, 0}, {5, 2}, {6, 0}};
  expect_points(controls(only("M0 0Q1 2 2 0T4 0 6 0")), chain);
  expect_points(controls(only("M0 0q1 2 2 0t2 0 2 0")), chain);
  expect_points(controls(only("M0 0L2 0T4 0")), {{0, 0}, {2, 0}, {2, 0}, {4, 0}});
  expect_points(controls(only("M0 0C0 1 1 2 2 0T4 0")), {{0, 0}, {0, 1}, {1, 2}, {2, 0}, {2, 0}, {4, 0}});
}

TEST(SvgPath, AreasUnderCurvesAreTheClosedForms) {
  // y dx = 3t(1-t) 6t(1-t) dt integrates to 3/5; a parabola has 2/3 of its box. Some sums of numbers near 1.
  EXPECT_NEAR(area(only("M0 0C0 1 1 1 1 0z")), -0.6, 1e-15);
  EXPECT_NEAR(area(only("M0 0Q1 2 2 0z")), -4.0 / 3, 2e-15);
  EXPECT_NEAR(area(only("M0 0Q1 2 2 0T4 0z")), 0, 2e-15);
  EXPECT_NEAR(area(only("M1 0A1 1 0 0 1-1 0A1 1 0 0 1 1 0z")), pi, 1e-14);
  EXPECT_NEAR(area(only("M3 0A3 2 0 1 1 0-2z")), 6 * pi * 0.75 + 3, 1e-13);
}

TEST(SvgPath, TheFlagsChooseAmongFourArcs) {
  struct Case {
    const char* flags;
    glm::dvec2 center;
    double turn_deg;
  };
  // Points one unit apart from two centres: (0, 0) and (1, 1).
  for (const auto& [flags, center, turn] : {Case{"0 0", {1, 1}, -90}, Case{"0 1", {0, 0}, 90},
                                            Case{"1 0", {0, 0}, -270}, Case{"1 1", {1, 1}, 270}}) {
    const Outline outline = only(std::string("M1 0A1 1 0 ") + flags + " 0 1");
    const sweep::ArcSegment<2>& arc = arc_of(outline);
    expect_points({arc.center}, {center}, 1e-15);
    EXPECT_EQ(arc.to_deg - arc.from_deg, turn) << flags;
    EXPECT_NEAR(length(outline), std::abs(turn) * pi / 180, 1e-13);
  }
}

TEST(SvgPath, RadiiThatDoNotReachGrowUntilTheyDo) {
  const Outline half = only("M-5 0A1 1 0 0 1 5 0");
  EXPECT_NEAR(length(half), 5 * pi, 1e-13);
  expect_points({evaluate<2>(half.segments[0], 0.5).position}, {{0, -5}}, 1e-14);
  // In their proportion: 2 : 1 becomes 10 : 5.
  expect_points({evaluate<2>(only("M-10 0A2 1 0 0 0 10 0").segments[0], 0.5).position}, {{0, 5}}, 1e-14);
  // Just reaching, both flags for the longer way mean the same half.
  EXPECT_NEAR(area(only("M-5 0A5 5 0 1 1 5 0z")), 12.5 * pi, 1e-12);
  // So small that their inverse overflows: as 0.
  expect_points(controls(only("M0 0A1e-310 1e-310 0 0 1 1 1")), {{0, 0}, {1, 1}});
}

TEST(SvgPath, ArcsThatAreNoneAreLinesOrNothing) {
  const std::vector<glm::dvec2> line = {{1, 2}, {4, 6}};
  expect_points(controls(only("M1 2A0 5 0 0 1 4 6")), line);
  expect_points(controls(only("M1 2A5 0 30 1 0 4 6")), line);
  expect_points(controls(only("M1 2A5 5 0 1 1 1 2L4 6")), line);
}

TEST(SvgPath, ShallowArcsAreAsGoodAsLongOnes) {
  // A chord of 2e-3 on a radius of 1000: its height is r - sqrt(r^2 - 1e-6) = 5e-10.
  const Outline shallow = only("M-1e-3 0A1000 1000 0 0 0 1e-3 0");
  ASSERT_EQ(shallow.segments.size(), 1);
  EXPECT_NEAR(evaluate<2>(shallow.segments[0], 0.5).position.y, 5e-10, 1e-19);
  EXPECT_EQ(evaluate<2>(shallow.segments[0], 1).position, glm::dvec2(1e-3, 0));
}

// SVG 2, B.2.4 and B.2.5 as they stand.
struct Reference {
  long double cx, cy, rx, ry, phi, from, turn;
  long double share;  // of the radii that the centre is from the chord's middle: how well it is known
};

Reference reference(const glm::dvec2& p, const OutlineBuilder::Arc& arc, const glm::dvec2& q) {
  using Real = long double;
  const Real pi_long = std::numbers::pi_v<Real>;
  const Real phi = arc.x_axis_deg * pi_long / 180;
  const Real c = std::cos(phi), s = std::sin(phi);
  const Real dx = (Real(p.x) - q.x) / 2, dy = (Real(p.y) - q.y) / 2;
  const Real x = c * dx + s * dy, y = -s * dx + c * dy;
  Real rx = arc.radii.x, ry = arc.radii.y;
  const Real lambda = x * x / (rx * rx) + y * y / (ry * ry);
  if (lambda > 1) {
    rx *= std::sqrt(lambda);
    ry *= std::sqrt(lambda);
  }
  const Real under =
      (rx * rx * ry * ry - rx * rx * y * y - ry * ry * x * x) / (rx * rx * y * y + ry * ry * x * x);
  const Real root = (arc.is_large == arc.is_positive ? -1 : 1) * std::sqrt(std::max(under, Real(0)));
  const Real ux = root * rx * y / ry, uy = -root * ry * x / rx;
  const auto angle = [](Real ax, Real ay) { return std::atan2(ay, ax); };
  const Real from = angle((x - ux) / rx, (y - uy) / ry);
  Real turn = angle((-x - ux) / rx, (-y - uy) / ry) - from;
  if (!arc.is_positive && turn > 0) turn -= 2 * pi_long;
  if (arc.is_positive && turn < 0) turn += 2 * pi_long;
  return {c * ux - s * uy + (Real(p.x) + q.x) / 2,
          s * ux + c * uy + (Real(p.y) + q.y) / 2,
          rx,
          ry,
          phi,
          from,
          turn,
          std::sqrt(std::max(1 - lambda, Real(0)))};
}

TEST(SvgPath, ArcsAgreeWithTheSpecificationInLongDouble) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> coordinate(-10, 10);
  std::uniform_real_distribution<double> radius(0.5, 20);
  std::uniform_real_distribution<double> degrees(-360, 360);
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec2 p(coordinate(random), coordinate(random));
    const glm::dvec2 q(coordinate(random), coordinate(random));
    const OutlineBuilder::Arc arc{{radius(random), radius(random)}, degrees(random), i % 2 == 0, i % 4 < 2};
    const Reference expected = reference(p, arc, q);
    // A centre near the chord's middle moves by the root of a rounding; no farther than a root of 1e-15.
    const double loss = std::min(1 / std::max(static_cast<double>(expected.share), 1e-300), 3e7);
    const double bound = 1e-14 * static_cast<double>(std::max(expected.rx, expected.ry)) * (1 + loss);
    OutlineBuilder pen;
    pen.move_to(p);
    pen.arc_to(arc, q);
    const std::vector<Outline> outlines = pen.take();
    ASSERT_EQ(outlines.size(), 1);
    ASSERT_EQ(outlines[0].segments.size(), 1);
    for (const double t : {0.0, 0.25, 0.5, 0.875, 1.0}) {
      const long double angle = expected.from + t * expected.turn;
      const long double x = expected.rx * std::cos(angle), y = expected.ry * std::sin(angle);
      const long double c = std::cos(expected.phi), s = std::sin(expected.phi);
      const glm::dvec2 at = evaluate<2>(outlines[0].segments[0], t).position;
      EXPECT_NEAR(at.x, static_cast<double>(expected.cx + c * x - s * y), bound)
          << "arc " << i << " at " << t;
      EXPECT_NEAR(at.y, static_cast<double>(expected.cy + s * x + c * y), bound)
          << "arc " << i << " at " << t;
    }
  }
}

TEST(SvgPath, SubpathsBeginAtAMoveOrWhereOneWasClosed) {
  const auto squares = drawn("M0 0h1v1h-1z M5 5h1v1h-1z");
  ASSERT_EQ(squares.size(), 2);
  EXPECT_NEAR(area(squares[0]), 1, 1e-14);
  expect_points(controls(squares[1]), {{5, 5}, {6, 5}, {6, 6}, {5, 6}, {5, 5}});
  // Relative moves go on from where the pen is, which z took to the start.
  expect_points(controls(drawn("M3 4h1v1z m1 1 h1")[1]), {{4, 5}, {5, 5}});
  expect_points(controls(drawn("M3 4h1v1z l0 2")[1]), {{3, 4}, {3, 6}});
  expect_points(controls(drawn("M3 4h1 m1 1 h1")[1]), {{5, 5}, {6, 5}});
  EXPECT_FALSE(drawn("M3 4h1v1z l0 2")[1].is_closed);
}

TEST(SvgPath, EndsThatCoincideCloseASubpath) {
  EXPECT_TRUE(only("M0 0H1V1H0V0").is_closed);
  EXPECT_FALSE(only("M0 0H1V1H0V.1").is_closed);
  // Ten steps of 0.1 miss the start by a rounding: no segment of 1e-16 stays, with or without z.
  for (const char* end : {"", "z"}) {
    const Outline outline = only(std::string("M0 0h.1.1.1.1.1.1.1.1.1.1v1h-1v-1") + end);
    EXPECT_TRUE(outline.is_closed);
    EXPECT_EQ(outline.segments.size(), 13);
    EXPECT_TRUE(sweep::Curve2(outline.segments).is_closed());
  }
}

TEST(SvgPath, WhatDrawsNothingIsLeftOut) {
  for (const char* nothing : {"", " \n", "M1 1", "M1 1z", "M1 1L1 1z",
                              "M1 1h0v0c0 0 0 0 0 0q0 0 0 0t0 0a5 5 0 1 1 0 0", "M0 0M1 1m2 2"}) {
    EXPECT_TRUE(drawn(nothing).empty()) << nothing;
  }
  EXPECT_EQ(controls(only("M1 1L1 1L2 2L2 2")).size(), 2);
}

TEST(SvgPath, SyntaxErrorsNameTheOffsetAndWhatStandsThere) {
  const std::string belongs = "a number (an arc's radii without a sign) or one of M L H V C S Q T A Z";
  const auto has = [&](const std::string& what, int offset) {
    return "has \"" + what + "\" at offset " + std::to_string(offset) + ", where " + belongs + " belongs";
  };
  const auto ends = [&](int offset) {
    return "ends at offset " + std::to_string(offset) + " where " + belongs + " is missing";
  };
  const std::vector<std::pair<std::string, std::string>> faults = {
      {"L1 1", has("L", 0)},
      {"10 10", has("1", 0)},
      {"M", ends(1)},
      {"M1", ends(2)},
      {"M0 0L1", ends(6)},
      {"M0 0 X", has("X", 5)},
      {"M0 0L1 1 2", ends(10)},
      {"M0 0L1 1#", has("#", 8)},
      {"M0 0C1 1 2 2 z", has("z", 13)},
      {"M0 0L1 1zz5", has("5", 10)},
      {"M0 0A1 1 0 2 0 5 5", has("2", 11)},
      {"M0 0A1 1 0 0 1 5", ends(16)},
      {"M0 0Lnan 1", has("n", 5)},
      {"M0 0L3. 4", has(" ", 7)},
      {"M0 0L0x3 4", has("x", 6)},
      {"M0 0L1e999 1", "the number 1e999 at offset 5 is too large"},
      {"M0 0L1e101 1", "has a coordinate beyond 1e100; draw smaller"},
      {"M0 0C1 1 2 -1e200 3 3", "has a coordinate beyond 1e100; draw smaller"},
  };
  for (const auto& fault : faults)
    EXPECT_EQ(refusal([&] { drawn(fault.first); }), fault.second) << fault.first;
}

TEST(SvgPath, MoreSegmentsThanMemoryIsRefused) {
  std::string data = "M0 0";
  for (std::size_t i = 0; i <= kMostSegments; ++i) data += i % 2 == 0 ? "h1" : "v1";
  EXPECT_EQ(refusal([&] { drawn(data); }), "has more than 500000 segments; simplify it");
}

TEST(SvgTransform, EachIsTheMatrixOfTheSpecification) {
  const auto image = [](const std::string& text) {
    return glm::dvec2(read_transform(text) * glm::dvec3(2, 3, 1));
  };
  EXPECT_EQ(image(""), glm::dvec2(2, 3));
  EXPECT_EQ(image("translate(10)"), glm::dvec2(12, 3));
  EXPECT_EQ(image("translate(10, -1)"), glm::dvec2(12, 2));
  EXPECT_EQ(image("scale(2)"), glm::dvec2(4, 6));
  EXPECT_EQ(image("scale(2 -1)"), glm::dvec2(4, -3));
  EXPECT_EQ(image("rotate(90)"), glm::dvec2(-3, 2));
  EXPECT_EQ(image("rotate(-90, 1, 1)"), glm::dvec2(3, 0));
  EXPECT_EQ(image("matrix(1 2 3 4 5 6)"), glm::dvec2(1 * 2 + 3 * 3 + 5, 2 * 2 + 4 * 3 + 6));
  // tan 45 degrees is 1 to a rounding.
  expect_points({image("skewX(45)"), image("skewY(45)")}, {{5, 3}, {2, 5}}, 2e-15);
  const double c = std::cos(pi / 6), s = 0.5;
  expect_points({image("rotate(30)")}, {{2 * c - 3 * s, 2 * s + 3 * c}}, 1e-15);
}

TEST(SvgTransform, AListAppliesTheLastFirst) {
  const glm::dvec3 p(2, 3, 1);
  EXPECT_EQ(read_transform("translate(10 20) scale(2)") * p, glm::dvec3(14, 26, 1));
  EXPECT_EQ(read_transform("scale(2),translate(10 20)") * p, glm::dvec3(24, 46, 1));
  EXPECT_EQ(read_transform(" scale( 2 ) \n translate(10,20)rotate(90) ") * p, glm::dvec3(14, 44, 1));
}

TEST(SvgTransform, ErrorsNameTheOffset) {
  const std::string belongs = "a part of matrix(), translate(), scale(), rotate(), skewX() or skewY()";
  for (const auto& [text, what] : std::vector<std::pair<std::string, std::string>>{
           {"turn(90)", "has \"u\" at offset 1, where "},
           {"scale(2", "ends at offset 7 where "},
           {"matrix(1 2 3)", "has \")\" at offset 12, where "},
           {"rotate(90deg)", "has \"d\" at offset 9, where "},
       }) {
    const std::string told = refusal([&, &text = text] { read_transform(text); });
    EXPECT_TRUE(told.starts_with(what) && told.find(belongs) != std::string::npos) << text << ": " << told;
  }
}

TEST(SvgPoints, AreReadWithAnySeparators) {
  const std::vector<glm::dvec2> points = {{1, 2}, {3, -4}, {5.5, 6}};
  for (const char* text : {"1,2 3,-4 5.5,6", "1 2 3 -4 5.5 6", " 1,2,3-4,5.5,6\n", "1 , 2\t3 -4\n5.5 6 "}) {
    expect_points(read_point_list(text), points);
  }
  EXPECT_TRUE(read_point_list("  ").empty());
  EXPECT_EQ(refusal([] { read_point_list("1,2 3"); }),
            "ends at offset 5 where x and y of a point is missing");
  EXPECT_EQ(refusal([] { read_point_list("1,2 x,3"); }),
            "has \"x\" at offset 4, where x and y of a point belongs");
}

}  // namespace
}  // namespace sweepkit::scene
