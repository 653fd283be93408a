// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "read_curve_file.hpp"

#include <algorithm>
#include <cmath>

#include "object_reader.hpp"
#include "point_file.hpp"
#include "svg_file.hpp"
#include "svg_values.hpp"
#include "sweepkit/error.hpp"
#include "text_file.hpp"

namespace sweepkit::scene {
namespace {

// The farthest that the outline, in metres, is from its start. Throws InputError beyond what coordinates may
// be.
double extent_of(const Outline& outline) {
  double extent = 0;
  const glm::dvec2 start = sweep::evaluate<2>(outline.segments.front(), 0).position;
  for (const sweep::Segment<2>& segment : outline.segments) {
    for (const double t : {0.0, 0.5, 1.0}) {
      const glm::dvec2 p = sweep::evaluate<2>(segment, t).position;
      if (!(std::abs(p.x) <= kFarthest && std::abs(p.y) <= kFarthest)) {
        throw InputError("reaches farther than " + to_text(kFarthest) +
                         " m from the origin; lower \"scale\"");
      }
      extent = std::max(extent, glm::distance(p, start));
    }
  }
  return extent;
}

// Leaves out outlines that are points: sizes begin at a nanometre.
void drop_points(std::vector<DrawnShape>& shapes) {
  bool has_points = false;
  bool has_outlines = false;
  for (DrawnShape& shape : shapes) {
    std::erase_if(shape.outlines, [&](const Outline& outline) {
      const bool is_point = extent_of(outline) < kExtent.low;
      (is_point ? has_points : has_outlines) = true;
      return is_point;
    });
  }
  if (has_points && !has_outlines) {
    throw InputError("has no outline of at least " + to_text(kExtent.low) + " m; raise \"scale\"");
  }
}

std::vector<sweep::Curve2> contour_of(std::vector<DrawnShape> shapes) {
  drop_points(shapes);
  std::vector<FilledShape> filled;
  std::vector<sweep::Curve2> unfilled;
  for (DrawnShape& shape : shapes) {
    if (shape.is_filled) filled.push_back({.rule = shape.rule, .outlines = {}});
    for (Outline& outline : shape.outlines) {
      if (shape.is_filled) close(outline);
      (shape.is_filled ? filled.back().outlines : unfilled)
          .push_back(sweep::Curve2(std::move(outline.segments)));
    }
  }
  std::vector<sweep::Curve2> contour = bounding_outlines(filled);
  contour.insert(contour.end(), unfilled.begin(), unfilled.end());
  if (contour.empty()) {
    throw InputError(
        "has no outline that bounds an area; a contour needs a filled shape, "
        "or a line drawn with fill=\"none\"");
  }
  return contour;
}

sweep::Curve3 trajectory_of(std::vector<DrawnShape> shapes) {
  drop_points(shapes);
  std::vector<Outline> outlines;
  for (DrawnShape& shape : shapes)
    std::move(shape.outlines.begin(), shape.outlines.end(), std::back_inserter(outlines));
  if (outlines.size() != 1) {
    throw InputError("has " + std::to_string(outlines.size()) +
                     " outlines, and a trajectory is one; choose or draw a single path");
  }
  const sweep::Curve2 plane(std::move(outlines.front().segments));
  const auto in_space = [](const glm::dvec2& p) { return glm::dvec3(p, 0); };
  std::vector<sweep::Segment<3>> segments;
  segments.reserve(plane.segments().size());
  for (const sweep::Segment<2>& segment : plane.segments()) {
    if (const auto* bezier = std::get_if<sweep::BezierSegment<2>>(&segment)) {
      sweep::BezierSegment<3> laid;
      laid.control.reserve(bezier->control.size());
      for (const glm::dvec2& p : bezier->control) laid.control.push_back(in_space(p));
      segments.emplace_back(std::move(laid));
    } else {
      const auto& arc = std::get<sweep::ArcSegment<2>>(segment);
      segments.emplace_back(sweep::ArcSegment<3>{in_space(arc.center), in_space(arc.x_axis),
                                                 in_space(arc.y_axis), arc.from_deg, arc.to_deg,
                                                 in_space(arc.rise)});
    }
  }
  return sweep::Curve3(std::move(segments));
}

void scale_all(std::vector<DrawnShape>& shapes, const glm::dvec2& scale) {
  for (DrawnShape& shape : shapes) {
    for (Outline& outline : shape.outlines) {
      transform(outline, {{scale.x, 0, 0}, {0, scale.y, 0}, {0, 0, 1}});
    }
  }
}

// In a file's curve what is wrong without a place is wrong with the file.
template <class Make>
auto naming(const std::filesystem::path& file, const Make& make) {
  try {
    return make();
  } catch (const InputError& error) {
    if (!error.place().file.empty()) throw;
    throw InputError({.file = file.string()}, error.problem());
  }
}

std::vector<DrawnShape> shapes_of(const SvgCurve& svg) {
  std::vector<DrawnShape> shapes =
      read_svg(read_text_file(svg.file, kLargestSvg, "an SVG file"), svg.file.string(), svg.id);
  scale_all(shapes, glm::dvec2(svg.scale));
  return shapes;
}

std::vector<DrawnShape> shapes_of(const PathCurve& path) {
  OutlineBuilder pen;
  read_path_data(path.data, pen);
  // Path data alone has no fill: its closed subpaths bound a region, its open ones stay open.
  DrawnShape closed;
  DrawnShape open{.outlines = {}, .is_filled = false};
  for (Outline& outline : pen.take()) {
    (outline.is_closed ? closed : open).outlines.push_back(std::move(outline));
  }
  std::vector<DrawnShape> shapes = {std::move(closed), std::move(open)};
  scale_all(shapes, {path.scale, -path.scale});  // y upwards
  return shapes;
}

template <int D>
sweep::Curve<D> curve_of(const PointCurve& given) {
  const PointFile read =
      read_points(read_text_file(given.file, kLargestPointFile, "a list of points"), given.file.string());
  if (read.columns > D) throw InputError("has 3 columns, and a contour is plane; leave z out");
  std::vector<sweep::Vector<D>> points;
  points.reserve(read.points.size());
  double size = 0;
  for (const glm::dvec3& p : read.points) {
    points.emplace_back(p);
    size = std::max(size, glm::distance(points.back(), points.front()));
  }
  if (size < kExtent.low) {
    throw InputError("has no length: its points are within " + to_text(kExtent.low) + " m of each other");
  }
  // The ends that a curve counts as meeting: one of them would be a segment of rounding errors.
  bool is_closed = given.is_closed;
  if (points.size() > 3 && glm::distance(points.front(), points.back()) <= 1e-9 * size) {
    points.pop_back();
    is_closed = true;
  }
  return given.is_smooth ? sweep::free_curve<D>(points, is_closed) : sweep::polyline<D>(points, is_closed);
}

}  // namespace

std::vector<sweep::Curve2> contour_of(const SvgCurve& svg) {
  return naming(svg.file, [&] { return contour_of(shapes_of(svg)); });
}
std::vector<sweep::Curve2> contour_of(const PathCurve& path) {
  return contour_of(shapes_of(path));
}
std::vector<sweep::Curve2> contour_of(const PointCurve& points) {
  return naming(points.file, [&] { return std::vector<sweep::Curve2>{curve_of<2>(points)}; });
}

sweep::Curve3 trajectory_of(const SvgCurve& svg) {
  return naming(svg.file, [&] { return trajectory_of(shapes_of(svg)); });
}
sweep::Curve3 trajectory_of(const PathCurve& path) {
  return trajectory_of(shapes_of(path));
}
sweep::Curve3 trajectory_of(const PointCurve& points) {
  return naming(points.file, [&] { return curve_of<3>(points); });
}

}  // namespace sweepkit::scene
