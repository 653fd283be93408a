// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A wall's patches lie side by side where the contour breaks and one behind the other where the trajectory
// does. Those behind one another have the same first coordinate across the way, bit for bit.

#include "growing_part.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace sweepkit::scene {
namespace {

using sweep::GridPatch;

// A patch as stations along the way, each with its lines across it.
struct Strip {
  const GridPatch* patch;
  bool is_along_u;

  std::uint32_t stations() const { return (is_along_u ? patch->columns : patch->rows) + 1; }
  std::uint32_t lines() const { return (is_along_u ? patch->rows : patch->columns) + 1; }

  // At a pole, which has a vertex less than other rows, a neighbour's: it lies in the same place.
  std::uint32_t vertex(std::uint32_t station, std::uint32_t line) const {
    std::uint32_t column = is_along_u ? station : line;
    const std::uint32_t row = is_along_u ? line : station;
    if (patch->has_first_pole && row == 0) column = std::max(column, 1u);
    if (patch->has_last_pole && row == patch->rows) column = std::min(column, patch->columns - 1);
    return patch->vertex(column, row);
  }
  // A line that is no pole, whose u is not its own.
  std::uint32_t plain_line() const { return is_along_u && patch->has_first_pole ? 1 : 0; }

  double way(const MeshView& mesh, std::uint32_t station) const {
    const glm::vec2& uv = mesh.texcoords[vertex(station, plain_line())];
    return std::abs(is_along_u ? uv.x : uv.y);
  }
  float across(const MeshView& mesh) const {
    const std::uint32_t station = !is_along_u && patch->has_first_pole ? 1 : 0;
    const glm::vec2& uv = mesh.texcoords[vertex(station, 0)];
    return is_along_u ? uv.y : uv.x;
  }
};

glm::dvec3 position(const MeshView& mesh, std::uint32_t vertex) {
  return glm::dvec3(mesh.positions[vertex]);
}

using Strips = std::vector<Strip>;  // one behind the other

std::vector<Strips> walls_of(const MeshView& mesh, const SweptPart& part) {
  std::map<std::tuple<std::uint32_t, float, std::uint32_t>, Strips> walls;
  for (const GridPatch& patch : mesh.patches) {
    if (patch.area < part.first_area || patch.area >= part.first_area + part.area_count) continue;
    const Strip strip{&patch, part.along == SweptPart::Along::kU};
    walls[{patch.area, strip.across(mesh), strip.lines()}].push_back(strip);
  }
  std::vector<Strips> result;
  result.reserve(walls.size());
  for (auto& [key, strips] : walls) result.push_back(std::move(strips));
  return result;
}

// The points of a wall's lines at a time, straight between its stations.
void append_points(const MeshView& mesh, const Strips& strips, double time, double length,
                   SectionPoints& points) {
  const Strip* before = &strips.front();
  std::uint32_t before_station = 0;
  const Strip* after = nullptr;
  std::uint32_t after_station = 0;
  for (const Strip& strip : strips) {
    for (std::uint32_t station = 0; station < strip.stations(); ++station) {
      const bool is_past = strip.way(mesh, station) / length > time;
      if (!is_past) {
        before = &strip;
        before_station = station;
        after = nullptr;
      } else if (after == nullptr) {
        after = &strip;
        after_station = station;
      }
    }
  }
  const double from = before->way(mesh, before_station) / length;
  const double to = after != nullptr ? after->way(mesh, after_station) / length : from;
  const double share = to > from ? std::clamp((time - from) / (to - from), 0.0, 1.0) : 0;
  for (std::uint32_t line = 0; line < before->lines(); ++line) {
    const glm::dvec3 here = position(mesh, before->vertex(before_station, line));
    points.push_back(share > 0 ? glm::mix(here, position(mesh, after->vertex(after_station, line)), share)
                               : here);
  }
}

bool is_cap(const MeshView& mesh, std::uint32_t area) {
  return std::none_of(mesh.patches.begin(), mesh.patches.end(),
                      [&](const GridPatch& patch) { return patch.area == area; });
}

void add_end_caps(const MeshView& mesh, const SweptPart& part, GrowingPart& growing) {
  const glm::dvec3 first = middle(growing.sections.front());
  const glm::dvec3 last = middle(growing.sections.back());
  for (std::uint32_t area = part.first_area; area < part.first_area + part.area_count; ++area) {
    if (!is_cap(mesh, area)) continue;
    std::set<std::uint32_t> vertices;
    const sweep::Area& triangles = mesh.areas[area];
    for (std::uint32_t t = 0; t < triangles.triangle_count; ++t) {
      for (const std::uint32_t vertex : mesh.triangles[triangles.first_triangle + t]) vertices.insert(vertex);
    }
    SectionPoints points;
    for (const std::uint32_t vertex : vertices) points.push_back(position(mesh, vertex));
    const glm::dvec3 center = middle(points);
    if (glm::distance(center, last) < glm::distance(center, first)) {
      growing.end_cap.insert(growing.end_cap.end(), vertices.begin(), vertices.end());
    }
  }
}

double largest_radius(const std::vector<SectionPoints>& sections) {
  double radius = 0;
  for (const SectionPoints& points : sections) {
    const glm::dvec3 center = middle(points);
    for (const glm::dvec3& point : points) radius = std::max(radius, glm::distance(point, center));
  }
  return radius;
}

}  // namespace

