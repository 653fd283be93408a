// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// PLY [Turk 1994, The PLY polygon file format]: a header of elements with properties, then their values, as
// text or binary in either order. Elements and properties that tell nothing of the surface are read over.
// (u,v) go by the names that programs write: s t, u v, texture_u texture_v, texture_s texture_t at vertices,
// or the list texcoord at faces, two numbers a corner.

#include <cmath>
#include <optional>
#include <vector>

#include "byte_order.hpp"
#include "message_text.hpp"
#include "object_reader.hpp"
#include "polygon_list.hpp"
#include "sweepkit/error.hpp"
#include "word_reader.hpp"

namespace sweepkit::scene {
namespace {

enum class Type { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

std::optional<Type> type_of(std::string_view name) {
  static constexpr std::pair<std::string_view, Type> kNames[] = {
      {"char", Type::kInt8},      {"int8", Type::kInt8},       {"uchar", Type::kUint8},
      {"uint8", Type::kUint8},    {"short", Type::kInt16},     {"int16", Type::kInt16},
      {"ushort", Type::kUint16},  {"uint16", Type::kUint16},   {"int", Type::kInt32},
      {"int32", Type::kInt32},    {"uint", Type::kUint32},     {"uint32", Type::kUint32},
      {"float", Type::kFloat32},  {"float32", Type::kFloat32}, {"double", Type::kFloat64},
      {"float64", Type::kFloat64}};
  for (const auto& [known, type] : kNames) {
    if (known == name) return type;
  }
  return std::nullopt;
}

enum class Role { kOther, kX, kY, kZ, kNx, kNy, kNz, kU, kV, kCorners, kCornerTexcoords };
constexpr std::size_t kVertexRoles = 9;  // from kOther to kV

Role role_of(std::string_view element, std::string_view property, bool is_list) {
  static constexpr std::pair<std::string_view, Role> kVertex[] = {
      {"x", Role::kX},         {"y", Role::kY},        {"z", Role::kZ},         {"nx", Role::kNx},
      {"ny", Role::kNy},       {"nz", Role::kNz},      {"s", Role::kU},         {"t", Role::kV},
      {"u", Role::kU},         {"v", Role::kV},        {"texture_u", Role::kU}, {"texture_v", Role::kV},
      {"texture_s", Role::kU}, {"texture_t", Role::kV}};
  if (element == "vertex" && !is_list) {
    for (const auto& [known, role] : kVertex) {
      if (known == property) return role;
    }
  }
  if (element == "face" && is_list) {
    if (property == "vertex_indices" || property == "vertex_index") return Role::kCorners;
    if (property == "texcoord") return Role::kCornerTexcoords;
  }
  return Role::kOther;
}

struct Property {
  Role role;
  Type type;
  std::optional<Type> count;  // of a list
};

struct Element {
  std::string name;
  std::uint64_t count;
  std::vector<Property> properties;

  bool has(Role role) const {
    for (const Property& property : properties) {
      if (property.role == role) return true;
    }
    return false;
  }
};

struct Header {
  std::string format;
  std::vector<Element> elements;
};

// Values one after another, whatever lines they are on.
class TextValues {
 public:
  explicit TextValues(const WordReader& after_header) : words_(after_header) {}

  double next(Type) {
    if (words_.is_at_end() && !words_.next_line()) words_.fail("is cut short: another number is needed here");
    return number_of(words_.word(), "a number", 1e300, words_);
  }
  [[noreturn]] void fail(const std::string& problem) const { words_.fail(problem); }

 private:
  WordReader words_;
};

class BinaryValues {
 public:
  BinaryValues(std::string_view bytes, std::size_t at, std::endian order, const std::string& file)
      : bytes_(bytes), at_(at), order_(order), file_(file) {}

