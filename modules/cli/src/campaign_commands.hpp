// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace brash::cli {

/// Adds `brash campaign`, and `brash campaign-case`, which a campaign starts for each of its cases.
void add_campaign_commands(CLI::App& app);

}  // namespace brash::cli
