// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A box of the ratio's own width, which need not be whole: a texel that lies half in it counts half. In units
// of 1/size of a texel all shares are whole numbers; an image has at most 2^31 texels of 16 bits, so that a
// sum of all of it stays below 2^47.

#include "sweepkit/texmap/shrink.hpp"

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace sweepkit::texmap {
namespace {

struct Share {
  int from = 0;         // texel of the image
  int to = 0;           // texel of the smaller one
  std::int64_t of = 0;  // `large` is a whole texel of the smaller one
};

// What each texel along one side gives to which.
std::vector<Share> shares_along(int large, int small) {
  std::vector<Share> shares;
  for (int to = 0; to < small; ++to) {
    const std::int64_t low = std::int64_t{to} * large;
    const std::int64_t high = low + large;
    for (std::int64_t from = low / small; from * small < high; ++from) {
      shares.push_back(
          {static_cast<int>(from), to, std::min(high, (from + 1) * small) - std::max(low, from * small)});
    }
  }
  return shares;
}

template <class Texel>
std::vector<Texel> shrink_texels(const std::vector<Texel>& texels, const Image& image, glm::ivec2 size) {
  using Sum = std::conditional_t<std::is_integral_v<Texel>, std::uint64_t, double>;
  const auto channels = static_cast<std::size_t>(image.channels);
  const std::size_t width = static_cast<std::size_t>(size.x) * channels;
  const Sum whole = static_cast<Sum>(image.width) * static_cast<Sum>(image.height);
  const std::vector<Share> across = shares_along(image.width, size.x);
  std::vector<Texel> out(width * static_cast<std::size_t>(size.y));
  std::vector<Sum> sums(width);
  const auto finish_row = [&](int row) {
    for (std::size_t i = 0; i < width; ++i) {
      Texel& texel = out[static_cast<std::size_t>(row) * width + i];
      if constexpr (std::is_integral_v<Texel>) {
        texel = static_cast<Texel>((sums[i] + whole / 2) / whole);
      } else {
        texel = static_cast<Texel>(sums[i] / whole);
      }
    }
    std::fill(sums.begin(), sums.end(), Sum{0});
  };
  int row = 0;
  for (const Share& down : shares_along(image.height, size.y)) {
    if (down.to != row) finish_row(row++);
    const Texel* from = texels.data() + static_cast<std::size_t>(down.from) *
                                            static_cast<std::size_t>(image.width) * channels;
    for (const Share& share : across) {
      for (std::size_t c = 0; c < channels; ++c) {
        sums[static_cast<std::size_t>(share.to) * channels + c] +=
            static_cast<Sum>(down.of * share.of) *
            static_cast<Sum>(from[static_cast<std::size_t>(share.from) * channels + c]);
      }
    }
  }
  finish_row(row);
  return out;
}

}  // namespace

glm::ivec2 fitting_size(glm::ivec2 size, int most) {
  const int longest = std::max(size.x, size.y);
  if (longest <= most) return size;
  const auto fitted = [&](int side) {
    return static_cast<int>(std::max<std::int64_t>((std::int64_t{side} * most + longest / 2) / longest, 1));
  };
  return {fitted(size.x), fitted(size.y)};
}

Image shrink(const Image& image, glm::ivec2 size) {
  Image out{size.x, size.y, image.channels, {}};
  std::visit([&](const auto& texels) { out.texels = shrink_texels(texels, image, size); }, image.texels);
  return out;
}

}  // namespace sweepkit::texmap
