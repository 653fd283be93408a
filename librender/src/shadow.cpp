// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Whitted80]: a shadow ray is dimmed by what it passes and not bent. Departs from it in dimming by
// distance inside as well, and in passing what a smooth surface would not have met:
//
// The terminator. A mesh stands for the smooth surface that its normals describe. Where a light grazes that,
// a shadow ray dips below facets that the surface curves over, and draws their outlines in black. Such a dip
// shows: the ray goes down through a triangle whose interpolated normal says that it comes up, which no ray
// does on a smooth surface. It is taken for no hit, together with the place where the ray comes up again. A
// wall has its other side turned away and a sheet lets no ray come up again, so neither leaks light. A dip
// begins no farther from the ray's start than the facet is long: what lies beyond throws the mesh's own
// shadow.

#include "shadow.hpp"

#include "material_of.hpp"
#include "scattering.hpp"
#include "surface_point.hpp"

namespace sweepkit::render {
namespace {

// Tells, hit by hit along a ray, which belong to dips below the facets of the object that it left.
class FacetDips {
 public:
  explicit FacetDips(std::uint32_t object) : object_(object) {}

  bool takes(const Tracer& tracer, const Hit& hit, const glm::dvec3& direction) {
    way_ += hit.t;
    if (hit.object != object_) return false;
    const SurfaceNormals normals = surface_normals(tracer, hit);
    const double down = glm::dot(normals.face, direction);
    if (!is_below()) {
      if (!(down * glm::dot(normals.shading, direction) < 0) || way_ > longest_edge(tracer, hit))
        return false;
      down_ = down;
      normal_ = normals.shading;
      return true;
    }
    if (!(down * down_ < 0 && glm::dot(normals.shading, normal_) > 0)) return false;
    down_ = 0;
    return true;
  }
  bool is_below() const { return down_ != 0; }

 private:
  std::uint32_t object_;
  double way_ = 0;
  double down_ = 0;  // the way through the facet, on the side that it has gone down by
  glm::dvec3 normal_{0.0};
};

// Each ray starts beyond the surface that the one before met, so there are no more of them than triangles
// along the way; the bound is for a scene of clear sheets without number.
constexpr int kMostSurfaces = 1000;

bool is_dip_alone(const Tracer& tracer, const Ray& ray, double end) {
  FacetDips dips(ray.from_object);
  Ray rest = ray;
  for (int surface = 0; surface < kMostSurfaces; ++surface) {
    const Hit hit = tracer.nearest(rest);
    if (!hit.is_hit() || !(hit.t < end)) return !dips.is_below();
    if (!dips.takes(tracer, hit, rest.direction)) return false;
    end -= hit.t;
    rest = pass_surface(hit, surface_point(tracer, hit, rest.direction), rest.direction);
  }
  return false;
}

}  // namespace

glm::dvec3 light_passing(const scene::Scene& scene, const Tracer& tracer, const Ray& ray, double end) {
  if (!scene.has_dimmed_shadows) {
    const bool passes = !tracer.is_blocked(ray, end) || is_dip_alone(tracer, ray, end);
    return glm::dvec3(passes ? 1.0 : 0.0);
  }
  glm::dvec3 passing(1.0);
  FacetDips dips(ray.from_object);
  Ray rest = ray;
  std::uint32_t medium = kNone;
  for (int surface = 0; surface < kMostSurfaces; ++surface) {
    const Hit hit = tracer.nearest(rest);
    if (!hit.is_hit() || !(hit.t < end)) {
      if (dips.is_below()) return glm::dvec3(0.0);
      // A light inside; one without end is outside of everything.
      if (medium != kNone && end < kNoEnd) passing *= absorbed(material_of(scene, medium), end);
      return passing;
    }
    const SurfacePoint point = surface_point(tracer, hit, rest.direction);
    if (!dips.takes(tracer, hit, rest.direction)) {
      const scene::Material& material = material_of(scene, hit.object);
      if (!(material.transmit > 0)) return glm::dvec3(0.0);
      if (point.is_inside) medium = hit.object;
      if (medium != kNone) passing *= absorbed(material_of(scene, medium), hit.t);
      passing *= static_cast<double>(material.transmit);
      medium = point.is_inside ? kNone : hit.object;
    }
    end -= hit.t;
    rest = pass_surface(hit, point, rest.direction);
  }
  return glm::dvec3(0.0);
}

}  // namespace sweepkit::render
