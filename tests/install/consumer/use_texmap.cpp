// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// An image to a PNG file and back: the image module, which lies beside no program of ours here, is found.
#include <cstdio>
#include <fstream>

#include "sweepkit/texmap/image_file.hpp"

using namespace sweepkit;

int main() {
  const texmap::Image image{2, 1, 3, std::vector<std::uint16_t>{0, 257, 65535, 514, 257 * 128, 771}};
  const std::vector<std::byte> png =
      texmap::encode_image(image, texmap::ImageFormat::kPng, texmap::ColorSpace::kLinear);
  const char* const file = "use_texmap.png";
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
  const texmap::Image again = texmap::read_image(file, texmap::ColorSpace::kLinear);
  std::remove(file);
  std::printf("texmap: %d x %d texels from %zu bytes\n", again.width, again.height, png.size());
  return again.texels == image.texels ? 0 : 1;
}
