// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Scenes, SVG files, lists of points and mesh files, spoiled at random: each is read or refused with an
// InputError of one line, and soon. Every round draws from its own seed, so that one that fails can be had
// again alone:
//   SWEEPKIT_FUZZ_FIRST=<round> SWEEPKIT_FUZZ_ROUNDS=1 test_scene_fuzz
// SWEEPKIT_FUZZ_SECONDS=<seconds> makes each test go on so long.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <random>

#include "outline_measures.hpp"
#include "read_curve_file.hpp"
#include "scene_text.hpp"
#include "sweepkit/scene/check.hpp"
#include "sweepkit/scene/mesh_file.hpp"
#include "sweepkit/scene/model.hpp"

namespace sweepkit::scene {
namespace {

using Random = std::mt19937_64;

// Some ten seconds in the release build.
constexpr int kRounds = 30'000;

// Of the processor, a round. What the readers allow themselves is a second or two; the sanitizers' build
// takes several times that.
constexpr double kMostSeconds = 20;

int from_environment(const char* name, int otherwise) {
  const char* given = std::getenv(name);
  return given != nullptr ? std::atoi(given) : otherwise;
}

std::size_t below(Random& random, std::size_t count) {
  return static_cast<std::size_t>(random() % count);
}

template <class List>
const auto& any_of(Random& random, const List& list) {
  return list[below(random, std::size(list))];
}

const std::vector<std::string> kScenes = {
    R"({"sweepkit": 1, "camera": {"eye": [0,1,5], "target": [0,0,0], "fov_deg": 40, "width": 64, "height": 64},
 "lights": [{"point": [1,2,3], "intensity": [1,1,1]}, {"directional": [0,-1,0], "intensity": [1,1,1]}],
 "textures": {"t": {"procedural": "checker", "scale": 2}},
 "materials": {"m": {"diffuse": [0.5,0.5,0.5], "texture": "t", "shininess": 9}},
 "objects": [{"name": "a", "material": "m", "translate": [1,2,3], "rotate_deg": [0,90,0], "scale": 2,
  "tessellation": {"contour": 8, "trajectory": 8}, "uv": {"by": "arc-length", "repeat": [2,1]}, "crease_deg": 30,
  "sweep": {"contour": {"circle": {"radius": 1}}, "trajectory": {"helix": {"radius": 3, "pitch": 1, "turns": 4}},
   "profile": {"points": [[0,1],[0.5,2],[1,1]]}, "twist_deg": 90, "caps": "flat", "joints": "round"}}]})",
    R"({"sweepkit": 1, "objects": [{"name": "a", "parts": [
  {"sweep": {"contour": {"star": {"points": 5, "radius": 1, "inner_radius": 0.5}},
   "trajectory": {"free": [[0,0,0],[0,1,0],[1,2,1]], "closed": true}, "frames": "fixed-up", "up": [0,1,0]}},
  {"revolve": {"contour": {"beziers": [[[1,0],[2,1],[1,2]],[[1,2],[0,3]]]}, "angle_deg": 270}},
  {"sweep": {"contour": {"rectangle": {"width": 2, "height": 1, "corner_radius": 0.2}},
   "trajectory": {"torus_knot": {"p": 2, "q": 3, "radius": 2, "tube": 1}}, "guide": {"line": [[0,0,0],[0,9,0]]}}},
  {"plane": {"size": [1,2]}}]}]})",
    R"({"sweepkit": 1, "objects": [
 {"name": "a", "revolve": {"contour": {"path": "M1 0C2 0 2-1 1-1S1-3 2-3Q3-4 2-5T1-7A1 2 30 1 0 2-9h1v-1z", "scale": 0.5}}},
 {"name": "b", "sweep": {"contour": {"svg": "seed.svg", "id": "r", "scale": 2}, "trajectory": {"csv": "seed.csv", "smooth": true}}},
 {"name": "c", "sweep": {"contour": {"csv": "seed.dat", "closed": true}, "trajectory": {"path": "M0 0a1 2 3 0 1 4 5l6 7"}}},
 {"name": "d", "sweep": {"contour": {"polygon": {"sides": 6, "radius": 1}},
  "trajectory": {"arc": {"radius": 3, "from_deg": 0, "to_deg": 180}}, "profile": {"x": 1, "y": {"bezier": [[0,1],[1,2]]}}}}]})"};

