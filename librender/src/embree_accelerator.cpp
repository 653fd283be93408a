// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The one file that knows Embree 3 (embree.org). Its tree is asked, in its robust mode, which triangles a ray
// comes to; every one is then met by ShearedRay in double, inside Embree's filter function, before Embree
// believes it. Where the two disagree at an edge - float32 sees the triangle, double says that the ray passes
// beside it - the neighbour may have been missed by float32 in turn, and the ray would slip through the
// surface; so the triangle is taken then, at the place where float32 sees it.

#include "embree_accelerator.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>

#include "triangle_test.hpp"

namespace sweepkit::render {
namespace {

// What float32 makes of a number, as a share of it; of a coordinate moved to the ray's origin a few of them.
constexpr double kFloatRounding = 0x1p-21;

double largest(const glm::dvec3& vector) {
  const glm::dvec3 size = glm::abs(vector);
  return std::max({size.x, size.y, size.z});
}

// What the filter works on; Embree hands the first member back.
struct Question {
  RTCIntersectContext context;
  const scene::MeshView& mesh;
  const Ray& ray;
  const ShearedRay sheared;
  std::uint32_t object;
  Hit& best;
  double end;
};

// Where float32 sees the triangle, on the ray.
bool meets_beside(const Question& question, std::uint32_t triangle, double u, double v, Hit& found) {
  const auto& [ia, ib, ic] = question.mesh.triangles[triangle];
  const glm::dvec3 a(question.mesh.positions[ia]);
  const glm::dvec3 b(question.mesh.positions[ib]);
  const glm::dvec3 c(question.mesh.positions[ic]);
  Hit anywhere;
  const auto& line = question.sheared;
  // Met, but not between 0 and the end: the two agree.
  if (line.meets(question.mesh.positions[ia], question.mesh.positions[ib], question.mesh.positions[ic],
                 kNoEnd, anywhere)) {
    return false;
  }
  found.b = std::clamp(u, 0.0, 1.0);
  found.c = std::clamp(v, 0.0, 1.0 - found.b);
  found.a = 1 - found.b - found.c;
  const glm::dvec3& direction = question.ray.direction;
  const glm::dvec3 way = found.a * a + found.b * b + found.c * c - question.ray.origin;
  found.t = glm::dot(way, direction) / glm::dot(direction, direction);
  // Nearer than float32 can tell from the place that the ray leaves.
  const double blur =
      kFloatRounding * std::max({largest(question.ray.origin), largest(a), largest(b), largest(c)});
  return found.t * glm::length(direction) > blur && found.t <= question.end;
}

void filter(const RTCFilterFunctionNArguments* arguments) {
  auto& question = *reinterpret_cast<Question*>(arguments->context);
  const std::uint32_t triangle = RTCHitN_primID(arguments->hit, 1, 0);
  Hit found;
  const bool is_met = !question.ray.leaves(question.object, triangle) &&
                      (test_triangle(question.mesh, question.sheared, triangle, question.end, found) ||
                       meets_beside(question, triangle, static_cast<double>(RTCHitN_u(arguments->hit, 1, 0)),
                                    static_cast<double>(RTCHitN_v(arguments->hit, 1, 0)), found));
  if (!is_met) {
    arguments->valid[0] = 0;
    return;
  }
  keep_nearer(question.best, found, question.object, triangle);
  question.end = question.best.t;
}

// float32 not before the number.
float float_end(double t) {
  return std::nextafter(static_cast<float>(t), HUGE_VALF);
}

RTCRay to_embree(const Ray& ray, double end) {
  RTCRay out{};
  out.org_x = static_cast<float>(ray.origin.x);
  out.org_y = static_cast<float>(ray.origin.y);
  out.org_z = static_cast<float>(ray.origin.z);
  out.dir_x = static_cast<float>(ray.direction.x);
  out.dir_y = static_cast<float>(ray.direction.y);
  out.dir_z = static_cast<float>(ray.direction.z);
  out.tfar = float_end(end);
  out.mask = 0xFFFFFFFF;
  return out;
}

class EmbreeAccelerator final : public MeshAccelerator {
 public:
  explicit EmbreeAccelerator(const scene::MeshView& mesh) : mesh_(mesh), device_(rtcNewDevice(nullptr)) {
    if (device_ == nullptr) throw_if_failed();
    rtcSetDeviceMemoryMonitorFunction(
        device_,
        [](void* bytes, ssize_t change, bool) {
          *static_cast<std::atomic<std::ptrdiff_t>*>(bytes) += change;
          return true;
        },
        &bytes_);
    scene_ = rtcNewScene(device_);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    // Copied: Embree reads four numbers for three, beyond the end of an array that is not its own.
    void* positions = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                              sizeof(glm::vec3), mesh.positions.size());
    if (positions != nullptr) std::memcpy(positions, mesh.positions.data(), mesh.positions.size_bytes());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.triangles.data(), 0,
                               sizeof(sweep::Triangle), mesh.triangles.size());
    rtcSetGeometryIntersectFilterFunction(geometry, filter);
    rtcSetGeometryOccludedFilterFunction(geometry, filter);
    if (positions != nullptr) {
      rtcCommitGeometry(geometry);
      rtcAttachGeometry(scene_, geometry);
      rtcCommitScene(scene_);
    }
    rtcReleaseGeometry(geometry);
    try {
      throw_if_failed();
    } catch (...) {
      release();
      throw;
    }
  }
  ~EmbreeAccelerator() override { release(); }

  using MeshAccelerator::find_nearest;
  void find_nearest(const Ray& ray, std::uint32_t object, Hit& best) const override {
    Question question{{}, mesh_, ray, ShearedRay(ray), object, best, best.t};
    rtcInitIntersectContext(&question.context);
    RTCRayHit asked{to_embree(ray, best.t), {}};
    asked.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_, &question.context, &asked);
  }

  bool is_blocked(const Ray& ray, std::uint32_t object, double end) const override {
    Hit any;
    // Strictly before the end.
    Question question{{}, mesh_, ray, ShearedRay(ray), object, any, std::nextafter(end, 0.0)};
    rtcInitIntersectContext(&question.context);
    RTCRay asked = to_embree(ray, end);
    rtcOccluded1(scene_, &question.context, &asked);
    return any.is_hit();
  }

  std::size_t bytes() const override { return static_cast<std::size_t>(bytes_.load()); }

 private:
  void throw_if_failed() const {
    const RTCError error = rtcGetDeviceError(device_);
    if (error == RTC_ERROR_NONE) return;
    if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
    throw std::runtime_error("Embree fails with its error " + std::to_string(static_cast<int>(error)));
  }
  void release() {
    if (scene_ != nullptr) rtcReleaseScene(scene_);
    if (device_ != nullptr) rtcReleaseDevice(device_);
  }

  const scene::MeshView& mesh_;
  std::atomic<std::ptrdiff_t> bytes_ = 0;
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
};

}  // namespace

bool has_embree() {
  return true;
}

std::unique_ptr<const MeshAccelerator> make_embree_accelerator(const scene::MeshView& mesh) {
  return std::make_unique<EmbreeAccelerator>(mesh);
}

}  // namespace sweepkit::render
