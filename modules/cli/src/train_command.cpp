// SPDX-License-Identifier: GPL-3.0-or-later
#include "train_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <set>

#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/sha256.hpp"
#include "brash/database/database.hpp"
#include "brash/database/edge_database.hpp"
#include "brash/failure/criterion.hpp"
#include "brash/failure/hump_sample.hpp"
#include "brash/io/file_names.hpp"
#include "brash/meta_model/training.hpp"
#include "card_files.hpp"
#include "edge_card.hpp"
#include "failure_rows.hpp"
#include "messages.hpp"
#include "profile_card.hpp"

namespace brash::cli {
namespace {

namespace fs = std::filesystem;

/// The result of `work`; its errors name the file `path`.
template <typename Work>
auto of_file(const std::string& path, Work work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
}

/// The rows of the solved geometries; all must have the same h / l_c.
std::vector<meta_model::Sample> to_samples(const std::string& file, const database::Database& data,
                                           double& thickness_over_lc) {
  std::vector<meta_model::Sample> samples;
  for (const database::Record& record : data.records) {
    if (!record.solved) continue;
    if (samples.empty()) thickness_over_lc = record.plate.thickness;
    if (record.plate.thickness != thickness_over_lc) {
      throw InputError(Complaint{fmt::format("{}, geometry {}", file, record.geometry),
                                 fmt::format("has h/l_c = {}, others {}", record.plate.thickness, thickness_over_lc),
                                 "one h/l_c, which the five inputs of Eq. 17 leave out",
                                 "give the plan one value of thickness_over_lc, or train with --superposition"});
    }
    for (const database::Row& row : record.rows) {
      samples.push_back(
          {.input = {record.plate.depth, record.plate.contact_length, record.plate.angle, row.load.mu1, row.load.mu2},
           .output = {row.response.sigma_over_p, row.response.lbreak_over_lc},
           .plateau_from = row.response.plateau_from,
           .plateau_to = row.response.plateau_to,
           .geometry = record.geometry});
    }
  }
  return samples;
}

void print_errors(const char* name, const meta_model::Errors& e) {
  print("{:<11} {:>6} {:>6} {:>10.2f} {:>10.2f} {:>10.2f} {:>12.4f} {:>12.4f} {:>11.1f}\n", name, e.n_geometries,
        e.n_rows, 100 * e.stress_rms, 100 * e.stress_median, 100 * e.stress_95, e.length_median, e.length_95,
        100 * e.length_on_plateau);
}

/// Refuses a model that has no folder, that has the name of its card, or by which an input or a result would be lost.
void check_output(const std::string& output, std::initializer_list<std::string> inputs) {
  io::refuse_missing_folder(output);
  for (const std::string& file : {output, card_file(output), errors_file(output)}) {
    refuse_overwriting(file, inputs);
    io::refuse_replacing_results(file);
  }
  if (card_file(output) == output)
    throw InputError(Complaint{output, "is the name of the model's card, which is written beside it",
                               "a name that does not end in .md", "give the model another name, such as model.json"});
}

void train_network(const std::string& database_file, const std::string& output, meta_model::TrainingOptions options,
                   const std::string& command) {
  const database::Database data = database::read_database(database_file);
  const auto samples = to_samples(database_file, data, options.thickness_over_lc);
  options.data_sha256 = sha256_of_file(database_file);
  const meta_model::Trained trained = of_file(database_file, [&] { return meta_model::train(samples, options); });
  const std::string hash = trained.network.write(output);

  const std::string card =
      write_card(output, {.text = meta_model::model_card(trained.network, trained.report, options,
                                                         {.model_file = file_name(output),
                                                          .content_sha256 = hash,
                                                          .database_file = file_name(database_file),
                                                          .errors_file = file_name(errors_file(output)),
                                                          .command = command}),
                          .errors = meta_model::error_table(trained.report)});

  print("{:<11} {:>6} {:>6} {:>10} {:>10} {:>10} {:>12} {:>12} {:>11}\n", "part", "geom.", "rows", "stress rms",
        "median [%]", "95 % [%]", "length med.", "95 % [l_c]", "plateau [%]");
  print_errors("training", trained.report.train);
  print_errors("validation", trained.report.validation);
  print_errors("test", trained.report.test);
  print("model       {}\nsha256      {}\ncard        {}\n", output, hash, card);
}

std::vector<meta_model::ProfileSample> to_profile_samples(const std::vector<const database::Record*>& records) {
  std::vector<meta_model::ProfileSample> samples;
  for (const database::Record* record : records) samples.push_back(to_profile_sample(*record));
  return samples;
}

std::vector<const database::Record*> solved_records(const database::Database& data) {
  std::vector<const database::Record*> records;
  for (const database::Record& record : data.records) {
    if (record.solved) records.push_back(&record);
  }
  return records;
}

/// Refuses a test database that would evaluate a model on plates that it has learned.
void refuse_learned(const std::string& file, const database::Database& test,
                    const std::vector<plate::WedgePlate>& learned) {
  using Point = std::array<double, 4>;
  const auto point = [](const plate::WedgePlate& p) -> Point {
    return {p.depth, p.contact_length, p.angle, p.thickness};
  };
  std::set<Point> points;
  for (const plate::WedgePlate& plate : learned) points.insert(point(plate));
  const auto n = std::ranges::count_if(test.records, [&](const auto& r) { return points.contains(point(r.plate)); });
  if (n == 0) return;
  throw InputError(Complaint{
      file, fmt::format("{} of its {} geometries are among the plates that the model learns", n, test.records.size()),
      "geometries that the model has not seen",
      "solve a plan for the test whose `first` lies behind the points of the other plan"});
}

/// Evaluates `model` on the test database; without one, evaluates a fit without every eleventh geometry on these
/// geometries instead.
std::pair<std::vector<JudgedRow>, std::string> judge_profiles(const meta_model::ProfileModel& model,
                                                              const std::vector<const database::Record*>& records,
                                                              const std::string& database_file,
                                                              const database::Database& test,
                                                              const std::string& test_file) {
  if (!test_file.empty()) {
    std::vector<plate::WedgePlate> learned;
    learned.reserve(records.size());
    for (const database::Record* record : records) learned.push_back(record->plate);
    refuse_learned(test_file, test, learned);
    return {judge(answers_of(model), solved_records(test)),
            fmt::format("geometries that it has not seen (`{}`)", file_name(test_file))};
  }
  constexpr int kTestEvery = 11;  // odd: an even share of a Sobol sequence lies in one half of the box
  std::vector<const database::Record*> kept, left_out;
  for (const database::Record* record : records) {
    (record->geometry % kTestEvery == kTestEvery - 1 ? left_out : kept).push_back(record);
  }
  const auto judged = of_file(database_file + ", without the geometries of the test",
                              [&] { return meta_model::ProfileModel::fit(to_profile_samples(kept), ""); });
  return {judge(answers_of(judged), left_out),
          "every eleventh geometry, left out of a fit for this purpose; the model holds them all"};
}

void fit_profiles(const std::string& database_file, const std::string& test_file, const std::string& output,
                  const std::string& command) {
  const database::Database data = database::read_database(database_file);
  const database::Database test = test_file.empty() ? database::Database{} : database::read_database(test_file);
  const auto records = solved_records(data);
  const std::string hash = sha256_of_file(database_file);
  const auto model =
      of_file(database_file, [&] { return meta_model::ProfileModel::fit(to_profile_samples(records), hash); });
  const auto [rows, name] = judge_profiles(model, records, database_file, test, test_file);
  const std::string content = model.write(output);
  const std::string card = write_card(output, profile_card(model, rows,
                                                           {.model_file = file_name(output),
                                                            .content_sha256 = content,
                                                            .database_file = file_name(database_file),
                                                            .data_sha256 = hash,
                                                            .test = name,
                                                            .errors_file = file_name(errors_file(output)),
                                                            .command = command,
                                                            .n_learned = records.size()}));
  print("{}modes       {}\nmodel       {}\nsha256      {}\ncard        {}\n", summary(rows), model.n_modes(), output,
        content, card);
}

/// The points of `plan`, answered by `teacher`.
std::vector<meta_model::HumpSample> hump_samples(const database::Plan& plan, const meta_model::ProfileModel& teacher) {
  std::vector<meta_model::HumpSample> samples;
  for (const database::DesignPoint& point : database::design(plan)) {
    for (const database::LoadPoint& load : point.loads) {
      samples.push_back(failure::hump_sample(
          teacher, {point.plate.depth, point.plate.contact_length, point.plate.angle, load.mu1, load.mu2},
          point.plate.thickness));
    }
  }
  return samples;
}

/// Refuses plates that the superposition does not know.
void check_taught(const database::Plan& plan, const std::string& plan_file) {
  constexpr double kPoissonRatio = 0.3;  // of its database
  const auto refuse = [&](const std::string& what, const char* allowed) {
    throw InputError(Complaint{plan_file, what, allowed, "change the plan, or train with --superposition"});
  };
  if (plan.thickness_over_lc.from != plan.thickness_over_lc.to)
    refuse("thickness_over_lc has a range: the five inputs of Eq. 17 leave h/l_c out", "one value");
  if (plan.split) refuse("split = true: the superposition that teaches is of whole sheets", "false");
  if (plan.poisson_ratio != kPoissonRatio || plan.theory != plate::Theory::kReissnerMindlin)
    refuse("[plate] differs from the superposition that teaches", "poisson_ratio = 0.3, theory = \"reissner-mindlin\"");
}

void train_deep_network(const std::string& plan_file, const std::string& test_file, const std::string& output,
                        meta_model::HumpTrainingOptions options, const std::string& command) {
  if (test_file.empty()) throw InputError("--deep needs --test: plate solutions that test the network");
  const database::Plan plan = database::read_plan(plan_file);
  check_taught(plan, plan_file);
  const database::Database test = database::read_database(test_file);
  const std::string teacher = failure::model_path(model::FailureModel::kSuperposition, "");
  const auto superposition = meta_model::ProfileModel::read(teacher);
  if (superposition.data_sha256() == sha256_of_file(test_file)) {
    throw InputError(Complaint{test_file, fmt::format("is the database of {}, which teaches the network", teacher),
                               "geometries that neither model has seen", "solve another plan for the test"});
  }
  std::vector<plate::WedgePlate> learned;
  for (const database::DesignPoint& point : database::design(plan)) learned.push_back(point.plate);
  refuse_learned(test_file, test, learned);
  options.thickness_over_lc = plan.thickness_over_lc.from;
  options.data_sha256 = sha256_of_file(teacher);
  const auto samples = hump_samples(plan, superposition);
  const meta_model::TrainedHumps trained = meta_model::train_humps(samples, options);
  const std::string content = trained.network.write(output);
  const auto rows = judge(answers_of(trained.network), solved_records(test));
  const std::string card = write_card(
      output, hump_card(trained, rows,
                        {.model_file = file_name(output),
                         .content_sha256 = content,
                         .database_file = file_name(teacher),
                         .data_sha256 = options.data_sha256,
                         .test = fmt::format("plate solutions that it has not seen (`{}`)", file_name(test_file)),
                         .errors_file = file_name(errors_file(output)),
                         .command = command,
                         .n_learned = samples.size()}));
  for (const meta_model::LayeredFit& fit : trained.fits) {
    print("{:<38} {:>4} iterations ({}), loss {:.4g} training, {:.4g} validation\n", fit.name, fit.iterations,
          fit.ended, fit.training_loss, fit.validation_loss);
  }
  print("{}model       {}\nsha256      {}\ncard        {}\n", summary(rows), output, content, card);
}

/// The products of `failure train`, each a bit.
enum Kind : unsigned { kNetwork = 1, kSuperposition = 2, kDeep = 4, kMovingEdge = 8 };

constexpr std::array<std::pair<Kind, const char*>, 4> kKinds{{{kNetwork, "the network"},
                                                              {kSuperposition, "a superposition (--superposition)"},
                                                              {kDeep, "a deep network (--deep)"},
                                                              {kMovingEdge, "the model of a moving edge"}}};

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
    std::string database, output, test;
    meta_model::TrainingOptions training;
    std::string split, test_split;  // of a moving edge
    bool superposition = false, deep = false;
  };
  auto options = std::make_shared<Options>();
  meta_model::TrainingOptions& training = options->training;
  CLI::App* command = failure.add_subcommand("train", "Train a failure model");
  command->add_option("database", options->database, "database (netCDF); with --deep a plan (TOML)")->required();
  command->add_option("-o,--output", options->output, "model to write (JSON); card and errors are written beside it")
      ->required();
  auto* const superposition = command->add_flag("--superposition", options->superposition,
                                                "interpolate the unit profiles instead of training the network");
  command
      ->add_flag("--deep", options->deep,
                 "train the deep network on the points of a plan, answered by the superposition")
      ->excludes(superposition);
  command->add_option("--test", options->test,
                      "database (netCDF) that tests a superposition, without it every eleventh geometry does, or a "
                      "deep network");
  auto* const split =
      command->add_option("--split", options->split, "database (netCDF) of the split sheets, for a moving edge");
  command->add_option("--test-split", options->test_split, "database (netCDF) that tests them")->needs(split);
  command->add_option("--hidden", training.hidden, "hidden units of a network; of each hidden layer with --deep [12]")
      ->capture_default_str()
      ->check(CLI::Range(1, 200));
  command->add_flag("!--one-network", training.separate, "one network for both outputs instead of one for each");
  command->add_option("--starts", training.starts, "random starts")->capture_default_str()->check(CLI::Range(1, 1000));
  command
      ->add_option("--iterations", training.max_iterations,
                   "most iterations of a start; of a network with --deep [120]")
      ->capture_default_str()
      ->check(CLI::Range(1, 100000));
  command->add_option("--seed", training.seed, "of split and starts")->capture_default_str();
  command->footer("Example: brash failure train cone.nc -o cone_network.json");
  command->callback([options, command] {
    check_output(options->output, {options->database, options->test, options->split, options->test_split});
    const Kind kind = options->deep                                   ? kDeep
                      : database::is_edge_database(options->database) ? kMovingEdge
                      : options->superposition                        ? kSuperposition
                                                                      : kNetwork;
    refuse_unheeded(*command, kind);
    if (kind == kDeep) {
      meta_model::HumpTrainingOptions deep;
      if (command->count("--hidden") > 0) deep.hidden.assign(2, options->training.hidden);
      if (command->count("--iterations") > 0) deep.max_iterations = options->training.max_iterations;
      deep.seed = options->training.seed;
      train_deep_network(options->database, options->test, options->output, deep, command_line(*command));
    } else if (kind == kMovingEdge) {
      fit_edges({.database = options->database,
                 .split = options->split,
                 .test = options->test,
                 .test_split = options->test_split,
                 .output = options->output,
                 .command = command_line(*command)});
    } else if (kind == kSuperposition) {
      fit_profiles(options->database, options->test, options->output, command_line(*command));
    } else {
      train_network(options->database, options->output, options->training, command_line(*command));
    }
  });
}

}  // namespace brash::cli
