// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/training/make_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "brash/core/error.hpp"
#include "brash/core/sha256.hpp"
#include "brash/failure/criterion.hpp"
#include "brash/training/database.hpp"
#include "profile_card.hpp"

namespace brash::training {
namespace {

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
std::vector<Sample> to_samples(const std::string& file, const Database& data, double& thickness_over_lc) {
  std::vector<Sample> samples;
  for (const Record& record : data.records) {
    if (!record.solved) continue;
    if (samples.empty()) thickness_over_lc = record.plate.thickness;
    if (record.plate.thickness != thickness_over_lc) {
      throw InputError(Complaint{fmt::format("{}, geometry {}", file, record.geometry),
                                 fmt::format("has h/l_c = {}, others {}", record.plate.thickness, thickness_over_lc),
                                 "one h/l_c, which the five inputs of Eq. 17 leave out",
                                 "give the plan one value of thickness_over_lc, or train with --superposition"});
    }
    for (const Row& row : record.rows) {
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

std::string error_line(const char* name, const Errors& e) {
  return fmt::format("{:<11} {:>6} {:>6} {:>10.2f} {:>10.2f} {:>10.2f} {:>12.4f} {:>12.4f} {:>11.1f}\n", name,
                     e.n_geometries, e.n_rows, 100 * e.stress_rms, 100 * e.stress_median, 100 * e.stress_95,
                     e.length_median, e.length_95, 100 * e.length_on_plateau);
}

/// The training sample for a ProfileModel from a solved record.
meta_model::ProfileSample to_profile_sample(const Record& record) {
  const plate::UnitProfiles& unit = record.profiles;
  const plate::WedgePlate& g = record.plate;
  meta_model::ProfileSample sample{{g.depth, g.contact_length, g.angle, g.thickness}, {}};
  meta_model::Profiles& p = sample.profiles;
  p.station = unit.station;
  p.buckling_load = unit.in_plane.buckling_load;
  for (std::size_t i = 0; i < unit.station.size(); ++i) {
    p.bending_xx.push_back(unit.bending[i].xx);
    p.bending_yy.push_back(unit.bending[i].yy);
    p.normal_xx.push_back(unit.normal[i].xx);
    p.normal_yy.push_back(unit.normal[i].yy);
    p.tangential_xy.push_back(unit.tangential[i].xy);
    p.first_xx.push_back(unit.in_plane.first[i].xx);
    p.first_yy.push_back(unit.in_plane.first[i].yy);
    p.rest_xx.push_back(unit.in_plane.rest[i].xx);
    p.rest_yy.push_back(unit.in_plane.rest[i].yy);
  }
  return sample;
}

std::vector<meta_model::ProfileSample> to_profile_samples(const std::vector<const Record*>& records) {
  std::vector<meta_model::ProfileSample> samples;
  for (const Record* record : records) samples.push_back(to_profile_sample(*record));
  return samples;
}

std::vector<const Record*> solved_records(const Database& data) {
  std::vector<const Record*> records;
  for (const Record& record : data.records) {
    if (record.solved) records.push_back(&record);
  }
  return records;
}

/// Refuses a test database that would evaluate a model on plates that it has learned.
void refuse_learned(const std::string& file, const Database& test, const std::vector<plate::WedgePlate>& learned) {
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
                                                              const std::vector<const Record*>& records,
                                                              const std::string& database_file, const Database& test,
                                                              const std::string& test_file) {
  if (!test_file.empty()) {
    std::vector<plate::WedgePlate> learned;
    learned.reserve(records.size());
    for (const Record* record : records) learned.push_back(record->plate);
    refuse_learned(test_file, test, learned);
    return {judge(answers_of(model), solved_records(test)),
            fmt::format("geometries that it has not seen (`{}`)", file_name(test_file))};
  }
  constexpr int kTestEvery = 11;  // odd: an even share of a Sobol sequence lies in one half of the box
  std::vector<const Record*> kept, left_out;
  for (const Record* record : records) {
    (record->geometry % kTestEvery == kTestEvery - 1 ? left_out : kept).push_back(record);
  }
  const auto judged = of_file(database_file + ", without the geometries of the test",
                              [&] { return meta_model::ProfileModel::fit(to_profile_samples(kept), ""); });
  return {judge(answers_of(judged), left_out),
          "every eleventh geometry, left out of a fit for this purpose; the model holds them all"};
}

/// The points of `plan`, answered by `teacher`.
std::vector<HumpSample> hump_samples(const Plan& plan, const meta_model::ProfileModel& teacher) {
  std::vector<HumpSample> samples;
  for (const DesignPoint& point : design(plan)) {
    for (const LoadPoint& load : point.loads) {
      samples.push_back(
          hump_sample(teacher, {point.plate.depth, point.plate.contact_length, point.plate.angle, load.mu1, load.mu2},
                      point.plate.thickness));
    }
  }
  return samples;
}

/// Refuses plates that the superposition does not know.
void check_taught(const Plan& plan, const std::string& plan_file) {
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

}  // namespace

MadeModel make_network(const ModelFiles& files, TrainingOptions options) {
  const Database data = read_database(files.data);
  const auto samples = to_samples(files.data, data, options.thickness_over_lc);
  options.data_sha256 = sha256_of_file(files.data);
  const Trained trained = of_file(files.data, [&] { return train(samples, options); });
  const std::string hash = trained.network.write(files.output);
  const std::string card =
      write_card(files.output, {.text = model_card(trained.network, trained.report, options,
                                                   {.model_file = file_name(files.output),
                                                    .content_sha256 = hash,
                                                    .database_file = file_name(files.data),
                                                    .errors_file = file_name(errors_file(files.output)),
                                                    .command = files.command}),
                                .errors = error_table(trained.report)});
  return {
      .report = fmt::format("{:<11} {:>6} {:>6} {:>10} {:>10} {:>10} {:>12} {:>12} {:>11}\n", "part", "geom.", "rows",
                            "stress rms", "median [%]", "95 % [%]", "length med.", "95 % [l_c]", "plateau [%]") +
                error_line("training", trained.report.train) + error_line("validation", trained.report.validation) +
                error_line("test", trained.report.test),
      .content_sha256 = hash,
      .card = card};
}

MadeModel make_superposition(const ModelFiles& files) {
  const Database data = read_database(files.data);
  const Database test = files.test.empty() ? Database{} : read_database(files.test);
  const auto records = solved_records(data);
  const std::string hash = sha256_of_file(files.data);
  const auto model =
      of_file(files.data, [&] { return meta_model::ProfileModel::fit(to_profile_samples(records), hash); });
  const auto [rows, name] = judge_profiles(model, records, files.data, test, files.test);
  const std::string content = model.write(files.output);
  const std::string card = write_card(files.output, profile_card(model, rows,
                                                                 {.model_file = file_name(files.output),
                                                                  .content_sha256 = content,
                                                                  .database_file = file_name(files.data),
                                                                  .data_sha256 = hash,
                                                                  .test = name,
                                                                  .errors_file = file_name(errors_file(files.output)),
                                                                  .command = files.command,
                                                                  .n_learned = records.size()}));
  return {.report = fmt::format("{}modes       {}\n", summary(rows), model.n_modes()),
          .content_sha256 = content,
          .card = card};
}

MadeModel make_deep_network(const ModelFiles& files, HumpTrainingOptions options) {
  if (files.test.empty()) throw InputError("--deep needs --test: plate solutions that test the network");
  const Plan plan = read_plan(files.data);
  check_taught(plan, files.data);
  const Database test = read_database(files.test);
  const std::string teacher = failure::model_path(model::FailureModel::kSuperposition, "");
  const auto superposition = meta_model::ProfileModel::read(teacher);
  if (superposition.data_sha256() == sha256_of_file(files.test)) {
    throw InputError(Complaint{files.test, fmt::format("is the database of {}, which teaches the network", teacher),
                               "geometries that neither model has seen", "solve another plan for the test"});
  }
  std::vector<plate::WedgePlate> learned;
  for (const DesignPoint& point : design(plan)) learned.push_back(point.plate);
  refuse_learned(files.test, test, learned);
  options.thickness_over_lc = plan.thickness_over_lc.from;
  options.data_sha256 = sha256_of_file(teacher);
  const auto samples = hump_samples(plan, superposition);
  const TrainedHumps trained = train_humps(samples, options);
  const std::string content = trained.network.write(files.output);
  const auto rows = judge(answers_of(trained.network), solved_records(test));
  const std::string card =
      write_card(files.output,
                 hump_card(trained, rows,
                           {.model_file = file_name(files.output),
                            .content_sha256 = content,
                            .database_file = file_name(teacher),
                            .data_sha256 = options.data_sha256,
                            .test = fmt::format("plate solutions that it has not seen (`{}`)", file_name(files.test)),
                            .errors_file = file_name(errors_file(files.output)),
                            .command = files.command,
                            .n_learned = samples.size()}));
  std::string fits;
  for (const LayeredFit& fit : trained.fits)
    fits += fmt::format("{:<38} {:>4} iterations ({}), loss {:.4g} training, {:.4g} validation\n", fit.name,
                        fit.iterations, fit.ended, fit.training_loss, fit.validation_loss);
  return {.report = fits + summary(rows), .content_sha256 = content, .card = card};
}

}  // namespace brash::training
