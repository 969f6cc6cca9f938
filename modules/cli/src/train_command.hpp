// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace brash::cli {

/// Adds `brash failure train`.
void add_train_command(CLI::App& failure);

}  // namespace brash::cli
