// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "object_mesh.hpp"

#include "make_mesh.hpp"
#include "sweepkit/error.hpp"
#include "sweepkit/sweep/tangents.hpp"

namespace sweepkit::scene {
namespace {

// Runs `make` and gives what it finds wrong with the geometry the piece's place in the file.
template <class Make>
auto at_place(const Place& place, Make&& make) {
  try {
    return make();
  } catch (const InputError& error) {
    if (!error.place().pointer.empty()) throw;
    throw InputError(place, error.problem());
  }
}

// Made where it will stay: OpenMesh has no move, so every other way would copy it.
std::unique_ptr<const sweep::Mesh> make_object(const ObjectEntry& object, const MeshNeeds& needs,
                                               Cost& layout_cost, std::vector<SweptPart>& swept) {
  const auto note = [&](const Piece& piece, std::size_t first, std::size_t end) {
    const bool is_revolve = std::holds_alternative<RevolveShape>(piece.shape);
    if (!is_revolve && !std::holds_alternative<SweepShape>(piece.shape)) return;
    swept.push_back({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(end - first),
                     is_revolve ? SweptPart::Along::kU : SweptPart::Along::kV});
  };
  const Piece& first = object.pieces.front();
  if (object.pieces.size() == 1 && to_matrix(first.placement) == glm::dmat4(1.0)) {
    return at_place(first.place, [&] {
      auto mesh = std::unique_ptr<const sweep::Mesh>(new sweep::Mesh(make_mesh(first, needs, layout_cost)));
      note(first, 0, mesh->areas.size());
      return mesh;
    });
  }
  auto whole = std::make_unique<sweep::Mesh>();
  for (const Piece& piece : object.pieces) {
    at_place(piece.place, [&] {
      const std::size_t areas = whole->areas.size();
      sweep::append(*whole, make_mesh(piece, needs, layout_cost), to_matrix(piece.placement));
      note(piece, areas, whole->areas.size());
      return true;
    });
  }
  return whole;
}

// For the mesh that was made last.
void add_tangents(Model& model, const Document& document, const ObjectEntry& entry) {
  if (!entry.material || !document.materials[*entry.material].normal_map) return;
  MeshView& mesh = model.scene.meshes.back();
  model.tangents.push_back(
      sweep::find_tangents(mesh.positions, mesh.normals, mesh.texcoords, mesh.triangles));
  mesh.tangents = model.tangents.back();  // where it stays when the list grows
  model.ledger[Part::kNormalMaps].bytes += mesh.tangents.size_bytes();
  model.ledger[Part::kNormalMaps].calls += 1;
}

}  // namespace

void add_mesh_of(const ObjectEntry& object, const Document& document, const Plan& plan, Model& model) {
  const MeshNeeds needs{plan.needs_part(Part::kHalfEdges), plan.needs_part(Part::kLayouts)};
  std::vector<SweptPart> swept;
  model.meshes.push_back(make_object(object, needs, model.ledger[Part::kLayouts], swept));
  const sweep::Mesh& mesh = *model.meshes.back();
  model.scene.meshes.push_back({mesh.positions(),
                                mesh.normals(),
                                mesh.texcoords(),
                                mesh.triangles,
                                mesh.patches,
                                mesh.areas,
                                mesh.origin,
                                {},
                                std::move(swept)});
  if (plan.needs_part(Part::kNormalMaps)) add_tangents(model, document, object);
  if (needs.half_edges) {
    model.ledger[Part::kHalfEdges].bytes += mesh.half_edge_bytes();
    model.ledger[Part::kHalfEdges].calls += 1;
  }
}

}  // namespace sweepkit::scene
