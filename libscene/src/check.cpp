// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "sweepkit/scene/check.hpp"

#include <algorithm>

#include "make_mesh.hpp"

namespace sweepkit::scene {
namespace {

std::vector<sweep::Finding> curve_findings(const Piece& piece) {
  if (const auto* shape = std::get_if<SweepShape>(&piece.shape)) {
    return sweep::check_sweep(shape->contour, shape->trajectory, sweep_options(piece, *shape));
  }
  if (const auto* shape = std::get_if<RevolveShape>(&piece.shape)) {
    return sweep::check_revolve(shape->contour, revolve_options(piece, *shape));
  }
  return {};
}

// The surface goes through itself beside a fold or a cusp, and where a morph folds.
bool is_of_a_fold(const sweep::Finding& crossing, const std::vector<sweep::Finding>& others) {
  // Reaches a little beyond the stretch that runs backwards.
  constexpr double kBeside = 0.1;
  return std::any_of(others.begin(), others.end(), [&](const sweep::Finding& other) {
    const bool folds = other.kind == sweep::FindingKind::kFold || other.kind == sweep::FindingKind::kCusp ||
                       other.kind == sweep::FindingKind::kFoldedMorph;
    return folds && crossing.t > other.from - kBeside && *crossing.other < other.to + kBeside;
  });
}

// Looking for crossings takes longer than making the mesh: of more triangles than these a quick look takes
// a coarser one, whose cells are still small to the eye.
constexpr std::size_t kQuickTriangles = 60000;
constexpr sweep::Tessellation kQuickCells{80, 320};

}  // namespace

std::vector<SceneFinding> check(const Document& document, const Model& model, Thoroughness thoroughness) {
  std::vector<SceneFinding> all;
  auto next = model.scene.objects.begin();
  for (const ObjectEntry& entry : document.objects) {
    // Of several instances the first stands for all.
    const Object& object = *next;
    next += static_cast<std::ptrdiff_t>(std::max(entry.instances.size(), std::size_t{1}));
    const glm::dmat4& world_from_object = object.world_from_object;
    for (const Piece& piece : entry.pieces) {
      if (std::holds_alternative<PlaneShape>(piece.shape)) continue;
      try {
        std::vector<sweep::Finding> findings = curve_findings(piece);
        // A contour that crosses itself makes a surface that does all along.
        const bool is_sound = std::none_of(findings.begin(), findings.end(), [](const sweep::Finding& f) {
          return f.kind == sweep::FindingKind::kContourCrossing;
        });
        const sweep::Mesh& whole = *model.meshes[object.mesh];
        const bool is_quick =
            thoroughness == Thoroughness::kQuick && whole.triangles.size() > kQuickTriangles;
        const bool is_file = std::holds_alternative<MeshShape>(piece.shape);
        // A file has no coarser mesh of the same surface.
        if (is_file && is_quick) continue;
        const bool is_alone = entry.pieces.size() == 1 && !is_quick;
        if (is_sound) {
          Piece looked_at = piece;
          if (is_quick) looked_at.tessellation = kQuickCells;
          Cost ignored;
          std::vector<sweep::Finding> crossings =
              is_alone ? sweep::find_crossings(whole)
                       : sweep::find_crossings(make_mesh(looked_at, {}, ignored));
          for (sweep::Finding& crossing : crossings) {
            if (is_file) crossing.cure = "mend the file's mesh there";
            if (!is_of_a_fold(crossing, findings)) findings.push_back(std::move(crossing));
          }
        }
        // A mesh of one piece has the piece's placement in it already; the curves have not.
        const glm::dmat4 world_from_piece = world_from_object * to_matrix(piece.placement);
        for (sweep::Finding& finding : findings) {
          const bool is_placed = is_alone && finding.kind == sweep::FindingKind::kCrossing;
          const glm::dvec4 point(finding.point, 1);
          finding.point = glm::dvec3((is_placed ? world_from_object : world_from_piece) * point);
          all.push_back({entry.name, piece.place, std::move(finding)});
        }
      } catch (const InputError& error) {
        if (!error.place().pointer.empty()) throw;
        throw InputError(piece.place, error.problem());
      }
    }
  }
  return all;
}

}  // namespace sweepkit::scene
