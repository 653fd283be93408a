// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Between states a and b a line's points at stations t go straight from its point p(a) to p(t): the stretch
// that grows is its final self made smaller towards p(a), so that on a straight way nothing is wrong and on
// an arc the end cuts the chord. Its tangents along the way are the final ones from the start; those across
// turn from the section's at a to the final ones. So the normal in state a is the product of the two.

#include "growth.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "growing_part.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::scene {
namespace {

constexpr double kMostOffWay = 0.02;    // of the mesh's diagonal
constexpr double kMostOffShape = 0.10;  // of the section's radius

struct Limits {
  double way;
  double shape;  // a share of the section's radius
};

// How far the growing end is from its places between two states.
struct OffPlace {
  double way = 0;
  double shape = 0;
  double point = 0;
};

OffPlace off_place(const GrowingPart& part, double from, double to) {
  OffPlace most;
  const SectionPoints first = part.section(from);
  const SectionPoints last = part.section(to);
  SectionPoints off(first.size());
  for (std::size_t i = part.station_before(from) + 1; i < part.times.size() && part.times[i] < to; ++i) {
    const double share = (part.times[i] - from) / (to - from);
    for (std::size_t line = 0; line < off.size(); ++line)
      off[line] = glm::mix(first[line], last[line], share) - part.sections[i][line];
    const glm::dvec3 center = middle(off);
    most.way = std::max(most.way, glm::length(center));
    for (const glm::dvec3& one : off) {
      most.shape = std::max(most.shape, glm::distance(one, center));
      most.point = std::max(most.point, glm::length(one));
    }
  }
  return most;
}

bool is_near_enough(const std::vector<GrowingPart>& parts, double from, double to, const Limits& limits) {
  return std::all_of(parts.begin(), parts.end(), [&](const GrowingPart& part) {
    const OffPlace off = off_place(part, from, to);
    return off.way <= limits.way && off.shape <= limits.shape * part.radius;
  });
}

// 0 and those after it at which a new straight stretch begins.
std::vector<double> choose_times(const std::vector<GrowingPart>& parts, const Limits& limits) {
  std::vector<double> candidates;
  for (const GrowingPart& part : parts)
    candidates.insert(candidates.end(), part.times.begin(), part.times.end());
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  std::vector<double> times = {0};
  std::size_t at = 0;
  while (true) {
    std::size_t next = at + 1;  // no station lies between neighbours, so that nothing can be off
    while (next + 1 < candidates.size() &&
           is_near_enough(parts, candidates[at], candidates[next + 1], limits))
      ++next;
    if (next + 1 >= candidates.size() || times.size() > kMostGrowthStates) return times;
    times.push_back(candidates[next]);
    at = next;
  }
}

// Takes the end's section to another one, and what is in its middle along: exact where the two are alike but
// for turning and scaling, a least-squares fit otherwise.
glm::dmat3 fit(const SectionPoints& end, const glm::dvec3& end_way, const SectionPoints& section,
               const glm::dvec3& way) {
  const glm::dvec3 end_middle = middle(end);
  const glm::dvec3 section_middle = middle(section);
  glm::dmat3 products(0.0);
  glm::dmat3 squares(0.0);
  double end_size = 0;
  double size = 0;
  for (std::size_t i = 0; i < end.size(); ++i) {
    const glm::dvec3 p = end[i] - end_middle;
    const glm::dvec3 q = section[i] - section_middle;
    products += glm::outerProduct(q, p);
    squares += glm::outerProduct(p, p);
    end_size += glm::dot(p, p);
    size += glm::dot(q, q);
  }
  if (!(end_size > 0)) return glm::dmat3(1.0);
  products += std::sqrt(size * end_size) * glm::outerProduct(way, end_way);
  squares += end_size * glm::outerProduct(end_way, end_way);
  return std::abs(glm::determinant(squares)) > 1e-12 * end_size * end_size * end_size
             ? products * glm::inverse(squares)
             : glm::dmat3(1.0);
}

class StateMaker {
 public:
  StateMaker(const MeshView& mesh, const GrowingPart& part, double from, double to, Growth::State& state)
      : mesh_(mesh), part_(part), from_(from), to_(to), section_(part.section(from)), state_(state) {}

