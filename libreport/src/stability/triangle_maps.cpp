// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The default map's promise: an error of at most 8 steps of double times the conditioning times the leg, and
// the rounding of (u,v) itself. Symbols: a, c barycentric coordinates at A1 and C1, by quadruple precision in
// the plane that drops the normal's longest axis; the conditioning is the sum of the sizes of the products
// over the area.

#include <array>
#include <cfenv>
#include <random>

#include "quad.hpp"
#include "stability/map_calls.hpp"
#include "stability/stability_case.hpp"

namespace sweepkit::report {
namespace {

constexpr const char* kPromise =
    "texture coordinates on a triangle: backward stable, no NaN, within a few units of the last place of the "
    "conditioning";
constexpr int kPairs = 2000;
const texmap::RightTriangle kTexture{{0.25, -3}, -0.5, 2};

struct Pair {
  texmap::Triangle3<double> triangle;
  glm::dvec3 hit;
};

struct Exact {
  bool has_area = false;
  Quad u = 0, v = 0;
  double bound_u = 0, bound_v = 0;
};

double size(Quad x) {
  return static_cast<double>(fabsq(x));
}

Exact exact_of(const Pair& pair) {
  using Vec = std::array<Quad, 3>;
  const auto from_b = [&](const glm::dvec3& p) {
    const glm::dvec3& b = pair.triangle.b;
    return Vec{static_cast<Quad>(p.x) - b.x, static_cast<Quad>(p.y) - b.y, static_cast<Quad>(p.z) - b.z};
  };
  const Vec a = from_b(pair.triangle.a);
  const Vec c = from_b(pair.triangle.c);
  const Vec h = from_b(pair.hit);
  const auto cross = [](const Vec& p, const Vec& q, std::size_t k) {
    return p[(k + 1) % 3] * q[(k + 2) % 3] - p[(k + 2) % 3] * q[(k + 1) % 3];
  };
  const auto products = [](const Vec& p, const Vec& q, std::size_t k) {
    return size(p[(k + 1) % 3] * q[(k + 2) % 3]) + size(p[(k + 2) % 3] * q[(k + 1) % 3]);
  };
  // The map's own choice, by doubles: on a tie either axis is right.
  const auto plane = texmap::dominant_plane(pair.triangle);
  const auto k = static_cast<std::size_t>(3 - plane.i - plane.j);
  const Quad area = cross(a, c, k);
  const double all = products(a, c, k);
  if (!(size(area) > 0x1p-100 * all)) return {};
  const Quad share_a = cross(h, c, k) / area;
  const Quad share_c = cross(a, h, k) / area;
  Exact exact{
      .has_area = true, .u = kTexture.b.x + share_c * kTexture.bc, .v = kTexture.b.y + share_a * kTexture.ba};
  const double conditioning_c = (products(a, h, k) + size(share_c) * all) / size(area);
  const double conditioning_a = (products(h, c, k) + size(share_a) * all) / size(area);
  exact.bound_u = 2 * kRounding * (8 * conditioning_c * std::abs(kTexture.bc) + size(exact.u));
  exact.bound_v = 2 * kRounding * (8 * conditioning_a * std::abs(kTexture.ba) + size(exact.v));
  return exact;
}

using Make = std::function<Pair(std::mt19937_64&)>;

double between(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

glm::dvec3 in_cube(std::mt19937_64& random) {
  const double x = between(random, -1, 1);
  const double y = between(random, -1, 1);
  return {x, y, between(random, -1, 1)};
}

glm::dvec3 mixed(const texmap::Triangle3<double>& t, double a, double b) {
  return a * t.a + b * t.b + (1 - a - b) * t.c;
}

// The barycentric matrix divides by an area that may have been lost in its rounding: what flags that raises
// are its own, and traps are off for it.
glm::dvec2 map_by_textbook(const Pair& pair) {
  std::fenv_t ours;
  std::feholdexcept(&ours);
  const glm::dvec2 uv = map_by_barycentric(pair.triangle, kTexture, pair.hit);
  std::fesetenv(&ours);
  return uv;
}

// The worst error over its own bound, so that pairs of any conditioning stand side by side.
Reached worst_of(const Make& make) {
  std::mt19937_64 random(7);
  Reached reached{.bound = 1};
  double barycentric = 0;
  double in_float = 0;
  for (int n = 0; n < kPairs; ++n) {
    const Pair pair = make(random);
    const Exact exact = exact_of(pair);
    const glm::dvec2 uv = map_by_area_ratio(pair.triangle, kTexture, pair.hit);
    if (!exact.has_area) {
      // It maps to B2.
      reached.error = worse(reached.error, uv == kTexture.b ? 0 : NAN);
      continue;
    }
    const auto over = [&](const glm::dvec2& at) {
      return worse(size(at.x - exact.u) / exact.bound_u, size(at.y - exact.v) / exact.bound_v);
    };
    reached.error = worse(reached.error, over(uv));
    barycentric = worse(barycentric, over(map_by_textbook(pair)));
    in_float = worse(in_float, over(map_by_area_ratio(texmap::Triangle3<float>{glm::vec3(pair.triangle.a),
                                                                               glm::vec3(pair.triangle.b),
                                                                               glm::vec3(pair.triangle.c)},
                                                      kTexture, glm::vec3(pair.hit))));
  }
  reached.in_double = barycentric;
  reached.in_float = in_float;
  return reached;
}

StabilityCase map_case(const std::string& name, const std::string& input, double hardness,
                       const std::string& hardness_is, Make make) {
  return {.name = "maps_" + name,
          .stage = "triangle maps",
          .input = input,
          .hardness = hardness,
          .hardness_is = hardness_is,
          .promise = kPromise,
          .unit = "of the promised error (float32: its corners; double: the barycentric matrix)",
          .run = [make = std::move(make)] { return worst_of(make); }};
}

Pair inside(std::mt19937_64& random, const texmap::Triangle3<double>& t) {
  const double b = between(random, 0, 1);
  return {t, mixed(t, (1 - b) * between(random, 0, 1), b)};
}

StabilityCase sliver(double height, const std::string& power) {
  return map_case("sliver_" + power, "triangles " + power + " times as high as long", 1 / height,
                  "length over height", [height](std::mt19937_64& random) {
                    texmap::Triangle3<double> t{in_cube(random), in_cube(random), {}};
                    t.c = t.a + between(random, -0.2, 1.2) * (t.b - t.a) + height * in_cube(random);
                    return inside(random, t);
                  });
}

StabilityCase far(double distance, const std::string& power) {
  return map_case(
      "far_" + power, "triangles of 1 m, " + power + " m from the origin", distance, "distance over size",
      [distance](std::mt19937_64& random) {
        const glm::dvec3 middle = distance * in_cube(random);
        return inside(random, {middle + in_cube(random), middle + in_cube(random), middle + in_cube(random)});
      });
}

StabilityCase hypotenuse(double beside, const std::string& power) {
  return map_case("hypotenuse_" + power, "hits " + power + " of the height beside the hypotenuse",
                  1 / std::max(beside, 1e-18), "height over what is left of it",
                  [beside](std::mt19937_64& random) {
                    const texmap::Triangle3<double> t{in_cube(random), in_cube(random), in_cube(random)};
                    return Pair{t, mixed(t, between(random, 0, 1), beside)};
                  });
}

StabilityCase through_origin(double beside, const std::string& power) {
  return map_case("origin_" + power, "planes that pass the origin at " + power + " m",
                  1 / std::max(beside, 1e-18), "1 m over the distance", [beside](std::mt19937_64& random) {
                    texmap::Triangle3<double> t{in_cube(random), in_cube(random), {}};
                    t.c = between(random, -1, 1) * t.a + between(random, -1, 1) * t.b +
                          beside * in_cube(random);
                    return inside(random, t);
                  });
}

StabilityCase grazing(double slope, const std::string& power) {
  return map_case("along_axis_" + power, "planes within " + power + " of holding the z axis", 1 / slope,
                  "1 over the slope", [slope](std::mt19937_64& random) {
                    texmap::Triangle3<double> t{in_cube(random), in_cube(random), {}};
                    t.c = t.a + between(random, -1, 1) * (t.b - t.a) + slope * in_cube(random);
                    t.c.z += between(random, -1, 1);
                    return inside(random, t);
                  });
}

StabilityCase scaled(double scale, const std::string& power) {
  return map_case(
      "size_" + power, "triangles of " + power + " m", std::max(scale, 1 / scale),
      "size over 1 m, or the inverse", [scale](std::mt19937_64& random) {
        return inside(random, {scale * in_cube(random), scale * in_cube(random), scale * in_cube(random)});
      });
}

StabilityCase no_area() {
  return map_case("no_area", "corners on one line or in one place", 0x1p53, "length over height, at least",
                  [](std::mt19937_64& random) {
                    const glm::dvec3 a = in_cube(random);
                    const glm::dvec3 c = random() % 2 == 0 ? a : in_cube(random);
                    return Pair{{a, a, c}, random() % 2 == 0 ? a : in_cube(random)};
                  });
}

// Products of such differences are infinite: no area, so B2.
StabilityCase overflow(double scale, const std::string& power) {
  return {.name = "maps_overflow_" + power,
          .stage = "triangle maps",
          .input = "triangles of " + power + " m, whose area is infinite in double",
          .hardness = scale,
          .hardness_is = "size over 1 m",
          .promise = kPromise,
          .unit = "hits of 2000 that are not at B2",
          .run =
              [scale] {
                std::mt19937_64 random(7);
                Reached reached;
                for (int n = 0; n < kPairs; ++n) {
                  const Pair pair = inside(
                      random, {scale * in_cube(random), scale * in_cube(random), scale * in_cube(random)});
                  if (map_by_area_ratio(pair.triangle, kTexture, pair.hit) != kTexture.b) reached.error += 1;
                }
                return reached;
              },
          .raises = "infinity less infinity is how the map learns that there is no area"};
}

}  // namespace

std::vector<StabilityCase> triangle_map_cases() {
  return {sliver(1e-3, "1e_3"),
          sliver(1e-9, "1e_9"),
          sliver(1e-15, "1e_15"),
          hypotenuse(1e-6, "1e_6"),
          hypotenuse(1e-15, "1e_15"),
          hypotenuse(0, "0"),
          far(1e3, "1e3"),
          far(1e7, "1e7"),
          far(1e14, "1e14"),
          through_origin(1e-9, "1e_9"),
          through_origin(0, "0"),
          grazing(1e-3, "1e_3"),
          grazing(1e-9, "1e_9"),
          scaled(1e-20, "1e_20"),
          scaled(1e20, "1e20"),
          no_area(),
          overflow(1e200, "1e200")};
}

}  // namespace sweepkit::report
