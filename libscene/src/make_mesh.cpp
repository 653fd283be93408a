// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "make_mesh.hpp"

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

sweep::Mesh make_mesh(const Piece& piece, bool has_half_edges) {
  if (const auto* shape = std::get_if<SweepShape>(&piece.shape)) {
    sweep::SweepOptions options = sweep_options(piece, *shape);
    options.has_half_edges = has_half_edges;
    return sweep::sweep(shape->contour, shape->trajectory, options);
  }
  if (const auto* shape = std::get_if<RevolveShape>(&piece.shape)) {
    sweep::RevolveOptions options = revolve_options(piece, *shape);
    options.has_half_edges = has_half_edges;
    return sweep::revolve(shape->contour, options);
  }
  return sweep::plane(std::get<PlaneShape>(piece.shape).size, {piece.tessellation, piece.uv, has_half_edges});
}

}  // namespace sweepkit::scene
