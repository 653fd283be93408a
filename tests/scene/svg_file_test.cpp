// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "svg_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "outline_measures.hpp"

namespace sweepkit::scene {
namespace {

using std::numbers::pi;

// Areas and coordinates up to some hundreds, after a handful of products.
constexpr double kRounding = 1e-11;

std::string svg(const std::string& content, const std::string& attributes = "") {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" " + attributes + ">\n" + content + "\n</svg>";
}

std::vector<DrawnShape> read(const std::string& text, const std::optional<std::string>& id = std::nullopt) {
  return read_svg(text, "a.svg", id);
}

Outline only(const std::string& text, const std::optional<std::string>& id = std::nullopt) {
  std::vector<DrawnShape> shapes = read(text, id);
  if (shapes.size() != 1 || shapes[0].outlines.size() != 1) {
    throw std::runtime_error("no single outline: " + text);
  }
  return shapes[0].outlines[0];
}

std::string fault(const std::string& text, const std::optional<std::string>& id = std::nullopt) {
  return refusal([&] { read(text, id); });
}

// The areas without their signs, in the order of drawing.
std::vector<double> areas(const std::vector<DrawnShape>& shapes) {
  std::vector<double> areas;
  for (const DrawnShape& shape : shapes) {
    for (const Outline& outline : shape.outlines) areas.push_back(std::abs(area(outline)));
  }
  return areas;
}

void expect_areas(const std::vector<DrawnShape>& shapes, const std::vector<double>& expected) {
  const std::vector<double> found = areas(shapes);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], kRounding) << i;
}

TEST(SvgFile, ShapesHaveTheAreasOfTheirFormulas) {
  const std::vector<std::pair<std::string, double>> shapes = {
      {R"(<circle cx="3" cy="4" r="2"/>)", 4 * pi},
      {R"(<ellipse cx="3" cy="4" rx="2" ry="5"/>)", 10 * pi},
      {R"(<ellipse rx="2"/>)", 4 * pi},
      {R"(<rect x="1" y="2" width="6" height="5"/>)", 30},
      {R"(<rect width="6" height="5" rx="1" ry="2"/>)", 30 - (4 - pi) * 2},
      {R"(<rect width="6" height="5" rx="1"/>)", 30 - (4 - pi)},
      {R"(<rect width="6" height="5" ry="1"/>)", 30 - (4 - pi)},
      {R"(<rect width="6" height="4" rx="99" ry="99"/>)", 6 * pi},
      {R"(<rect width="6" height="5" rx="1" ry="0"/>)", 30},
      {R"(<polygon points="0,0 4,0 4,3"/>)", 6},
      {R"(<polyline points="0,0 4,0 4,3"/>)", 6},
      {R"(<path d="M0 0H4V3"/>)", 6},
  };
  for (const auto& [text, expected] : shapes) {
    EXPECT_NEAR(std::abs(area(only(svg(text)))), expected, kRounding) << text;
  }
}

TEST(SvgFile, ShapesBeginAndRunAsTheSpecificationSays) {
  const auto starts = [](const std::string& shape) {
    return sweep::evaluate<2>(only(svg(shape)).segments[0], 0).position;
  };
  EXPECT_EQ(starts(R"(<circle cx="3" cy="4" r="2"/>)"), glm::dvec2(5, -4));
  EXPECT_EQ(starts(R"(<rect x="1" y="2" width="6" height="5" rx="1"/>)"), glm::dvec2(2, -2));
  // To growing angles while y runs down: clockwise once y runs up.
  for (const char* shape :
       {R"(<circle r="2"/>)", R"(<rect width="1" height="1"/>)", R"(<ellipse rx="1" ry="2"/>)"}) {
    EXPECT_LT(area(only(svg(shape))), 0) << shape;
    EXPECT_TRUE(only(svg(shape)).is_closed) << shape;
  }
  EXPECT_FALSE(only(svg(R"(<polyline points="0,0 1,0 1,1"/>)")).is_closed);
  const std::vector<DrawnShape> line = read(svg(R"(<line x1="1" y1="2" x2="3" y2="5"/>)"));
  ASSERT_EQ(line.size(), 1);
  EXPECT_FALSE(line[0].is_filled);
  expect_points(controls(line[0].outlines[0]), {{1, -2}, {3, -5}});
}

