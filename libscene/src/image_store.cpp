// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Few entries, each worth milliseconds: a list that is looked through from the front. Each entry has a lock
// of its own, held while it is filled, so that different images are read side by side.

#include "sweepkit/scene/image_store.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <fstream>
#include <mutex>
#include <span>
#include <utility>
#include <variant>

#include "sweepkit/error.hpp"
#include "sweepkit/texmap/bake.hpp"
#include "sweepkit/texmap/normal_image.hpp"
#include "sweepkit/texmap/shrink.hpp"

namespace sweepkit::scene {
namespace {

// Scenes with a small image each, or one that cannot be read, would make the list longer with every scene.
// This many are looked through in microseconds.
constexpr std::size_t kMostEntries = 1000;

struct FileKey {
  std::filesystem::path file;
  texmap::ColorSpace color_space = texmap::ColorSpace::kSrgb;
  bool operator==(const FileKey&) const = default;
};

struct BakeKey {
  texmap::Procedural procedural;
  glm::ivec2 size{0};
  bool operator==(const BakeKey&) const = default;
};

// A file as it is, not decoded.
struct BytesKey {
  std::filesystem::path file;
  bool operator==(const BytesKey&) const = default;
};

using Key = std::variant<FileKey, BakeKey, BytesKey>;

using Bytes = std::vector<std::byte>;

struct Entry {
  Key key;
  std::mutex filling;
  std::shared_ptr<const texmap::Image> image;
  std::shared_ptr<const Bytes> file;
  ImageForm form;         // of `file`, where it was encoded
  std::size_t bytes = 0;  // of both, under the shelf's lock
};

std::shared_ptr<const Bytes> encode(const texmap::Image& image, const ImageForm& form) {
  const glm::ivec2 size(image.width, image.height);
  const glm::ivec2 fitting = form.most_texels > 0 ? texmap::fitting_size(size, form.most_texels) : size;
  const auto write = [&](const texmap::Image& fitted) {
    return std::make_shared<const Bytes>(texmap::encode_image(
        fitted, form.format, form.is_normal_map ? texmap::ColorSpace::kLinear : texmap::ColorSpace::kSrgb));
  };
  if (fitting == size) return write(image);
  return write(form.is_normal_map ? texmap::shrink_normals(image, fitting) : texmap::shrink(image, fitting));
}

Bytes read_bytes(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  Bytes bytes;
  std::array<char, std::size_t{1} << 16> block;
  while (stream) {
    stream.read(block.data(), block.size());
    const auto read = std::as_bytes(std::span(block)).first(static_cast<std::size_t>(stream.gcount()));
    bytes.insert(bytes.end(), read.begin(), read.end());
  }
  if (!stream.eof()) throw InputError({.file = file.string()}, "cannot be read");
  return bytes;
}

}  // namespace

struct ImageStore::Shelf {
  std::size_t most_bytes;
  std::mutex lock;
  std::deque<std::shared_ptr<Entry>> entries;  // oldest first
  std::size_t bytes = 0;

  std::shared_ptr<Entry> entry(const Key& key) {
    const std::lock_guard guard(lock);
    const auto found =
        std::find_if(entries.begin(), entries.end(), [&](const auto& one) { return one->key == key; });
    if (found != entries.end()) return *found;
    if (entries.size() == kMostEntries) drop_oldest();
    entries.push_back(std::make_shared<Entry>());
    entries.back()->key = key;
    return entries.back();
  }

  // What is let go stays whole for whoever holds it.
  void drop_oldest() {
    bytes -= entries.front()->bytes;
    entries.pop_front();
  }

  std::shared_ptr<Entry> entry_of(const std::shared_ptr<const texmap::Image>& image) {
    const std::lock_guard guard(lock);
    // An entry that is being filled has no size yet, and its image is not to be looked at.
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [&](const auto& one) { return one->bytes > 0 && one->image == image; });
    return found != entries.end() ? *found : nullptr;
  }

  // An entry that was let go meanwhile no longer counts.
  void grow(const std::shared_ptr<Entry>& entry, std::size_t by) {
    const std::lock_guard guard(lock);
    if (std::find(entries.begin(), entries.end(), entry) == entries.end()) return;
    entry->bytes += by;
    bytes += by;
    while (bytes > most_bytes) drop_oldest();
  }

  template <class Make>
  StoredImage image(const Key& key, Make&& make) {
    const std::shared_ptr<Entry> of_key = entry(key);
    const std::lock_guard filling(of_key->filling);
    if (of_key->image) return {of_key->image, false};
    of_key->image = std::make_shared<const texmap::Image>(make());
    grow(of_key, of_key->image->bytes());
    return {of_key->image, true};
  }
};

ImageStore::ImageStore(std::size_t most_bytes) : shelf_(new Shelf{.most_bytes = most_bytes}) {}

ImageStore::~ImageStore() = default;

StoredImage ImageStore::read(const std::filesystem::path& file, texmap::ColorSpace color_space) {
  return shelf_->image(FileKey{file, color_space}, [&] { return texmap::read_image(file, color_space); });
}

StoredImage ImageStore::bake(const texmap::Procedural& procedural, glm::ivec2 size, int threads) {
  return shelf_->image(BakeKey{procedural, size}, [&] {
    return texmap::bake(procedural, {}, {size.x, size.y, threads}).image;
  });
}

std::shared_ptr<const Bytes> ImageStore::encoded(const std::shared_ptr<const texmap::Image>& image,
                                                 const ImageForm& form) {
  const std::shared_ptr<Entry> entry = shelf_->entry_of(image);
  if (!entry) return encode(*image, form);
  const std::lock_guard filling(entry->filling);
  if (!entry->file) {
    entry->file = encode(*image, form);
    entry->form = form;
    shelf_->grow(entry, entry->file->size());
  }
  return entry->form == form ? entry->file : encode(*image, form);
}

std::shared_ptr<const Bytes> ImageStore::file_bytes(const std::filesystem::path& file) {
  const std::shared_ptr<Entry> entry = shelf_->entry(BytesKey{file});
  const std::lock_guard filling(entry->filling);
  if (!entry->file) {
    entry->file = std::make_shared<const Bytes>(read_bytes(file));
    shelf_->grow(entry, entry->file->size());
  }
  return entry->file;
}

}  // namespace sweepkit::scene
