// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace brash::cli {

/// Adds `failure database | train | predict` to `app`.
void add_failure_command(CLI::App& app);

}  // namespace brash::cli
