// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "make_mesh.hpp"

#include "mesh_shape.hpp"
#include "sweepkit/sweep/sweep.hpp"

namespace sweepkit::scene {

sweep::SweepOptions sweep_options(const Piece& piece, const SweepShape& shape) {
  return {.tessellation = piece.tessellation,
          .uv = piece.uv,
          .crease_deg = piece.crease_deg,
          .caps = shape.caps,
          .joints = shape.joints,
          .miter_limit = shape.miter_limit,
          .profile = shape.profile,
          .morph = shape.morph,
          .twist_deg = shape.twist_deg,
          .orientation = shape.orientation};
}

sweep::RevolveOptions revolve_options(const Piece& piece, const RevolveShape& shape) {
  return {.tessellation = piece.tessellation,
          .uv = piece.uv,
          .angle_deg = shape.angle_deg,
          .crease_deg = piece.crease_deg,
          .caps = shape.caps};
}

sweep::Mesh make_mesh(const Piece& piece, const MeshNeeds& needs, Cost& layout_cost) {
  if (const auto* shape = std::get_if<SweepShape>(&piece.shape)) {
    sweep::SweepOptions options = sweep_options(piece, *shape);
    options.has_half_edges = needs.half_edges;
    return sweep::sweep(shape->contour, shape->trajectory, options);
  }
  if (const auto* shape = std::get_if<RevolveShape>(&piece.shape)) {
    sweep::RevolveOptions options = revolve_options(piece, *shape);
    options.has_half_edges = needs.half_edges;
    return sweep::revolve(shape->contour, options);
  }
  if (const auto* shape = std::get_if<PlaneShape>(&piece.shape)) {
    return sweep::plane(shape->size, {piece.tessellation, piece.uv, needs.half_edges});
  }
  return make_mesh_shape(piece, std::get<MeshShape>(piece.shape), needs, layout_cost);
}

}  // namespace sweepkit::scene
