// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>
#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "outline.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/sweep/curve.hpp"

namespace sweepkit::scene {

/// The sum of `term` over a segment by Gauss and Legendre's rule of 5 points on 32 panels: exact for the area
/// under Bezier segments up to degree 5, and to rounding for arcs (the error falls as panels^-10).
inline double integral(const sweep::Segment<2>& segment,
                       const std::function<double(const sweep::CurvePoint<2>&)>& term) {
  constexpr int kPanels = 32;
  constexpr std::array<double, 5> kNodes = {0, -0.538469310105683091, 0.538469310105683091,
                                            -0.906179845938663993, 0.906179845938663993};
  constexpr std::array<double, 5> kWeights = {0.568888888888888889, 0.478628670499366468,
                                              0.478628670499366468, 0.236926885056189088,
                                              0.236926885056189088};
  double sum = 0;
  for (int panel = 0; panel < kPanels; ++panel) {
    for (std::size_t i = 0; i < kNodes.size(); ++i) {
      const double t = (panel + 0.5 + 0.5 * kNodes[i]) / kPanels;
      sum += kWeights[i] * term(sweep::evaluate<2>(segment, t));
    }
  }
  return sum / (2 * kPanels);
}

/// Counter-clockwise positive, closed by a straight line if it is open.
inline double area(std::span<const sweep::Segment<2>> segments) {
  double sum = 0;
  for (const sweep::Segment<2>& segment : segments) {
    sum += integral(segment, [](const sweep::CurvePoint<2>& p) {
      return 0.5 * (p.position.x * p.first.y - p.position.y * p.first.x);
    });
  }
  const glm::dvec2 end = sweep::evaluate<2>(segments.back(), 1).position;
  const glm::dvec2 start = sweep::evaluate<2>(segments.front(), 0).position;
  return sum + 0.5 * (end.x * start.y - end.y * start.x);
}
inline double area(const Outline& outline) {
  return area(outline.segments);
}
inline double area(const sweep::Curve2& curve) {
  return area(curve.segments());
}

inline double length(const Outline& outline) {
  double sum = 0;
  for (const sweep::Segment<2>& segment : outline.segments) {
    sum += integral(segment, [](const sweep::CurvePoint<2>& p) { return glm::length(p.first); });
  }
  return sum;
}

/// The control points of segments that all are Bezier ones, those that joined segments share once.
inline std::vector<glm::dvec2> controls(std::span<const sweep::Segment<2>> segments) {
  std::vector<glm::dvec2> points;
  for (const sweep::Segment<2>& segment : segments) {
    const auto* bezier = std::get_if<sweep::BezierSegment<2>>(&segment);
    if (bezier == nullptr) {
      ADD_FAILURE() << "an arc, no Bezier segment";
      continue;
    }
    const std::vector<glm::dvec2>& own = bezier->control;
    const bool is_joined = !points.empty() && points.back() == own.front();
    points.insert(points.end(), own.begin() + (is_joined ? 1 : 0), own.end());
  }
  return points;
}
inline std::vector<glm::dvec2> controls(const Outline& outline) {
  return controls(outline.segments);
}

inline void expect_points(const std::vector<glm::dvec2>& points, const std::vector<glm::dvec2>& expected,
                          double bound = 0) {
  ASSERT_EQ(points.size(), expected.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(points[i].x, expected[i].x, bound) << "x of point " << i;
    EXPECT_NEAR(points[i].y, expected[i].y, bound) << "y of point " << i;
  }
}

/// What the InputError says that `act` ends in, or "" if it does not.
template <class Act>
std::string refusal(const Act& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// A folder for one test, removed with what is in it.
class Folder {
 public:
  Folder()
      : path_(std::filesystem::path(testing::TempDir()) / ("sweepkit_curves_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

}  // namespace sweepkit::scene
