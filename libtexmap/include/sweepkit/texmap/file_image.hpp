// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "sweepkit/texmap/image.hpp"
#include "sweepkit/texmap/image_file.hpp"

namespace sweepkit::texmap {

/// Where an image lies in a larger picture, pixels, y down from the top. Only EXR files keep it.
struct ImageWindow {
  int x = 0;
  int y = 0;
  int full_width = 0;  ///< 0: the image is the whole picture
  int full_height = 0;
};

struct FileChannel {
  std::string name;  ///< "R", "G", "B", "A", "Y"; in EXR also "depth.Z", ...
  int bits = 8;      ///< 8 and 16 are integers, in EXR 16 is half and 32 float

  bool operator==(const FileChannel&) const = default;
};

/// The numbers of an image file as they stand in it, not decoded: what a file is made from, or was read as.
struct FileImage {
  int width = 0;
  int height = 0;
  ImageFormat format = ImageFormat::kPng;
  bool is_srgb = true;  ///< what the numbers are; no matter in EXR, which is linear
  std::vector<FileChannel> channels;
  /// width * height * channels, interleaved; float for every channel of an EXR.
  std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>> samples;
  ImageWindow window;
  std::string description;  ///< one line of text that the file keeps; empty: none
};

/// Further channels for an EXR file: as many names as the float image has channels. They are kept as 32-bit
/// floats.
struct ImageLayer {
  std::vector<std::string> channels;
  const Image* image = nullptr;
};

struct FileEncoding {
  ImageFormat format = ImageFormat::kPng;
  ColorSpace color_space = ColorSpace::kSrgb;
  int bits = 0;  ///< a sample: one that holds_bits() says the format has; 0: 8, for EXR 16
  std::span<const ImageLayer> layers = {};  ///< EXR alone; each as large as the image
};

/// Has the format samples of so many bits? PNG and TIFF 8 and 16, JPEG 8, EXR 16 (half) and 32 (float).
bool holds_bits(ImageFormat format, int bits);

/// The image as a file of that kind holds it: by the sRGB curve or linear, clamped to what the format holds
/// and rounded to nearest; NaN becomes 0, alpha is left out for JPEG. Alpha itself is linear, and colours are
/// taken as they are: multiplied by it or not is for the caller, who knows that EXR has them multiplied and
/// PNG and TIFF have not. Precondition: holds_bits().
FileImage to_file_image(const Image& image, const FileEncoding& encoding);

/// The bytes of the file. The same image gives the same bytes (no time stamps). Throws OutputError if the
/// encoder fails or the module is missing.
std::vector<std::byte> encode_file(const FileImage& image);

/// Loads what encodes and reads files now instead of with the first one: that takes some 0.3 s, which who
/// keeps to a time wants to have behind them. Throws OutputError if the module is missing.
void load_image_module();

/// Reads a PNG, JPEG, TIFF or EXR file, all its channels. Throws InputError as read_image() does, and for any
/// other format and for over 64 channels.
FileImage read_file_image(const std::filesystem::path& file);

/// The description of such a file, by its header alone; empty where it has none, or where there is no such
/// file or it is no image.
std::string read_description(const std::filesystem::path& file);

}  // namespace sweepkit::texmap
