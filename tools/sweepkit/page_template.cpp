// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "page_template.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "sweepkit/error.hpp"

namespace sweepkit::tools {

std::string read_bundled(const std::string& file, const std::string& purpose) {
  std::error_code ignored;
  const std::filesystem::path folder = std::filesystem::canonical("/proc/self/exe", ignored).parent_path();
  for (const std::filesystem::path& place : {folder / file, folder / "../share/sweepkit" / file}) {
    std::ifstream in(place, std::ios::binary);
    if (in) return {std::istreambuf_iterator<char>(in), {}};
  }
  throw InputError("this build has no page " + purpose + " (" + file +
                   " beside the program): it was built where node or the npm packages were missing; run "
                   "scripts/setup and build again");
}

std::string fill_marks(const std::string& page_template, const std::string& file,
                       std::span<const std::pair<std::string, std::string>> texts) {
  // In the order in which they stand, so that none is looked for in what was put in.
  std::string page;
  std::size_t done = 0;
  for (const auto& [mark, text] : texts) {
    const std::size_t at = page_template.find(mark, done);
    if (at == std::string::npos) throw OutputError(file + " is damaged; build again");
    page.append(page_template, done, at - done);
    page += text;
    done = at + mark.size();
  }
  return page.append(page_template, done);
}

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

// Inside a JSON string this is the same letter.
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

}  // namespace sweepkit::tools
