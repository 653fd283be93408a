// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "view_page.hpp"

#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

#include "page_template.hpp"

namespace sweepkit::tools {
namespace {

constexpr const char* kTemplateFile = "sweepkit-view.html";

}  // namespace

std::string read_page_template() {
  return read_bundled(kTemplateFile, "to show models with");
}

std::string base64(std::span<const std::byte> bytes) {
  static constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (k < count ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) out += k <= count ? kDigits[group >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

std::string fill_page(const std::string& page_template, const PageContents& contents) {
  const std::array<std::pair<std::string, std::string>, 4> texts = {
      {{"@GENERATOR@", "sweepkit " SWEEPKIT_VERSION},
       {"@TITLE@", html_text(contents.title)},
       {"@FACTS@", json_in_html(contents.facts)},
       {"@MODEL@", base64(contents.model)}}};
  return fill_marks(page_template, kTemplateFile, texts);
}

}  // namespace sweepkit::tools
