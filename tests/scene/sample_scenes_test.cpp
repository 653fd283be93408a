// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// The objects of samples/scenes against closed forms. What a mesh within d of a surface of area A encloses
// is off by A d at most, which is the bound on every volume here.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <numbers>
#include <string>

#include "../sweep/mesh_measures.hpp"
#include "../sweep/surface_distance.hpp"
#include "sweepkit/scene/check.hpp"
#include "sweepkit/scene/document.hpp"
#include "sweepkit/scene/model.hpp"

namespace sweepkit::scene {
namespace {

using sweep::test::measure;
using sweep::test::Measures;

constexpr double kPi = std::numbers::pi;

// The n-th object of a sample with other settings than the file's.
struct Sample {
  std::string file;
  std::size_t object = 1;  // the first is the table

  ObjectEntry read(const std::vector<Setting>& settings = {}) const {
    return read_document(std::string(SWEEPKIT_SAMPLES) + "/scenes/" + file + ".json", settings)
        .objects.at(object);
  }
  static std::unique_ptr<const sweep::Mesh> make(const ObjectEntry& object) {
    Document document;
    document.objects = {object};
    document.objects[0].material.reset();
    return std::move(build(document, plan(document, {.product = Request::Product::kMeshFile})).meshes.at(0));
  }
};

ObjectEntry with_tolerance(ObjectEntry object, double tolerance) {
  for (Piece& piece : object.pieces) piece.tessellation.tolerance = tolerance;
  return object;
}
ObjectEntry with_counts(ObjectEntry object, int contour, int trajectory) {
  for (Piece& piece : object.pieces) {
    // A piece of few cells on purpose, such as a box, is left as it is.
    piece.tessellation = {contour, trajectory};
  }
  return object;
}

const SweepShape& sweep_of(const ObjectEntry& object, std::size_t piece = 0) {
  return std::get<SweepShape>(object.pieces.at(piece).shape);
}
const RevolveShape& revolve_of(const ObjectEntry& object, std::size_t piece = 0) {
  return std::get<RevolveShape>(object.pieces.at(piece).shape);
}

// The integral of f(p) dy, or of f(p) dx, along a contour by midpoints; more than these the polygons of
// 200,000 points do not show.
double along(const sweep::Curve2& contour, const std::function<double(const glm::dvec2&)>& f) {
  constexpr int kPoints = 200000;
  double sum = 0;
  glm::dvec2 before = contour.evaluate({0, 0}).position;
  for (int i = 1; i <= kPoints; ++i) {
    const double length = contour.length() * i / kPoints;
    const glm::dvec2 here = contour.evaluate(contour.locate(length)).position;
    sum += f(0.5 * (before + here)) * (here.y - before.y);
    before = here;
  }
  return sum;
}
double area_of(const sweep::Curve2& closed) {
  return along(closed, [](const glm::dvec2& p) { return p.x; });
}
// A contour from the axis round to the axis, turned.
double turned_volume(const sweep::Curve2& contour) {
  return along(contour, [](const glm::dvec2& p) { return kPi * p.x * p.x; });
}

// The integral of f over [0, 1] by Simpson's rule.
double integral(const std::function<double(double)>& f) {
  constexpr int kCells = 20000;
  double sum = f(0) + f(1);
  for (int i = 1; i < kCells; ++i) sum += (i % 2 == 1 ? 4 : 2) * f(static_cast<double>(i) / kCells);
  return sum / (3.0 * kCells);
}

struct Expected {
  Sample sample;
  long euler;
  std::function<double(const ObjectEntry&)> volume;
  /// Free curves, bends and joined Beziers are smooth, but their curvature jumps: a section that turns has
  /// two normals there, an edge too flat to see, and differences across it tell neither.
  bool has_curvature_jumps = false;
};

double knot_length() {
  return integral([](double t) {
    const double s = 2 * kPi * t;
    const double ring = 0.36 + 0.17 * std::cos(3 * s);
    // ((R + r cos 3s) cos 2s, r sin 3s, -(R + r cos 3s) sin 2s) by s.
    return 2 * kPi * std::sqrt(std::pow(3 * 0.17, 2) + 4 * ring * ring);
  });
}

double frame_volume(const ObjectEntry& object) {
  const sweep::Curve2& moulding = sweep_of(object).contour.front();
  const double area = area_of(moulding);
  // Pappus on the four mitred legs: each is as long as its rectangle through the section's centroid.
  const double outwards = along(moulding, [](const glm::dvec2& p) { return p.x * p.x / 2; }) / area;
  return std::abs(area) * (2 * (0.92 + 0.64) + 8 * outwards);
}

double pipe_volume(const ObjectEntry&) {
  const double legs = 0.75 + 0.53 + 0.72 + 0.38 + 0.6 + 0.5 + 0.32;
  const double bend = 2 * 0.045;  // its radius; an arc instead of two stretches as long
  return kPi * (0.045 * 0.045 - 0.036 * 0.036) * (legs - 6 * (2 - kPi / 2) * bend);
}

double column_volume(const ObjectEntry& object) {
  const SweepShape& shaft = sweep_of(object, 0);
  const double swell = integral([&](double t) { return std::pow(shaft.profile.x.at(t).value, 2); });
  return std::abs(area_of(shaft.contour.front())) * 1.6 * swell +
         turned_volume(revolve_of(object, 1).contour.front()) +
         turned_volume(revolve_of(object, 2).contour.front()) + 0.56 * 0.56 * 0.07;
}

double shell_volume(const ObjectEntry& object) {
  const SweepShape& shape = sweep_of(object);
  const double q = shape.profile.x.at(0).value;
  const double area = std::abs(area_of(shape.contour.front()));
  return area * shape.trajectory.length() * (1 + q + q * q) / 3;
}

std::vector<Expected> samples() {
  return {
      {{"spring"},
       2,
       [](const ObjectEntry&) { return kPi * 0.024 * 0.024 * 6 * std::hypot(2 * kPi * 0.18, 0.078); }},
      {{"rope"},
       6,
       [](const ObjectEntry& o) { return 3 * kPi * 0.03 * 0.03 * sweep_of(o).trajectory.length(); },
       true},
      {{"seashell"}, 2, shell_volume, true},
      {{"moebius_band"},
       0,
       [](const ObjectEntry&) { return (0.24 * 0.016 - (4 - kPi) * 0.006 * 0.006) * 2 * kPi * 0.36; }},
      {{"trefoil_knot"}, 0, [](const ObjectEntry&) { return kPi * 0.075 * 0.075 * knot_length(); }},
      {{"picture_frame"}, 0, frame_volume},
      {{"pipe_run"}, 0, pipe_volume, true},
      {{"bottle"},
       2,
       [](const ObjectEntry& o) { return turned_volume(revolve_of(o).contour.front()); },
       true},
      {{"column"}, 8, column_volume},
  };
}

double size_of(const sweep::Mesh& mesh) {
  glm::vec3 low = mesh.positions()[0];
  glm::vec3 high = low;
  for (const glm::vec3& p : mesh.positions()) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return glm::length(glm::dvec3(high - low));
}

TEST(SampleScenes, EncloseWhatTheirClosedFormsSay) {
  for (const Expected& expected : samples()) {
    const ObjectEntry object = expected.sample.read();
    const double volume = expected.volume(object);
    for (const double tolerance : {1e-3, 2e-4}) {
      const auto mesh = Sample::make(with_tolerance(object, tolerance));
      const Measures m = measure(*mesh);
      ASSERT_TRUE(mesh->deviation) << expected.sample.file;
      EXPECT_NEAR(m.volume, volume, m.area * *mesh->deviation) << expected.sample.file;
    }
  }
}

TEST(SampleScenes, HaveNoFindings) {
  std::size_t scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(SWEEPKIT_SAMPLES) + "/scenes")) {
    // faults.json shows findings: tests/cli/check_test.cpp holds which.
    if (entry.path().extension() != ".json" || entry.path().stem() == "faults") continue;
    const Document document = read_document(entry.path());
    Plan shapes = plan(document, {.product = Request::Product::kMeshFile});
    std::fill(shapes.textures.begin(), shapes.textures.end(), false);
    for (const SceneFinding& found : check(document, build(document, shapes)))
      ADD_FAILURE() << entry.path() << ": " << found.object << ": " << found.finding.problem;
    for (const MaterialFinding& found : check_materials(document))
      ADD_FAILURE() << entry.path() << ": " << found.material << ": " << found.problem;
    ++scenes;
  }
  EXPECT_GE(scenes, 18u);
}

