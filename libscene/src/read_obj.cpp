// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Wavefront OBJ [Advanced Visualizer manual, appendix B1], its polygonal part: v, vt, vn and f. Statements
// that tell nothing about triangles (groups, materials, lines, curves) are passed over, and no other file is
// read.

#include <charconv>
#include <limits>

#include "message_text.hpp"
#include "object_reader.hpp"
#include "polygon_list.hpp"
#include "word_reader.hpp"

namespace sweepkit::scene {
namespace {

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& file) : words_(text, file) {}

  PolygonList read() {
    list_.format = "OBJ";
    while (words_.next_line()) {
      const std::string_view kind = words_.word();
      if (kind == "v") {
        check_room(list_.positions.size());
        const glm::dvec3 p = three("a coordinate");
        list_.positions.push_back(p);
      } else if (kind == "vt") {
        check_room(list_.texcoords.size());
        // v is 0 where it is left out.
        const double u = words_.number("a texture coordinate", kFarthest);
        const double v = words_.is_at_end() ? 0 : words_.number("a texture coordinate", kFarthest);
        list_.texcoords.push_back(glm::vec2(glm::dvec2(u, v)));
      } else if (kind == "vn") {
        check_room(list_.normals.size());
        list_.normals.push_back(glm::vec3(three("a normal's coordinate")));
      } else if (kind == "f" || kind == "fo") {
        read_face();
      }
    }
    return std::move(list_);
  }

 private:
  glm::dvec3 three(const char* what) {
    glm::dvec3 p;
    for (glm::length_t k = 0; k < 3; ++k) p[k] = words_.number(what, kFarthest);
    return p;
  }

  void check_room(std::size_t count) const {
    if (count == kMostMeshCorners) {
      words_.fail("is more than the " + std::to_string(kMostMeshCorners) + " that are read; split the mesh");
    }
  }

  // "7" counts from the first, "-1" from the last so far.
  std::uint32_t index(std::string_view digits, std::size_t count, const char* what) const {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size())
      words_.fail("needs an index of " + std::string(what) + ", got " + in_quotes(digits));
    const auto all = static_cast<std::int64_t>(count);
    if (value == 0 || value > all || value < -all) {
      words_.fail("points at " + std::string(what) + " " + std::to_string(value) + ", but there are " +
                  std::to_string(count) + " so far");
    }
    return static_cast<std::uint32_t>(value > 0 ? value - 1 : all + value);
  }

  void read_face() {
    std::size_t count = 0;
    while (!words_.is_at_end()) {
      const std::string_view word = words_.word();
      check_room(list_.corners.size());
      if (++count > kMostFaceCorners)
        words_.fail("a face has more than " + std::to_string(kMostFaceCorners) +
                    " corners; cut it into triangles");
      const std::size_t first = word.find('/');
      PolygonList::Corner corner{index(word.substr(0, first), list_.positions.size(), "vertex")};
      if (first != std::string_view::npos) {
        const std::string_view rest = word.substr(first + 1);
        const std::size_t second = rest.find('/');
        const std::string_view texcoord = rest.substr(0, second);
        if (!texcoord.empty()) corner.texcoord = index(texcoord, list_.texcoords.size(), "texture vertex");
        if (second != std::string_view::npos) {
          const std::string_view normal = rest.substr(second + 1);
          if (!normal.empty()) corner.normal = index(normal, list_.normals.size(), "normal");
        }
      }
      list_.corners.push_back(corner);
    }
    if (count < 3) words_.fail("a face needs at least 3 corners, got " + std::to_string(count));
    list_.ends.push_back(static_cast<std::uint32_t>(list_.corners.size()));
  }

  WordReader words_;
  PolygonList list_;
};

}  // namespace

PolygonList read_obj(std::string_view text, const std::string& file) {
  return ObjReader(text, file).read();
}

}  // namespace sweepkit::scene
