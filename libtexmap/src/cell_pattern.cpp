// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Tiles and bricks: rows of cells of side 1 with joints between them, every other row moved along. What the
// cells cover of a footprint is known in closed form. The colours of cells that a footprint of some cells
// meets are added up one by one; over wider ones the cells' own colours fade to their mean.
//
// Where the pattern comes round after `columns` x `rows` cells, the cells are ranked by a bijection that
// looks random [Luby88]: a Feistel network on the cell's number, taken again while it leads outside. Equal
// stretches of ranks have equal colours, so that each colour has as many cells as another and the mean is
// known.

#include <array>

#include "pattern.hpp"
#include "tent_steps.hpp"

namespace sweepkit::texmap {
namespace {

// Half widths, in cells, from which on cells lose their own colours and where they have lost them.
constexpr double kFadeFrom = 2;
constexpr double kFadeTo = 4;
constexpr std::size_t kMostAcross = 10;  // cells within 4 of a place, and the two that they cut

struct Cells {
  double joint_x;  // as shares of a cell
  double joint_y;
  double bond;
  bool is_chess = false;
  std::int64_t columns = 0;  // after which they come round; 0: never
  std::int64_t rows = 0;
};

std::uint64_t stirred(std::uint64_t h) {
  h = (h ^ (h >> 32)) * 0xD6E8FEB86659FD93u;
  return h ^ (h >> 32);
}

std::int64_t wrapped(std::int64_t cell, std::int64_t period) {
  const std::int64_t rest = cell % period;
  return rest < 0 ? rest + period : rest;
}

std::uint64_t rank_of(std::uint64_t number, std::uint64_t count) {
  int half = 1;
  while (half < 16 && (std::uint64_t{1} << (2 * half)) < count) ++half;
  const std::uint64_t mask = (std::uint64_t{1} << half) - 1;
  do {
    std::uint64_t left = number >> half;
    std::uint64_t right = number & mask;
    for (std::uint64_t round = 1; round <= 4; ++round) {
      const std::uint64_t mixed = left ^ (stirred((right + 1) * 0x9E3779B97F4A7C15u + round) & mask);
      left = right;
      right = mixed;
    }
    number = left << half | right;
  } while (number >= count);
  return number;
}

// Ranks are kept where count * colours stays far inside 64 bits; larger patterns are even enough by chance.
bool is_ranked(const Cells& cells) {
  return cells.columns > 0 && cells.columns <= 65535 && cells.rows <= 65535;
}

std::size_t color_index(const Cells& cells, std::int64_t x, std::int64_t y, std::size_t colors) {
  if (colors == 1) return 0;
  if (cells.is_chess) return static_cast<std::size_t>((x + y) & 1);
  if (cells.columns > 0) {
    x = wrapped(x, cells.columns);
    y = wrapped(y, cells.rows);
  }
  if (is_ranked(cells)) {
    const auto count = static_cast<std::uint64_t>(cells.columns * cells.rows);
    return static_cast<std::size_t>(rank_of(static_cast<std::uint64_t>(y * cells.columns + x), count) *
                                    colors / count);
  }
  return static_cast<std::size_t>((stirred(static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15u +
                                           static_cast<std::uint64_t>(y) * 0xC2B2AE3D27D4EB4Fu) >>
                                   20) %
                                  colors);
}

glm::dvec3 mean_color(const Cells& cells, Colors colors) {
  glm::dvec3 sum(0.0);
  const auto n = static_cast<std::uint64_t>(colors.size());
  const auto count =
      is_ranked(cells) && !cells.is_chess ? static_cast<std::uint64_t>(cells.columns * cells.rows) : n;
  const auto first_rank = [&](std::uint64_t i) { return (i * count + n - 1) / n; };
  for (std::uint64_t i = 0; i < n; ++i)
    sum += static_cast<double>(first_rank(i + 1) - first_rank(i)) * glm::dvec3(colors[i]);
  return sum / static_cast<double>(count);
}

// The cells along an axis that a tent meets, and the share of it that each one's body has.
struct Run {
  std::int64_t first = 0;
  std::size_t count = 0;
  std::array<double, kMostAcross> shares{};
};
Run run_of(double x, double half, double joint, FilterShape shape) {
  Run run;
  const double base = std::floor(x);
  const double f = x - base;
  const double low = std::floor(f - half);
  run.first = static_cast<std::int64_t>(base) + static_cast<std::int64_t>(low);
  run.count = std::min(kMostAcross, static_cast<std::size_t>(std::floor(f + half) - low) + 1);
  for (std::size_t i = 0; i < run.count; ++i) {
    const double cell = low + static_cast<double>(i) - f;
    run.shares[i] =
        share_below(cell + 1 - 0.5 * joint, half, shape) - share_below(cell + 0.5 * joint, half, shape);
  }
  return run;
}

// The bodies of the rows of one parity: a period of 2 rows.
double rows_share(double y, double half, double joint, int parity, FilterShape shape) {
  const double from = 0.5 * parity + 0.25 * joint;
  return filtered_pulse(0.5 * y, from, from + 0.5 - 0.5 * joint, 0.5 * half, shape);
}

// A footprint that is wide: what bodies and joints cover of it, in their mean colours.
glm::dvec3 far_color(const Cells& cells, const glm::dvec3& body_color, const glm::dvec3& joint_color,
                     const PatternPlace& place, const glm::dvec3& half) {
  const glm::dvec3& at = place.at;
  double body = 0;
  for (int parity = 0; parity < 2; ++parity) {
    body += rows_share(at.y, half.y, cells.joint_y, parity, place.shape) *
            filtered_pulse(at.x - parity * cells.bond, 0.5 * cells.joint_x, 1 - 0.5 * cells.joint_x, half.x,
                           place.shape);
  }
  return body * body_color + (1 - body) * joint_color;
}

// One that meets few cells: each in its own colour.
glm::dvec3 near_color(const Cells& cells, Colors colors, const glm::dvec3& joint_color,
                      const PatternPlace& place, const glm::dvec3& half) {
  const glm::dvec3& at = place.at;
  const Run rows = run_of(at.y, half.y, cells.joint_y, place.shape);
  const std::array<Run, 2> columns = {run_of(at.x, half.x, cells.joint_x, place.shape),
                                      run_of(at.x - cells.bond, half.x, cells.joint_x, place.shape)};
  glm::dvec3 sum(0.0);
  double body = 0;
  for (std::size_t j = 0; j < rows.count; ++j) {
    const std::int64_t row = rows.first + static_cast<std::int64_t>(j);
    const Run& run = columns[static_cast<std::size_t>(row & 1)];
    for (std::size_t i = 0; i < run.count; ++i) {
      const double share = rows.shares[j] * run.shares[i];
      if (share <= 0) continue;
      const std::int64_t column = run.first + static_cast<std::int64_t>(i);
      sum += share * glm::dvec3(colors[color_index(cells, column, row, colors.size())]);
      body += share;
    }
  }
  return sum + (1 - body) * joint_color;
}

glm::dvec3 cells_color(const Cells& cells, Colors all, const PatternPlace& place) {
  const Colors colors = all.size() > 1 ? all.first(all.size() - 1) : all;
  const glm::dvec3 joint_color(all.back());
  const glm::dvec3 half = place.half_widths();
  const double t = std::clamp((std::max(half.x, half.y) - kFadeFrom) / (kFadeTo - kFadeFrom), 0.0, 1.0);
  const double faded = t * t * (3 - 2 * t);
  glm::dvec3 color(0.0);
  if (faded < 1) color += (1 - faded) * near_color(cells, colors, joint_color, place, half);
  if (faded > 0) color += faded * far_color(cells, mean_color(cells, colors), joint_color, place, half);
  return color;
}

}  // namespace

bool courses_come_round(const Procedural& procedural) {
  const double courses = procedural.scale * procedural.ratio;
  return procedural.scale >= 1 && procedural.scale == std::floor(procedural.scale) &&
         std::fmod(courses, procedural.bond == 0 ? 1.0 : 2.0) == 0;
}

glm::dvec3 tiles(const Pattern& pattern, const PatternPlace& place) {
  const double grout = pattern.given.grout;
  return cells_color({.joint_x = grout,
                      .joint_y = grout,
                      .bond = 0,
                      .is_chess = pattern.colors.size() == 3,
                      .columns = pattern.period,
                      .rows = pattern.period},
                     pattern.colors, place);
}

glm::dvec3 brick(const Pattern& pattern, const PatternPlace& place) {
  const Procedural& given = pattern.given;
  const glm::dvec3 stretch(1, given.ratio, 1);
  return cells_color({.joint_x = std::min(1.0, given.mortar / given.ratio),
                      .joint_y = given.mortar,
                      .bond = given.bond,
                      .columns = pattern.period,
                      .rows = pattern.period > 0 ? static_cast<std::int64_t>(given.scale * given.ratio) : 0},
                     pattern.colors,
                     {stretch * place.at, stretch * place.major, stretch * place.minor, place.shape});
}

}  // namespace sweepkit::texmap
