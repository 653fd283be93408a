// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// "svg", "path" and "csv" as a scene has them, from the file on the disk to the mesh.

#include "read_curve_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "outline_measures.hpp"
#include "scene_text.hpp"
#include "sweepkit/scene/model.hpp"
#include "sweepkit/scene/plan.hpp"

namespace sweepkit::scene {
namespace {

using std::numbers::pi;

std::string object(const std::string& contour,
                   const std::string& trajectory = R"({"line": [[0,0,0],[0,2,0]]})") {
  return R"({"name": "a", "sweep": {"contour": )" + contour + R"(, "trajectory": )" + trajectory + "}}";
}

class CurveFile : public testing::Test {
 protected:
  Document parse(const std::string& contour,
                 const std::string& trajectory = R"({"line": [[0,0,0],[0,2,0]]})") const {
    return parse_document(scene_text("", object(contour, trajectory)), folder.path() / "s.json");
  }
  std::vector<sweep::Curve2> contour(const std::string& curve) const {
    return std::get<SweepShape>(parse(curve).objects.at(0).pieces.at(0).shape).contour;
  }
  sweep::Curve3 trajectory(const std::string& curve) const {
    return std::get<SweepShape>(parse(R"({"circle": {"radius": 1}})", curve).objects.at(0).pieces.at(0).shape)
        .trajectory;
  }
  // What the scene's message says after its place, of a curve that stands as the contour.
  std::string fault(const std::string& curve) const {
    return without_folder(refusal([&] { parse(curve); }));
  }
  std::string trajectory_fault(const std::string& curve) const {
    return without_folder(refusal([&] { trajectory(curve); }));
  }
  std::string without_folder(std::string text) const {
    const std::string path = folder.path().string() + "/";
    for (std::size_t at = text.find(path); at != std::string::npos; at = text.find(path))
      text.erase(at, path.size());
    return text;
  }

  Folder folder;
};

std::vector<double> areas(const std::vector<sweep::Curve2>& outlines) {
  std::vector<double> areas;
  areas.reserve(outlines.size());
  for (const sweep::Curve2& outline : outlines) areas.push_back(area(outline));
  return areas;
}

void expect_areas(const std::vector<sweep::Curve2>& outlines, const std::vector<double>& expected) {
  const std::vector<double> found = areas(outlines);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-12) << i;
}

const char* const kRing = R"(<svg viewBox="0 0 10 10"><path id="ring" fill-rule="evenodd"
    d="M0 0H4V4H0zM1 1H3V3H1z"/><circle id="dot" cx="8" cy="8" r="1"/>
    <path id="wire" fill="none" d="M0 0L3 4"/></svg>)";

TEST_F(CurveFile, SvgFilesAreFoundBesideTheSceneAndScaled) {
  folder.write("ring.svg", kRing);
  expect_areas(contour(R"({"svg": "ring.svg", "id": "ring"})"), {16, -4});
  expect_areas(contour(R"({"svg": "ring.svg", "id": "ring", "scale": 0.5})"), {4, -1});
  expect_areas(contour(R"({"svg": "ring.svg", "id": "dot", "scale": 0.1})"), {0.01 * pi});
  const std::vector<sweep::Curve2> wire = contour(R"({"svg": "ring.svg", "id": "wire"})");
  ASSERT_EQ(wire.size(), 1);
  expect_points(controls(wire[0].segments()), {{0, 0}, {3, -4}});
}

TEST_F(CurveFile, AFilledOpenSubpathClosesAndAnUnfilledOneStaysOpen) {
  folder.write("a.svg", R"(<svg><path id="f" d="M0 0H2V2"/><path id="n" fill="none" d="M0 0H2V2"/></svg>)");
  EXPECT_TRUE(contour(R"({"svg": "a.svg", "id": "f"})")[0].is_closed());
  EXPECT_FALSE(contour(R"({"svg": "a.svg", "id": "n"})")[0].is_closed());
  EXPECT_TRUE(contour(R"({"path": "M0 0H2V2z"})")[0].is_closed());
  EXPECT_TRUE(contour(R"({"path": "M0 0H2V2H0V0"})")[0].is_closed());
  EXPECT_FALSE(contour(R"({"path": "M0 0H2V2"})")[0].is_closed());
}

