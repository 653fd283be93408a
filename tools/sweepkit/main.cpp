// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Exit status: 0 done; 1 failed (disk, memory, an internal fault); 2 bad usage or bad input, refused before
// any work; 3 check --strict has findings; 128 + n ended by signal n, which is 130 for Ctrl-C. An error is
// one line on standard error.

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <utility>

#include "commands.hpp"
#include "findings.hpp"
#include "interrupt.hpp"
#include "memory.hpp"
#include "output.hpp"
#include "sweepkit/error.hpp"

namespace {

constexpr int kFailed = 1;
constexpr int kBadInput = 2;
constexpr int kFindings = 3;

int fail(int status, std::string message) {
  sweepkit::tools::complain(std::move(message));
  return status;
}

// CLI11's own words, with what to do.
std::string usage_problem(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  if (!chosen.empty())
    return std::string(error.what()) + "; see sweepkit " + chosen.front()->get_name() + " --help";
  std::string names;
  for (const CLI::App* command : app.get_subcommands({}))
    names += (names.empty() ? "" : ", ") + command->get_name();
  const std::vector<std::string> extras = app.remaining();
  const std::string got = extras.empty() ? "" : ", got \"" + extras.front() + "\"";
  return "needs a command (" + names + ")" + got + "; see sweepkit --help";
}

int run(int argc, char** argv) {
  CLI::App app("Sweep curves into textured objects: glTF files, and ray-traced pictures of them.");
  app.name("sweepkit");
  app.set_version_flag("--version", "sweepkit " SWEEPKIT_VERSION);
  app.require_subcommand(1);
  app.footer(
      "Example:\n  sweepkit render samples/scenes/vase_and_cup.json -o vase_and_cup.png\n\n"
      "sweepkit COMMAND --help tells more. Messages go to standard error. Exit status: 0 done; 1 failed;\n"
      "2 bad usage or bad input; 3 findings of check --strict; 130 interrupted.");
  sweepkit::tools::add_generate(app);
  sweepkit::tools::add_render(app);
  sweepkit::tools::add_assemble(app);
  sweepkit::tools::add_bake(app);
  sweepkit::tools::add_info(app);
  sweepkit::tools::add_check(app);
  sweepkit::tools::add_report(app);
  sweepkit::tools::add_view(app);
  sweepkit::tools::add_schema(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    app.exit(success);  // --help, --version
  } catch (const sweepkit::tools::FoundFaults&) {
    return std::fflush(stdout) == 0 ? kFindings : kFailed;
  } catch (const CLI::ParseError& error) {
    return fail(kBadInput, usage_problem(app, error));
  }
  if (std::fflush(stdout) != 0) {
    return fail(kFailed, std::string("standard output: cannot be written: ") + std::strerror(errno));
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  sweepkit::tools::handle_interrupts();
  sweepkit::tools::limit_memory();
  try {
    return run(argc, argv);
  } catch (const sweepkit::InputError& error) {
    return fail(kBadInput, error.what());
  } catch (const sweepkit::OutputError& error) {
    return fail(kFailed, error.what());
  } catch (const std::bad_alloc&) {
    return fail(kFailed, "out of memory; ask for fewer cells or a smaller picture");
  } catch (const std::exception& error) {
    return fail(kFailed, std::string("internal fault: ") + error.what());
  }
}
