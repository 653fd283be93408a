// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT

#include "image_header.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace sweepkit::scene {
namespace {

using namespace std::string_literals;

std::optional<ImageHeader> header_of(std::string_view text) {
  return image_header(std::as_bytes(std::span(text)));
}

const std::string kPng = "\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\x01\x02\0\0\0\x03"s;

// A frame of 3 x 258 with so many components, after other segments.
std::string jpeg(const std::string& segments, char components = 3) {
  return "\xff\xd8"s + segments + "\xff\xc2\0\x0b\x08\x01\x02\0\x03"s + components;
}

std::string exif(const std::string& tiff) {
  const std::string body = "Exif\0\0"s + tiff;
  return "\xff\xe1\0"s + static_cast<char>(body.size() + 2) + body;
}

TEST(ImageHeader, OfAPng) {
  const auto header = header_of(kPng);
  ASSERT_TRUE(header.has_value());
  EXPECT_FALSE(header->is_jpeg);
  EXPECT_EQ(header->width, 258);
  EXPECT_EQ(header->height, 3);
}

TEST(ImageHeader, OfAJpegBehindOtherSegments) {
  const auto header = header_of(jpeg("\xff\xe0\0\x04zz"s, 4));
  ASSERT_TRUE(header.has_value());
  EXPECT_TRUE(header->is_jpeg);
  EXPECT_EQ(header->width, 3);
  EXPECT_EQ(header->height, 258);
  EXPECT_EQ(header->components, 4);
  EXPECT_EQ(header->orientation, 1);
}

TEST(ImageHeader, ExifTurnsAJpegInEitherByteOrder) {
  const std::string little = "II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0\x06\0\0\0"s;
  const std::string big = "MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x08\0\0"s;
  EXPECT_EQ(header_of(jpeg(exif(little)))->orientation, 6);
  EXPECT_EQ(header_of(jpeg(exif(big)))->orientation, 8);
  EXPECT_EQ(header_of(jpeg(exif("II*\0\xff\xff\xff\xff")))->orientation, 1) << "a directory nowhere";
}

TEST(ImageHeader, EveryPrefixIsToldOrNot) {
  for (const std::string& whole :
       {kPng, jpeg(exif("II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0\x06\0\0\0"s))}) {
    for (std::size_t size = 0; size < whole.size(); ++size) {
      EXPECT_FALSE(header_of(std::string_view(whole).substr(0, size)).has_value()) << size;
    }
    EXPECT_TRUE(header_of(whole).has_value());
  }
  EXPECT_FALSE(header_of("\xff\xd8\xff\xe0\0\0\0\0\0\0\0\0\0\0"s).has_value())
      << "a segment that goes nowhere";
  EXPECT_FALSE(header_of("GIF89a and more than enough of it").has_value());
}

}  // namespace
}  // namespace sweepkit::scene
