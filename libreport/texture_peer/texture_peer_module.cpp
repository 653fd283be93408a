// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// OpenImageIO's texture system, for libreport to measure beside our filters.
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/texture.h>
#include <stdlib.h>
#include <unistd.h>

#include <exception>
#include <filesystem>
#include <memory>

#include "texture_peer.hpp"

namespace sweepkit::report {
namespace {

constexpr const char* kFile = "texture.tx";

struct Opened {
  std::filesystem::path folder;
  // The one that all share: OpenImageIO 2.4 deletes any other through a pointer of the wrong type.
  OIIO::TextureSystem* system = OIIO::TextureSystem::create(true);
  OIIO::TextureSystem::TextureHandle* handle = nullptr;
  OIIO::TextureSystem::Perthread* thread = nullptr;

  Opened() = default;
  Opened(const Opened&) = delete;
  Opened& operator=(const Opened&) = delete;
  ~Opened() {
    system->invalidate(OIIO::ustring((folder / kFile).string()));
    std::error_code ignored;
    if (!folder.empty()) std::filesystem::remove_all(folder, ignored);
  }
};

std::string open(const float* texels, int side, void*& handle) try {
  auto opened = std::make_unique<Opened>();
  std::error_code error;
  const std::filesystem::path temporary = std::filesystem::temp_directory_path(error);
  if (error) return "no folder for temporary files (TMPDIR): " + error.message();
  std::string name = (temporary / "sweepkit-peer-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) return name + ": cannot be made";
  opened->folder = name;
  const std::string file = (opened->folder / kFile).string();
  OIIO::ImageBuf image(OIIO::ImageSpec(side, side, 3, OIIO::TypeDesc::FLOAT));
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const float value = *texels++;
      image.setpixel(x, y, OIIO::cspan<float>({value, value, value}));
    }
  }
  if (!OIIO::ImageBufAlgo::make_texture(OIIO::ImageBufAlgo::MakeTxTexture, image, file, {}))
    return "no pyramid: " + OIIO::geterror();
  opened->handle = opened->system->get_texture_handle(OIIO::ustring(file));
  opened->thread = opened->system->get_perthread_info();
  if (opened->handle == nullptr || !opened->system->good(opened->handle))
    return "the pyramid cannot be read: " + opened->system->geterror();
  handle = opened.release();
  return {};
} catch (const std::exception& error) {
  return error.what();
}

void sample(void* handle, const PeerOptions& options, const texmap::Footprint* footprints, std::size_t count,
            float* out) {
  const auto& opened = *static_cast<const Opened*>(handle);
  OIIO::TextureOpt how;
  how.swrap = how.twrap = OIIO::TextureOpt::WrapPeriodic;
  how.anisotropic = options.anisotropy;
  switch (options.interpolation) {
    case PeerOptions::Interpolation::kBilinear:
      how.interpmode = OIIO::TextureOpt::InterpBilinear;
      break;
    case PeerOptions::Interpolation::kBicubic:
      how.interpmode = OIIO::TextureOpt::InterpBicubic;
      break;
    case PeerOptions::Interpolation::kSmartBicubic:
      how.interpmode = OIIO::TextureOpt::InterpSmartBicubic;
      break;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const texmap::Footprint& f = footprints[i];
    float color[3];
    // Its t runs down.
    opened.system->texture(opened.handle, opened.thread, how, static_cast<float>(f.uv.x),
                           static_cast<float>(1 - f.uv.y), static_cast<float>(f.dx.x),
                           static_cast<float>(-f.dx.y), static_cast<float>(f.dy.x),
                           static_cast<float>(-f.dy.y), 3, color);
    out[i] = color[0];
  }
}

void close(void* handle) {
  delete static_cast<Opened*>(handle);
}

}  // namespace
}  // namespace sweepkit::report

// The name is kTexturePeerSymbol.
extern "C" __attribute__((visibility("default")))
const sweepkit::report::TexturePeer sweepkit_texture_peer_1 = {
    sweepkit::report::open, sweepkit::report::sample, sweepkit::report::close};
