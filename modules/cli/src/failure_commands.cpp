// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <memory>

#include "commands.hpp"
#include "failure_rows.hpp"

namespace brash::cli {
namespace {

void add_predict_command(CLI::App& failure) {
  struct Options {
    PredictOptions rows;
    EdgePredictOptions edges;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = failure.add_subcommand("predict", "Predict stress and breaking length for rows of inputs");
  CLI::Option* const model = command->add_option(
      "--model", options->rows.model,
      "model file; network, deep-network or superposition: the one that comes with the program; fem: solve "
      "the plate; with --case a model of a moving edge [the one that comes with the program], or fem");
  command->add_option(
      "--in", options->rows.rows,
      "CSV with b_lc,c_lc,theta_deg,mu1,mu2[,lc_over_h], a bay with b_lc below 0; standard input if left out");
  CLI::Option* const speeds =
      command->add_option("--speed", options->edges.speeds, "speeds in m/s, such as 0.2,1.2; 0: the static plate")
          ->delimiter(',')
          ->check(CLI::Range(0.0, 100.0));
  CLI::Option* const of_case =
      command
          ->add_option(
              "--case", options->edges.case_file,
              "case file (TOML): follow the moving edge of each row until the structure breaks it, at each --speed")
          ->needs(speeds);
  speeds->needs(of_case);
  command->add_option("--set", options->edges.overrides, "section.key=value of the case")
      ->needs(of_case)
      ->take_all()
      ->allow_extra_args(false);
  command->footer("Example: brash failure predict --model cone_network.json --in rows.csv");
  command->callback([options, model, of_case] {
    if (of_case->count() > 0) {
      options->edges.model = options->rows.model;
      options->edges.rows = options->rows.rows;
      return predict_moving_edges(options->edges);
    }
    if (model->count() == 0) throw CLI::RequiredError("--model");
    predict_rows(options->rows);
  });
}

}  // namespace

void add_failure_command(CLI::App& app) {
  CLI::App* failure = app.add_subcommand("failure", "Failure of the ice edge: database, training, prediction");
  failure->require_subcommand(1);
  failure->footer("Example: brash failure predict --model fem --in rows.csv");
  add_database_command(*failure);
  add_train_command(*failure);
  add_predict_command(*failure);
}

}  // namespace brash::cli