TEST(SvgFile, ShapesThatSvgDrawsNothingOfLeaveNothing) {
  EXPECT_TRUE(read(svg(R"(<circle/><circle r="0"/><ellipse rx="0" ry="1"/><rect width="1"/><line/>
      <path/><path d=""/><path d="none"/><polygon points=""/><polyline points="1,1"/>)"))
                  .empty());
}

TEST(SvgFile, YRunsUpwardsFromTheTopLeftCorner) {
  expect_points(controls(only(svg(R"(<polyline points="0,0 10,0 10,5"/>)"))), {{0, 0}, {10, 0}, {10, -5}});
}

TEST(SvgFile, TransformsOfGroupsAndShapesComposeFromTheOutside) {
  const std::string line = R"svg(<polyline points="1,0 2,1" transform="translate(10 20)"/>)svg";
  expect_points(
      controls(only(svg("<g transform=\"scale(2)\"><g transform=\"rotate(90)\">" + line + "</g></g>"))),
      {{-40, -22}, {-42, -24}});
  expect_points(controls(only(svg("<g transform=\"scale(2) rotate(90)\">" + line + "</g>"))),
                {{-40, -22}, {-42, -24}});
  expect_points(controls(only(svg("<g>" + line + "</g>", "transform=\"scale(2) rotate(90)\""))),
                {{-40, -22}, {-42, -24}});
}

TEST(SvgFile, AnyTransformKeepsArcsExact) {
  // Areas grow by the determinant, 2 * 4 - 1 * 3.
  const Outline ellipse = only(svg(R"svg(<circle cx="1" cy="1" r="2" transform="matrix(2 1 3 4 5 6)"/>)svg"));
  ASSERT_EQ(ellipse.segments.size(), 1);
  EXPECT_TRUE(std::holds_alternative<sweep::ArcSegment<2>>(ellipse.segments[0]));
  EXPECT_NEAR(std::abs(area(ellipse)), 5 * 4 * pi, kRounding);
  for (int i = 0; i < 8; ++i) {
    const double a = 2 * pi * i / 8;
    const glm::dvec2 p(1 + 2 * std::cos(a), 1 + 2 * std::sin(a));
    expect_points({sweep::evaluate<2>(ellipse.segments[0], i / 8.0).position},
                  {{2 * p.x + 3 * p.y + 5, -(p.x + 4 * p.y + 6)}}, 1e-14);
  }
}

TEST(SvgFile, TheViewBoxIsFittedIntoWidthAndHeightAsAViewerDoes) {
  struct Case {
    std::string attributes;
    glm::dvec2 at_1_2;  // where (1, 2) of the user space comes, y down
  };
  const std::vector<Case> cases = {
      {"", {1, 2}},
      {R"(width="100" height="50")", {1, 2}},
      {R"(viewBox="0 0 10 10")", {1, 2}},
      {R"(viewBox="1 1 10 10")", {0, 1}},
      {R"(viewBox="0 0 10 10" width="100%" height="100%")", {1, 2}},
      {R"(viewBox="0 0 10 20" width="100")", {10, 20}},
      {R"(viewBox="0 0 10 20" height="100px")", {5, 10}},
      {R"(viewBox="0,0,10,10" width="1in" height="1in")", {9.6, 19.2}},
      {R"(viewBox="0 0 254 254" width="254mm" height="25.4cm")", {96 / 25.4, 192 / 25.4}},
      {R"(viewBox="0 0 72 6" width="72pt" height="6pc")", {96 / 72.0, 96 / 72.0 * 2 + 44}},
      {R"(viewBox="0 0 1016 1016" width="1016Q" height="1016Q")", {96 / 101.6, 192 / 101.6}},
      // 100 x 50 about a square of 10: half as large as wide, in the middle unless said.
      {R"(viewBox="0 0 10 10" width="100" height="50")", {25 + 5, 10}},
      {R"(viewBox="0 0 10 10" width="100" height="50" preserveAspectRatio="xMinYMid")", {5, 10}},
      {R"(viewBox="0 0 10 10" width="100" height="50" preserveAspectRatio="xMaxYMax meet")", {55, 10}},
      {R"(viewBox="0 0 10 10" width="100" height="50" preserveAspectRatio="none")", {10, 10}},
      {R"(viewBox="0 0 10 10" width="100" height="50" preserveAspectRatio="xMidYMid slice")", {10, 20 - 25}},
      {R"(viewBox="0 0 10 10" width="100" height="50" preserveAspectRatio="xMidYMin slice")", {10, 20}},
      {R"(viewBox="0 0 10 10" width="100" height="50" preserveAspectRatio="xMidYMax slice")", {10, 20 - 50}},
  };
  for (const auto& [attributes, at] : cases) {
    SCOPED_TRACE(attributes);
    expect_points({controls(only(svg(R"(<polyline points="1,2 3,4"/>)", attributes))).front()},
                  {{at.x, -at.y}}, kRounding);
  }
}

TEST(SvgFile, NestedViewportsAndPercentagesFollowTheNearestOne) {
  const std::string content = R"(<svg x="10" y="20" width="50%" height="40" viewBox="0 0 25 20">
      <polyline points="1,2 3,4"/><rect width="50%" height="50%"/><circle r="10%"/></svg>)";
  const std::vector<DrawnShape> shapes = read(svg(content, R"(width="100" height="100")"));
  ASSERT_EQ(shapes.size(), 3);
  expect_points(controls(shapes[0].outlines[0]), {{12, -24}, {16, -28}}, 1e-13);
  EXPECT_NEAR(std::abs(area(shapes[1].outlines[0])), 12.5 * 10 * 4, kRounding);
  const double r = 0.1 * std::sqrt((25.0 * 25 + 20 * 20) / 2);
  EXPECT_NEAR(std::abs(area(shapes[2].outlines[0])), pi * r * r * 4, kRounding);
}

