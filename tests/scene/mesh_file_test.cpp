// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/scene/mesh_file.hpp"

#include <gtest/gtest.h>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <algorithm>
#include <array>
#include <bit>

#include "cut_polygon.hpp"
#include "outline_measures.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/sweep/primitives.hpp"
#include "sweepkit/sweep/sweep.hpp"

namespace sweepkit::scene {
namespace {

// What reading these bytes ends in, or "".
std::string fault_of(const std::string& bytes, const std::string& name) {
  try {
    parse_mesh_file(bytes, name);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

template <class T>
void put(std::string& bytes, T value, bool is_big = false) {
  auto own = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if (is_big) std::reverse(own.begin(), own.end());
  bytes.append(own.data(), own.size());
}

// A square of two triangles as each format has it.
const std::string kObj = "# square\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
const std::string kOff = "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 255 0 0\n";
const std::string kPly =
    "ply\nformat ascii 1.0\ncomment square\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";
const std::string kStl =
    "solid square\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 "
    "0\nendloop\nendfacet\n"
    "facet normal nan nan nan\nouter loop\nvertex 0 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\n"
    "endsolid square\n";

std::string binary_stl() {
  std::string bytes = "solid, and binary all the same";
  bytes.resize(80, ' ');
  put<std::uint32_t>(bytes, 2);
  for (const auto& triangle :
       {std::array<float, 9>{0, 0, 0, 1, 0, 0, 1, 1, 0}, {0, 0, 0, 1, 1, 0, 0, 1, 0}}) {
    for (int k = 0; k < 3; ++k) put(bytes, 0.0f);
    for (const float value : triangle) put(bytes, value);
    put<std::uint16_t>(bytes, 0);
  }
  return bytes;
}

std::string binary_ply(bool is_big) {
  std::string bytes =
      std::string("ply\nformat ") + (is_big ? "binary_big_endian" : "binary_little_endian") +
      " 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
      "property uchar red\nproperty list uchar short scratch\nelement edge 1\nproperty int a\n"
      "element face 1\nproperty list uchar uint vertex_index\nend_header\n";
  for (const auto& p : {std::array{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 1.0, 0.0}, {0.0, 1.0, 0.0}}) {
    for (const double value : p) put(bytes, value, is_big);
    put<std::uint8_t>(bytes, 7);
    put<std::uint8_t>(bytes, 2);
    put<std::int16_t>(bytes, -1, is_big);
    put<std::int16_t>(bytes, 5, is_big);
  }
  put<std::int32_t>(bytes, 9, is_big);
  put<std::uint8_t>(bytes, 4);
  for (const std::uint32_t index : {0u, 1u, 2u, 3u}) put(bytes, index, is_big);
  return bytes;
}

struct Sound {
  std::string name, bytes, format;
};

std::vector<Sound> sound_files() {
  return {{"s.obj", kObj, "OBJ"},
          {"s.OFF", kOff, "OFF"},
          {"s.ply", kPly, "PLY, text"},
          {"s.stl", kStl, "STL, text"},
          {"s.stl", binary_stl(), "STL, binary"},
          {"s.ply", binary_ply(false), "PLY, binary"},
          {"s.ply", binary_ply(true), "PLY, binary"}};
}

TEST(MeshFile, EveryFormatTellsTheSameSquare) {
  for (const Sound& file : sound_files()) {
    const MeshFile mesh = parse_mesh_file(file.bytes, file.name);
    EXPECT_EQ(mesh.format, file.format);
    EXPECT_EQ(mesh.positions.size(), 4u) << file.format;
    ASSERT_EQ(mesh.triangles.size(), 2u) << file.format;
    EXPECT_TRUE(mesh.texcoords.empty());
    double area = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
      const glm::dvec3 cross =
          glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
      EXPECT_GT(cross.z, 0) << file.format;
      area += 0.5 * cross.z;
    }
    EXPECT_EQ(area, 1) << file.format;
  }
}

// Cut anywhere a file is refused, or what is left is a smaller mesh in a format that has no end mark.
TEST(MeshFile, EveryPrefixIsReadOrRefused) {
  for (const Sound& file : sound_files()) {
    for (std::size_t length = 0; length < file.bytes.size(); ++length) {
      const std::string prefix = file.bytes.substr(0, length);
      const std::string fault = fault_of(prefix, file.name);
      const bool is_refused = fault.starts_with(file.name + ":");
      EXPECT_TRUE(is_refused || fault.empty()) << fault;
      EXPECT_EQ(fault.find('\n'), std::string::npos);
      // Of text a last line may lose its colours, its line feed or a digit; binary has not a byte to spare.
      const bool is_binary = file.format.find("binary") != std::string::npos;
      EXPECT_TRUE(is_refused || !is_binary) << length;
    }
  }
}

TEST(MeshFile, ReadsTexcoordsAndNormalsAtCorners) {
  const MeshFile mesh = parse_mesh_file(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 0.5 0\nvt 0 0.25\nvn 0 0 2\nf 1/1/1 2/2/-1 -1/-1\nf 3/1 2/2 "
      "1/3\n",
      "a.obj");
  ASSERT_EQ(mesh.texcoords.size(), 2u);
  EXPECT_EQ(mesh.texcoords[0][1], glm::vec2(0.5f, 0));
  EXPECT_EQ(mesh.texcoords[0][2], glm::vec2(0, 0.25f));
  EXPECT_EQ(mesh.texcoords[1][2], glm::vec2(0, 0.25f));
  ASSERT_EQ(mesh.normals.size(), 2u);
  EXPECT_EQ(mesh.normals[0][0], glm::vec3(0, 0, 2));
  EXPECT_EQ(mesh.normals[0][2], glm::vec3(0));
}

TEST(MeshFile, ReadsTexcoordsOfPlyAndOff) {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  const MeshFile at_vertices = parse_mesh_file(
      head +
          "property float s\nproperty float t\nelement face 1\nproperty list uchar int vertex_indices\n"
          "end_header\n0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 0.5\n3 0 1 2\n",
      "a.ply");
  ASSERT_EQ(at_vertices.texcoords.size(), 1u);
  EXPECT_EQ(at_vertices.texcoords[0][2], glm::vec2(0, 0.5f));
  const MeshFile at_corners = parse_mesh_file(
      head +
          "element face 1\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n"
          "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 6 0 0 1 0 0 0.5\n",
      "a.ply");
  EXPECT_EQ(at_corners.texcoords, at_vertices.texcoords);
  const MeshFile off = parse_mesh_file(
      "STCNOFF\n3 1 3\n0 0 0 0 0 1 1 0 0 1 0 0\n1 0 0 0 0 1 1 0 0 1 1 0\n0 1 0 0 0 1 1 0 0 1 0 .5\n3 0 1 2\n",
      "a.off");
  EXPECT_EQ(off.texcoords, at_vertices.texcoords);
  EXPECT_EQ(off.normals[0][1], glm::vec3(0, 0, 1));
}

TEST(MeshFile, JoinsLinesAndPassesOverWhatTellsNothing) {
  const MeshFile mesh = parse_mesh_file(
      "mtllib /dev/zero\no thing\r\nv 0 0 0 1.0\nv 1 0 0 1 0 0\nv 0 1 0\nusemtl none\ns off\nl 1 2\nf 1 "
      "\\\n2 3\n",
      "a.obj");
  EXPECT_EQ(mesh.triangles.size(), 1u);
}

TEST(MeshFile, LeavesTrianglesOutWhoseCornersAreOnePlaceAndCountsThem) {
  const MeshFile mesh = parse_mesh_file("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 -0\nf 1 2 3\nf 1 4 2\n", "a.obj");
  EXPECT_EQ(mesh.positions.size(), 3u);
  EXPECT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.degenerate, 1u);
}

struct Fault {
  std::string name, bytes, message;
};

TEST(MeshFile, NamesEveryFaultWithItsPlace) {
  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const std::string ply = "ply\nformat ascii 1.0\n";
  const std::string ply3 = ply + "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string face = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  std::string nan_stl = binary_stl();
  for (std::size_t k = 0; k < 3; ++k) nan_stl[84 + 12 + k] = '\xFF';
  nan_stl[84 + 12 + 3] = '\x7F';
  std::string cut_stl = binary_stl().substr(0, 180);
  cut_stl[0] = 'x';
  for (const Fault& fault : std::vector<Fault>{
           {"a.obj", "", "is empty"},
           {"a.gltf", "x", "its name needs to end in .obj, .ply, .stl or .off"},
           {"a.obj", three, "has no faces"},
           {"a.obj", three + "f 1 2\n", "a.obj:4:5: a face needs at least 3 corners, got 2"},
           {"a.obj", three + "f 1 2 4\n", "a.obj:4:7: points at vertex 4, but there are 3 so far"},
           {"a.obj", three + "f 1 2 -4\n", "points at vertex -4"},
           {"a.obj", three + "f 0 1 2\n", "points at vertex 0"},
           {"a.obj", three + "f /1 2 3\n", "needs an index of vertex, got \"\""},
           {"a.obj", three + "f 1/1 2 3\n", "points at texture vertex 1, but there are 0"},
           {"a.obj", three + "f 1//1 2 3\n", "points at normal 1, but there are 0"},
           {"a.obj", three + "f 1 2 9999999999999999999999\n", "needs an index of vertex"},
           {"a.obj", "v 0 0 nan\n", "a.obj:1:7: needs a coordinate, got \"nan\""},
           {"a.obj", "v 0 0\n", "needs a coordinate here, and the line ends"},
           {"a.obj", "v 0 0 1e10\n", "at most 1e+09 from 0, got 1e10"},
           {"a.obj", three + "vt 0 0\nf 1/1 2 3\n", "gives (u,v) to 1 of its 3 corners"},
           {"a.obj", "v 0 0 0\nf 1 1 1\n", "no triangle with three corners at different places"},
           {"a.off", "COFF\n", "needs the counts"},
           {"a.off", "OFF\n999999 0 0\n", "a.off:2:1: says 999999 where the whole file has 15 bytes"},
           {"a.off", "OFF\n-1 0 0\n", "a whole number from 0"},
           {"a.off", "OFF\n4 1 0\n0 0 0\n", "is cut short: needs vertex 2 of 4"},
           {"a.off", "OFF\n3 1 0\n" + points + "3 0 1 3\n", "a.off:6:7: points at vertex 3, but there are 3"},
           {"a.off", "OFF BINARY\n", "is a binary OFF"},
           {"a.off", "4OFF\n", "other than 3 coordinates"},
           {"a.off", "OFX\n", "needs OFF in its first line, got \"OFX\""},
           {"a.off", "OFF\n3 1 0\n" + points + "1001 0\n", "from 0 to 1000"},
           {"a.ply", "plx\n", "is no PLY file"},
           {"a.ply", ply, "ends without end_header"},
           {"a.ply", ply + "element vertex 4000000000\n", "says 4000000000 where the whole file has"},
           {"a.ply", ply + "property float x\n", "needs an element before it"},
           {"a.ply", ply + "element vertex 1\nproperty real x\n", "a.ply:4:10: needs a type of number"},
           {"a.ply", ply + "end_header\n", "needs one element vertex, got 0"},
           {"a.ply", ply + "element vertex 1\nproperty float x\nend_header\n0\n",
            "needs properties x, y and z"},
           {"a.ply", "ply\nformat binary 1.0\n" + ply3.substr(ply.size()) + face, "needs the format ascii"},
           {"a.ply", ply3 + face + points + "3 0 1 3\n", "points at vertex 3, but there are 3 before it"},
           {"a.ply", ply3 + face + points + "3 0 1\n", "is cut short"},
           {"a.ply", ply3 + face + points + "2 0 1\n", "a face needs 3 to 1000 corners, got 2"},
           {"a.ply", ply3 + face + "0 0 inf\n", "needs a number, got \"inf\""},
           {"a.stl", "solid\nfacet\nouter loop\nvertex 0 0 0\n", "ends without endsolid"},
           {"a.stl", "solid\nvertex 0 0 0\n", "a.stl:2:1: a vertex needs a facet about it"},
           {"a.stl", "solid\nfacet\nendfacet\n", "a facet needs 3 vertices, got 0"},
           {"a.stl", "solid\nfaced\n", "needs a word of an STL file"},
           {"a.stl", "hello", "is no STL file"},
           {"a.stl", cut_stl, "says that it has 2 triangles"},
           {"a.stl", nan_stl, "triangle 1 has a coordinate of nan"},
       }) {
    const std::string got = fault_of(fault.bytes, fault.name);
    EXPECT_NE(got.find(fault.message), std::string::npos) << "got: " << got << "\nfor: " << fault.message;
    EXPECT_EQ(got.find('\n'), std::string::npos) << got;
  }
}

TEST(MeshFile, RefusesAFaceOfMoreCornersThanItCutsInTime) {
  std::string text;
  std::string face = "f";
  for (int i = 1; i <= 1001; ++i) {
    text +=
        std::string("v ").append(std::to_string(i)).append(" ").append(std::to_string(i % 7)).append(" 0\n");
    face.append(" ").append(std::to_string(i));
  }
  EXPECT_NE(fault_of(text + face + "\n", "a.obj").find("more than 1000 corners"), std::string::npos);
}

TEST(MeshFile, RefusesWhatCannotBeRead) {
  const Folder folder;
  EXPECT_THROW(read_mesh_file(folder.path() / "missing.obj"), InputError);
  EXPECT_THROW(read_mesh_file(folder.path() / "missing.xyz"), InputError);
  std::filesystem::create_directory(folder.path() / "d.obj");
  EXPECT_THROW(read_mesh_file(folder.path() / "d.obj"), InputError);
}

// A second implementation on both sides: OpenMesh writes a mesh of ours, OpenMesh and we read it again.
TEST(MeshFile, AgreesWithOpenMeshOnWhatOpenMeshWrites) {
  const Folder folder;
  omlog().disable();
  sweep::Mesh torus =
      sweep::sweep(sweep::circle_contour(0.2), sweep::circle_trajectory(1), {.tessellation = {12, 24}});
  for (const std::string name : {"t.obj", "t.off", "t.ply", "t.stl"}) {
    for (const bool is_binary : {false, true}) {
      // Its binary OFF is a format of its own, and of OBJ there is none.
      if (is_binary && (name == "t.obj" || name == "t.off")) continue;
      const std::string file = folder.path() / name;
      const auto kind = is_binary ? OpenMesh::IO::Options::Binary : OpenMesh::IO::Options::Default;
      ASSERT_TRUE(OpenMesh::IO::write_mesh(torus, file, kind, 9)) << name;
      OpenMesh::TriMesh_ArrayKernelT<> theirs;
      ASSERT_TRUE(OpenMesh::IO::read_mesh(theirs, file)) << name;
      const MeshFile ours = read_mesh_file(file);
      ASSERT_EQ(ours.triangles.size(), theirs.n_faces()) << name;
      for (const auto face : theirs.faces()) {
        std::size_t k = 0;
        for (const auto vertex : theirs.fv_range(face)) {
          const auto& p = theirs.point(vertex);
          const glm::dvec3 got = ours.positions[ours.triangles[static_cast<std::size_t>(face.idx())][k++]];
          EXPECT_EQ(glm::vec3(got), glm::vec3(p[0], p[1], p[2])) << name;
        }
      }
    }
  }
}

double area_of(std::span<const glm::dvec3> corners) {
  double area = 0;
  for (const auto& [a, b, c] : cut_polygon(corners)) {
    const double z = glm::cross(corners[b] - corners[a], corners[c] - corners[a]).z;
    EXPECT_GE(z, 0);
    area += 0.5 * z;
  }
  return area;
}

TEST(CutPolygon, KeepsInsideOfWhatIsNotConvex) {
  const std::vector<glm::dvec3> arrow = {{0, 0, 0}, {4, 2, 0}, {0, 4, 0}, {1, 2, 0}};
  EXPECT_DOUBLE_EQ(area_of(arrow), 6);
  std::vector<glm::dvec3> comb;  // 20 teeth, each a triangle of 1 x 2, on a bar of 20 x 1
  comb.push_back({0, 0, 0});
  comb.push_back({20, 0, 0});
  for (int i = 20; i > 0; --i) {
    comb.push_back({i, 1, 0});
    comb.push_back({i - 0.5, 3, 0});
  }
  comb.push_back({0, 1, 0});
  EXPECT_NEAR(area_of(comb), 20 + 20, 1e-12);
}

TEST(CutPolygon, CutsAQuadrilateralAlongItsShorterDiagonal) {
  const std::vector<glm::dvec3> kite = {{-3, 0, 0}, {0, -1, 0}, {3, 0, 0}, {0, 1, 0}};
  for (const auto& triangle : cut_polygon(kite)) {
    EXPECT_EQ(std::count(triangle.begin(), triangle.end(), 1u), 1);
    EXPECT_EQ(std::count(triangle.begin(), triangle.end(), 3u), 1);
  }
}

}  // namespace
}  // namespace sweepkit::scene
