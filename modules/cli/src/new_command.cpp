// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "brash/core/error.hpp"
#include "brash/core/write_file.hpp"
#include "brash/io/new_case.hpp"
#include "brash/simulator/builder.hpp"
#include "commands.hpp"
#include "messages.hpp"

namespace brash::cli {
namespace {

struct Options {
  std::string file, kind = "cone", ice = "basin", page;
};

void expect_new(const std::string& file) {
  if (std::filesystem::exists(std::filesystem::symlink_status(file)))
    throw InputError(Complaint{file, "is there already", "a file that is not there yet", "name another, or remove it"});
}

/// The case builder as a page; whoever opens it needs no program.
void write_page(const std::string& file) {
  if (simulator::kBuilder.empty())
    throw RunError(
        "no case builder: this program was built without its page\n"
        "  remedy:  install Node.js and npm (Debian: nodejs, npm), configure and build again");
  expect_new(file);
  write_file(file, std::string(simulator::kBuilder));
  print("the case builder is in {}: open it in a browser\n", file);
}

void write_case(const Options& options) {
  const std::string text = io::new_case(options.kind, options.ice);
  if (options.file.empty()) return print_data(text);
  expect_new(options.file);
  write_file(options.file, text);
  print("a new case is in {}; `brash check` reads it, and `brash run` runs it\n", options.file);
}

}  // namespace

void add_new_command(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("new", "Write a new case file, or the page of the case builder");
  CLI::Option* file =
      command->add_option("-o,--output", options->file, "case file to write (TOML) [the standard output]");
  CLI::Option* kind = command->add_option("--kind", options->kind, "kind of structure, as structure.kind [cone]");
  CLI::Option* ice = command->add_option(
      "--ice", options->ice, fmt::format("ice with sourced values: {} [basin]", fmt::join(io::site_ice(), ", ")));
  command->add_option("--page", options->page, "write a page with a form for every key into this file (HTML)")
      ->excludes(file)
      ->excludes(kind)
      ->excludes(ice);
  command->footer("Example: brash new -o mine.toml --kind wedge-bow --ice baltic");
  command->callback([options] { options->page.empty() ? write_case(*options) : write_page(options->page); });
}

}  // namespace brash::cli
