// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// mean_flip A.png B.png: prints the mean of FLIP of two pictures, for the scripts here.
#include <cstdio>
#include <exception>

#include "sweepkit/texmap/image_error.hpp"
#include "sweepkit/texmap/image_file.hpp"

int main(int count, char** arguments) {
  if (count != 3) {
    std::fputs("usage: mean_flip A.png B.png\n", stderr);
    return 2;
  }
  try {
    using namespace sweepkit::texmap;
    const Image a = read_image(arguments[1], ColorSpace::kSrgb);
    const Image b = read_image(arguments[2], ColorSpace::kSrgb);
    std::printf("%.6f\n", mean_flip(a, b));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mean_flip: %s\n", error.what());
    return 2;
  }
}
