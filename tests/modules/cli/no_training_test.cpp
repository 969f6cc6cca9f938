// SPDX-License-Identifier: GPL-3.0-or-later
// The commands that make failure models, in a program that was built without them.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

#include "brash/core/error.hpp"
#include "commands.hpp"

namespace brash::cli {
namespace {

BOOST_AUTO_TEST_CASE(a_command_that_is_not_built_says_so_whatever_its_arguments_are) {
  const std::vector<std::vector<std::string>> commands{
      {"database", "plan.toml", "-o", "cone.nc", "--jobs", "2"},
      {"train", "cone.nc", "-o", "cone.json", "--superposition"},
      {"train"},
      {"train", "--help"},
  };
  for (std::vector<std::string> arguments : commands) {
    CLI::App failure;
    add_database_command(failure);
    add_train_command(failure);
    const std::string name = "brash failure " + arguments.front();
    std::reverse(arguments.begin(), arguments.end());
    BOOST_CHECK_EXCEPTION(failure.parse(arguments), InputError, [&](const InputError& error) {
      const std::string message = error.what();
      return message.starts_with(name + ": is not in this program") &&
             message.find("-DBRASH_TRAINING=ON") != std::string::npos;
    });
  }
}

}  // namespace
}  // namespace brash::cli
