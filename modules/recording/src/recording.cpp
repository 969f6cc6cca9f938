// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/recording/recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>

#include "brash/core/error.hpp"
#include "brash/core/write_file.hpp"
#include "brash/io/checkpoint.hpp"
#include "brash/io/origin.hpp"
#include "brash/io/results.hpp"
#include "brash/model/case_keys.hpp"

namespace brash::recording {

simulation::CheckpointStore checkpoint_file(const std::string& path, bool resume) {
  simulation::CheckpointStore store{.name = path,
                                    .keep = [path](const model::Checkpoint& c) { io::write_checkpoint(path, c); }};
  if (resume)
    store.newest = [path]() -> std::optional<model::Checkpoint> {
      if (!std::filesystem::exists(path)) return std::nullopt;
      return io::read_checkpoint(path);
    };
  return store;
}

namespace {

constexpr const char* kInputs = "input";

/// The case without the names of its files: their hashes say which they are.
model::Case nameless(model::Case resolved) {
  for (std::string* const file : model::files_of(resolved)) file->clear();
  return resolved;
}

/// The hashes of the files that a run reads besides its case, whose values the state has itself.
model::Table models_of(const Inputs& inputs) {
  std::vector<std::string> digests;
  for (std::size_t i = 1; i < inputs.files.size(); ++i) digests.push_back(inputs.files[i].sha256);
  return {kInputs, {{"sha256", "1", "SHA-256 of a model file", std::move(digests)}}};
}

constexpr const char* kProgram = "program";

/// The hash of this program, as a table of a state.
model::Table this_program() {
  static const std::string digest = io::sha256_of_program();
  return {kProgram, {{"sha256", "1", "SHA-256 of the program that kept the state", std::vector<std::string>{digest}}}};
}

/// Adds a warning to a state that another program kept: no run of one program gives such results.
void tell_of_another_program(model::Checkpoint& checkpoint) {
  const auto kept = std::ranges::find(checkpoint.tables, kProgram, &model::Table::name);
  if (kept == checkpoint.tables.end() || *kept == this_program()) return;
  const auto digest = [](const model::Table& program) {
    return std::get<std::vector<std::string>>(program.column("sha256").values).at(0).substr(0, 8);
  };
  simulation::add_warning(
      checkpoint,
      {"several-programs",
       fmt::format("another program (sha256 {}...) went as far as {:.9g} s, and this one ({}...) "
                   "continued: neither program alone need give these results; begin it again",
                   digest(*kept), checkpoint.results.loads.empty() ? 0.0 : checkpoint.results.loads.back().time,
                   digest(this_program()))});
}

}  // namespace

simulation::CheckpointStore checkpoint_file(const std::string& path, bool resume, const Inputs& inputs) {
  simulation::CheckpointStore store = checkpoint_file(path, resume);
  const model::Table models = models_of(inputs);
  // The results of a long run are many: a state with the tables of this run is written, and never copied with them.
  store.keep = [path, models](const model::Checkpoint& checkpoint) {
    std::vector<model::Table> tables = checkpoint.tables;
    tables.push_back(models);
    tables.push_back(this_program());
    io::write_checkpoint(path, nameless(checkpoint.resolved), tables, checkpoint.results);
  };
  if (!store.newest) return store;
  store.newest = [newest = store.newest, models, inputs, path]() -> std::optional<model::Checkpoint> {
    std::optional<model::Checkpoint> checkpoint = newest();
    if (!checkpoint) return checkpoint;
    const auto kept = std::ranges::find(checkpoint->tables, kInputs, &model::Table::name);
    if (kept != checkpoint->tables.end() && *kept != models)
      throw InputError(Complaint{path,
                                 "is of a run with another failure model or mesh than the one that is there now, or an "
                                 "earlier version of the program kept it, with the hashes of fewer models",
                                 "a checkpoint of this case with the same files, by this version",
                                 "put the file back, or start again without --resume"});
    if (checkpoint->resolved == nameless(inputs.resolved)) checkpoint->resolved = inputs.resolved;
    tell_of_another_program(*checkpoint);
    return checkpoint;
  };
  return store;
}

void write_run(const std::string& directory, const Inputs& inputs, const simulation::Run& run,
               const std::vector<std::string>& pictures, Kept kept) {
  const auto start = std::chrono::steady_clock::now();
  const model::Case resolved = inputs.recorded();
  std::vector<std::string> outputs{"summary.json"};
  if (kept == Kept::kRun) {
    io::write_results(directory, resolved, run.results);
    outputs = {"run.nc", "history.csv", "events.csv", "summary.json"};
  } else if (kept == Kept::kHistory) {
    io::write_history(directory, run.results);
    outputs = {"history.csv", "summary.json"};
  }
  simulation::RunSummary summary = run.summary;
  summary.origin = io::origin_of(resolved);
  write_file(directory + "/summary.json", simulation::to_json(summary));

  // Of a campaign's case the campaign has the copies.
  if (kept == Kept::kRun) write_copies(inputs, directory);
  std::vector<io::HashedFile> read;
  for (const InputFile& file : inputs.files) read.push_back({file.path, file.sha256, file.n_bytes, file.copy});
  outputs.insert(outputs.end(), pictures.begin(), pictures.end());
  std::map<std::string, double> stage_seconds;
  simulation::visit_stages(run.stage_times, [&](const char* name, double seconds) { stage_seconds[name] = seconds; });
  stage_seconds["recording"] += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  io::write_manifest(directory, resolved, read, outputs,
                     {.started_at = run.started_at,
                      .wall_seconds = run.wall_seconds,
                      .host_cpu = {},
                      .stage_seconds = std::move(stage_seconds),
                      .threads = run.threads});
}

}  // namespace brash::recording
