// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "texture_peer.hpp"

#include "module_file.hpp"

namespace sweepkit::report {

const TexturePeer* texture_peer(std::string& reason) {
  return static_cast<const TexturePeer*>(texmap::module_symbol(kTexturePeerFile, kTexturePeerSymbol, reason));
}

}  // namespace sweepkit::report
