// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "error_plot.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace sweepkit::bench {
namespace {

constexpr double kWidth = 760;
constexpr double kHeight = 480;
constexpr double kLeft = 70;
constexpr double kRight = 170;  // for the names of the curves
constexpr double kTop = 40;
constexpr double kBottom = 50;

struct Axis {
  double low;  // decimal logarithms
  double high;
  double from;  // on the page
  double to;

  double place(double value) const { return from + (std::log10(value) - low) / (high - low) * (to - from); }
};

Axis axis_over(const std::vector<PlotCurve>& curves, double PlotPoint::*value, double from, double to) {
  double low = std::numeric_limits<double>::max();
  double high = 0;
  for (const PlotCurve& curve : curves) {
    for (const PlotPoint& point : curve.points) {
      low = std::min(low, point.*value);
      high = std::max(high, point.*value);
    }
  }
  return {std::log10(low) - 0.1, std::log10(high) + 0.1, from, to};
}

template <class... Arguments>
void add(std::string& svg, const char* format, Arguments... arguments) {
  char text[512];
  std::snprintf(text, sizeof text, format, arguments...);
  svg += text;
}

// Lines at 1, 2 and 5 times every power of ten.
void add_grid(std::string& svg, const Axis& x, const Axis& y) {
  const auto for_each_mark = [](const Axis& axis, auto&& use) {
    for (int power = -6; power < 6; ++power) {
      for (const double digit : {1.0, 2.0, 5.0}) {
        const double value = digit * std::pow(10.0, power);
        if (std::log10(value) >= axis.low && std::log10(value) <= axis.high) use(value, axis.place(value));
      }
    }
  };
  for_each_mark(x, [&](double value, double at) {
    add(svg,
        "<path d='M%.1f %.1fV%.1f' stroke='#ddd'/><text x='%.1f' y='%.1f' text-anchor='middle'>%g</text>\n",
        at, y.from, y.to, at, y.from + 18, value);
  });
  for_each_mark(y, [&](double value, double at) {
    add(svg, "<path d='M%.1f %.1fH%.1f' stroke='#ddd'/><text x='%.1f' y='%.1f' text-anchor='end'>%g</text>\n",
        x.from, at, x.to, x.from - 6, at + 4, value);
  });
}

struct Rect {
  double left, top, right, bottom;

  bool meets(const Rect& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

constexpr double kLetter = 5.8;  // of the labels, on average, and a line of them
constexpr double kLine = 10;

// Where labels go: beside their points, and on nothing that is there already.
class Labels {
 public:
  void avoid(double x, double y) { taken_.push_back({x - 4, y - 4, x + 4, y + 4}); }

  void add_to(std::string& svg, double x, double y, const PlotPoint& point, const char* color) {
    const double width = kLetter * static_cast<double>(point.label.size());
    for (double away = 0; away < 200; away += 3) {
      for (const double side : {-1.0, 1.0}) {
        for (const bool is_right : {true, false}) {
          const double middle = y + side * (5 + away);
          const double left = is_right ? x + 5 : x - 5 - width;
          const Rect rect{left, middle - kLine / 2, left + width, middle + kLine / 2};
          if (std::any_of(taken_.begin(), taken_.end(), [&](const Rect& t) { return t.meets(rect); }) ||
              left < kLeft)
            continue;
          taken_.push_back(rect);
          if (away > 6) {
            add(svg, "<path d='M%.1f %.1fL%.1f %.1f' stroke='%s' stroke-width='0.5'/>\n", x, y,
                is_right ? left : left + width, middle, color);
          }
          add(svg, "<text x='%.1f' y='%.1f' fill='%s' font-size='10'>%s</text>\n", left, middle + 3.5, color,
              point.label.c_str());
          return;
        }
      }
    }
  }

 private:
  std::vector<Rect> taken_;
};

}  // namespace

std::string error_plot(const std::string& title, const std::vector<PlotCurve>& curves) {
  const Axis x = axis_over(curves, &PlotPoint::seconds, kLeft, kWidth - kRight);
  const Axis y = axis_over(curves, &PlotPoint::error, kHeight - kBottom, kTop);
  std::string svg;
  add(svg,
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 %g %g' font-family='sans-serif' font-size='12'>\n"
      "<rect width='100%%' height='100%%' fill='white'/>\n",
      kWidth, kHeight);
  add(svg, "<text x='%g' y='24' font-size='15'>%s</text>\n", kLeft, title.c_str());
  add_grid(svg, x, y);
  add(svg, "<text x='%.1f' y='%.1f' text-anchor='middle'>seconds, one thread</text>\n", 0.5 * (x.from + x.to),
      kHeight - 10);
  add(svg,
      "<text transform='translate(16 %.1f) rotate(-90)' text-anchor='middle'>RMSE, linear light</text>\n",
      0.5 * (y.from + y.to));
  Labels labels;
  for (const PlotCurve& curve : curves) {
    for (const PlotPoint& point : curve.points) labels.avoid(x.place(point.seconds), y.place(point.error));
  }
  double name_y = kTop + 10;
  for (const PlotCurve& curve : curves) {
    const char* color = curve.color.c_str();
    std::string path;
    for (const PlotPoint& point : curve.points)
      add(path, "%c%.1f %.1f", path.empty() ? 'M' : 'L', x.place(point.seconds), y.place(point.error));
    if (curve.is_joined)
      svg += "<path d='" + path + "' fill='none' stroke-width='1.5' stroke='" + curve.color + "'/>\n";
    for (const PlotPoint& point : curve.points) {
      const double at_x = x.place(point.seconds);
      const double at_y = y.place(point.error);
      add(svg, "<circle cx='%.1f' cy='%.1f' r='3.5' fill='%s'/>\n", at_x, at_y, color);
      labels.add_to(svg, at_x, at_y, point, color);
    }
    add(svg, "<circle cx='%.1f' cy='%.1f' r='4' fill='%s'/><text x='%.1f' y='%.1f'>%s</text>\n", x.to + 20,
        name_y - 4, color, x.to + 30, name_y, curve.name.c_str());
    name_y += 20;
  }
  return svg + "</svg>\n";
}

}  // namespace sweepkit::bench
