// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace sweepkit::tools {

/// The page that tools/view makes of three.js, as it lies beside the program or where it was installed.
/// Throws InputError where this build has none.
std::string read_page_template();

struct PageContents {
  std::string title;
  std::string facts;                 ///< JSON, of the form that tools/view/src/page.js reads
  std::span<const std::byte> model;  ///< a .glb
};

/// The page with these in it: one file that needs no other and no network.
std::string fill_page(const std::string& page_template, const PageContents& contents);

/// RFC 4648, padded.
std::string base64(std::span<const std::byte> bytes);

}  // namespace sweepkit::tools
