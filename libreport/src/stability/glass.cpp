// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Symbols: c the cosine of arrival, b the one beyond, eta the index here over the one beyond; against Snell
// and Fresnel in quadruple precision.

#include "fresnel.hpp"
#include "quad.hpp"
#include "stability/stability_case.hpp"

namespace sweepkit::report {
namespace {

constexpr const char* kStage = "glass";
constexpr const char* kPromise =
    "mirrored and refracted shares by Fresnel's equations, 0 to 1, total from the "
    "critical angle on";

template <class Real>
Real square_root_of(Real x) {
  return std::sqrt(x);
}
template <>
Quad square_root_of(Quad x) {
  return sqrtq(x);
}

template <class Real>
Real fresnel(Real c, Real eta) {
  const Real rest = 1 - eta * eta * (1 - c * c);
  if (!(rest > 0)) return 1;
  const Real b = square_root_of(rest);
  const Real s = (eta * c - b) / (eta * c + b);
  const Real p = (c - eta * b) / (c + eta * b);
  return (s * s + p * p) / 2;
}

double apart(double share, Quad exact) {
  return static_cast<double>(fabsq(share - exact));
}

// `short_of` the critical angle, by 1 - eta^2 (1 - c^2) = b^2.
StabilityCase critical(double beyond, const std::string& power) {
  return {.name = "glass_critical_" + power,
          .stage = kStage,
          .input = "from glass of 1.5 where the cosine beyond is " + power,
          .hardness = 1 / beyond,
          .hardness_is = "1 over the cosine beyond",
          .promise = kPromise,
          .unit = "of the light",
          .run = [beyond] {
            const double eta = 1.5;
            const double c = std::sqrt(1 - (1 - beyond) * (1 + beyond) / (eta * eta));
            const double error =
                apart(render::fresnel_exact(c, render::refracted_cosine(c, eta), eta), fresnel<Quad>(c, eta));
            // b^2 is wrong by 6 roundings of 1 and so is b by those over b, but by no more than their root;
            // |dF/db| <= 4 (eta + 1 / eta) / c there.
            const double off = std::min(6 * kRounding / beyond, std::sqrt(6 * kRounding));
            return Reached{.error = error,
                           .bound = 4 * (eta + 1 / eta) / c * off + 8 * kRounding,
                           .in_float = apart(static_cast<double>(fresnel<float>(static_cast<float>(c), 1.5F)),
                                             fresnel<Quad>(c, eta)),
                           .in_double = apart(fresnel<double>(c, eta), fresnel<Quad>(c, eta))};
          }};
}

StabilityCase index_beside_one(double beside, const std::string& power) {
  return {.name = "glass_index_1_plus_" + power,
          .stage = kStage,
          .input = "indices 1 + " + power + " and its inverse, from upright to grazing",
          .hardness = 1 / beside,
          .hardness_is = "1 over the index's difference from 1",
          .promise = kPromise,
          .unit = "of the light",
          .run = [beside] {
            Reached reached;
            double in_float = 0;
            // As above, b from eta's own rest: at most the root of 6 roundings where both cosines vanish, and
            // F changes by no more than its difference, 1, over b's own size.
            reached.bound = 8 * std::sqrt(6 * kRounding);
            for (const double eta : {1 + beside, 1 / (1 + beside)}) {
              for (int i = 1; i <= 64; ++i) {
                const double c = i / 64.0;
                const Quad exact = fresnel<Quad>(c, eta);
                reached.error =
                    worse(reached.error,
                          apart(render::fresnel_exact(c, render::refracted_cosine(c, eta), eta), exact));
                in_float = worse(
                    in_float,
                    apart(static_cast<double>(fresnel<float>(static_cast<float>(c), static_cast<float>(eta))),
                          exact));
              }
            }
            reached.in_float = in_float;
            return reached;
          }};
}

StabilityCase index_one() {
  return {.name = "glass_index_1",
          .stage = kStage,
          .input = "index 1, from upright to grazing",
          .hardness = 0x1p53,
          .hardness_is = "1 over the index's difference from 1, at least",
          .promise = "no boundary mirrors nothing",
          .unit = "of the light",
          .run = [] {
            Reached reached;
            for (int i = 0; i <= 64; ++i) {
              const double c = i / 64.0;
              reached.error =
                  worse(reached.error, std::abs(render::fresnel_exact(c, render::refracted_cosine(c, 1), 1)));
            }
            return reached;
          }};
}

StabilityCase grazing(double cosine, const std::string& power) {
  return {.name = "glass_grazing_" + power,
          .stage = kStage,
          .input = "onto glass of 1.5 at a cosine of " + power,
          .hardness = 1 / cosine,
          .hardness_is = "1 over the cosine",
          .promise = kPromise,
          .unit = "of the light",
          .run = [cosine] {
            const double eta = 1 / 1.5;
            const double share = render::fresnel_exact(cosine, render::refracted_cosine(cosine, eta), eta);
            // Sums of unlike sizes: nothing cancels.
            return Reached{.error = apart(share, fresnel<Quad>(cosine, eta)), .bound = 16 * kRounding};
          }};
}

}  // namespace

std::vector<StabilityCase> glass_cases() {
  return {critical(1e-3, "1e_3"),
          critical(1e-6, "1e_6"),
          critical(1e-9, "1e_9"),
          index_beside_one(1e-3, "1e_3"),
          index_beside_one(1e-6, "1e_6"),
          index_beside_one(1e-9, "1e_9"),
          index_one(),
          grazing(1e-6, "1e_6"),
          grazing(1e-300, "1e_300")};
}

}  // namespace sweepkit::report