TEST(SvgFile, LengthsHaveTheUnitsOfCss) {
  for (const auto& [length, size] : std::vector<std::pair<std::string, double>>{{"3", 3},
                                                                                {"3px", 3},
                                                                                {"0.5in", 48},
                                                                                {"2.54cm", 96},
                                                                                {"25.4mm", 96},
                                                                                {"101.6Q", 96},
                                                                                {"72pt", 96},
                                                                                {"6pc", 96},
                                                                                {"1e1", 10},
                                                                                {" +2 ", 2}}) {
    const Outline outline = only(svg("<line x2=\"" + length + "\"/>"));
    EXPECT_NEAR(controls(outline).back().x, size, 1e-13) << length;
  }
}

TEST(SvgFile, UseDrawsAnElementOnceMore) {
  const std::string defs = R"(<defs><polyline id="p" points="1,0 2,1"/>
      <symbol id="s" viewBox="0 0 10 10"><rect width="10" height="10"/></symbol>
      <g id="two"><use href="#p"/><use href="#p" y="5"/></g></defs>)";
  expect_points(controls(only(svg(defs + R"(<use href="#p" x="10" y="20"/>)"))), {{11, -20}, {12, -21}});
  expect_points(controls(only(svg(defs + R"svg(<use xlink:href="#p" x="10" transform="scale(2)"/>)svg"))),
                {{22, 0}, {24, -2}});
  EXPECT_NEAR(std::abs(area(only(svg(defs + R"(<use href="#s" width="30" height="20"/>)")))), 400, kRounding);
  EXPECT_EQ(read(svg(defs + R"(<use href="#two"/><use href="#two" x="9"/>)")).size(), 4);
}

TEST(SvgFile, DrawsWhatAViewerDrawsAndNoMore) {
  expect_areas(read(svg(R"(
      <defs><rect width="1" height="1"/></defs> <symbol><rect width="1" height="1"/></symbol>
      <clipPath><rect width="1" height="1"/></clipPath> <mask><rect width="1" height="1"/></mask>
      <pattern><rect width="1" height="1"/></pattern> <marker><rect width="1" height="1"/></marker>
      <metadata><rect width="1" height="1"/></metadata> <title>t</title> <text>none</text>
      <rect width="1" height="1" display="none"/> <g style="display: none"><rect width="1" height="1"/></g>
      <rect width="1" height="1" visibility="hidden"/>
      <g visibility="hidden"><rect width="2" height="1" visibility="visible"/></g>
      <other:rect xmlns:other="urn:x" width="1" height="1"/>
      <!-- <rect width="1" height="1"/> -->
      <a><rect width="3" height="1"/></a> <switch><rect width="4" height="1"/></switch>)")),
               {2, 3, 4});
}

TEST(SvgFile, AnIdChoosesOneElementInItsPlace) {
  const std::string text =
      svg(R"svg(<defs><g transform="scale(3)"><rect id="d" width="1" height="1"/></g></defs>
      <g id="g" transform="scale(2)"><rect id="r" width="1" height="2"/><rect width="5" height="5"/></g>
      <g display="none"><circle id="c" r="1"/></g> <symbol id="s"><rect width="7" height="1"/></symbol>
      <rect id="hidden" visibility="hidden" width="6" height="1"/> <clipPath id="clip"><circle r="2"/></clipPath>)svg");
  expect_areas(read(text, "r"), {8});
  expect_areas(read(text, "g"), {8, 100});
  expect_areas(read(text, "d"), {9});
  expect_areas(read(text, "c"), {pi});
  expect_areas(read(text, "s"), {7});
  expect_areas(read(text, "hidden"), {6});
  expect_areas(read(text, "clip"), {4 * pi});
  expect_areas(read(text), {8, 100});
}

TEST(SvgFile, FillIsInheritedAndStyleGoesBeforeAttributes) {
  const std::vector<DrawnShape> shapes = read(svg(R"(
      <g fill-rule="evenodd" fill="none"><rect width="1" height="1"/>
        <rect width="1" height="1" fill-rule="nonzero" fill="red"/>
        <rect width="1" height="1" style="fill:#123; fill-rule : nonzero"/>
        <rect width="1" height="1" fill="red" style="fill:none!important"/>
        <rect width="1" height="1" fill="inherit" fill-rule="inherit"/></g>
      <rect width="1" height="1"/>)"));
  ASSERT_EQ(shapes.size(), 6);
  const std::vector<bool> filled = {false, true, true, false, false, true};
  const std::vector<bool> even_odd = {true, false, false, true, true, false};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    EXPECT_EQ(shapes[i].is_filled, filled[i]) << i;
    EXPECT_EQ(shapes[i].rule == FillRule::kEvenOdd, even_odd[i]) << i;
  }
}

TEST(SvgFile, ReadsPrefixedElementsAndOtherEncodings) {
  const std::string prefixed =
      R"(<?xml version="1.0"?><!DOCTYPE svg><svg:svg xmlns:svg="http://www.w3.org/2000/svg"><svg:circle r="1"/><circle r="9"/></svg:svg>)";
  expect_areas(read(prefixed), {pi});
  std::string utf16 = {'\xFF', '\xFE'};
  for (const char c : svg(R"(<circle r="1"/>)")) utf16 += {c, '\0'};
  expect_areas(read(utf16), {pi});
  expect_areas(read("\xEF\xBB\xBF" + svg(R"(<circle r="1"/>)")), {pi});
}

TEST(SvgFile, FaultsAreToldWithLineColumnAndTag) {
  const auto in = [](const std::string& content) { return fault(svg(content)); };
  const std::string belongs = "a number (an arc's radii without a sign) or one of M L H V C S Q T A Z";
  EXPECT_EQ(in("<g>\n  <path id=\"p\" d=\"M0 0L1\"/></g>"),
            "a.svg:3:3: <path id=\"p\">: \"d\" ends at offset 6 where " + belongs + " is missing");
  EXPECT_EQ(in("<circle r=\"-1\"/>"), "a.svg:2:1: <circle>: \"r\" needs to be at least 0, got -1");
  EXPECT_EQ(in("<circle r=\"1em\"/>"),
            "a.svg:2:1: <circle>: \"r\" needs a length in px, in, cm, mm, Q, pt, pc or %, got \"1em\"");
  EXPECT_EQ(in("<circle r=\"big\"/>"), "a.svg:2:1: <circle>: \"r\" needs a length, got \"big\"");
  EXPECT_EQ(in("<circle r=\"nan\"/>"), "a.svg:2:1: <circle>: \"r\" needs a length, got \"nan\"");
  EXPECT_EQ(in("<circle r=\"1e999\"/>"), "a.svg:2:1: <circle>: \"r\" is too large, got \"1e999\"");
  EXPECT_EQ(in("<circle r=\"1e101\"/>"), "a.svg:2:1: <circle>: has a coordinate beyond 1e100; draw smaller");
  EXPECT_EQ(
      in("<circle r=\"5%\"/>"),
      "a.svg:2:1: <circle>: \"r\" is a share of a size the svg element does not have; give it a viewBox, got "
      "\"5%\"");
  EXPECT_EQ(in("<polygon points=\"1,2 3\"/>"),
            "a.svg:2:1: <polygon>: \"points\" ends at offset 5 where x and y of a point is missing");
  EXPECT_EQ(
      in("<g transform=\"turn(3)\"/>"),
      "a.svg:2:1: <g>: \"transform\" has \"u\" at offset 1, where a part of matrix(), translate(), scale(), "
      "rotate(), skewX() or skewY() belongs");
  EXPECT_EQ(in("<g fill-rule=\"odd\"/>"),
            "a.svg:2:1: <g>: \"fill-rule\" needs nonzero or evenodd, got \"odd\"");
  EXPECT_EQ(in("<use href=\"b.svg#x\"/>"),
            "a.svg:2:1: <use>: \"href\" needs an element of this file (\"#...\"), got \"b.svg#x\"");
  EXPECT_EQ(in("<rect id=\"left\"/><use href=\"#lefd\"/>"),
            "a.svg:2:18: <use>: there is no element \"lefd\"; did you mean \"left\"?");
  EXPECT_EQ(in("<style>path { fill : none }</style>"),
            "a.svg:2:1: <style>: style sheets are not read, and this one says \"fill:none\"; put it into the "
            "elements' attributes");
  EXPECT_EQ(in("<g style=\"transform: scale(2)\"/>"),
            "a.svg:2:1: <g>: CSS transforms are not read; put a transform attribute in their place");
}

TEST(SvgFile, StyleSheetsOfColoursAreNoHindrance) {
  expect_areas(read(svg(R"(<style>.a{fill:#f00;stroke:none}</style><circle class="a" r="1"/>)")), {pi});
}

TEST(SvgFile, FaultsOfTheViewport) {
  const auto with = [](const std::string& attributes) { return fault(svg("", attributes)); };
  const std::string at = "a.svg:1:1: <svg>: ";
  EXPECT_EQ(with("viewBox=\"0 0 10\""), at + "\"viewBox\" needs 4 numbers, got \"0 0 10\"");
  EXPECT_EQ(with("viewBox=\"0 0 10 1e999\""), at + "\"viewBox\" needs 4 numbers, got \"0 0 10 1e999\"");
  EXPECT_EQ(with("viewBox=\"0 0 10 10 10\""), at + "\"viewBox\" needs 4 numbers, got \"0 0 10 10 10\"");
  EXPECT_EQ(with("viewBox=\"0 0 10 0\""),
            at + "\"viewBox\" needs a width and a height above 0, got \"0 0 10 0\"");
  EXPECT_EQ(with("width=\"0\" height=\"1\""),
            at + "is drawn by no viewer: its width or height is 0; give them above 0, or a viewBox alone");
  EXPECT_EQ(
      with("viewBox=\"0 0 1 1\" preserveAspectRatio=\"left\""),
      at + "\"preserveAspectRatio\" needs none or a value as xMidYMid, then meet or slice, got \"left\"");
  EXPECT_EQ(fault(svg("<svg viewBox=\"0 0 1 1\"/>")),
            "a.svg:2:1: <svg>: needs \"width\" and \"height\": the svg element about it has no size");
}

TEST(SvgFile, FaultsOfTheDocument) {
  EXPECT_EQ(fault(""), "a.svg:1:1: not valid XML: No document element found");
  EXPECT_EQ(fault("<svg>\n<g></svg>"), "a.svg:2:6: not valid XML: Start-end tags mismatch");
  EXPECT_EQ(fault("<html/>"), "a.svg:1:1: <html>: needs to be an svg element, for this to be an SVG file");
  const std::string text = svg("<rect id=\"left\"/><rect id=\"right\"/><text id=\"t\"/>");
  EXPECT_EQ(fault(text, "lift"), "a.svg:1:1: <svg>: there is no element \"lift\"; did you mean \"left\"?");
  EXPECT_EQ(fault(svg("<rect/>"), "a"),
            "a.svg:1:1: <svg>: there is no element \"a\": none has an id; leave \"id\" out");
  EXPECT_EQ(fault(text, "t"),
            "a.svg:2:36: <text id=\"t\">: has no outlines; convert it to a path, or choose another element");
}

TEST(SvgFile, NestingAndRepetitionEndBeforeMemoryAndPatience) {
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "<g>";
  for (int i = 0; i < 100'000; ++i) deep += "</g>";
  EXPECT_EQ(fault(svg(deep)),
            "a.svg:2:766: <g>: is nested deeper than 256 elements; a use element may not hold itself");
  EXPECT_EQ(fault(svg(R"(<g id="a"><use href="#a"/></g>)")),
            "a.svg:2:11: <use>: is nested deeper than 256 elements; a use element may not hold itself");
  EXPECT_EQ(fault("<svg id=\"a\"><use href=\"#a\"/></svg>"),
            "a.svg:1:13: <use>: holds itself: it uses the document's own svg element; use a part of it");
  // Each level draws the one before ten times: 10^9 circles.
  std::string laughs = R"(<circle id="l0" r="1"/>)";
  for (int level = 1; level <= 9; ++level) {
    laughs += "<g id=\"l" + std::to_string(level) + "\">";
    for (int i = 0; i < 10; ++i) laughs += "<use href=\"#l" + std::to_string(level - 1) + "\"/>";
    laughs += "</g>";
  }
  const std::string told = fault(svg("<defs>" + laughs + "</defs><use href=\"#l9\"/>"));
  EXPECT_TRUE(told.find("simplify") != std::string::npos) << told;
}

}  // namespace
}  // namespace sweepkit::scene