  void move_wall() {
    for (const GrowingPart::WallVertex& at : part_.wall) {
      if (part_.times[at.station] <= from_) continue;
      const glm::dvec3 position(mesh_.positions[at.vertex]);
      state_.moved[at.vertex] = glm::vec3(section_[at.line] - position);
      // What comes later than this stretch has no area before it is over.
      if (part_.times[at.station] > to_) continue;
      const glm::dvec3 along = along_at(at);
      const glm::dvec3 across = section_[std::min(at.line + 1, at.last_line)] -
                                section_[at.line > at.first_line ? at.line - 1 : at.line];
      const glm::dvec3 product = glm::cross(along, across);
      const double length = glm::length(product);
      if (!(length > 1e-9 * glm::length(along) * glm::length(across))) continue;
      const glm::dvec3 own(mesh_.normals[at.vertex]);
      const glm::dvec3 normal = product / (glm::dot(product, own) < 0 ? -length : length);
      state_.turned[at.vertex] = glm::vec3(normal - own);
    }
  }

  // A cap's rim stays on the walls' edge, whatever the section has become.
  void move_end_cap() {
    if (part_.end_cap.empty()) return;
    const SectionPoints& end = part_.sections.back();
    const auto less = [](const glm::dvec3& a, const glm::dvec3& b) {
      return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
    };
    std::map<glm::dvec3, std::size_t, decltype(less)> rim(less);
    for (std::size_t line = 0; line < end.size(); ++line) rim.emplace(end[line], line);
    const glm::dmat3 map = fit(end, part_.way_at(part_.sections.size() - 1), section_,
                               part_.way_at(part_.station_before(from_)));
    const glm::dvec3 end_middle = middle(end);
    const glm::dvec3 here = middle(section_);
    const bool is_singular = std::abs(glm::determinant(map)) < 1e-9;
    const glm::dmat3 normal_map = is_singular ? glm::dmat3(1.0) : glm::transpose(glm::inverse(map));
    for (const std::uint32_t vertex : part_.end_cap) {
      const glm::dvec3 position(mesh_.positions[vertex]);
      const auto on_rim = rim.find(position);
      const glm::dvec3 moved =
          on_rim != rim.end() ? section_[on_rim->second] : here + map * (position - end_middle);
      const glm::dvec3 own(mesh_.normals[vertex]);
      state_.moved[vertex] = glm::vec3(moved - position);
      state_.turned[vertex] = glm::vec3(glm::normalize(normal_map * own) - own);
    }
  }

 private:
  glm::dvec3 along_at(const GrowingPart::WallVertex& at) const {
    const std::size_t before = at.begins_patch ? at.station : at.station - 1;
    const std::size_t after = at.ends_patch ? at.station : at.station + 1;
    return part_.sections[after][at.line] - part_.sections[before][at.line];
  }

  const MeshView& mesh_;
  const GrowingPart& part_;
  double from_;
  double to_;
  SectionPoints section_;
  Growth::State& state_;
};

double diagonal(const MeshView& mesh) {
  glm::vec3 low = mesh.positions.front();
  glm::vec3 high = low;
  for (const glm::vec3& position : mesh.positions) {
    low = glm::min(low, position);
    high = glm::max(high, position);
  }
  return glm::distance(glm::dvec3(low), glm::dvec3(high));
}

}  // namespace

std::optional<Growth> grow(const MeshView& mesh) {
  std::vector<GrowingPart> parts;
  for (const SweptPart& swept : mesh.swept) {
    if (std::optional<GrowingPart> part = growing_part(mesh, swept)) parts.push_back(*std::move(part));
  }
  if (parts.empty()) return std::nullopt;
  Limits limits{kMostOffWay * diagonal(mesh), kMostOffShape};
  std::vector<double> times = choose_times(parts, limits);
  while (times.size() > kMostGrowthStates) {
    limits = {2 * limits.way, 2 * limits.shape};
    times = choose_times(parts, limits);
  }
  // Before they are made: what no file may hold need not be in memory either.
  const std::size_t bytes = times.size() * mesh.positions.size() * 2 * sizeof(glm::vec3);
  if (bytes >= std::size_t{1} << 31) {
    throw InputError("to grow takes " + std::to_string(times.size()) +
                     " morph targets, which would be over 2 GiB; ask for fewer cells");
  }
  Growth growth;
  for (std::size_t k = 0; k < times.size(); ++k) {
    const double to = k + 1 < times.size() ? times[k + 1] : 1;
    Growth::State& state = growth.states.emplace_back();
    state.time = times[k];
    state.moved.resize(mesh.positions.size(), glm::vec3(0.0f));
    state.turned.resize(mesh.positions.size(), glm::vec3(0.0f));
    for (const GrowingPart& part : parts) {
      StateMaker maker(mesh, part, times[k], to, state);
      maker.move_wall();
      maker.move_end_cap();
      growth.error = std::max(growth.error, off_place(part, times[k], to).point);
    }
  }
  return growth;
}

}  // namespace sweepkit::scene
