// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <string>

#include "brash/core/text.hpp"

namespace brash::python {

/// Says on stderr that a reader of files left content out, as the command does. It needs no GIL.
inline void say_note(const std::string& note) {
  static_cast<void>(std::fputs(escaped_lines("note: " + note + "\n").c_str(), stderr));
  std::fflush(stderr);
}

}  // namespace brash::python
