// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "intersection_tree.hpp"
#include "neighbourhood.hpp"

namespace sweepkit::render {

/// The rows of trees that the work on one row looks at.
enum class KeptRows {
  kOwn,       ///< that row alone
  kAbove,     ///< and the one above, to compare it with
  kBothSides  ///< and the ones above and below (the filter's border)
};

/// Row buffers that shift by one row at a time (the paper's 3.2.3).
class RowBuffers {
 public:
  /// Pixels first..end-1 of each row.
  RowBuffers(const TreeBuilder& builder, const EyeRays& eye_rays, KeptRows kept, int first, int end)
      : builder_(builder), eye_rays_(eye_rays), kept_(kept), first_(first), end_(end) {}

  /// Makes row y the middle one. The first time any row, then one after the other.
  void shift_to(int y, RayCounts& counts, texmap::FilterThread& filter);

  RowWindow window() const {
    return {&rows_[kept_ == KeptRows::kBothSides ? 0 : 1], &rows_[1],
            &rows_[kept_ == KeptRows::kBothSides ? 2 : 1]};
  }
  const TreeRow& middle() const { return rows_[1]; }
  const TreeRow& above() const { return rows_[0]; }  ///< not with kOwn, and not the first time with kAbove

  const std::array<TreeRow, 3>& rows() const { return rows_; }

 private:
  const TreeBuilder& builder_;
  const EyeRays& eye_rays_;
  KeptRows kept_;
  int first_;
  int end_;
  bool has_started_ = false;
  std::array<TreeRow, 3> rows_;
};

}  // namespace sweepkit::render
