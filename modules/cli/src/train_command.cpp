// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <initializer_list>
#include <memory>

#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/io/file_names.hpp"
#include "brash/training/edge_database.hpp"
#include "brash/training/make_model.hpp"
#include "commands.hpp"
#include "messages.hpp"

namespace brash::cli {
namespace {

namespace fs = std::filesystem;

/// Refuses a model that has no folder, that has the name of its card, or by which an input or a result would be lost.
void check_output(const std::string& output, std::initializer_list<std::string> inputs) {
  io::refuse_missing_folder(output);
  for (const std::string& file : {output, training::card_file(output), training::errors_file(output)}) {
    refuse_overwriting(file, inputs);
    io::refuse_replacing_results(file);
  }
  if (training::card_file(output) == output)
    throw InputError(Complaint{output, "is the name of the model's card, which is written beside it",
                               "a name that does not end in .md", "give the model another name, such as model.json"});
}

/// The command `brash failure train ...` as the user gave it, without the folders of its files.
std::string command_line(const CLI::App& command) {
  std::string positional, named;
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0) continue;
    std::string values;
    if (option->get_expected_max() > 0)  // no flag
      for (const std::string& value : option->results()) values += " " + fs::path(value).filename().string();
    if (option->get_positional())
      positional += values;
    else
      named += " " + option->get_name() + values;
  }
  return "brash failure " + command.get_name() + positional + named;
}

/// The products of `failure train`, each a bit.
enum Kind : unsigned { kNetwork = 1, kSuperposition = 2, kDeep = 4, kMovingEdge = 8 };

constexpr std::array<std::pair<Kind, const char*>, 4> kKinds{{{kNetwork, "the network"},
                                                              {kSuperposition, "a superposition (--superposition)"},
                                                              {kDeep, "a deep network (--deep)"},
                                                              {kMovingEdge, "the model of a moving edge"}}};

Kind kind_of(const std::string& data, bool superposition, bool deep) {
  return deep ? kDeep : training::is_edge_database(data) ? kMovingEdge : superposition ? kSuperposition : kNetwork;
}

/// The options that not every kind heeds, and the kinds that do.
constexpr std::array<std::pair<const char*, unsigned>, 9> kHeeded{{{"--superposition", kSuperposition},
                                                                   {"--test", kSuperposition | kDeep | kMovingEdge},
                                                                   {"--split", kMovingEdge},
                                                                   {"--test-split", kMovingEdge},
                                                                   {"--hidden", kNetwork | kDeep},
                                                                   {"--one-network", kNetwork},
                                                                   {"--starts", kNetwork},
                                                                   {"--iterations", kNetwork | kDeep},
                                                                   {"--seed", kNetwork | kDeep}}};

/// The names of the kinds in `kinds`, joined by `or`.
std::string names_of(unsigned kinds) {
  std::vector<std::string> names;
  for (const auto& [kind, name] : kKinds)
    if ((kinds & kind) != 0) names.emplace_back(name);
  return fmt::format("{}", fmt::join(names, " or "));
}

void refuse_unheeded(const CLI::App& command, Kind kind) {
  for (const auto& [option, kinds] : kHeeded) {
    if (command.count(option) == 0 || (kinds & kind) != 0) continue;
    throw InputError(Complaint{option, fmt::format("has no effect on {}", names_of(kind)),
                               fmt::format("{} with {}", option, names_of(kinds)), "leave the option out"});
  }
}

}  // namespace

void add_train_command(CLI::App& failure) {
  struct Options {
    training::ModelFiles files;
    training::TrainingOptions network;
    bool superposition = false, deep = false;
  };
  auto options = std::make_shared<Options>();
  training::ModelFiles& files = options->files;
  training::TrainingOptions& network = options->network;
  CLI::App* command = failure.add_subcommand("train", "Train a failure model");
  command->add_option("database", files.data, "database (netCDF); with --deep a plan (TOML)")->required();
  command->add_option("-o,--output", files.output, "model to write (JSON); card and errors are written beside it")
      ->required();
  auto* const superposition = command->add_flag("--superposition", options->superposition,
                                                "interpolate the unit profiles instead of training the network");
  command
      ->add_flag("--deep", options->deep,
                 "train the deep network on the points of a plan, answered by the superposition")
      ->excludes(superposition);
  command->add_option("--test", files.test,
                      "database (netCDF) that tests a superposition, without it every eleventh geometry does, or a "
                      "deep network");
  auto* const split =
      command->add_option("--split", files.split, "database (netCDF) of the split sheets, for a moving edge");
  command->add_option("--test-split", files.test_split, "database (netCDF) that tests them")->needs(split);
  command->add_option("--hidden", network.hidden, "hidden units of a network; of each hidden layer with --deep [12]")
      ->capture_default_str()
      ->check(CLI::Range(1, 200));
  command->add_flag("!--one-network", network.separate, "one network for both outputs instead of one for each");
  command->add_option("--starts", network.starts, "random starts")->capture_default_str()->check(CLI::Range(1, 1000));
  command
      ->add_option("--iterations", network.max_iterations, "most iterations of a start; of a network with --deep [120]")
      ->capture_default_str()
      ->check(CLI::Range(1, 100000));
  command->add_option("--seed", network.seed, "of split and starts")->capture_default_str();
  command->footer("Example: brash failure train cone.nc -o cone_network.json");
  command->callback([options, command, &files] {
    check_output(files.output, {files.data, files.test, files.split, files.test_split});
    const Kind kind = kind_of(files.data, options->superposition, options->deep);
    refuse_unheeded(*command, kind);
    files.command = command_line(*command);
    training::HumpTrainingOptions deep;
    if (command->count("--hidden") > 0) deep.hidden.assign(2, options->network.hidden);
    if (command->count("--iterations") > 0) deep.max_iterations = options->network.max_iterations;
    deep.seed = options->network.seed;
    const training::MadeModel made = kind == kDeep            ? training::make_deep_network(files, deep)
                                     : kind == kMovingEdge    ? training::make_edge_model(files)
                                     : kind == kSuperposition ? training::make_superposition(files)
                                                              : training::make_network(files, options->network);
    print("{}model       {}\nsha256      {}\ncard        {}\n", made.report, files.output, made.content_sha256,
          made.card);
  });
}

}  // namespace brash::cli