const std::vector<std::string> kDrawings = {
    R"svg(<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="50mm" viewBox="0 0 100 50" preserveAspectRatio="xMidYMid slice">
<defs><symbol id="s" viewBox="0 0 10 10"><rect width="10" height="10" rx="2"/></symbol><circle id="c" r="3"/></defs>
<g transform="translate(10 20) rotate(30, 5 5) scale(2 -1) skewX(10)" fill-rule="evenodd">
<path id="r" d="M0 0H40V40H0zM10 10H30V30H10z"/><ellipse cx="50%" cy="25" rx="10" ry="5in"/></g>
<use href="#s" x="5" width="30" height="20"/><use xlink:href="#c" transform="matrix(1 2 3 4 5 6)"/>
<svg x="10" y="10" width="50%" height="20" viewBox="0 0 5 5"><polygon id="w" points="0,0 5,0 5,5"/></svg></svg>)svg",
    R"svg(<svg viewBox="-5 -5 10 10"><path fill="none" style="stroke:#000" d="m1 1c1 2 3 4 5 6s7 8 9 10q1 2 3 4t5 6 7 8a5 3 20 0 1 4 4 2 2 0 1 0-3 1z"/>
<polyline id="w" points="0,0 1,1 2,0"/><line x1="1" y1="2" x2="3" y2="4"/><g display="none"><rect width="1" height="1"/></g></svg>)svg",
    R"svg(<svg><g><g><g><path id="w" d="M.5.5-.5-.5l1e1-1E-1+2 3e0A1 1 0 011 1z"/></g></g></g><circle r="5"/><circle r="4"/><circle r="3"/></svg>)svg"};

const std::vector<std::string> kPoints = {
    "x,y,z\n0,0,0\n1,0,0.5\n1,1,1\n0,1,1.5\n",
    "NACA 0006\n 1.0 0.00063\n 0.5 0.02647\n 0.0 0.0\n 0.5 -0.02647\n 1.0 -0.00063\n",
    "# ring\n0;0\n4;0\n4;3\n0;0\n", "0 0\t1\r\n1e3 -2.5E-3 +4\r\n.5 5. 6\r\n"};

const std::vector<std::string> kMeshes = {
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nf 1/1/1 2/2/1 3/3/1\nf -4/1/1 "
    "-2/2/1 -1/3/1\n",
    "# net\nv 0 0 0 1\nv 2 0 0\nv 1 2 0\nv 1 1 2\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n",
    "STCNOFF\n4 2 4\n0 0 0 0 0 1 1 0 0 0 0\n1 0 0 0 0 1 1 0 0 1 0\n1 1 0 0 0 1 1 0 0 1 1\n0 1 0 0 0 1 1 0 0 "
    "0 1\n3 0 1 2\n3 0 2 3 1 0 0\n",
    "ply\nformat ascii 1.0\ncomment c\nelement vertex 4\nproperty float x\nproperty double y\nproperty int "
    "z\nproperty float s\n"
    "property float t\nelement face 2\nproperty list uchar int vertex_indices\nproperty list uchar float "
    "texcoord\nend_header\n"
    "0 0 0 0 0\n1 0 0 1 0\n1 1 0 1 1\n0 1 0 0 1\n3 0 1 2 6 0 0 1 0 1 1\n4 0 1 2 3 0\n",
    std::string("ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty char x\nproperty uchar "
                "y\nproperty short z\n"
                "element face 1\nproperty list uchar uchar "
                "vertex_index\nend_header\n\0\0\0\0\1\0\0\0\0\1\0\0\3\0\1\2",
                172),
    "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
    "0\nendloop\nendfacet\nendsolid s\n",
    std::string(80, ' ') + std::string("\1\0\0\0", 4) + std::string(14, '\0') +
        std::string("\x80?\0\0\0\0\0\0", 8) + std::string(28, '?')};

const std::vector<std::string> kTame = {"0", "1", "2", "3.5", "0.25", "-1", "7", "1e1", "45", "-0.5"};
const std::vector<std::string> kNumbers = {"0",
                                           "-0",
                                           "1",
                                           "-1",
                                           "2",
                                           "64",
                                           "0.1",
                                           "1e-9",
                                           "1e-10",
                                           "1e9",
                                           "1e10",
                                           "-1e9",
                                           "1e100",
                                           "1e-100",
                                           "1e154",
                                           "1e200",
                                           "1e308",
                                           "1e309",
                                           "-1e999",
                                           "1e-320",
                                           "1e-999",
                                           "nan",
                                           "inf",
                                           "1e99999999999999999999",
                                           "4294967296",
                                           "2147483647",
                                           "-2147483648",
                                           "18446744073709551616",
                                           "0.1234567890123456789",
                                           "00",
                                           ".",
                                           "-",
                                           "+",
                                           "1.",
                                           ".5.5",
                                           "1e",
                                           "99999999999999999999999999999999999999999999999999",
                                           "360",
                                           "1e6",
                                           "89.99999999999999"};

