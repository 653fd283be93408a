// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "row_buffers.hpp"

#include <algorithm>
#include <utility>

namespace sweepkit::render {

void RowBuffers::shift_to(int y, RayCounts& counts, texmap::FilterThread& filter) {
  const auto trace = [&](std::size_t row, int at) {
    builder_.build(rows_[row], eye_rays_, at, first_, end_, counts, &filter);
  };
  switch (kept_) {
    case KeptRows::kOwn:
      trace(1, y);
      break;
    case KeptRows::kAbove:
      std::swap(rows_[0], rows_[1]);
      trace(1, y);
      break;
    case KeptRows::kBothSides:
      if (!has_started_) {
        trace(1, y - 1);
        trace(2, y);
      }
      // Row 2 takes the place of row 1, row 3 that of row 2, and row 3 is traced anew.
      std::rotate(rows_.begin(), rows_.begin() + 1, rows_.end());
      trace(2, y + 1);
      break;
  }
  has_started_ = true;
}

}  // namespace sweepkit::render
