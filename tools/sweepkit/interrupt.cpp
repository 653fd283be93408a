// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "interrupt.hpp"

#include <unistd.h>

#include <csignal>

#include "sweepkit/scene/output_file.hpp"

namespace sweepkit::tools {
namespace {

extern "C" void on_interrupt(int signal) {
  scene::abandon_writes();
  _exit(128 + signal);
}

}  // namespace

void handle_interrupts() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
    struct sigaction before {};
    if (sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_IGN) continue;
    struct sigaction action {};
    action.sa_handler = on_interrupt;
    sigfillset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
  }
  // Then a file that may not grow any more is a failed write like that on a full disk, told and cleaned up.
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace sweepkit::tools
