// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace sweepkit::sweep {

/// Has the system bring in at once memory that is to be filled and that nothing has touched yet, in pages of
/// 2 MiB where they fit: brought in page by page, a large mesh's first touch takes longer than its filling. A
/// hint: what is small, and any other system than Linux, does without.
void prepare_first_touch(void* memory, std::size_t bytes);

/// resize() of a vector whose new values are filled at once.
template <class T>
void resize_to_fill(std::vector<T>& values, std::size_t size) {
  if (size > values.capacity()) {
    values.reserve(size);
    prepare_first_touch(values.data() + values.size(), (size - values.size()) * sizeof(T));
  }
  values.resize(size);
}

}  // namespace sweepkit::sweep