// A prismatoid with a profile has no closed form here, but its rows do: their polygons' areas by Simpson.
TEST(SampleScenes, TheMorphEnclosesWhatItsSectionsSayByHeight) {
  const ObjectEntry object = with_counts(Sample{"star_to_circle"}.read(), 1400, 200);
  const auto mesh = Sample::make(object);
  std::vector<double> areas(201, 0.0);
  for (const sweep::GridPatch& patch : mesh->patches) {
    if (patch.area != 0) continue;
    for (std::uint32_t row = 0; row <= patch.rows; ++row) {
      for (std::uint32_t i = 0; i < patch.columns; ++i) {
        const glm::dvec3 a = sweep::test::position(*mesh, patch.vertex(i, row));
        const glm::dvec3 b = sweep::test::position(*mesh, patch.vertex(i + 1, row));
        areas[row] += 0.5 * (a.z * b.x - a.x * b.z);
      }
    }
  }
  double volume = 0;
  for (std::size_t row = 0; row <= 200; ++row) {
    volume += (row == 0 || row == 200 ? 1 : row % 2 == 1 ? 4 : 2) * areas[row] * 0.7 / 600;
  }
  const double star = 7 * 0.22 * 0.13 * std::sin(kPi / 7);
  EXPECT_NEAR(areas.front(), 0.8 * 0.8 * star, 1e-6 * star);
  const double circle = kPi * 0.16 * 0.16;
  // A circle of 1,400 chords.
  EXPECT_NEAR(areas.back(), 0.86 * 0.86 * circle, 1e-5 * circle);
  const Measures m = measure(*mesh);
  // Between rows 3.5 mm apart the sides are straight; the profile bends by 20 a metre squared at most.
  EXPECT_NEAR(m.volume, volume, m.area * 20 * 0.22 * 0.0035 * 0.0035 / 8);
  EXPECT_EQ(m.euler, 2);
  EXPECT_EQ(m.open_edges, 0u);
}

