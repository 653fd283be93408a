// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sweepkit/scene/document.hpp"

namespace sweepkit::scene {

/// Values for many scenes made from one: a column a JSON pointer, a row a scene.
struct ValuesTable {
  struct Cell {
    std::string text;  ///< without the quotes that CSV puts round it
    int line = 0;      ///< from 1; where the cell begins
    int column = 0;    ///< from 1, in bytes
  };
  using Row = std::vector<Cell>;

  std::string file;       ///< for messages
  Row pointers;           ///< the header; not empty, no pointer twice
  std::vector<Row> rows;  ///< not empty; each as long as `pointers`

  Place place(const Cell& cell) const;
};

/// Reads comma-separated values (RFC 4180): the first row holds JSON pointers; a cell with a comma, a quote
/// or a line break in it stands in double quotes, a quote inside written twice; blanks round a cell that is
/// not quoted do not count; lines end in LF, CR LF or CR; empty lines are passed over; UTF-8, with or without
/// a byte-order mark. Throws InputError with file, line and column: unreadable, no header, no rows, a row
/// longer or shorter than the header, an empty or repeated pointer, a quote astray.
ValuesTable read_values_table(const std::filesystem::path& file);

/// The same from text; `file` names it in messages.
ValuesTable parse_values_table(const std::string& text, const std::filesystem::path& file);

/// What a row sets, from left to right. An empty cell sets nothing: the scene keeps its own value.
std::vector<Setting> settings_of(const ValuesTable& table, const ValuesTable::Row& row);

/// Throws InputError, placed in the header, if a pointer leads nowhere in the scene, or to a key that the
/// scene format does not have there. A pointer below an earlier column's is left to the rows, which may make
/// its way.
void check_pointers(const ValuesTable& table, const SceneFile& scene);

}  // namespace sweepkit::scene
