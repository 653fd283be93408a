// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "view_page.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <utility>

#include "sweepkit/error.hpp"

namespace sweepkit::tools {
namespace {

constexpr const char* kTemplateFile = "sweepkit-view.html";

std::string html_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

// A browser looks for the end of a script in JSON as well; inside a JSON string this is the same letter.
std::string json_in_html(const std::string& json) {
  std::string out;
  for (const char c : json) {
    if (c == '<') {
      out += "\\u003c";
    } else {
      out += c;
    }
  }
  return out;
}

}  // namespace

std::string read_page_template() {
  std::error_code ignored;
  const std::filesystem::path folder = std::filesystem::canonical("/proc/self/exe", ignored).parent_path();
  for (const std::filesystem::path& file :
       {folder / kTemplateFile, folder / "../share/sweepkit" / kTemplateFile}) {
    std::ifstream in(file, std::ios::binary);
    if (in) return {std::istreambuf_iterator<char>(in), {}};
  }
  throw InputError(std::string("this build has no page to show models with (") + kTemplateFile +
                   " beside the program): it was built where node or the npm packages were missing; run "
                   "scripts/setup and build again");
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
  const std::array<std::pair<std::string_view, std::string>, 4> marks = {
      {{"@GENERATOR@", "sweepkit " SWEEPKIT_VERSION},
       {"@TITLE@", html_text(contents.title)},
       {"@FACTS@", json_in_html(contents.facts)},
       {"@MODEL@", base64(contents.model)}}};
  // In the order in which they stand, so that none is looked for in what was put in.
  std::string page;
  std::size_t done = 0;
  for (const auto& [mark, text] : marks) {
    const std::size_t at = page_template.find(mark, done);
    if (at == std::string::npos) throw OutputError(std::string(kTemplateFile) + " is damaged; build again");
    page.append(page_template, done, at - done);
    page += text;
    done = at + mark.size();
  }
  return page.append(page_template, done);
}

}  // namespace sweepkit::tools