TEST(SampleScenes, AreWatertightWithoutFlatTrianglesAndFaceOutwards) {
  for (const Expected& expected : samples()) {
    const auto mesh = Sample::make(expected.sample.read());
    const Measures m = measure(*mesh);
    EXPECT_EQ(m.open_edges, 0u) << expected.sample.file;
    EXPECT_EQ(m.euler, expected.euler) << expected.sample.file;
    EXPECT_GT(m.smallest_triangle, 0) << expected.sample.file;
    EXPECT_GT(m.volume, 0) << expected.sample.file;
    EXPECT_LT(m.worst_normal_length, 1e-6) << expected.sample.file;
  }
}

// Every piece of every object of a sample, but planes, as an object of its own.
std::vector<ObjectEntry> pieces_of(const std::string& file) {
  std::vector<ObjectEntry> pieces;
  for (const ObjectEntry& object :
       read_document(std::string(SWEEPKIT_SAMPLES) + "/scenes/" + file + ".json").objects) {
    for (const Piece& piece : object.pieces) {
      if (std::holds_alternative<PlaneShape>(piece.shape)) continue;
      pieces.push_back(object);
      pieces.back().name = object.name + ' ' + std::to_string(&piece - object.pieces.data());
      pieces.back().pieces = {piece};
    }
  }
  return pieces;
}

