// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "sweepkit/scene/values_table.hpp"

namespace sweepkit::tools {

/// The file that each row of a table is written to: out/vase_{row}.glb, {/objects/0/name}.gltf.
///   {row}      the row's number, from 1, with zeros in front so that names sort as rows do
///   {POINTER}  what the row has in that column
class NamePattern {
 public:
  /// `table` must outlive the pattern. Throws InputError naming -o: no model's name, standard output, an
  /// unknown name in braces, a brace without its other, one name for several rows.
  NamePattern(const std::string& text, const scene::ValuesTable& table);

  /// The file of a row, by its index from 0. Throws InputError at the cell that cannot be part of a file's
  /// name: empty, "." or "..", with a slash or a control character, too long.
  std::string file(std::size_t row) const;

 private:
  struct RowNumber {};
  using Part = std::variant<std::string, RowNumber, std::size_t>;  // a text, {row}, a column

  Part field(const std::string& name) const;
  std::string value(const scene::ValuesTable::Cell& cell, const std::string& pointer) const;

  const scene::ValuesTable* table_;
  std::vector<Part> parts_;
};

}  // namespace sweepkit::tools