  double next(Type type) {
    switch (type) {
      case Type::kInt8:
        return take<std::int8_t>();
      case Type::kUint8:
        return take<std::uint8_t>();
      case Type::kInt16:
        return take<std::int16_t>();
      case Type::kUint16:
        return take<std::uint16_t>();
      case Type::kInt32:
        return take<std::int32_t>();
      case Type::kUint32:
        return take<std::uint32_t>();
      case Type::kFloat32:
        return static_cast<double>(take<float>());
      default:
        return take<double>();
    }
  }
  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError({.file = file_}, "byte " + std::to_string(at_) + ": " + problem);
  }

 private:
  template <class T>
  T take() {
    if (bytes_.size() - at_ < sizeof(T)) fail("is cut short: another number is needed here");
    const T value = from_bytes<T>(bytes_, at_, order_);
    at_ += sizeof(T);
    return value;
  }

  std::string_view bytes_;
  std::size_t at_;
  std::endian order_;
  const std::string& file_;
};

Property read_property(WordReader& words, std::string_view element) {
  std::string_view word = words.word();
  const auto type = [&] {
    const std::optional<Type> found = type_of(word);
    if (!found) words.fail("needs a type of number, such as float or int32, got " + in_quotes(word));
    return *found;
  };
  std::optional<Type> count;
  if (word == "list") {
    word = words.word();
    count = type();
    word = words.word();
  }
  const Type of_values = type();
  const std::string_view name = words.word();
  if (name.empty()) words.fail("needs the property's name");
  return {role_of(element, name, count.has_value()), of_values, count};
}

Header read_header(WordReader& words, std::size_t most) {
  Header header;
  if (!words.next_line() || words.word() != "ply") words.fail("is no PLY file: needs ply in its first line");
  for (;;) {
    if (!words.next_line()) words.fail("is cut short: its header ends without end_header");
    const std::string_view word = words.word();
    if (word == "end_header") break;
    if (word == "format") {
      header.format = words.word();
    } else if (word == "element") {
      const std::string name(words.word());
      const std::uint64_t count = words.whole("the count of an element", 0xFFFFFFFF);
      // An item takes a byte at least.
      if (count > most)
        words.fail("says " + std::to_string(count) + " where the whole file has " + std::to_string(most) +
                   " bytes");
      header.elements.push_back({name, count, {}});
    } else if (word == "property") {
      if (header.elements.empty()) words.fail("a property needs an element before it");
      header.elements.back().properties.push_back(read_property(words, header.elements.back().name));
    } else if (word != "comment" && word != "obj_info") {
      words.fail("needs a word of a PLY header, such as element or property, got " + in_quotes(word));
    }
  }
  return header;
}

template <class Values>
class BodyReader {
 public:
  BodyReader(Values& values, PolygonList& list) : values_(values), list_(list) {}

  void read(const Element& element) {
    if (element.properties.empty()) return;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      std::array<double, kVertexRoles> of_vertex{};
      corners_.clear();
      texcoords_.clear();
      for (const Property& property : element.properties) {
        if (property.count) {
          read_list(property);
        } else {
          const double value = values_.next(property.type);
          if (property.role != Role::kOther)
            of_vertex[static_cast<std::size_t>(property.role)] = checked(value);
        }
      }
      if (element.name == "vertex") add_vertex(element, of_vertex);
      if (element.has(Role::kCorners)) add_face(element);
    }
  }

 private:
  double checked(double value) const {
    if (!(std::abs(value) <= kFarthest))
      values_.fail("a coordinate needs to be at most " + to_text(kFarthest) + " from 0, got " +
                   to_text(value));
    return value;
  }

  void read_list(const Property& property) {
    const double count = values_.next(*property.count);
    const bool is_face = property.role == Role::kCorners;
    if (is_face && !(count >= 3 && count <= static_cast<double>(kMostFaceCorners)))
      values_.fail("a face needs 3 to " + std::to_string(kMostFaceCorners) + " corners, got " +
                   to_text(count));
    if (!(count >= 0 && count <= 4294967295.0 && count == std::floor(count)))
      values_.fail("needs the length of a list, got " + to_text(count));
    const auto length = static_cast<std::uint64_t>(count);
    for (std::uint64_t k = 0; k < length; ++k) {
      const double value = values_.next(property.type);
      if (is_face) {
        if (!(value >= 0 && value < static_cast<double>(list_.positions.size()) &&
              value == std::floor(value))) {
          values_.fail("points at vertex " + to_text(value) + ", but there are " +
                       std::to_string(list_.positions.size()) + " before it, numbered from 0");
        }
        corners_.push_back(static_cast<std::uint32_t>(value));
      } else if (property.role == Role::kCornerTexcoords) {
        texcoords_.push_back(checked(value));
      }
    }
  }

