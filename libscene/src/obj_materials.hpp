// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "byte_writer.hpp"
#include "sweepkit/scene/image_store.hpp"
#include "sweepkit/scene/mesh_output.hpp"
#include "sweepkit/scene/scene.hpp"
#include "sweepkit/texmap/bake.hpp"

namespace sweepkit::scene {

/// The user's names as words that a line of a file can hold, each another one: blanks and control characters
/// become _, and what is taken gets a number.
class UniqueNames {
 public:
  std::string unique(const std::string& name);

 private:
  std::set<std::string> taken_;
  std::map<std::string, std::uint64_t> numbers_;  // by word: the last one given
};

/// A name as one word.
std::string as_word(std::string name);

/// The material library of an OBJ file and the images that it names, written as objects use them.
class ObjMaterials {
 public:
  /// `stem` begins the names of the files; scene, plan and options must last as long as this.
  ObjMaterials(const Scene& scene, const Plan& plan, const std::string& stem,
               const MeshOutputOptions& options);

  struct Use {
    std::string name;                                    ///< for usemtl
    const std::vector<texmap::UvTransform>* transforms;  ///< where (u,v) lie in a baked image; may be empty
    float uv_factor = 1;
  };
  Use use(const Object& object);

  /// Has any object a material? Without one there is no library.
  bool are_needed() const { return are_needed_; }
  std::string file() const { return stem_ + ".mtl"; }

  /// The images, then the library. Call it last.
  std::vector<NamedBytes> take_files(const std::string& title);
  const Ledger& ledger() const { return ledger_; }

 private:
  struct Image {
    std::string file;
    bool is_clamped = false;
    float uv_factor = 1;
    std::vector<texmap::UvTransform> transforms;
  };
  struct Entry {
    std::string name;
    const Image* image = nullptr;
    const Image* normals = nullptr;
  };
  const Image* image_of(const Object& object, std::size_t texture);
  Image write_image(const Object& object, std::size_t texture);
  /// The material's normal map, which has to do with the (u,v) of its colours. Throws InputError if it
  /// cannot.
  const Image* normals_of(const Object& object, const Material& material, const Image* colors);
  std::string add_file(std::vector<std::byte> png);
  void write_material(const Material& material, const Entry& entry);

  const Scene& scene_;
  const Plan& plan_;
  const MeshOutputOptions& options_;
  ImageStore own_images_;  // where the caller has none
  ImageStore& images_;
  std::string stem_;
  bool are_needed_ = false;
  UniqueNames names_;
  ByteWriter library_;
  std::vector<NamedBytes> image_files_;
  Ledger ledger_;
  /// By texture, and by mesh too where the image is baked over it.
  std::map<std::pair<std::size_t, std::optional<std::size_t>>, Image> image_entries_;
  /// By material (none: the default one) and image.
  std::map<std::pair<std::optional<std::size_t>, const Image*>, Entry> entries_;
};

}  // namespace sweepkit::scene