TEST_F(CurveFile, PathsAreScaledAndRunUpwards) {
  const auto outlines = contour(R"({"path": "M1 2L3 5", "scale": 0.5})");
  ASSERT_EQ(outlines.size(), 1);
  expect_points(controls(outlines[0].segments()), {{0.5, -1}, {1.5, -2.5}});
  expect_areas(contour(R"({"path": "M0 0H4V4H0zM1 1V3H3V1z"})"), {16, -4});
  expect_areas(contour(R"({"path": "M0 0H4V4H0V0M1 1V3H3V1H1"})"), {16, -4});
}

TEST_F(CurveFile, ATrajectoryLiesInTheXYPlaneAsItIsDrawn) {
  const sweep::Curve3 arc = trajectory(R"({"path": "M1 0A1 1 0 0 0 0-1", "scale": 2})");
  EXPECT_FALSE(arc.is_closed());
  EXPECT_NEAR(arc.length(), pi, 1e-9 * pi);  // the curve's promise
  for (int i = 0; i <= 8; ++i) {
    const double a = pi / 2 * i / 8;
    const glm::dvec3 at = arc.evaluate(arc.locate(arc.length() * i / 8)).position;
    EXPECT_NEAR(glm::distance(at, glm::dvec3(2 * std::cos(a), 2 * std::sin(a), 0)), 0, 1e-8);
  }
  folder.write("ring.svg", kRing);
  EXPECT_NEAR(trajectory(R"({"svg": "ring.svg", "id": "wire"})").length(), 5, 5e-9);
  EXPECT_NEAR(trajectory(R"({"svg": "ring.svg", "id": "dot"})").length(), 2 * pi, 1e-8);
  EXPECT_TRUE(trajectory(R"({"svg": "ring.svg", "id": "dot"})").is_closed());
}

TEST_F(CurveFile, PointsAreJoinedByLinesOrSmoothly) {
  folder.write("p.csv", "x,y\n0,0\n4,0\n4,3\n");
  folder.write("ring.dat", "RING\n0 0\n4 0\n4 3\n0 0\n");
  folder.write("p.xyz", "0 0 0\n1 2 3\n4 5 7\n");
  const auto open = contour(R"({"csv": "p.csv"})");
  expect_points(controls(open.at(0).segments()), {{0, 0}, {4, 0}, {4, 3}});
  EXPECT_FALSE(open[0].is_closed());
  expect_areas(contour(R"({"csv": "p.csv", "closed": true})"), {6});
  const auto coinciding = contour(R"({"csv": "ring.dat"})");
  EXPECT_TRUE(coinciding[0].is_closed());
  EXPECT_EQ(coinciding[0].segments().size(), 3);
  EXPECT_EQ(contour(R"({"csv": "ring.dat", "closed": true})")[0].segments().size(), 3);

  const sweep::Curve3 smooth = trajectory(R"({"csv": "p.xyz", "smooth": true})");
  const sweep::Curve3 expected = sweep::free_curve<3>({{0, 0, 0}, {1, 2, 3}, {4, 5, 7}}, false);
  EXPECT_EQ(smooth.length(), expected.length());
  EXPECT_FALSE(smooth.is_corner(1));
  EXPECT_TRUE(trajectory(R"({"csv": "p.xyz"})").is_corner(1));
  EXPECT_EQ(trajectory(R"({"csv": "p.csv"})").evaluate({1, 1}).position, glm::dvec3(4, 3, 0));
}

TEST_F(CurveFile, OutlinesWithHolesBecomeOneSolid) {
  folder.write("ring.svg", kRing);
  const Document document = parse(R"({"svg": "ring.svg", "id": "ring"})");
  const Model model = build(document, plan(document, Request{}));
  const sweep::Mesh& mesh = *model.meshes.at(0);
  double volume = 0;
  const auto positions = mesh.positions();
  for (const auto& triangle : mesh.triangles) {
    const glm::dvec3 a(positions[triangle[0]]), b(positions[triangle[1]]), c(positions[triangle[2]]);
    volume += glm::dot(a, glm::cross(b, c)) / 6;
  }
  // (16 - 4) m^2 along 2 m, positions in float32.
  EXPECT_NEAR(volume, 24, 24 * 1e-6);
}

