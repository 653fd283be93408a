// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// svgpp has the grammars and makes relative commands absolute and short ones whole. It tells no place where a
// text goes wrong; an iterator that remembers the farthest byte it was led to does, since a grammar that
// gives up has just looked at what it could not use.

#include "svg_values.hpp"

#include <boost/iterator/iterator_facade.hpp>
#include <boost/range/iterator_range.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <svgpp/parser/list_of_points.hpp>
#include <svgpp/parser/path_data.hpp>
#include <svgpp/parser/transform_list.hpp>
#include <svgpp/parser/value_parser.hpp>
#include <svgpp/policy/error.hpp>
#include <svgpp/policy/path.hpp>
#include <svgpp/policy/transform.hpp>

#include "cos_sin_deg.hpp"
#include "message_text.hpp"
#include "number_token.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::scene {
namespace {

class WatchedIterator
    : public boost::iterator_facade<WatchedIterator, const char, std::forward_iterator_tag> {
 public:
  WatchedIterator() = default;
  WatchedIterator(const char* at, const char** farthest) : at_(at), farthest_(farthest) {}

 private:
  friend class boost::iterator_core_access;
  const char& dereference() const { return *at_; }
  bool equal(const WatchedIterator& other) const { return at_ == other.at_; }
  void increment() {
    if (++at_ > *farthest_) *farthest_ = at_;
  }

  const char* at_ = nullptr;
  const char** farthest_ = nullptr;
};

// The number that ends at `end` overflows.
bool is_too_large(std::string_view text, std::size_t end, std::size_t& begin) {
  begin = end;
  while (begin > 0 && std::string_view("0123456789.eE+-").find(text[begin - 1]) != std::string_view::npos)
    --begin;
  std::string_view token = text.substr(begin, end - begin);
  const std::optional<double> number = take_number(token);
  return number && token.empty() && std::isinf(*number);
}

[[noreturn]] void refuse(std::string_view text, std::size_t offset, const std::string& belongs) {
  std::size_t begin = 0;
  if (is_too_large(text, offset, begin)) {
    throw InputError("the number " + one_line(text.substr(begin, offset - begin), 40) + " at offset " +
                     std::to_string(begin) + " is too large");
  }
  if (offset >= text.size()) {
    throw InputError("ends at offset " + std::to_string(text.size()) + " where " + belongs + " is missing");
  }
  throw InputError("has " + in_quotes(text.substr(offset, 1)) + " at offset " + std::to_string(offset) +
                   ", where " + belongs + " belongs");
}

// svgpp's answer to a text it cannot read; value_parser::parse() then returns false.
template <class Context>
struct Quiet {
  using context_type = Context;
  template <class... What>
  static bool parse_failed(const What&...) {
    return false;
  }
};

template <class Parser, class Attribute, class Context>
void parse(std::string_view text, Attribute attribute, Context& context, const std::string& belongs) {
  const char* farthest = text.data();
  const auto range = boost::make_iterator_range(WatchedIterator(text.data(), &farthest),
                                                WatchedIterator(text.data() + text.size(), &farthest));
  if (!Parser::parse(attribute, context, range, svgpp::tag::source::attribute())) {
    refuse(text, static_cast<std::size_t>(farthest - text.data()), belongs);
  }
}

// svgpp calls these by their names.
struct PathEvents {
  using Absolute = svgpp::tag::coordinate::absolute;
  OutlineBuilder& pen;

  void path_move_to(double x, double y, Absolute) { pen.move_to({x, y}); }
  void path_line_to(double x, double y, Absolute) { pen.line_to({x, y}); }
  void path_quadratic_bezier_to(double x1, double y1, double x, double y, Absolute) {
    pen.quadratic_to({x1, y1}, {x, y});
  }
  void path_cubic_bezier_to(double x1, double y1, double x2, double y2, double x, double y, Absolute) {
    pen.cubic_to({x1, y1}, {x2, y2}, {x, y});
  }
  void path_elliptical_arc_to(double rx, double ry, double x_axis_deg, bool is_large, bool is_positive,
                              double x, double y, Absolute) {
    pen.arc_to({{rx, ry}, x_axis_deg, is_large, is_positive}, {x, y});
  }
  void path_close_subpath() { pen.close_subpath(); }
  void path_exit() {}
};

struct TransformEvents {
  glm::dmat3 outer_from_inner{1.0};

  // Columns: glm stores a matrix by them.
  void add(const glm::dvec2& x, const glm::dvec2& y, const glm::dvec2& origin) {
    outer_from_inner *= glm::dmat3(glm::dvec3(x, 0), glm::dvec3(y, 0), glm::dvec3(origin, 1));
  }
  void transform_matrix(const boost::array<double, 6>& m) { add({m[0], m[1]}, {m[2], m[3]}, {m[4], m[5]}); }
  void transform_translate(double x, double y) { add({1, 0}, {0, 1}, {x, y}); }
  void transform_scale(double x, double y) { add({x, 0}, {0, y}, {0, 0}); }
  void transform_rotate(double degrees) {
    const glm::dvec2 turn = cos_sin_deg(degrees);
    add(turn, {-turn.y, turn.x}, {0, 0});
  }
  void transform_skew_x(double degrees) { add({1, 0}, {tan_deg(degrees), 1}, {0, 0}); }
  void transform_skew_y(double degrees) { add({1, tan_deg(degrees)}, {0, 1}, {0, 0}); }

  static double tan_deg(double degrees) {
    const glm::dvec2 turn = cos_sin_deg(degrees);
    return turn.y / turn.x;
  }
};

struct PointEvents {
  std::vector<glm::dvec2> points;

  template <class Range>
  void set(svgpp::tag::attribute::points, const Range& range) {
    for (const auto& [x, y] : range) points.emplace_back(x, y);
  }
};

}  // namespace

void read_path_data(std::string_view text, OutlineBuilder& pen) {
  PathEvents events{pen};
  using Parser = svgpp::value_parser<svgpp::tag::type::path_data, svgpp::error_policy<Quiet<PathEvents>>,
                                     svgpp::path_policy<svgpp::policy::path::no_shorthands>>;
  parse<Parser>(text, svgpp::tag::attribute::d(), events,
                "a number (an arc's radii without a sign) or one of M L H V C S Q T A Z");
}

glm::dmat3 read_transform(std::string_view text) {
  TransformEvents events;
  using Parser =
      svgpp::value_parser<svgpp::tag::type::transform_list, svgpp::error_policy<Quiet<TransformEvents>>,
                          svgpp::transform_policy<svgpp::policy::transform::minimal>>;
  parse<Parser>(text, svgpp::tag::attribute::transform(), events,
                "a part of matrix(), translate(), scale(), rotate(), skewX() or skewY()");
  return events.outer_from_inner;
}

std::vector<glm::dvec2> read_point_list(std::string_view text) {
  // svgpp wants the first point and the end without blanks about them.
  constexpr std::string_view kBlanks = " \t\r\n\f";
  PointEvents events;
  const std::size_t last = text.find_last_not_of(kBlanks);
  if (last == std::string_view::npos) return {};
  using Parser = svgpp::value_parser<svgpp::tag::attribute::points, svgpp::error_policy<Quiet<PointEvents>>>;
  parse<Parser>(text.substr(0, last + 1), svgpp::tag::attribute::points(), events, "x and y of a point");
  return std::move(events.points);
}

}  // namespace sweepkit::scene
