// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace brash::campaign {

/// The output of a command, and its exit code (128 + the signal that ended it).
struct Printed {
  int code = 0;
  std::string out;
  std::string err;
};

/// Runs a command that is found on the path, without a shell, and takes its output.
/// @throws RunError when it cannot be started.
Printed run_command(const std::vector<std::string>& command);

}  // namespace brash::campaign
