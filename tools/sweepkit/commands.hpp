// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#pragma once

namespace CLI {
class App;
}

namespace sweepkit::tools {

/// What --threads takes at most.
inline constexpr int kMostThreads = 1024;

/// Each adds one command to the program: its options, its help with an example, and what it does when it is
/// called. Commands throw InputError and OutputError; main() turns them into an exit status.
void add_generate(CLI::App& app);
void add_render(CLI::App& app);
void add_assemble(CLI::App& app);
void add_bake(CLI::App& app);
void add_info(CLI::App& app);
void add_check(CLI::App& app);
void add_report(CLI::App& app);
void add_view(CLI::App& app);
void add_schema(CLI::App& app);

}  // namespace sweepkit::tools
