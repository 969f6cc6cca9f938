// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "commands.hpp"
#include "messages.hpp"

namespace brash::cli {
namespace {

/// One arm of the shell's `case` for each command: the words that may follow it.
void add_arms(const CLI::App& app, const std::string& path, std::string& arms, std::string& paths) {
  std::vector<std::string> words;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_group().empty()) continue;  // not shown
    words.push_back(command->get_name());
    const std::string below = path.empty() ? command->get_name() : path + ' ' + command->get_name();
    paths += fmt::format("{}\"{}\"", paths.empty() ? "" : "|", below);
    add_arms(*command, below, arms, paths);
  }
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;
    for (const std::string& name : option->get_snames()) words.push_back('-' + name);
    for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
  }
  arms += fmt::format("    '{}') words='{}' ;;\n", path, fmt::join(words, " "));
}

/// Commands and options are completed from the program's own; everything else as files.
std::string bash_completion(const CLI::App& app) {
  std::string arms, paths;
  add_arms(app, "", arms, paths);
  return fmt::format(R"(# Completion of `brash` for bash.
_brash() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} path='' word below words=''
  for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
    below=${{path:+$path }}$word
    case $below in
      {}) path=$below ;;
    esac
  done
  case $path in
{}  esac
  COMPREPLY=()
  # The name of a command, or an option once a dash is there.
  if [[ $current == -* || -z $path || $words != -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
  fi
}}
complete -o default -F _brash brash
)",
                     paths, arms);
}

}  // namespace

void add_completion_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("completion", "Print the completion of commands and options for bash");
  command->footer("Example: source <(brash completion)");
  command->callback([&app] { print("{}", bash_completion(app)); });
}

}  // namespace brash::cli
