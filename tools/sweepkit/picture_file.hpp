// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sweepkit/render/render.hpp"
#include "sweepkit/texmap/file_image.hpp"

namespace sweepkit::tools {

/// How pictures become files.
struct PictureEncoding {
  texmap::ImageFormat format = texmap::ImageFormat::kPng;
  int bits = 0;         ///< a sample; 0: 8, for EXR 16
  double exposure = 0;  ///< stops: light is doubled so many times
  texmap::ImageWindow window;
};

struct EncodedFile {
  std::string name;
  std::vector<std::byte> bytes;
};

/// The names of the files of a picture `file`: itself first, then, where it is no EXR file, one for each
/// layer, such as vase.depth.exr beside vase.png.
std::vector<std::string> picture_file_names(const std::string& file, texmap::ImageFormat format,
                                            const std::vector<render::Layer>& layers);

/// The bytes of those files. Colours are exposed; in EXR they stay multiplied by alpha, elsewhere they are
/// divided by it; what is no number becomes 0. `description` goes into every file. Throws OutputError where
/// the encoder fails.
std::vector<EncodedFile> encode_picture(render::Picture picture, const std::string& file,
                                        const PictureEncoding& encoding, const std::string& description);

}  // namespace sweepkit::tools