TEST_F(CurveFile, FaultsNameTheSceneAndThePlaceInTheCurvesFile) {
  folder.write("ring.svg", kRing);
  folder.write("bad.svg", "<svg>\n<path d='M0 0L1'/></svg>");
  folder.write("bad.csv", "0 0\n1 x\n");
  folder.write("xyz.csv", "0 0 0\n1 1 1\n");
  folder.write("still.csv", "1 1\n1 1\n");
  folder.write("wires.svg", "<svg><line x2='1'/><line y2='1'/></svg>");
  std::filesystem::create_directory(folder.path() / "sub");
  struct Case {
    std::string curve, pointer, message;
  };
  const std::vector<Case> cases = {
      {R"({"svg": ""})", "svg", "needs a file's name, got \"\""},
      {R"({"svg": "none.svg"})", "svg", "none.svg: no such file"},
      {R"({"svg": "sub"})", "svg", "sub: is a folder, not an SVG file"},
      {R"({"csv": "none.csv"})", "csv", "none.csv: no such file"},
      {R"({"csv": "sub"})", "csv", "sub: is a folder, not a list of points"},
      {R"({"svg": "bad.svg"})", "svg",
       "bad.svg:2:1: <path>: \"d\" ends at offset 6 where a number (an arc's radii without a sign) or one of "
       "M L H V "
       "C S Q T A Z is missing"},
      {R"({"svg": "ring.svg", "id": "rung"})", "svg",
       "ring.svg:1:1: <svg>: there is no element \"rung\"; did you mean \"ring\"?"},
      {R"({"svg": "ring.svg", "scale": 1e9})", "svg",
       "ring.svg: reaches farther than 1e+09 m from the origin; lower \"scale\""},
      {R"({"path": "M0 0L1e-3 0", "scale": 1e-9})", "path",
       "has no outline of at least 1e-09 m; raise \"scale\""},
      {R"({"path": "M0 0L1 0L0 0z"})", "path",
       "has no outline that bounds an area; a contour needs a filled shape, or a line drawn with "
       "fill=\"none\""},
      {R"({"path": ""})", "path",
       "has no outline that bounds an area; a contour needs a filled shape, or a line drawn with "
       "fill=\"none\""},
      {R"({"path": "M0 0L1"})", "path",
       "ends at offset 6 where a number (an arc's radii without a sign) or one of M L H V C S Q T A Z is "
       "missing"},
      {R"({"csv": "bad.csv"})", "csv",
       "bad.csv:2:3: needs a number, got \"x\"; put # before what is no point"},
      {R"({"csv": "xyz.csv"})", "csv", "xyz.csv: has 3 columns, and a contour is plane; leave z out"},
      {R"({"csv": "still.csv"})", "csv",
       "still.csv: has no length: its points are within 1e-09 m of each other"},
  };
  for (const auto& [curve, pointer, message] : cases) {
    const std::string told = fault(curve);
    EXPECT_TRUE(told.starts_with("s.json:1:") &&
                told.ends_with("/objects/0/sweep/contour/" + pointer + ": " + message))
        << curve << "\n " << told;
  }
  EXPECT_TRUE(
      trajectory_fault(R"({"svg": "wires.svg"})")
          .ends_with("wires.svg: has 2 outlines, and a trajectory is one; choose or draw a single path"))
      << trajectory_fault(R"({"svg": "wires.svg"})");
  EXPECT_TRUE(trajectory_fault(R"({"path": "M0 0h1m1 1h1"})")
                  .ends_with("has 2 outlines, and a trajectory is one; choose or draw a single path"));
}

TEST_F(CurveFile, KeysThatBelongToAnotherKindAreUnknown) {
  for (const char* curve :
       {R"({"path": "M0 0h1", "id": "a"})", R"({"path": "M0 0h1", "closed": true})",
        R"({"csv": "p.csv", "scale": 2})", R"({"polyline": [[0,0],[1,1]], "smooth": true})"}) {
    EXPECT_NE(fault(curve).find("unknown key"), std::string::npos) << curve;
  }
  EXPECT_NE(fault(R"({"path": "M0 0h1", "scale": 0})").find("/scale: "), std::string::npos);
}

TEST_F(CurveFile, FilesOverTheirLimitAreRefusedUnread) {
  folder.write("large.svg", std::string((std::size_t{16} << 20) + 1, ' '));
  EXPECT_TRUE(
      fault(R"({"svg": "large.svg"})").ends_with("large.svg: is over 16 MiB, too large for an SVG file"))
      << fault(R"({"svg": "large.svg"})");
}

}  // namespace
}  // namespace sweepkit::scene
