// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>

#include "sweepkit/texmap/image.hpp"
#include "sweepkit/texmap/image_error.hpp"
#include "texel.hpp"

namespace sweepkit::texmap {

/// Where the finest level of a texture comes from, piece by piece.
class TexelSource {
 public:
  virtual ~TexelSource() = default;
  virtual int width() const = 0;
  virtual int height() const = 0;
  virtual bool is_float() const = 0;
  virtual std::size_t bytes() const = 0;  ///< of memory held

  /// Fills `texels`, row by row, with a rectangle inside the image. Only the form that is_float() names may
  /// be asked for. Any number of threads. Throws InputError where a file turns out to be damaged.
  virtual void read(const PixelRect& rect, std::span<IntegerTexel> texels) const = 0;
  virtual void read(const PixelRect& rect, std::span<FloatTexel> texels) const = 0;
};

/// An image that is in memory as a whole.
std::shared_ptr<const TexelSource> make_texel_source(std::shared_ptr<const Image> image);

}  // namespace sweepkit::texmap
