// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// OFF [Geomview manual, section 4.2.5]: [ST][C][N]OFF, the counts, a vertex a line - position, normal with N,
// colours, (u,v) with ST - and a face a line.

#include <algorithm>
#include <vector>

#include "message_text.hpp"
#include "object_reader.hpp"
#include "polygon_list.hpp"
#include "word_reader.hpp"

namespace sweepkit::scene {
namespace {

class OffReader {
 public:
  OffReader(std::string_view text, const std::string& file) : text_(text), words_(text, file) {}

  PolygonList read() {
    list_.format = "OFF";
    need_line("its header, such as OFF");
    read_header();
    if (words_.is_at_end()) need_line("the counts of vertices, faces and edges");
    const std::uint64_t vertices = count("the count of vertices");
    const std::uint64_t faces = count("the count of faces");
    for (std::uint64_t i = 0; i < vertices; ++i) {
      need_line("vertex " + std::to_string(i + 1) + " of " + std::to_string(vertices));
      read_vertex();
    }
    for (std::uint64_t i = 0; i < faces; ++i) {
      need_line("face " + std::to_string(i + 1) + " of " + std::to_string(faces));
      read_face();
    }
    return std::move(list_);
  }

 private:
  void need_line(const std::string& what) {
    if (!words_.next_line()) words_.fail("is cut short: needs " + what);
  }

  void read_header() {
    std::string_view word = words_.word();
    const std::string header(word);
    const auto take = [&](std::string_view prefix) {
      if (!word.starts_with(prefix)) return false;
      word.remove_prefix(prefix.size());
      return true;
    };
    has_texcoords_ = take("ST");
    take("C");
    has_normals_ = take("N");
    if (take("4") || take("n")) words_.fail("has vertices of other than 3 coordinates, which is not read");
    if (word != "OFF") words_.fail("needs OFF in its first line, got " + in_quotes(header));
    if (words_.rest().starts_with("BINARY"))
      words_.fail("is a binary OFF, which is not read; save it as text");
  }

  // Of things that take a byte at least, so that a lie is told apart before it is believed.
  std::uint64_t count(const char* what) {
    const std::uint64_t value = words_.whole(what, kMostMeshCorners);
    if (value > text_.size())
      words_.fail("says " + std::to_string(value) + " where the whole file has " +
                  std::to_string(text_.size()) + " bytes");
    return value;
  }

  void read_vertex() {
    glm::dvec3 p;
    for (glm::length_t k = 0; k < 3; ++k) p[k] = words_.number("a coordinate", kFarthest);
    list_.positions.push_back(p);
    if (has_normals_) {
      glm::dvec3 n;
      for (glm::length_t k = 0; k < 3; ++k) n[k] = words_.number("a normal's coordinate", kFarthest);
      list_.normals.push_back(glm::vec3(n));
    }
    if (!has_texcoords_) return;
    // The last two of the line, whatever colours are before.
    std::vector<double> numbers;
    while (!words_.is_at_end()) numbers.push_back(words_.number("a texture coordinate", kFarthest));
    if (numbers.size() < 2) words_.fail("needs two texture coordinates at the line's end");
    list_.texcoords.push_back(glm::vec2(glm::dvec2(numbers[numbers.size() - 2], numbers.back())));
  }

  void read_face() {
    const std::uint64_t count = words_.whole("the count of a face's corners", kMostFaceCorners);
    if (count < 3) words_.fail("a face needs at least 3 corners, got " + std::to_string(count));
    for (std::uint64_t k = 0; k < count; ++k) {
      const auto index = static_cast<std::uint32_t>(words_.whole("an index of a vertex", kMostMeshCorners));
      if (index >= list_.positions.size()) {
        words_.fail("points at vertex " + std::to_string(index) + ", but there are " +
                    std::to_string(list_.positions.size()) + ", numbered from 0");
      }
      list_.corners.push_back(
          {index, has_texcoords_ ? index : PolygonList::kNone, has_normals_ ? index : PolygonList::kNone});
    }
    list_.ends.push_back(static_cast<std::uint32_t>(list_.corners.size()));
  }

  std::string_view text_;
  WordReader words_;
  PolygonList list_;
  bool has_texcoords_ = false;
  bool has_normals_ = false;
};

}  // namespace

PolygonList read_off(std::string_view text, const std::string& file) {
  return OffReader(text, file).read();
}

}  // namespace sweepkit::scene