glm::dvec3 middle(const SectionPoints& points) {
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

std::size_t GrowingPart::station_before(double time) const {
  const auto after = std::upper_bound(times.begin(), times.end(), time);
  return after == times.begin() ? 0 : static_cast<std::size_t>(after - times.begin()) - 1;
}

SectionPoints GrowingPart::section(double time) const {
  const std::size_t before = station_before(time);
  SectionPoints points = sections[before];
  if (before + 1 == times.size() || times[before] >= time) return points;
  const double share = (time - times[before]) / (times[before + 1] - times[before]);
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] = glm::mix(points[i], sections[before + 1][i], share);
  return points;
}

glm::dvec3 GrowingPart::way_at(std::size_t station) const {
  const std::size_t before = station > 0 ? station - 1 : 0;
  const std::size_t after = std::min(station + 1, sections.size() - 1);
  const glm::dvec3 way = middle(sections[after]) - middle(sections[before]);
  const double length = glm::length(way);
  return length > 0 ? way / length : glm::dvec3(0.0);
}

std::optional<GrowingPart> growing_part(const MeshView& mesh, const SweptPart& part) {
  const std::vector<Strips> walls = walls_of(mesh, part);
  std::set<double> ways;
  for (const Strips& strips : walls) {
    for (const Strip& strip : strips) {
      for (std::uint32_t i = 0; i < strip.stations(); ++i) ways.insert(strip.way(mesh, i));
    }
  }
  if (ways.size() < 2) return std::nullopt;
  const double length = *ways.rbegin();
  GrowingPart growing;
  for (const double way : ways) growing.times.push_back(way / length);
  for (const double time : growing.times) {
    SectionPoints& points = growing.sections.emplace_back();
    for (const Strips& strips : walls) append_points(mesh, strips, time, length, points);
  }
  growing.radius = largest_radius(growing.sections);
  std::uint32_t first_line = 0;
  for (const Strips& strips : walls) {
    const std::uint32_t last_line = first_line + strips.front().lines() - 1;
    for (const Strip& strip : strips) {
      for (std::uint32_t i = 0; i < strip.stations(); ++i) {
        const auto station = static_cast<std::uint32_t>(growing.station_before(strip.way(mesh, i) / length));
        for (std::uint32_t line = 0; line < strip.lines(); ++line) {
          growing.wall.push_back({strip.vertex(i, line), station, first_line + line, first_line, last_line,
                                  i == 0, i + 1 == strip.stations()});
        }
      }
    }
    first_line = last_line + 1;
  }
  add_end_caps(mesh, part, growing);
  return growing;
}

}  // namespace sweepkit::scene
