// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace sweepkit::scene {

/// How EXT_meshopt_compression packed a view, by its own names.
struct GltfPacking {
  std::string mode;    ///< "ATTRIBUTES", "TRIANGLES"
  std::string filter;  ///< "OCTAHEDRAL", "EXPONENTIAL"; empty: none
  std::size_t count = 0;
  std::size_t item_bytes = 0;       ///< of one of `count`, unpacked
  std::size_t unpacked_offset = 0;  ///< in the buffer that viewers unpack into

  bool operator==(const GltfPacking&) const = default;
};

/// A stretch of the buffer, as a bufferView has it.
struct GltfView {
  std::size_t offset = 0;
  std::size_t length = 0;
  int target = 0;
  std::size_t stride = 0;  ///< 0: none is said
  std::optional<GltfPacking> packing;
};

}  // namespace sweepkit::scene
