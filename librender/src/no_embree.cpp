// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Stands in for embree_accelerator.cpp where Embree is not installed.

#include "embree_accelerator.hpp"
#include "sweepkit/error.hpp"

namespace sweepkit::render {

bool has_embree() {
  return false;
}

std::unique_ptr<const MeshAccelerator> make_embree_accelerator(const scene::MeshView& /*mesh*/) {
  throw InputError(
      "the accelerator embree is not in this build; install Embree 3 (Debian: libembree-dev) and build "
      "again, "
      "or ask for another one");
}

}  // namespace sweepkit::render
