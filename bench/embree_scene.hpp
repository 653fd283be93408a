// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <embree3/rtcore.h>

#include <array>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include "ray.hpp"
#include "sweepkit/scene/scene.hpp"

namespace sweepkit::bench {

/// What Embree says of a ray: its triangle (on GRID geometry always 0), none where it misses.
struct EmbreeHit {
  float t = 0;
  std::uint32_t triangle = render::kNone;
};

/// One mesh in Embree, one thread, medium quality, default flags; as triangles or as GRID geometry.
class EmbreeScene {
 public:
  EmbreeScene(const scene::MeshView& mesh, bool is_grid) : mesh_(mesh), is_grid_(is_grid) {
    device_ = rtcNewDevice("threads=1");
    if (device_ == nullptr) throw std::runtime_error("Embree does not start");
    rtcSetDeviceMemoryMonitorFunction(
        device_,
        [](void* bytes, ssize_t more, bool) {
          *static_cast<std::int64_t*>(bytes) += more;
          return true;
        },
        &bytes_);
  }
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;
  ~EmbreeScene() {
    clear();
    rtcReleaseDevice(device_);
  }

  void clear() {
    if (scene_ != nullptr) rtcReleaseScene(scene_);
    scene_ = nullptr;
  }

  /// From the mesh's own arrays, which stay in use.
  void build() {
    clear();
    scene_ = rtcNewScene(device_);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_MEDIUM);
    RTCGeometry geometry =
        rtcNewGeometry(device_, is_grid_ ? RTC_GEOMETRY_TYPE_GRID : RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_MEDIUM);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, mesh_.positions.data(),
                               0, sizeof(glm::vec3), mesh_.positions.size());
    if (is_grid_) {
      add_grids();
      rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_GRID, 0, RTC_FORMAT_GRID, grids_.data(), 0,
                                 sizeof(RTCGrid), grids_.size());
    } else {
      rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh_.triangles.data(),
                                 0, sizeof(sweep::Triangle), mesh_.triangles.size());
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
    if (rtcGetDeviceError(device_) != RTC_ERROR_NONE) throw std::runtime_error("Embree refuses the mesh");
  }

  std::int64_t bytes() const { return bytes_; }

  void intersect_single(std::span<const render::Ray> rays, std::span<EmbreeHit> hits) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      RTCRayHit query;
      query.ray.org_x = static_cast<float>(rays[i].origin.x);
      query.ray.org_y = static_cast<float>(rays[i].origin.y);
      query.ray.org_z = static_cast<float>(rays[i].origin.z);
      query.ray.dir_x = static_cast<float>(rays[i].direction.x);
      query.ray.dir_y = static_cast<float>(rays[i].direction.y);
      query.ray.dir_z = static_cast<float>(rays[i].direction.z);
      query.ray.tnear = 0;
      query.ray.time = 0;
      query.ray.tfar = std::numeric_limits<float>::infinity();
      query.ray.mask = ~0u;
      query.ray.flags = 0;
      query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
      rtcIntersect1(scene_, &context, &query);
      hits[i] = {query.ray.tfar,
                 query.hit.geomID == RTC_INVALID_GEOMETRY_ID ? render::kNone : query.hit.primID};
    }
  }

  /// Precondition: a multiple of 16 rays.
  void intersect_packets(std::span<const render::Ray> rays, std::span<EmbreeHit> hits) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    alignas(64) std::array<int, 16> valid;
    valid.fill(-1);
    for (std::size_t i = 0; i < rays.size(); i += 16) {
      RTCRayHit16 query;
      for (std::size_t k = 0; k < 16; ++k) {
        const render::Ray& ray = rays[i + k];
        query.ray.org_x[k] = static_cast<float>(ray.origin.x);
        query.ray.org_y[k] = static_cast<float>(ray.origin.y);
        query.ray.org_z[k] = static_cast<float>(ray.origin.z);
        query.ray.dir_x[k] = static_cast<float>(ray.direction.x);
        query.ray.dir_y[k] = static_cast<float>(ray.direction.y);
        query.ray.dir_z[k] = static_cast<float>(ray.direction.z);
        query.ray.tnear[k] = 0;
        query.ray.time[k] = 0;
        query.ray.tfar[k] = std::numeric_limits<float>::infinity();
        query.ray.mask[k] = ~0u;
        query.ray.flags[k] = 0;
        query.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
        query.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
      }
      rtcIntersect16(valid.data(), scene_, &context, &query);
      for (std::size_t k = 0; k < 16; ++k) {
        hits[i + k] = {query.ray.tfar[k],
                       query.hit.geomID[k] == RTC_INVALID_GEOMETRY_ID ? render::kNone : query.hit.primID[k]};
      }
    }
  }

 private:
  // Embree's grids have at most 32767 vertices a side; pole rows are triangles and belong to none.
  void add_grids() {
    grids_.clear();
    constexpr std::uint32_t kMostCells = 32766;
    for (const sweep::GridPatch& patch : mesh_.patches) {
      const std::uint32_t first = patch.has_first_pole ? 1 : 0;
      const std::uint32_t end = patch.rows - (patch.has_last_pole ? 1 : 0);
      for (std::uint32_t row = first; row < end; row += kMostCells) {
        const std::uint32_t rows = std::min(end - row, kMostCells);
        grids_.push_back({patch.vertex(0, row), patch.columns + 1,
                          static_cast<std::uint16_t>(patch.columns + 1),
                          static_cast<std::uint16_t>(rows + 1)});
      }
    }
  }

  const scene::MeshView& mesh_;
  bool is_grid_;
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
  std::int64_t bytes_ = 0;
  std::vector<RTCGrid> grids_;
};

}  // namespace sweepkit::bench
