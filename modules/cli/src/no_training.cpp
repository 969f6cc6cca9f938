// SPDX-License-Identifier: GPL-3.0-or-later
// In place of database_command.cpp and train_command.cpp, if this program was built without BRASH_TRAINING.
#include <CLI/CLI.hpp>
#include <string>

#include "brash/core/error.hpp"
#include "commands.hpp"

namespace brash::cli {
namespace {

/// A command that takes any arguments and says that it is not here.
void add_absent(CLI::App& failure, const std::string& name) {
  CLI::App* const command = failure.add_subcommand(name, "Not in this program: it was built without BRASH_TRAINING");
  command->prefix_command();
  command->set_help_flag();
  command->callback([name] {
    throw InputError(Complaint{"brash failure " + name, "is not in this program, which was built to run cases alone",
                               "a program that makes failure models: one of the packages, or built with its tests",
                               "configure the build with -DBRASH_TRAINING=ON, and build it again"});
  });
}

}  // namespace

void add_database_command(CLI::App& failure) { add_absent(failure, "database"); }
void add_train_command(CLI::App& failure) { add_absent(failure, "train"); }

}  // namespace brash::cli
