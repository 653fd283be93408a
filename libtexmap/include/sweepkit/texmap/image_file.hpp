// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "sweepkit/texmap/image.hpp"

namespace sweepkit::texmap {

/// How a file's numbers stand for light. sRGB applies to integer files; float files are linear always.
enum class ColorSpace { kSrgb, kLinear };

/// Reads any image OpenImageIO knows, decoded to linear light; colours are not multiplied by alpha, and of
/// more than four channels the first four are taken. The first call loads the image module. Throws InputError
/// naming the file: missing, no image, cut short or otherwise damaged, no pixels, too large (over 2^31
/// texels), or NaN or infinity in a float image.
Image read_image(const std::filesystem::path& file, ColorSpace color_space);

class TexelSource;

/// Opens an image for a TextureSampler. An image of at most a quarter of `memory` bytes is read whole.
/// A larger one stays in its file if that is tiled; else it is unpacked, once, into a temporary file (8 bytes
/// a texel, 16 of float images; TMPDIR says where) that has no name and goes with the program. Throws
/// InputError as read_image() does, and, for files that stay where they are, when a damaged part is first
/// read; OutputError if the temporary file cannot be written.
std::shared_ptr<const TexelSource> open_image(const std::filesystem::path& file, ColorSpace color_space,
                                              std::size_t memory);

/// Memory that such an image holds besides tiles.
std::size_t bytes_held(const TexelSource& image);

struct ImageFileInfo {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::string format;       ///< "png", "jpeg", "tiff", "openexr", ...
  std::string sample_type;  ///< "uint8", "uint16", "half", "float"
};
/// The header alone. Throws InputError as read_image does.
ImageFileInfo read_image_info(const std::filesystem::path& file);

enum class ImageFormat { kPng, kJpeg, kTiff, kExr };

/// The format that a file name ends in: .png .jpg .jpeg .tif .tiff .exr. Throws InputError for any other.
ImageFormat image_format(const std::filesystem::path& file);

/// The bytes of an image file: PNG, JPEG and TIFF 8-bit sRGB (or linear, for data), EXR 16-bit half linear;
/// file_image.hpp has other depths and more. Values are rounded to nearest and clamped to what the format
/// holds, NaN becomes 0; JPEG leaves alpha out. The same image gives the same bytes (no time stamps). Throws
/// OutputError if the encoder fails or the module is missing.
std::vector<std::byte> encode_image(const Image& image, ImageFormat format,
                                    ColorSpace color_space = ColorSpace::kSrgb);

/// Was the image module loaded in this process? (--explain's counters and tests read it.)
bool is_image_module_loaded();

}  // namespace sweepkit::texmap
