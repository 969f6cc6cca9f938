// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace brash::cli {

/// Adds `openfast` to the command `export`.
void add_openfast_command(CLI::App& command);

}  // namespace brash::cli
