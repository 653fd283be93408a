// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Values are hashed as they were read, so that comments, spacing and the file's own name do not count, and
// each with its kind and size before it, so that no two scenes make the same bytes. What names a file is told
// by the disk alone and not by a list of keys, which a new key would make wrong without anyone seeing.

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdio>
#include <fstream>
#include <memory>
#include <set>

#include "json_value.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/scene/document.hpp"

namespace sweepkit::scene {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 20;

class ContentHash {
 public:
  explicit ContentHash(std::filesystem::path folder)
      : folder_(std::move(folder)), state_(XXH3_createState(), XXH3_freeState) {
    if (!state_) throw std::bad_alloc();
    XXH3_128bits_reset(state_.get());
  }

  void add_text(std::string_view text) {
    add_number(text.size());
    add_bytes(text.data(), text.size());
  }

  /// A scene: what it tells editors is no part of it.
  void add_scene(const JsonValue& root) {
    const auto* members = std::get_if<JsonValue::Object>(&root.data);
    if (members == nullptr) return add(root);
    const auto is_said = [](const JsonMember& member) { return member.key != "$schema"; };
    add_number(root.data.index());
    add_number(static_cast<std::uint64_t>(std::count_if(members->begin(), members->end(), is_said)));
    for (const JsonMember& member : *members) {
      if (is_said(member)) add_member(member);
    }
  }

  void add(const JsonValue& value) {
    add_number(value.data.index());
    std::visit([this](const auto& data) { add_data(data); }, value.data);
  }

  std::string digits() const {
    const XXH128_hash_t hash = XXH3_128bits_digest(state_.get());
    std::array<char, 33> text{};
    std::snprintf(text.data(), text.size(), "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                  static_cast<unsigned long long>(hash.low64));
    return text.data();
  }

 private:
  void add_bytes(const void* bytes, std::size_t size) { XXH3_128bits_update(state_.get(), bytes, size); }

  void add_number(std::uint64_t number) {
    std::array<std::byte, 8> bytes;
    for (std::size_t i = 0; i < 8; ++i) bytes[i] = static_cast<std::byte>(number >> (8 * i));
    add_bytes(bytes.data(), bytes.size());
  }

  void add_data(std::nullptr_t) {}
  void add_data(bool value) { add_number(value ? 1 : 0); }
  void add_data(double value) { add_number(std::bit_cast<std::uint64_t>(value)); }
  void add_data(const std::string& text) {
    add_text(text);
    add_file(text);
  }
  void add_data(const JsonValue::Array& items) {
    add_number(items.size());
    for (const JsonValue& item : items) add(item);
  }
  void add_data(const JsonValue::Object& members) {
    add_number(members.size());
    for (const JsonMember& member : members) add_member(member);
  }
  void add_member(const JsonMember& member) {
    add_text(member.key);
    add(member.value);
  }

  // The bytes of the file of that name, once.
  void add_file(const std::string& name) {
    std::error_code ignored;
    const std::filesystem::path file = folder_ / name;
    if (name.empty() || !std::filesystem::is_regular_file(file, ignored) || !files_.insert(name).second)
      return;
    std::ifstream stream(file, std::ios::binary);
    std::vector<char> block(kBlock);
    std::uint64_t size = 0;
    while (stream) {
      stream.read(block.data(), static_cast<std::streamsize>(block.size()));
      const auto count = static_cast<std::size_t>(stream.gcount());
      add_bytes(block.data(), count);
      size += count;
    }
    if (!stream.eof()) throw InputError({.file = file.string()}, "cannot be read");
    add_number(size);
  }

  std::filesystem::path folder_;
  std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state_;
  std::set<std::string> files_;
};

}  // namespace

std::string SceneFile::content_hash(std::string_view more) const {
  ContentHash hash(folder_);
  hash.add_text(more);
  hash.add_scene(json_->root);
  return hash.digits();
}

}  // namespace sweepkit::scene
