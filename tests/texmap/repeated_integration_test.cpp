// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
// The filters integral-1, -2 and -3 against sums over every texel.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <random>

#include "spline_reference.hpp"
#include "sweepkit/texmap/texture_sampler.hpp"

namespace sweepkit::texmap {
namespace {

using reference::Box;
using reference::random_image;

constexpr Wrap kWraps[] = {Wrap::kRepeat, Wrap::kClamp, Wrap::kMirror};
// A level of 8 bits; promises are told in it.
constexpr double kLevel = 1.0 / 255;

// A texture with its own cache.
class Table {
 public:
  Table(Image image, Wrap wrap, int order)
      : image_(std::make_shared<const Image>(std::move(image))),
        order_(order),
        sampler_({image_, wrap}, filter(order), cache_, 0) {}
  const Image& image() const { return *image_; }

  glm::vec3 over(const Box& box) {
    const glm::dvec2 size(image_->width, image_->height);
    return over(UvBox{{box.x / size.x, 1 - (box.y + order_ * box.height) / size.y},
                      {(box.x + order_ * box.width) / size.x, 1 - box.y / size.y}});
  }
  glm::vec3 over(const UvBox& box) { return sampler_.over_box(box, thread_); }
  glm::vec3 sample(const Footprint& footprint) { return sampler_.sample(footprint, thread_); }

 private:
  static Filter filter(int order) {
    return static_cast<Filter>(static_cast<int>(Filter::kIntegral1) + order - 1);
  }
  std::shared_ptr<const Image> image_;
  int order_;
  TileCache cache_;
  TextureSampler sampler_;
  FilterThread thread_{cache_};
};

class RepeatedIntegration : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Order, RepeatedIntegration, testing::Values(1, 2, 3));

TEST_P(RepeatedIntegration, IsExactForIntegerCorners) {
  std::mt19937 random(1);
  // Powers of two: (u,v) name the corners exactly. One below and one above a tile's side.
  for (const auto& [width, height] : {std::pair{8, 4}, std::pair{1, 16}, std::pair{128, 256}}) {
    for (const Wrap wrap : kWraps) {
      Table table(random_image(width, height, 2), wrap, GetParam());
      for (int n = 0; n < 1000; ++n) {
        const auto whole = [&](int low, int high) {
          return static_cast<double>(low +
                                     static_cast<int>(random() % static_cast<unsigned>(high - low + 1)));
        };
        const Box box{whole(-3 * width, 3 * width), whole(-3 * height, 3 * height), whole(1, 20),
                      whole(1, 20)};
        const glm::vec3 color = table.over(box);
        for (int k = 0; k < 3; ++k) {
          const double want = reference::value<reference::Whole>(table.image(), wrap, box, GetParam(), k);
          // Half a step of a float, which is what the result is rounded to.
          EXPECT_LE(std::abs(color[k] - want), std::ldexp(1.0000001 * want, -24))
              << box.x << ' ' << box.y << ' ' << box.width << ' ' << box.height;
        }
      }
    }
  }
}

TEST_P(RepeatedIntegration, AgreesWithASumOverTheTexelsOnBoxesInAnyPlace) {
  std::mt19937 random(3);
  const auto real = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (const bool is_float : {false, true}) {
    for (const auto& [width, height] :
         {std::pair{7, 5}, std::pair{1, 1}, std::pair{64, 65}, std::pair{200, 100}}) {
      for (const Wrap wrap : kWraps) {
        Table table(random_image(width, height, 4, is_float), wrap, GetParam());
        for (int n = 0; n < 300; ++n) {
          // From what is just not widened to more than the texture.
          const Box box{real(-3 * width, 3 * width), real(-3 * height, 3 * height), std::exp2(real(0, 6)),
                        std::exp2(real(0, 6))};
          const glm::vec3 color = table.over(box);
          for (int k = 0; k < 3; ++k) {
            EXPECT_NEAR(color[k], reference::value<long double>(table.image(), wrap, box, GetParam(), k),
                        1e-4 * kLevel)
                << box.x << ' ' << box.y << ' ' << box.width << ' ' << box.height;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace sweepkit::texmap