  void add_vertex(const Element& element, const std::array<double, kVertexRoles>& values) {
    const auto at = [&](Role role) { return values[static_cast<std::size_t>(role)]; };
    list_.positions.emplace_back(at(Role::kX), at(Role::kY), at(Role::kZ));
    if (element.has(Role::kNx))
      list_.normals.push_back(glm::vec3(glm::dvec3(at(Role::kNx), at(Role::kNy), at(Role::kNz))));
    if (element.has(Role::kU)) list_.texcoords.push_back(glm::vec2(glm::dvec2(at(Role::kU), at(Role::kV))));
    vertex_texcoords_ = list_.texcoords.size();
  }

  void add_face(const Element& element) {
    const bool has_own = element.has(Role::kCornerTexcoords) && !texcoords_.empty();
    if (has_own && texcoords_.size() != 2 * corners_.size()) {
      values_.fail("a face of " + std::to_string(corners_.size()) +
                   " corners needs twice as many texture "
                   "coordinates, got " +
                   std::to_string(texcoords_.size()));
    }
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      PolygonList::Corner corner{corners_[k]};
      if (!list_.normals.empty()) corner.normal = corners_[k];
      if (has_own) {
        corner.texcoord = static_cast<std::uint32_t>(list_.texcoords.size());
        list_.texcoords.push_back(glm::vec2(glm::dvec2(texcoords_[2 * k], texcoords_[2 * k + 1])));
      } else if (vertex_texcoords_ > 0) {
        corner.texcoord = corners_[k];
      }
      list_.corners.push_back(corner);
    }
    if (list_.corners.size() > kMostMeshCorners)
      values_.fail("has more than the " + std::to_string(kMostMeshCorners) +
                   " corners that are read; split the mesh");
    list_.ends.push_back(static_cast<std::uint32_t>(list_.corners.size()));
  }

  Values& values_;
  PolygonList& list_;
  std::vector<std::uint32_t> corners_;
  std::vector<double> texcoords_;
  std::size_t vertex_texcoords_ = 0;
};

template <class Values>
void read_body(const Header& header, Values values, PolygonList& list) {
  BodyReader body(values, list);
  for (const Element& element : header.elements) body.read(element);
}

}  // namespace

PolygonList read_ply(std::string_view bytes, const std::string& file) {
  // The header is text even where the body is not.
  WordReader words(bytes, file);
  const Header header = read_header(words, bytes.size());
  std::size_t vertex_elements = 0;
  for (const Element& element : header.elements) {
    if (element.name != "vertex") continue;
    if (!element.has(Role::kX) || !element.has(Role::kY) || !element.has(Role::kZ))
      words.fail("needs properties x, y and z of its vertices");
    ++vertex_elements;
  }
  if (vertex_elements != 1) words.fail("needs one element vertex, got " + std::to_string(vertex_elements));
  PolygonList list;
  if (header.format == "ascii") {
    list.format = "PLY, text";
    read_body(header, TextValues(words), list);
    return list;
  }
  const bool is_big = header.format == "binary_big_endian";
  if (!is_big && header.format != "binary_little_endian")
    words.fail("needs the format ascii, binary_little_endian or binary_big_endian, got " +
               in_quotes(header.format));
  list.format = "PLY, binary";
  const std::size_t end = bytes.find("end_header");
  const std::size_t start = std::min(bytes.find('\n', end), bytes.size() - 1) + 1;
  read_body(header, BinaryValues(bytes, start, is_big ? std::endian::big : std::endian::little, file), list);
  return list;
}

}  // namespace sweepkit::scene
