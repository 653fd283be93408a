// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "sweepkit/texmap/file_image.hpp"

namespace sweepkit::texmap {

/// The border between libtexmap and the image module (its one place that knows OpenImageIO). Both sides are
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
  std::string description;
};

/// An image file that stays open to be read piece by piece.
struct ModuleFile {
  void* handle = nullptr;  ///< to be given to close()
  int width = 0;
  int height = 0;
  int channels = 0;
  int sample_bytes = 2;   ///< 1 and 2 are unsigned integers, 4 is float
  bool is_tiled = false;  ///< any piece costs about what it holds; else every row above it is read as well
};

struct ModuleRect {
  int x, y, width, height;
};

/// Takes rows first..first + count - 1, as std::uint16_t or float. Returns what is wrong with them, or an
/// empty text.
using TakeRows = std::string (*)(void* context, int first, int count, const void* samples);

/// What a function returns where memory runs out.
inline constexpr const char* kOutOfMemory = "out of memory";

/// Each returns an empty text, or what went wrong.
struct ImageModule {
  std::string (*read)(const std::string& file, ModuleImage& image);
  std::string (*read_info)(const std::string& file, ModuleInfo& info);
  /// The whole image in bands of rows, from the top, few of them in memory at a time.
  std::string (*read_rows)(const std::string& file, TakeRows take, void* context);
  /// `cache_bytes` bound what the file's own tiles take in memory.
  std::string (*open)(const std::string& file, std::size_t cache_bytes, ModuleFile& opened);
  /// A rectangle inside the image, row by row, all channels, samples as `sample_bytes` says. Any number of
  /// threads.
  std::string (*read_rect)(void* handle, const ModuleRect& rect, void* samples);
  void (*close)(void* handle);
  std::string (*encode)(const FileImage& image, std::vector<std::byte>& bytes);
  /// All channels of a PNG, JPEG, TIFF or EXR file.
  std::string (*read_file)(const std::string& file, FileImage& image);
};

/// The module, loaded by the first call. Throws OutputError if it is missing, and std::bad_alloc if there is
/// no memory for it.
const ImageModule& image_module();

/// Throws InputError if there is no such file, or if it is a folder.
void check_image_exists(const std::filesystem::path& file);

/// What the module found wrong, as an InputError about the file or an OutputError; std::bad_alloc for
/// kOutOfMemory.
void throw_if_unreadable(const std::filesystem::path& file, const std::string& problem);
void throw_if_not_encoded(const std::string& problem);

inline constexpr const char* kImageModuleSymbol = "sweepkit_image_module_3";
inline constexpr const char* kImageModuleFile = "sweepkit-image-files.so";

}  // namespace sweepkit::texmap
