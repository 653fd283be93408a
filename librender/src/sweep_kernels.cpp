// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Based on [Benthin, Woop, Niessner, Selgrad, Wald 2015] and [Woop, Benthin, Wald 2013]. Departs from them:
// float32 only rules out, by bounds that docs/algorithms/sweep-hierarchy.md derives, and ShearedRay decides
// in double about what is left; so every instruction set finds the same to the bit.

#include "sweep_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep_kernels.cpp"
#include <hwy/foreach_target.h>
// Behind the above, which includes this file once an instruction set.
#include <hwy/highway.h>

#include "packet_search-inl.hpp"
#include "sweep_search-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sweepkit::render::HWY_NAMESPACE {

SweepKernels kernels() {
  return {find_nearest, find_nearest_packet, is_blocked};
}

}  // namespace sweepkit::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sweepkit::render {

HWY_EXPORT(kernels);

std::vector<std::string> instruction_sets() {
  std::vector<std::string> names;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
    names.emplace_back(hwy::TargetName(target));
  return names;
}

SweepKernels sweep_kernels(const std::string& instruction_set) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    if (instruction_set != hwy::TargetName(target)) continue;
    hwy::ChosenTarget chosen;
    chosen.Update(target);
    return HWY_DISPATCH_TABLE(kernels)[chosen.GetIndex()]();
  }
  return {};
}

}  // namespace sweepkit::render
#endif