const std::vector<std::string> kWords = {"{",
                                         "}",
                                         "[",
                                         "]",
                                         "\"",
                                         ",",
                                         ":",
                                         "<",
                                         ">",
                                         "/>",
                                         "&",
                                         "&lt;",
                                         "&#0;",
                                         "<!--",
                                         "]]>",
                                         "\n",
                                         "\r",
                                         "\0x",
                                         "\xFF",
                                         "#",
                                         ";",
                                         "%",
                                         "M",
                                         "z",
                                         "A",
                                         "a1 1 0 01",
                                         "Q",
                                         "T",
                                         "S",
                                         "null",
                                         "true",
                                         "\"closed\": true,",
                                         "\"scale\": 1e-9,",
                                         "\"id\": \"c\",",
                                         "<g>",
                                         "</g>",
                                         "<use href=\"#s\"/>",
                                         "<use href=\"#c\"/>",
                                         "<circle r=\"1\"/>",
                                         " id=\"c\" ",
                                         " transform=\"scale(0)\" ",
                                         " transform=\"rotate(1e300)\" ",
                                         " transform=\"scale(1e200)\" ",
                                         " fill=\"none\" ",
                                         " visibility=\"hidden\" ",
                                         " r=\"1em\" ",
                                         "seed.csv",
                                         "seed.svg"};

// The place of a number in the text and its length, from somewhere on; length 0 where there is none.
std::pair<std::size_t, std::size_t> find_number(const std::string& text, std::size_t from) {
  constexpr const char* kStarts = "0123456789";
  const std::size_t start = text.find_first_of(kStarts, from);
  if (start == std::string::npos) return {0, 0};
  const std::size_t end = std::min(text.find_first_not_of("0123456789.eE+-", start), text.size());
  return {start, end - start};
}

void spoil(Random& random, const std::vector<std::string>& corpus, std::string& text) {
  const std::size_t at = below(random, text.size() + 1);
  switch (below(random, 10)) {
    case 0:  // flip a bit
      if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << below(random, 8)));
      return;
    case 1:  // cut the rest off
      if (below(random, 4) == 0) text.resize(at);
      return;
    case 2:  // leave a stretch out
      text.erase(at, below(random, 20));
      return;
    case 3:  // say a stretch again, elsewhere
      text.insert(below(random, text.size() + 1), text.substr(at, below(random, 60)));
      return;
    case 4: {  // the start of one and the end of another
      const std::string& other = any_of(random, corpus);
      text = text.substr(0, at) + other.substr(below(random, other.size()));
      return;
    }
    case 5:
      text.insert(at, any_of(random, kWords));
      return;
    case 6: {  // nest deep, or repeat often
      if (below(random, 8) != 0) return;
      const std::string word = any_of(random, kWords);
      const std::size_t times = std::size_t{1} << below(random, 12);
      std::string nest;
      for (std::size_t i = 0; i < times; ++i) nest += word;
      text.insert(at, nest);
      return;
    }
    default: {  // another number
      const auto [start, length] = find_number(text, at);
      if (length > 0) text.replace(start, length, any_of(random, below(random, 3) == 0 ? kNumbers : kTame));
      return;
    }
  }
}

std::string spoiled(Random& random, const std::vector<std::string>& corpus) {
  std::string text = any_of(random, corpus);
  const std::size_t times = 1 + below(random, 6) * below(random, 2) * below(random, 2);
  for (std::size_t i = 0; i < times; ++i) spoil(random, corpus, text);
  return text;
}

// Reads; an InputError of one line that says something is as good as success.
template <class Read>
void read_or_refuse(const Read& read, int& refused) {
  try {
    read();
  } catch (const InputError& error) {
    ++refused;
    EXPECT_FALSE(error.problem().empty());
    EXPECT_EQ(error.problem().find('\n'), std::string::npos) << error.what();
  }
}

class Fuzz : public testing::Test {
 protected:
  template <class Round>
  void run(const std::vector<std::string>& corpus, int share, const Round& round) {
    folder.write("seed.svg", kDrawings[0]);
    folder.write("seed.csv", kPoints[0]);
    folder.write("seed.dat", kPoints[1]);
    const int first = from_environment("SWEEPKIT_FUZZ_FIRST", 0);
    const int most_seconds = from_environment("SWEEPKIT_FUZZ_SECONDS", 0);
    const int most_rounds = most_seconds > 0 ? std::numeric_limits<int>::max() - first
                                             : from_environment("SWEEPKIT_FUZZ_ROUNDS", kRounds / share);
    const auto begin = std::chrono::steady_clock::now();
    const std::chrono::seconds time(most_seconds);
    int refused = 0;
    int rounds = 0;
    for (int i = first; rounds < most_rounds; ++i, ++rounds) {
      if (most_seconds > 0 && std::chrono::steady_clock::now() - begin > time) break;
      Random random(static_cast<std::uint64_t>(i));
      const std::string text = spoiled(random, corpus);
      const std::clock_t start = std::clock();
      ASSERT_NO_THROW(round(text, refused)) << "round " << i << " of:\n" << text;
      const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
      slowest = std::max(slowest, seconds);
      ASSERT_LT(seconds, kMostSeconds) << "round " << i << " of:\n" << text;
      ASSERT_FALSE(HasFailure()) << "round " << i << " of:\n" << text;
    }
    std::printf("%d rounds, %d readings refused, the slowest took %.0f ms\n", rounds, refused,
                1000 * slowest);
    RecordProperty("refused", refused);
    RecordProperty("slowest_ms", static_cast<int>(1000 * slowest));
    // Spoiled texts that all were refused, or none, would have tested half of the readers.
    if (rounds >= 1000) {
      EXPECT_GT(refused, rounds / 20);
      EXPECT_GT(rounds, refused / 2 + rounds / 20);
    }
  }

