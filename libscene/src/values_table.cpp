// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// The one file that knows libcsv, which does the parsing but counts no lines. A cell can only end with a
// comma or a line's end, so the text is handed over in stretches that end there: when a cell arrives its last
// byte is the stretch's, and the next cell begins behind it.

#include "sweepkit/scene/values_table.hpp"

#include <csv.h>

#include <algorithm>
#include <memory>
#include <string_view>

#include "message_text.hpp"
#include "sweepkit/error.hpp"
#include "text_file.hpp"

namespace sweepkit::scene {
namespace {

constexpr std::size_t kLargestTable = std::size_t{256} << 20;

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

class Reader {
 public:
  Reader(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {
    if (text_.substr(0, 3) == kByteOrderMark) text_.remove_prefix(3);
    if (text_.find('\0') != std::string_view::npos) {
      throw InputError({.file = file_}, "is no UTF-8 text; save it as comma-separated values in UTF-8");
    }
  }

  std::vector<ValuesTable::Row> read() {
    csv_parser parser;
    if (csv_init(&parser, CSV_STRICT | CSV_STRICT_FINI) != 0) throw std::bad_alloc();
    const std::unique_ptr<csv_parser, void (*)(csv_parser*)> release(&parser, csv_free);
    begin_cell();
    while (at_ < text_.size()) {
      const std::size_t mark = text_.find_first_of(",\r\n", at_);
      const std::size_t end = mark == std::string_view::npos ? text_.size() : mark + 1;
      const std::size_t taken = csv_parse(&parser, text_.data() + at_, end - at_, on_cell, on_row, this);
      if (taken != end - at_) refuse(parser);
      pass(end);
      if (is_cell_over_) begin_cell();
    }
    if (csv_fini(&parser, on_cell, on_row, this) != 0) refuse(parser);
    return std::move(rows_);
  }

 private:
  static void on_cell(void* text, std::size_t size, void* self) {
    auto& reader = *static_cast<Reader*>(self);
    reader.row_.push_back({{static_cast<const char*>(text), size}, reader.cell_line_, reader.cell_column_});
    reader.is_cell_over_ = true;
  }
  static void on_row(int, void* self) {
    auto& reader = *static_cast<Reader*>(self);
    reader.rows_.push_back(std::exchange(reader.row_, {}));
  }

  [[noreturn]] void refuse(csv_parser& parser) const {
    if (csv_error(&parser) == CSV_ENOMEM) throw std::bad_alloc();
    throw InputError(
        {.file = file_, .line = cell_line_, .column = cell_column_},
        "a quote stands astray in this cell; put the whole cell in quotes and double the quotes inside");
  }

  // Counts lines as libcsv ends them: LF, CR LF or CR.
  void pass(std::size_t end) {
    for (; at_ < end; ++at_) {
      const bool is_cr_of_crlf = text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n';
      if ((text_[at_] == '\n' || text_[at_] == '\r') && !is_cr_of_crlf) {
        ++line_;
        line_start_ = at_ + 1;
      }
    }
    // Between rows, empty lines and the LF of a CR LF belong to no cell.
    if (row_.empty() && !is_cell_over_ && is_blank(cell_start_, end)) is_cell_over_ = true;
  }

  bool is_blank(std::size_t from, std::size_t to) const {
    return text_.substr(from, to - from).find_first_not_of(" \t\r\n") == std::string_view::npos;
  }

  void begin_cell() {
    is_cell_over_ = false;
    cell_start_ = at_;
    const std::size_t first = std::min(text_.find_first_not_of(" \t", at_), text_.size());
    cell_line_ = line_;
    cell_column_ = static_cast<int>(first - line_start_) + 1;
  }

  std::string_view text_;
  std::string file_;
  std::vector<ValuesTable::Row> rows_;
  ValuesTable::Row row_;
  std::size_t at_ = 0;
  std::size_t line_start_ = 0;
  int line_ = 1;
  std::size_t cell_start_ = 0;
  int cell_line_ = 1;
  int cell_column_ = 1;
  bool is_cell_over_ = false;
};

std::string count_of(std::size_t count, const std::string& what) {
  return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}

void check_header(const ValuesTable& table) {
  const ValuesTable::Row& header = table.pointers;
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (header[i].text.empty()) {
      throw InputError(table.place(header[i]), "column " + std::to_string(i + 1) +
                                                   " needs a JSON pointer above it, such as /objects/0/name");
    }
    const auto same = std::find_if(header.begin(), header.begin() + static_cast<std::ptrdiff_t>(i),
                                   [&](const auto& cell) { return cell.text == header[i].text; });
    if (same != header.begin() + static_cast<std::ptrdiff_t>(i)) {
      throw InputError(table.place(header[i]),
                       "the pointer " + one_line(header[i].text) + " stands above column " +
                           std::to_string(same - header.begin() + 1) + " too; leave one out");
    }
  }
}

void check_lengths(const ValuesTable& table) {
  for (const ValuesTable::Row& row : table.rows) {
    if (row.size() == table.pointers.size()) continue;
    throw InputError(
        table.place(row.front()),
        "has " + count_of(row.size(), "cell") + " where the header has " +
            std::to_string(table.pointers.size()) +
            "; put a cell that holds a comma in quotes, and leave a cell empty for the scene's value");
  }
}

bool is_below(const std::string& pointer, const std::string& other) {
  return pointer.size() > other.size() && pointer.compare(0, other.size(), other) == 0 &&
         pointer[other.size()] == '/';
}

}  // namespace

Place ValuesTable::place(const Cell& cell) const {
  return {.file = file, .line = cell.line, .column = cell.column};
}

ValuesTable parse_values_table(const std::string& text, const std::filesystem::path& file) {
  ValuesTable table;
  table.file = file.string();
  table.rows = Reader(text, table.file).read();
  if (table.rows.empty()) {
    throw InputError({.file = table.file},
                     "is empty; needs a row of JSON pointers, then a row of values for each file");
  }
  table.pointers = std::move(table.rows.front());
  table.rows.erase(table.rows.begin());
  check_header(table);
  if (table.rows.empty()) {
    throw InputError({.file = table.file}, "has no row of values below its header; add one for each file");
  }
  check_lengths(table);
  return table;
}

ValuesTable read_values_table(const std::filesystem::path& file) {
  return parse_values_table(read_text_file(file, kLargestTable, "a table of values"), file);
}

std::vector<Setting> settings_of(const ValuesTable& table, const ValuesTable::Row& row) {
  std::vector<Setting> settings;
  settings.reserve(row.size());
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (row[i].text.empty()) continue;
    settings.push_back(
        {table.pointers[i].text, row[i].text, table.place(row[i]), table.place(table.pointers[i])});
  }
  return settings;
}

void check_pointers(const ValuesTable& table, const SceneFile& scene) {
  const ValuesTable::Row& header = table.pointers;
  for (std::size_t i = 0; i < header.size(); ++i) {
    const bool is_made = std::any_of(header.begin(), header.begin() + static_cast<std::ptrdiff_t>(i),
                                     [&](const auto& cell) { return is_below(header[i].text, cell.text); });
    if (!is_made) scene.check_pointer(header[i].text, table.place(header[i]));
    // A key that the format does not know shows once a row that sets it is read; any other fault is that
    // row's.
    const auto sets = std::find_if(table.rows.begin(), table.rows.end(),
                                   [&](const auto& row) { return !row[i].text.empty(); });
    if (sets == table.rows.end()) continue;
    try {
      scene.document(settings_of(table, *sets));
    } catch (const InputError& error) {
      const Place& place = error.place();
      if (place.file == table.file && place.line == header[i].line && place.column == header[i].column) throw;
    }
  }
}

}  // namespace sweepkit::scene
