// SPDX-License-Identifier: GPL-3.0-or-later
#include "messages.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

#include "brash/core/text.hpp"

namespace brash::cli {

void show(const std::string& text) noexcept {
  static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
  std::fflush(stderr);
}

void say_text(const std::string& text) { show(escaped_lines(text)); }

void say_note(const std::string& note) { say("note: {}\n", note); }

void say_warnings(const std::vector<model::Warning>& warnings) {
  for (const model::Warning& warning : warnings) say("warning: {}: {}\n", warning.id, warning.text);
}

void print_text(const std::string& text) { fmt::print("{}", escaped_lines(text)); }

void print_data(const std::string& text) { fmt::print("{}", escaped_as_unicode(text)); }

void secure_streams() {
  // Each stream gets its own number: they are opened in order. Printing on a closed stdout is an error.
  for (const auto& [stream, mode] :
       {std::pair{STDIN_FILENO, O_RDONLY}, std::pair{STDOUT_FILENO, O_RDONLY}, std::pair{STDERR_FILENO, O_WRONLY}})
    if (::fcntl(stream, F_GETFD) < 0) static_cast<void>(::open("/dev/null", mode));
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
}

}  // namespace brash::cli