  Folder folder;
  double slowest = 0;
};

TEST_F(Fuzz, ScenesAreReadOrRefused) {
  run(kScenes, 4, [&](const std::string& text, int& refused) {
    read_or_refuse([&] { parse_document(text, folder.path() / "s.json"); }, refused);
  });
}

TEST_F(Fuzz, ObjectsAreMadeOrRefused) {
  run(kScenes, 12, [&](const std::string& text, int& refused) {
    read_or_refuse(
        [&] {
          Document document = parse_document(text, folder.path() / "s.json");
          for (ObjectEntry& object : document.objects) {
            for (Piece& piece : object.pieces) {
              // Small ones: what is looked for does not hide in a number of cells.
              piece.tessellation.contour = std::min(piece.tessellation.contour, 12);
              piece.tessellation.trajectory = std::min(piece.tessellation.trajectory, 12);
              if (piece.tessellation.tolerance)
                piece.tessellation.tolerance = std::max(*piece.tessellation.tolerance, 0.02);
            }
          }
          const Model model = build(document, plan(document, {.product = Request::Product::kMeshFile}));
          for (const auto& mesh : model.meshes) {
            for (const glm::vec3& p : mesh->positions())
              ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
            for (const glm::vec3& n : mesh->normals()) ASSERT_NEAR(glm::length(glm::dvec3(n)), 1, 1e-6);
          }
          check(document, model, Thoroughness::kQuick);
        },
        refused);
  });
}

// By every reader: the name decides, not what is inside. What is read becomes an object.
TEST_F(Fuzz, MeshFilesAreReadOrRefused) {
  run(kMeshes, 4, [&](const std::string& text, int& refused) {
    for (const char* name : {"spoiled.obj", "spoiled.ply", "spoiled.stl", "spoiled.off"}) {
      read_or_refuse([&] { parse_mesh_file(text, name); }, refused);
    }
    // One of the four at most is the format that the text was.
    refused -= 3;
    const char* kind = text.starts_with("ply") ? ".ply" : text.find("OFF") < 8 ? ".off" : ".obj";
    folder.write(std::string("spoiled") + kind, text);
    const std::string scene =
        scene_text("", R"({"name": "a", "mesh": {"file": "spoiled)" + std::string(kind) + R"("}})");
    int again = 0;
    read_or_refuse(
        [&] {
          const Document document = parse_document(scene, folder.path() / "s.json");
          const Model model = build(
              document, plan(document, {.product = Request::Product::kMeshFile, .has_half_edges = true}));
          for (const glm::vec3& p : model.meshes[0]->positions())
            ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
          for (const glm::vec2& uv : model.meshes[0]->texcoords())
            ASSERT_TRUE(std::isfinite(uv.x) && std::isfinite(uv.y));
          for (const glm::vec3& n : model.meshes[0]->normals())
            ASSERT_NEAR(glm::length(glm::dvec3(n)), 1, 1e-6);
          check(document, model, Thoroughness::kQuick);
        },
        again);
  });
}

TEST_F(Fuzz, DrawingsAreReadOrRefused) {
  run(kDrawings, 2, [&](const std::string& text, int& refused) {
    const std::filesystem::path file = folder.write("spoiled.svg", text);
    read_or_refuse([&] { EXPECT_FALSE(contour_of(SvgCurve{.file = file}).empty()); }, refused);
    read_or_refuse([&] { trajectory_of(SvgCurve{.file = file, .id = "w", .scale = 0.5}); }, refused);
  });
}

TEST_F(Fuzz, ListsOfPointsAreReadOrRefused) {
  run(kPoints, 4, [&](const std::string& text, int& refused) {
    const std::filesystem::path file = folder.write("spoiled.csv", text);
    read_or_refuse([&] { contour_of(PointCurve{.file = file, .is_smooth = true}); }, refused);
    read_or_refuse([&] { trajectory_of(PointCurve{.file = file, .is_closed = true}); }, refused);
  });
}

}  // namespace
}  // namespace sweepkit::scene
