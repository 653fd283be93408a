// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// STL [3D Systems, Stereolithography interface specification, 1989]. Binary: 80 bytes of header, the count,
// and 50 bytes a facet. Many binary files begin with "solid" too, so the size decides first: a file of just
// the size that its count asks for is binary. Normals of facets are passed over: the corners tell them.

#include <algorithm>
#include <cmath>

#include "byte_order.hpp"
#include "message_text.hpp"
#include "object_reader.hpp"
#include "polygon_list.hpp"
#include "sweepkit/error.hpp"
#include "word_reader.hpp"

namespace sweepkit::scene {
namespace {

constexpr std::size_t kHeader = 84;
constexpr std::size_t kFacet = 50;

bool is_word(std::string_view word, std::string_view lower) {
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a + ('a' - 'A') : a) == b; });
}

void end_facet(PolygonList& list) {
  for (std::uint32_t k = 3; k > 0; --k)
    list.corners.push_back({static_cast<std::uint32_t>(list.positions.size()) - k});
  list.ends.push_back(static_cast<std::uint32_t>(list.corners.size()));
}

PolygonList read_binary(std::string_view bytes, const std::string& file) {
  PolygonList list;
  list.format = "STL, binary";
  const std::size_t count = (bytes.size() - kHeader) / kFacet;
  if (3 * count > kMostMeshCorners)
    throw InputError({.file = file}, "has " + std::to_string(count) + " triangles, at most " +
                                         std::to_string(kMostMeshCorners / 3) + " are read; split the mesh");
  list.positions.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      glm::dvec3 p;
      for (std::size_t k = 0; k < 3; ++k) {
        const float value = little_endian<float>(bytes, kHeader + kFacet * i + 12 + 12 * corner + 4 * k);
        if (!(std::abs(value) <= kFarthest)) {
          throw InputError({.file = file}, "triangle " + std::to_string(i + 1) + " has a coordinate of " +
                                               to_text(static_cast<double>(value)) +
                                               "; at most 1e+09 is read");
        }
        p[static_cast<glm::length_t>(k)] = static_cast<double>(value);
      }
      list.positions.push_back(p);
    }
    end_facet(list);
  }
  return list;
}

// facet normal x y z / outer loop / vertex x y z (three times) / endloop / endfacet, between solid and
// endsolid.
PolygonList read_text(std::string_view text, const std::string& file) {
  PolygonList list;
  list.format = "STL, text";
  WordReader words(text, file);
  int corners = -1;  // of the facet that is open
  bool is_ended = false;
  while (words.next_line()) {
    const std::string_view word = words.word();
    if (is_word(word, "solid")) {
      is_ended = false;
    } else if (is_word(word, "endsolid")) {
      is_ended = true;
    } else if (is_word(word, "facet")) {
      if (corners >= 0) words.fail("a facet begins inside another");
      corners = 0;
    } else if (is_word(word, "vertex")) {
      if (corners < 0 || corners == 3)
        words.fail(corners < 0 ? "a vertex needs a facet about it"
                               : "a facet has 3 vertices, and this is a fourth");
      if (list.positions.size() == kMostMeshCorners)
        words.fail("is more than the " + std::to_string(kMostMeshCorners) + " that are read; split the mesh");
      glm::dvec3 p;
      for (glm::length_t k = 0; k < 3; ++k) p[k] = words.number("a coordinate", kFarthest);
      list.positions.push_back(p);
      ++corners;
    } else if (is_word(word, "endfacet")) {
      if (corners != 3) words.fail("a facet needs 3 vertices, got " + std::to_string(std::max(corners, 0)));
      end_facet(list);
      corners = -1;
    } else if (!is_word(word, "outer") && !is_word(word, "endloop")) {
      words.fail("needs a word of an STL file, such as facet or vertex, got " + in_quotes(word));
    }
  }
  if (!is_ended) throw InputError({.file = file}, "is cut short: it ends without endsolid");
  return list;
}

}  // namespace

PolygonList read_stl(std::string_view bytes, const std::string& file) {
  const std::size_t count = bytes.size() < kHeader ? 0 : little_endian<std::uint32_t>(bytes, kHeader - 4);
  if (bytes.size() >= kHeader && bytes.size() == kHeader + kFacet * count) return read_binary(bytes, file);
  const std::size_t start = bytes.find_first_not_of(" \t\r\n");
  if (start != std::string_view::npos && is_word(bytes.substr(start, 5), "solid"))
    return read_text(bytes, file);
  if (bytes.size() < kHeader) {
    throw InputError({.file = file}, "is no STL file: neither text that begins with solid nor 84 bytes long");
  }
  throw InputError({.file = file}, "says that it has " + std::to_string(count) + " triangles, which is " +
                                       std::to_string(kHeader + kFacet * count) + " bytes, but has " +
                                       std::to_string(bytes.size()) + "; it is cut short or no STL file");
}

}  // namespace sweepkit::scene
