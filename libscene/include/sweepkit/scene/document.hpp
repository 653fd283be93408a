// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sweepkit/error.hpp"
#include "sweepkit/scene/camera.hpp"
#include "sweepkit/scene/light.hpp"
#include "sweepkit/scene/material.hpp"
#include "sweepkit/sweep/curve.hpp"
#include "sweepkit/sweep/options.hpp"
#include "sweepkit/texmap/image_file.hpp"
#include "sweepkit/texmap/procedural.hpp"
#include "sweepkit/texmap/texture.hpp"

namespace sweepkit::scene {

/// Scale, then rotate about the fixed x, y, z axes in that order, then translate.
struct Placement {
  glm::dvec3 translate{0.0};
  glm::dvec3 rotate_deg{0.0};
  glm::dvec3 scale{1.0};
};
/// Exact at whole quarter turns.
glm::dmat4 to_matrix(const Placement& placement);

struct SweepShape {
  /// One outline, or several that bound one region, holes inside outer ones. Not empty. Closed outlines of a
  /// filled region run with it on their left.
  std::vector<sweep::Curve2> contour;
  std::vector<sweep::MorphKey> morph;
  sweep::Curve3 trajectory;
  sweep::Profile profile;
  sweep::Law twist_deg = 0;
  sweep::Orientation orientation;
  sweep::Caps caps = sweep::Caps::kFlat;
  sweep::Joints joints = sweep::SweepOptions{}.joints;
  double miter_limit = sweep::SweepOptions{}.miter_limit;
};

struct RevolveShape {
  std::vector<sweep::Curve2> contour;  ///< as SweepShape's
  double angle_deg = 360;
  sweep::Caps caps = sweep::Caps::kFlat;
};

struct PlaneShape {
  glm::dvec2 size{1.0};  ///< x, z
};

/// A mesh file's surface, metres, as it stands.
struct MeshShape {
  std::filesystem::path file;  ///< .obj .ply .stl .off, resolved against the scene file
};

/// One shape with what belongs to it. An object has one, or several under "parts".
struct Piece {
  std::variant<PlaneShape, SweepShape, RevolveShape, MeshShape> shape;
  Placement placement;               ///< object from piece
  sweep::Tessellation tessellation;  ///< counts that the file leaves out are 64, for a plane 1
  sweep::UvOptions uv;               ///< of a mesh file `repeat` alone
  double crease_deg = 30;
  Place place;  ///< for messages about the geometry
};

struct ObjectEntry {
  std::string name;
  std::optional<std::size_t> material;  ///< index into Document::materials
  Placement placement;                  ///< world from object
  /// The object, placed, is drawn once for each of these, moved by it: world = instance * placement. Empty:
  /// it is drawn once, as it stands.
  std::vector<Placement> instances;
  std::vector<Piece> pieces;  ///< not empty
  Place place;
};

struct ImageEntry {
  std::filesystem::path file;  ///< resolved against the scene file
  texmap::ColorSpace color_space = texmap::ColorSpace::kSrgb;
  texmap::Wrap wrap = texmap::Wrap::kRepeat;
};

struct TextureEntry {
  std::string name;
  std::variant<ImageEntry, texmap::Procedural> source;
  Place place;
};

/// A scene file, read and checked: every key known, every number in range, every name found, every curve
/// sound. Only the files it names are unread.
struct Document {
  Camera camera;          ///< without has_view its eye and target are build()'s to find
  bool has_view = false;  ///< the scene file says where the camera stands
  int width = 512;        ///< pixels, from the camera
  int height = 512;
  glm::vec3 background{0.0f};
  std::optional<TextureEntry> environment;  ///< an image in place of `background`
  glm::vec3 ambient{0.0f};
  bool has_ambient = false;
  int depth = 6;  ///< levels of reflection and refraction; 0 is the primary hit alone
  std::vector<Light> lights;
  std::vector<TextureEntry> textures;
  std::vector<Material> materials;
  std::vector<Place> material_places;  ///< one a material
  std::vector<ObjectEntry> objects;    ///< not empty; names are unique
};

/// A value that takes another's place in a scene: POINTER (RFC 6901; the last part may be a new key, or "-"
/// to append to an array) and VALUE.
struct Setting {
  enum class Form {
    kAny,       ///< JSON, or else a string
    kJson,      ///< JSON alone, with line and column in messages
    kJsonFile,  ///< a file's name, which holds JSON
  };
  std::string pointer;
  std::string value;
  Place place = {.file = "--set"};          ///< of the value, for messages
  Place pointer_place = {.file = "--set"};  ///< of the pointer
  Form form = Form::kAny;
};

struct JsonDocument;

/// A scene file (design: scene format version 1; // comments allowed), parsed once: documents that differ in
/// a few values are read from it without the text.
class SceneFile {
 public:
  /// Throws InputError with file, line and column: missing, unreadable, over 256 MiB, no JSON.
  explicit SceneFile(const std::filesystem::path& file);
  /// The same from text; `file` names it in messages and is what file names are relative to.
  SceneFile(const std::string& text, const std::filesystem::path& file);
  /// The same, with file names relative to another folder.
  SceneFile(const std::string& text, const std::filesystem::path& file, std::filesystem::path folder);
  SceneFile(SceneFile&&) noexcept;
  SceneFile& operator=(SceneFile&&) noexcept;
  ~SceneFile();

  /// Changes a value for every document to come. Throws InputError where the pointer leads nowhere.
  void set(const Setting& setting);

  /// The scene with these values set, in order; the file itself stays as it is, so that any number of threads
  /// may ask at once. Throws InputError with file, line, column and JSON pointer.
  Document document(std::span<const Setting> settings = {}) const;

  /// The scene with these values set as JSON on one line, without comments and $schema: the same for the
  /// same scene however it is spaced. File names are as they stand. Throws InputError as document() does for
  /// a setting.
  std::string text(std::span<const Setting> settings = {}) const;

  /// A hash (XXH3 of 128 bits, hexadecimal) of all that the scene says, of the bytes of the files that it
  /// names, and of `more`. It is the same wherever the scene lies and however it is spaced. Throws InputError
  /// for a file that cannot be read.
  std::string content_hash(std::string_view more) const;

  /// Throws InputError at `place` if set() with this pointer would find nothing to set.
  void check_pointer(const std::string& pointer, const Place& place) const;

 private:
  std::unique_ptr<JsonDocument> json_;
  std::filesystem::path folder_;
};

/// A file's only document, with the settings in order. Throws as SceneFile does.
Document read_document(const std::filesystem::path& file, const std::vector<Setting>& settings = {});

/// The same from text.
Document parse_document(const std::string& text, const std::filesystem::path& file,
                        const std::vector<Setting>& settings = {});

}  // namespace sweepkit::scene
