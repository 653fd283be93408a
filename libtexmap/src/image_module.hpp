// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace sweepkit::texmap {

/// The border between libtexmap and the image module (the one place that knows OpenImageIO). Both sides are
/// built together; errors cross it as text, not as exceptions. A change of this struct changes the symbol's
/// name.
struct ModuleImage {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::variant<std::vector<std::uint16_t>, std::vector<float>>
      samples;  ///< the file's own numbers, not decoded
};

struct ModuleInfo {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::string format;
  std::string sample_type;
};

struct ModuleEncoding {
  const char* extension;  ///< "png", "jpg", "tif", "exr"
  int width;
  int height;
  int channels;
  bool is_srgb;
  const std::uint8_t* bytes;  ///< for png, jpg, tif
  const float* floats;        ///< for exr
};

/// Each returns an empty text, or what went wrong.
struct ImageModule {
  std::string (*read)(const std::string& file, ModuleImage& image);
  std::string (*read_info)(const std::string& file, ModuleInfo& info);
  std::string (*encode)(const ModuleEncoding& encoding, std::vector<std::byte>& bytes);
};

inline constexpr const char* kImageModuleSymbol = "sweepkit_image_module_1";
inline constexpr const char* kImageModuleFile = "sweepkit-image-files.so";

}  // namespace sweepkit::texmap
