// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace brash::cli {

/// Adds `brash failure database`.
void add_database_command(CLI::App& failure);

}  // namespace brash::cli
