// SPDX-License-Identifier: GPL-3.0-or-later
#include "usage_error.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <vector>

#include "brash/core/text.hpp"

namespace brash::cli {
namespace {

/// The command that was read last: `brash export vtk`.
struct Command {
  const CLI::App* app;
  std::string name;
};

Command last_command(const CLI::App* app) {
  Command command{app, app->get_name()};
  while (!command.app->get_subcommands().empty()) {
    command.app = command.app->get_subcommands().back();
    command.name += " " + command.app->get_name();
  }
  return command;
}

std::vector<std::string> subcommands_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

std::vector<std::string> options_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/// "write it as in `brash check cone.toml`": the example in the command's help.
std::string example_of(const Command& command) {
  constexpr std::string_view kMark = "Example: ";
  const std::string footer = command.app->get_footer();
  const std::size_t at = footer.find(kMark);
  if (at == std::string::npos) return fmt::format("`{} --help` explains it", command.name);
  return fmt::format("write it as in `{}`", footer.substr(at + kMark.size()));
}

std::string message(const Command& command, const std::string& what, const std::string& nearest,
                    const std::string& remedy) {
  std::string text = fmt::format("{}: {}\n", command.name, what);
  if (!nearest.empty()) text += fmt::format("  nearest: {}\n", nearest);
  return text + fmt::format("  remedy:  {}\n", remedy);
}

/// The first of the words that the command does not know: an option is likelier the fault than its value.
std::string first_unknown(const std::vector<std::string>& words) {
  const auto option = std::ranges::find_if(words, [](const std::string& word) { return word.starts_with('-'); });
  return option == words.end() ? words.front() : *option;
}

/// The option that begins with `word`, else the one with the most similar name; "" when there is none.
std::string nearest_option(const std::string& word, const std::vector<std::string>& options) {
  const auto longer = std::ranges::find_if(options, [&](const std::string& name) { return name.starts_with(word); });
  return longer != options.end() && word.size() > 3 ? *longer : nearest_name(word, options);
}

}  // namespace

std::string usage_error(const CLI::App* app, const CLI::Error& error) {
  const Command command = last_command(app);
  const std::vector<std::string> unknown = app->remaining(/*recurse=*/true);
  const bool has_unknown = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError) && !unknown.empty();
  if (!has_unknown) return message(command, error.what(), "", example_of(command));

  const std::string word = first_unknown(unknown);
  const std::string shown = printable(word);
  const std::vector<std::string> options = options_of(*command.app);
  const bool takes_keys = std::ranges::find(options, "--set") != options.end();
  if (word.starts_with('-')) {
    // Only `run` has a short form of it.
    if (word.starts_with("--seed") && takes_keys)
      return message(command, fmt::format("{} is not an option", shown), "--set", "write --set random.seed=N");
    const std::string nearest = nearest_option(word.substr(0, word.find('=')), options);
    return message(command, fmt::format("{} is not an option", shown), nearest,
                   nearest.empty() ? fmt::format("`{} --help` lists the options", command.name)
                                   : fmt::format("write {}", nearest));
  }
  const std::vector<std::string> commands = subcommands_of(*command.app);
  if (commands.empty() && takes_keys && word.find('=') != std::string::npos)
    return message(command, fmt::format("{} is one argument too many", shown), "--set",
                   fmt::format("write --set {}, since each key has a --set of its own", shown));
  if (commands.empty())
    return message(command, fmt::format("{} is one argument too many", shown), "",
                   example_of(command) + ", and a value that holds blanks between quotes");
  const std::string nearest = nearest_name(word, commands);
  return message(command, fmt::format("{} is not a command", shown), nearest,
                 nearest.empty() ? fmt::format("`{} --help` lists the commands", command.name)
                                 : fmt::format("write `{} {}`", command.name, nearest));
}

}  // namespace brash::cli
