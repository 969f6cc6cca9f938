// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace CLI {
class App;
class Error;
}  // namespace CLI

namespace brash::cli {

/// The message about a command line that `app` cannot read: the command, the fault, the nearest name, the remedy.
std::string usage_error(const CLI::App* app, const CLI::Error& error);

}  // namespace brash::cli
