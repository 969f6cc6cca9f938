// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace brash::cli {

/// Adds `failure database | train | predict` to `app`.
void add_failure_command(CLI::App& app);

/// Refuses a file to write whose folder is missing.
void refuse_missing_folder(const std::string& path);

}  // namespace brash::cli
