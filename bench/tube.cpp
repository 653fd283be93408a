// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The same tube from sweepkit and from VTK's vtkTubeFilter, positions, normals, texture coordinates and
// triangles from both: a circle along a helix, VTK's helix given as points. One thread: VTK 9.1's filter
// knows no more. Every run makes its mesh anew in fresh memory and frees it in the time of the next one's
// start. VTK writes triangle strips and no half-edges.
//
// Usage: bench_tube [FILE.csv]

#include <malloc.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTubeFilter.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "harness.hpp"
#include "sweepkit/sweep/primitives.hpp"
#include "sweepkit/sweep/sweep.hpp"

namespace {

using namespace sweepkit;

constexpr double kRadius = 0.1;
constexpr double kHelixRadius = 1;
constexpr double kPitch = 0.4;
constexpr double kTurns = 10;

struct Size {
  const char* name;
  int sides;
  int cells;  // along the helix
};

vtkSmartPointer<vtkPolyData> helix_points(int cells) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(cells + 1);
  for (int i = 0; i <= cells; ++i) {
    const double t = static_cast<double>(i) / cells;
    const double angle = 2 * std::numbers::pi * kTurns * t;
    points->InsertNextPoint(kHelixRadius * std::cos(angle), kPitch * kTurns * t,
                            -kHelixRadius * std::sin(angle));
    lines->InsertCellPoint(i);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(lines);
  return data;
}

struct VtkTube {
  vtkSmartPointer<vtkPolyData> tube;

  void make(vtkPolyData* line, int sides) {
    vtkNew<vtkTubeFilter> filter;
    filter->SetInputData(line);
    filter->SetRadius(kRadius);
    filter->SetNumberOfSides(sides);
    filter->CappingOff();
    filter->SetGenerateTCoordsToNormalizedLength();
    filter->Update();
    tube = filter->GetOutput();
  }
  std::string wrong() const {
    if (tube->GetNumberOfPoints() == 0) return "no points";
    if (tube->GetPointData()->GetNormals() == nullptr) return "no normals";
    if (tube->GetPointData()->GetTCoords() == nullptr) return "no texture coordinates";
    for (vtkIdType i = 0; i < tube->GetNumberOfPoints(); i += 1009) {
      double p[3];
      tube->GetPoint(i, p);
      const double off = std::hypot(p[0], p[2]) - kHelixRadius;
      if (std::abs(off) > 1.1 * kRadius) return "a point off the tube";
    }
    return "";
  }
};

std::string wrong_with(const sweep::Mesh& mesh, const Size& size, bool has_half_edges) {
  if (mesh.triangles.size() != 2u * static_cast<unsigned>(size.sides) * static_cast<unsigned>(size.cells))
    return "another number of triangles";
  if ((mesh.n_faces() == mesh.triangles.size()) != has_half_edges) return "half-edges";
  for (std::size_t i = 0; i < mesh.n_vertices(); i += 1009) {
    const glm::dvec3 p = glm::dvec3(mesh.positions()[i]) + mesh.origin;
    if (std::abs(std::hypot(p.x, p.z) - kHelixRadius) > 1.1 * kRadius) return "a point off the tube";
  }
  return "";
}

int compare_tubes(const char* csv_name) {
  // What is freed goes back to the system, so that every run touches its memory for the first time.
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
  mallopt(M_TRIM_THRESHOLD, 1 << 20);
  const sweep::Curve2 contour = sweep::circle_contour(kRadius);
  const sweep::Curve3 trajectory = sweep::helix(kHelixRadius, kPitch, kTurns);
  std::vector<bench::Comparison> comparisons;
  for (const Size& size : {Size{"1e5", 50, 1000}, Size{"1e6", 100, 5000}, Size{"1e7", 250, 20000}}) {
    const vtkSmartPointer<vtkPolyData> line = helix_points(size.cells);
    VtkTube vtk;
    std::unique_ptr<sweep::Mesh> plain;
    std::unique_ptr<sweep::Mesh> whole;
    const auto make = [&](bool has_half_edges) {
      return std::unique_ptr<sweep::Mesh>(
          new sweep::Mesh(sweep::sweep(contour, trajectory,
                                       {.tessellation = {size.sides, size.cells},
                                        .caps = sweep::Caps::kNone,
                                        .has_half_edges = has_half_edges})));
    };
    comparisons.push_back(
        bench::compare(std::string("tube_") + size.name,
                       {{"vtk", [&] { vtk.make(line, size.sides); }, [&] { return vtk.wrong(); },
                         [&] { vtk.tube = nullptr; }},
                        {"sweepkit", [&] { plain = make(false); },
                         [&] { return wrong_with(*plain, size, false); }, [&] { plain.reset(); }},
                        {"sweepkit_half_edges", [&] { whole = make(true); },
                         [&] { return wrong_with(*whole, size, true); }, [&] { whole.reset(); }}}));
    std::fputs(bench::to_table(comparisons.back()).c_str(), stdout);
    const std::vector<double> points = {static_cast<double>(vtk.tube->GetNumberOfPoints()),
                                        static_cast<double>(plain->n_vertices()),
                                        static_cast<double>(whole->n_vertices())};
    const double vtk_rate = points[0] / comparisons.back().results[0].seconds.median;
    const double triangles = 2.0 * size.sides * size.cells;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bench::Result& result = comparisons.back().results[i];
      const double rate = points[i] / result.seconds.median;
      std::printf("  %-24s %8.1f M points/s, %5.2f x VTK's, %5.1f ns a triangle\n", result.name.c_str(),
                  1e-6 * rate, rate / vtk_rate, 1e9 * result.seconds.median / triangles);
    }
    std::printf("  bytes a vertex: sweepkit %.1f, with half-edges %.1f, vtk %.1f\n",
                static_cast<double>(plain->bytes()) / points[1],
                static_cast<double>(whole->bytes()) / points[2],
                1024.0 * static_cast<double>(vtk.tube->GetActualMemorySize()) / points[0]);
  }
  if (csv_name != nullptr && !(std::ofstream(csv_name) << bench::to_csv(comparisons))) {
    std::fprintf(stderr, "%s: cannot be written\n", csv_name);
    return 1;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return compare_tubes(argc > 1 ? argv[1] : nullptr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
