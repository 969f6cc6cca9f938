// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "brash/model/warning.hpp"

namespace brash::cli {

/// Writes `text` to stderr as it is. Never fails: a reader that has gone and a disk that is full change no exit code.
void show(const std::string& text) noexcept;

/// Says something on stderr, as show() does; characters that control a terminal are escaped.
void say_text(const std::string& text);
template <typename... Values>
void say(fmt::format_string<Values...> format, Values&&... values) {
  say_text(fmt::format(format, std::forward<Values>(values)...));
}

/// Says a note of a reader of files on stderr.
void say_note(const std::string& note);

/// Says each warning on stderr, as `warning: id: text`.
void say_warnings(const std::vector<model::Warning>& warnings);

/// Prints a result for people on stdout; characters that control a terminal are escaped.
/// @throws std::system_error when it cannot be written, here and below.
void print_text(const std::string& text);
template <typename... Values>
void print(fmt::format_string<Values...> format, Values&&... values) {
  print_text(fmt::format(format, std::forward<Values>(values)...));
}

/// Prints JSON or TOML on stdout; characters that control a terminal are written \uXXXX, which reads back to the same
/// text.
void print_data(const std::string& text);

/// Makes closed standard streams safe and signals of a full disk or a closed pipe errors: no file that is opened later
/// gets the number of a stream, and no signal ends the program.
void secure_streams();

}  // namespace brash::cli
