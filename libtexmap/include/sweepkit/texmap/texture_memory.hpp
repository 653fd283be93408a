// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace sweepkit::texmap {

/// What the textures of a picture may fill in memory unless told otherwise: 512 MB.
inline constexpr std::size_t kDefaultTextureMemory = std::size_t{512} << 20;

}  // namespace sweepkit::texmap
