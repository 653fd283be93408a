// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sweepkit/texmap/footprint.hpp"

namespace sweepkit::report {

/// How OpenImageIO's texture system is asked.
struct PeerOptions {
  enum class Interpolation {
    kBilinear,
    kBicubic,
    kSmartBicubic
  } interpolation = Interpolation::kSmartBicubic;
  int anisotropy = 16;
};

/// The border between libreport and the peer module, which alone links OpenImageIO here: that costs 0.3 s at
/// every start of a program. Both sides are built together. A change of this struct changes the symbol's
/// name.
struct TexturePeer {
  /// A grey texture of `side` x `side` texels that repeats, its pyramid made as `maketx` does, of float
  /// texels, which it is fastest on. Returns what went wrong, or an empty text.
  std::string (*open)(const float* texels, int side, void*& handle);
  /// The red of each footprint, into `out`.
  void (*sample)(void* handle, const PeerOptions& options, const texmap::Footprint* footprints,
                 std::size_t count, float* out);
  void (*close)(void* handle);
};

/// The module, loaded by the first call; nullptr where it is missing, and then `reason` says why.
const TexturePeer* texture_peer(std::string& reason);

inline constexpr const char* kTexturePeerSymbol = "sweepkit_texture_peer_1";
inline constexpr const char* kTexturePeerFile = "sweepkit-texture-peer.so";

}  // namespace sweepkit::report