// The largest distance of places on the surface, `columns` x `rows` of them, from its mesh within share times
// its size, as a share of what was asked for.
double largest_share(const ObjectEntry& piece, double share, int columns, int rows) {
  const auto surface = Sample::make(with_counts(piece, columns, rows));
  const double tolerance = share * size_of(*surface);
  const auto mesh = Sample::make(with_tolerance(piece, tolerance));
  double largest = *mesh->deviation;
  std::uint32_t walls = 0;
  for (const sweep::GridPatch& patch : surface->patches) walls = std::max(walls, patch.area + 1);
  for (std::uint32_t wall = 0; wall < walls; ++wall)
    largest = std::max(largest, sweep::test::largest_distance(*surface, *mesh, wall));
  return largest / tolerance;
}

TEST(SampleScenes, StayWithinTheToleranceEverywhere) {
  int looked_at = 0;
  for (const char* file :
       {"bottle", "column", "frames", "joints", "moebius_band", "picture_frame", "pipe_run", "rope",
        "seashell", "spring", "star_to_circle", "trefoil_knot", "vase_and_cup"}) {
    for (const ObjectEntry& piece : pieces_of(file)) {
      ++looked_at;
      for (const double share : {1e-2, 1e-3, 1e-4})
        EXPECT_LE(largest_share(piece, share, 240, 701), 1) << file << ' ' << piece.name << ' ' << share;
    }
  }
  EXPECT_GT(looked_at, 20);
}

TEST(SampleScenes, StayWithinAMillionthToo) {
  for (const char* file : {"spring", "trefoil_knot", "bottle"}) {
    for (const ObjectEntry& piece : pieces_of(file))
      EXPECT_LE(largest_share(piece, 1e-6, 479, 1601), 1) << file;
  }
}

// One place of a grid patch by differences of the fifth point: of fourth order.
glm::dvec3 difference(const std::function<glm::dvec3(int)>& at) {
  return (at(-2) - at(2) + 8.0 * (at(1) - at(-1))) / 12.0;
}
// From one side, of second order.
glm::dvec3 difference_on(int side, const std::function<glm::dvec3(int)>& at) {
  return side * 0.5 * (4.0 * at(side) - 3.0 * at(0) - at(2 * side));
}

TEST(SampleScenes, HaveNormalsThatAgreeWithDifferencesOfPositions) {
  for (const Expected& expected : samples()) {
    const ObjectEntry object = expected.sample.read();
    const auto mesh = Sample::make(with_counts(object, 160, 1600));
    std::size_t compared = 0;
    std::size_t all = 0;
    std::size_t far_off = 0;
    double worst = 0;
    for (const sweep::GridPatch& patch : mesh->patches) {
      for (std::uint32_t row = 2; row + 2 < patch.rows + 1; ++row) {
        for (std::uint32_t column = 2; column + 2 < patch.columns + 1; ++column) {
          const auto across = [&](int k) {
            return sweep::test::position(*mesh, patch.vertex(column + static_cast<std::uint32_t>(k), row));
          };
          const auto ahead = [&](int k) {
            return sweep::test::position(*mesh, patch.vertex(column, row + static_cast<std::uint32_t>(k)));
          };
          ++all;
          const glm::dvec3 normal = glm::normalize(glm::cross(difference(across), difference(ahead)));
          // Where a curvature jumps, or cells change their size, differences from the sides disagree.
          bool is_smooth = true;
          for (const int u : {-1, 1}) {
            for (const int v : {-1, 1}) {
              const glm::dvec3 sided =
                  glm::normalize(glm::cross(difference_on(u, across), difference_on(v, ahead)));
              is_smooth = is_smooth && glm::length(normal - sided) < 2e-3;
            }
          }
          if (!is_smooth) continue;
          ++compared;
          const glm::dvec3 given(mesh->normals()[patch.vertex(column, row)]);
          const double off = glm::length(normal - given);
          if (off > 1e-4) ++far_off;
          worst = std::max(worst, off);
        }
      }
    }
    EXPECT_GT(compared, all / 2) << expected.sample.file;
    if (expected.has_curvature_jumps) {
      EXPECT_LT(far_off, compared / 18) << expected.sample.file;
      EXPECT_LT(worst, 1e-2) << expected.sample.file;
    } else {
      EXPECT_LT(worst, 1e-4) << expected.sample.file << " of " << compared << " compared";
    }
  }
}

}  // namespace
}  // namespace sweepkit::scene
