// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace brash::cli {

/// As in commands.hpp.
void add_new_command(CLI::App& app);

}  // namespace brash::cli
