// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "sweepkit/texmap/image.hpp"
#include "sweepkit/texmap/image_file.hpp"
#include "sweepkit/texmap/procedural.hpp"

namespace sweepkit::scene {

/// An image and what is made of it, kept for the next scene that needs the same.
struct StoredImage {
  std::shared_ptr<const texmap::Image> image;
  bool is_new = false;  ///< read or baked by this call
};

/// An image as a file of that kind, made smaller where it is larger.
struct ImageForm {
  texmap::ImageFormat format = texmap::ImageFormat::kPng;
  int most_texels = 0;         ///< on a side; 0: as large as it is
  bool is_normal_map = false;  ///< its numbers are linear, and made smaller as vectors

  bool operator==(const ImageForm&) const = default;
};

/// Images that many scenes share: a file is read once, a procedural texture that repeats is baked once, and
/// each is encoded once, however many scenes ask. A file is taken not to change meanwhile. Results are the
/// same as without a store. Any number of threads may ask at once: those who want the same image wait for the
/// first.
class ImageStore {
 public:
  static constexpr std::size_t kMostBytes = std::size_t{512} << 20;

  /// Keeps at most `most_bytes` of texels and encoded bytes, and a thousand images, and lets the oldest go,
  /// so that scenes with an image each do not fill the memory.
  explicit ImageStore(std::size_t most_bytes = kMostBytes);
  ~ImageStore();
  ImageStore(const ImageStore&) = delete;
  ImageStore& operator=(const ImageStore&) = delete;

  /// texmap::read_image(). Throws what that throws, for every scene that asks.
  StoredImage read(const std::filesystem::path& file, texmap::ColorSpace color_space);

  /// The unit square of a procedural texture in `size` texels. Precondition:
  /// texmap::repeats_in_unit_square(). `threads` as in texmap::BakeOptions.
  StoredImage bake(const texmap::Procedural& procedural, glm::ivec2 size, int threads = 0);

  /// The image as a file, sRGB but for normal maps; kept where the image came from this store, in one form.
  std::shared_ptr<const std::vector<std::byte>> encoded(const std::shared_ptr<const texmap::Image>& image,
                                                        const ImageForm& form = {});

  /// A file's own bytes. Throws InputError if it cannot be read.
  std::shared_ptr<const std::vector<std::byte>> file_bytes(const std::filesystem::path& file);

 private:
  struct Shelf;
  std::unique_ptr<Shelf> shelf_;
};

}  // namespace sweepkit::scene
