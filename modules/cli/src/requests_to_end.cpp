// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>
#include <initializer_list>

#include "progress.hpp"

namespace brash::cli {
namespace {

volatile std::sig_atomic_t asked = 0;
void note(int) { asked = 1; }

}  // namespace

void catch_requests_to_end() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (std::signal(signal, note) == SIG_IGN) std::signal(signal, SIG_IGN);
}

bool is_asked_to_end() { return asked != 0; }

}  // namespace brash::cli
