// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "report.hpp"
#include "sweepkit/texmap/image_file.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace sweepkit::tools {

/// Where a command's result goes and what it tells on the way. Tables that were asked for go to standard
/// output, or to standard error where the result itself goes to standard output.
struct Output {
  std::string file;    ///< "-" is standard output; empty: nothing but the plan is wanted
  std::string format;  ///< "png", ...; empty: what the file's name ends in
  bool explains = false;
  bool is_json = false;
  bool is_quiet = false;

  bool is_standard() const { return file == "-"; }
};

void add_quiet(CLI::App& command, Output& output);
void add_explain(CLI::App& command, Output& output);
CLI::Option* add_json(CLI::App& command, Output& output, const std::string& what);
void add_picture_output(CLI::App& command, Output& output, const std::string& what);

/// The format a picture is to be written in; PNG where neither --format nor a name tells. Throws InputError.
texmap::ImageFormat picture_format(const Output& output);

/// Prints a table that was asked for.
void print(const Report& report, const Output& output);

/// Says in a line on standard error what was done, unless it is to be quiet.
void say(const std::string& line, const Output& output);

/// An error in a line on standard error, in the program's name.
void complain(std::string message);

/// "0.84 s", "12 ms".
std::string duration_text(double seconds);

/// "0.00097 m": a length to two digits, which is what one asks of an error.
std::string length_text(double metres);

}  // namespace sweepkit::tools
