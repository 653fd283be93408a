// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "read_objects.hpp"

#include <algorithm>
#include <unordered_set>

#include "message_text.hpp"
#include "read_curve.hpp"
#include "read_law.hpp"
#include "read_placement.hpp"
#include "sweepkit/scene/mesh_file.hpp"

namespace sweepkit::scene {
namespace {

// What an object says for all its parts and each part may say again.
struct Manner {
  std::optional<int> contour_cells;
  std::optional<int> trajectory_cells;
  std::optional<double> tolerance;
  sweep::UvOptions uv;
  double crease_deg = 30;
};

void read_manner(ObjectReader& reader, Manner& manner) {
  if (const auto node = reader.find("tessellation")) {
    // Said again it is said whole: counts of a part stand against its object's tolerance and the other way.
    ObjectReader cells(*node);
    const std::optional<Node> tolerance = cells.find("tolerance");
    if (tolerance) {
      manner.tolerance = tolerance->number(kExtent);
      for (const char* count : {"contour", "trajectory"}) {
        if (const auto other = cells.find(count)) {
          other->fail("counts cells, and \"tolerance\" finds how many there are to be; leave one out");
        }
      }
    } else {
      manner.tolerance.reset();
    }
    if (const auto contour = cells.find("contour")) {
      manner.contour_cells = contour->integer(1, sweep::kMaxCells, " cells");
    }
    if (const auto along = cells.find("trajectory")) {
      manner.trajectory_cells = along->integer(1, sweep::kMaxCells, " cells");
    }
    cells.finish();
  }
  if (const auto node = reader.find("uv")) {
    ObjectReader uv(*node);
    if (const auto by = uv.find("by")) {
      manner.uv.by =
          by->choice({"arc-length", "parameter"}) == 0 ? sweep::UvBy::kArcLength : sweep::UvBy::kParameter;
    }
    const auto repeat = uv.find("repeat");
    if (repeat) manner.uv.repeat = repeat->vector<2>({.low = 1e-6, .high = 1e6});
    if (const auto size = uv.find("size")) {
      if (repeat) size->fail("decides in place of \"repeat\"; leave one out");
      manner.uv.size = size->is_number() ? glm::dvec2(size->number(kExtent)) : size->vector<2>(kExtent);
    }
    uv.finish();
  }
  if (const auto node = reader.find("crease_deg")) {
    manner.crease_deg = node->number({.low = 0, .high = 180, .unit = " degrees"});
  }
}

sweep::Caps read_sweep_caps(ObjectReader& reader) {
  const auto node = reader.find("caps");
  if (!node) return sweep::Caps::kFlat;
  constexpr sweep::Caps kKinds[] = {sweep::Caps::kFlat, sweep::Caps::kRound, sweep::Caps::kNone};
  return kKinds[node->choice({"flat", "round", "none"})];
}

sweep::Caps read_revolve_caps(ObjectReader& reader) {
  const auto node = reader.find("caps");
  return node && node->choice({"flat", "none"}) == 1 ? sweep::Caps::kNone : sweep::Caps::kFlat;
}

std::vector<sweep::MorphKey> read_morph(const Node& node, const std::filesystem::path& folder) {
  std::vector<sweep::MorphKey> keys;
  double before = 0;
  for (const Node& item : node.items()) {
    ObjectReader reader(item);
    const Node at = reader.get("at");
    const double t = at.number({.low = 0, .high = 1});
    if (t <= before) {
      at.fail(std::string("needs to be above ") +
              (keys.empty() ? "0, where the contour itself is" : "the one before"));
    }
    keys.push_back({t, read_contour(reader.get("contour"), folder)});
    reader.finish();
    before = t;
  }
  if (keys.empty()) node.fail("needs at least one contour to change into");
  return keys;
}

sweep::Orientation read_orientation(ObjectReader& reader, const std::filesystem::path& folder) {
  sweep::Orientation orientation;
  const std::optional<Node> frames = reader.find("frames");
  const std::optional<Node> guide = reader.find("guide");
  const std::optional<Node> up = reader.find("up");
  if (frames && guide) guide->fail("says where the section points, and so does \"frames\"; leave one out");
  if (frames) {
    constexpr sweep::Frames kKinds[] = {sweep::Frames::kRotationMinimizing, sweep::Frames::kFrenet,
                                        sweep::Frames::kFixedUp};
    orientation.frames = kKinds[frames->choice({"rotation-minimizing", "frenet", "fixed-up"})];
  }
  if (guide) orientation.guide = read_trajectory(*guide, folder);
  if (up) {
    orientation.up = up->vector<3>(kCoordinate);
    if (!(glm::length(orientation.up) > 0)) up->fail("needs a direction, got [0, 0, 0]");
  }
  return orientation;
}

sweep::Joints read_joints(ObjectReader& reader) {
  const auto node = reader.find("joints");
  if (!node) return sweep::SweepOptions{}.joints;
  constexpr sweep::Joints kKinds[] = {sweep::Joints::kMiter, sweep::Joints::kSmooth, sweep::Joints::kRound,
                                      sweep::Joints::kBevel};
  return kKinds[node->choice({"miter", "smooth", "round", "bevel"})];
}

SweepShape read_sweep(const Node& node, const std::filesystem::path& folder) {
  ObjectReader reader(node);
  const Node contour = reader.get("contour");
  const Node trajectory = reader.get("trajectory");
  const std::optional<Node> profile = reader.find("profile");
  const std::optional<Node> twist = reader.find("twist_deg");
  const sweep::Orientation orientation = read_orientation(reader, folder);
  const sweep::Caps caps = read_sweep_caps(reader);
  const sweep::Joints joints = read_joints(reader);
  double miter_limit = sweep::SweepOptions{}.miter_limit;
  if (const auto limit = reader.find("miter_limit")) miter_limit = limit->number({.low = 1, .high = 1000});
  const std::optional<Node> morph = reader.find("morph");
  reader.finish();
  return {read_contour(contour, folder),
          morph ? read_morph(*morph, folder) : std::vector<sweep::MorphKey>{},
          read_trajectory(trajectory, folder),
          profile ? read_profile(*profile) : sweep::Profile{},
          twist ? read_twist(*twist) : sweep::Law(0),
          orientation,
          caps,
          joints,
          miter_limit};
}

RevolveShape read_revolve(const Node& node, const std::filesystem::path& folder) {
  ObjectReader reader(node);
  const Node contour = reader.get("contour");
  double angle = 360;
  if (const auto angle_node = reader.find("angle_deg")) {
    angle = angle_node->number({.low = 1e-6, .high = 360, .unit = " degrees"});
  }
  const sweep::Caps caps = read_revolve_caps(reader);
  reader.finish();
  return {read_contour(contour, folder), angle, caps};
}

PlaneShape read_plane(const Node& node) {
  ObjectReader reader(node);
  PlaneShape plane;
  const Node size = reader.get("size");
  plane.size = size.vector<2>(kExtent);
  reader.finish();
  return plane;
}

// What divides and unrolls a surface of curves means nothing to triangles that are there already.
void refuse_manner_of_curves(ObjectReader& reader) {
  if (const auto node = reader.find("tessellation")) {
    node->fail("divides surfaces of curves; a mesh file has its triangles already; leave it out");
  }
  if (const auto node = reader.find("uv")) {
    ObjectReader uv(*node);
    for (const char* key : {"by", "size"}) {
      if (const auto found = uv.find(key)) {
        found->fail(
            "is for (u,v) that run along curves; a mesh has its own, or is laid out over the texture; "
            "leave it out");
      }
    }
  }
}

MeshShape read_mesh(const Node& node, const std::filesystem::path& folder) {
  ObjectReader reader(node);
  const Node file = reader.get("file");
  reader.finish();
  if (file.text().empty()) file.fail("needs a file name");
  if (!is_mesh_name(file.text())) {
    file.fail("needs a file that ends in .obj, .ply, .stl or .off, got " + in_quotes(file.text()));
  }
  return {folder / file.text()};
}

// The shape keys; an object may have "parts" instead of one of them.
std::optional<Piece> read_shape(ObjectReader& reader, const std::filesystem::path& folder) {
  std::optional<Piece> piece;
  for (const char* kind : {"sweep", "revolve", "plane", "mesh"}) {
    const std::optional<Node> node = reader.find(kind);
    if (!node) continue;
    if (piece) node->fail("an object has one shape; put several under \"parts\"");
    piece.emplace();
    piece->place = node->place();
    const std::string name = kind;
    if (name == "sweep") {
      piece->shape = read_sweep(*node, folder);
    } else if (name == "revolve") {
      piece->shape = read_revolve(*node, folder);
    } else if (name == "plane") {
      piece->shape = read_plane(*node);
    } else {
      piece->shape = read_mesh(*node, folder);
      refuse_manner_of_curves(reader);
    }
  }
  return piece;
}

void set_manner(Piece& piece, const Manner& manner) {
  const bool is_plane = std::holds_alternative<PlaneShape>(piece.shape);
  piece.tessellation = is_plane ? sweep::PlaneOptions{}.tessellation : sweep::Tessellation{};
  piece.tessellation.contour = manner.contour_cells.value_or(piece.tessellation.contour);
  piece.tessellation.trajectory = manner.trajectory_cells.value_or(piece.tessellation.trajectory);
  piece.tessellation.tolerance = manner.tolerance;
  piece.uv = manner.uv;
  piece.crease_deg = manner.crease_deg;
}

Piece read_part(const Node& node, Manner manner, const std::filesystem::path& folder) {
  ObjectReader reader(node);
  const Placement placement = read_placement(reader);
  read_manner(reader, manner);
  std::optional<Piece> piece = read_shape(reader, folder);
  reader.finish();
  if (!piece) node.fail("needs one of \"sweep\", \"revolve\", \"plane\" or \"mesh\"");
  set_manner(*piece, manner);
  piece->placement = placement;
  return *piece;
}

ObjectEntry read_one(const Node& node, const std::vector<Material>& materials,
                     const std::filesystem::path& folder) {
  ObjectReader reader(node);
  ObjectEntry object;
  object.place = node.place();
  const Node name = reader.get("name");
  object.name = name.text();
  if (object.name.empty()) name.fail("needs a name that is not empty");
  if (const auto material = reader.find("material")) {
    const auto found = std::find_if(materials.begin(), materials.end(),
                                    [&](const Material& entry) { return entry.name == material->text(); });
    if (found == materials.end()) {
      std::vector<std::string> names;
      names.reserve(materials.size());
      for (const Material& entry : materials) names.push_back(entry.name);
      material->fail(unknown_name("material", material->text(), names));
    }
    object.material = static_cast<std::size_t>(found - materials.begin());
  }
  object.placement = read_placement(reader);
  object.instances = read_instances(reader);
  Manner manner;
  read_manner(reader, manner);
  std::optional<Piece> piece = read_shape(reader, folder);
  const std::optional<Node> parts = reader.find("parts");
  reader.finish();
  if (piece && parts) parts->fail("an object has one shape or \"parts\", not both");
  if (!piece && !parts) node.fail("needs one of \"sweep\", \"revolve\", \"plane\", \"mesh\" or \"parts\"");
  if (piece) {
    set_manner(*piece, manner);
    object.pieces.push_back(std::move(*piece));
    return object;
  }
  for (const Node& part : parts->items()) object.pieces.push_back(read_part(part, manner, folder));
  if (object.pieces.empty()) parts->fail("needs at least one part");
  return object;
}

}  // namespace

std::vector<ObjectEntry> read_objects(const Node& node, const std::vector<Material>& materials,
                                      const std::filesystem::path& folder) {
  std::vector<ObjectEntry> objects;
  std::unordered_set<std::string> names;
  for (const Node& item : node.items()) {
    objects.push_back(read_one(item, materials, folder));
    if (!names.insert(objects.back().name).second) {
      item.fail("the name " + in_quotes(objects.back().name) +
                " is taken by an object before; choose another");
    }
  }
  if (objects.empty()) node.fail("needs at least one object");
  return objects;
}

}  // namespace sweepkit::scene
