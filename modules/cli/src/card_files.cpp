// SPDX-License-Identifier: GPL-3.0-or-later
#include "card_files.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>

#include "brash/core/write_file.hpp"

namespace brash::cli {

namespace fs = std::filesystem;

std::string file_name(const std::string& path) { return fs::path(path).filename().string(); }

std::string card_file(const std::string& model) { return fs::path(model).replace_extension(".md").string(); }

std::string errors_file(const std::string& model) {
  return fs::path(model).replace_extension("").string() + "_errors.csv";
}

std::string write_card(const std::string& model, const ModelCard& card) {
  if (!card.errors.empty()) write_file(errors_file(model), card.errors);
  write_file(card_file(model), card.text);
  return card_file(model);
}

std::string command_line(const CLI::App& command) {
  std::string positional, named;
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0) continue;
    std::string values;
    if (option->get_expected_max() > 0)  // no flag
      for (const std::string& value : option->results()) values += " " + file_name(value);
    if (option->get_positional())
      positional += values;
    else
      named += " " + option->get_name() + values;
  }
  return "brash failure " + command.get_name() + positional + named;
}

}  // namespace brash::cli
