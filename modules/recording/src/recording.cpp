// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/recording/recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>

#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "brash/core/write_file.hpp"
#include "brash/io/checkpoint.hpp"
#include "brash/io/origin.hpp"
#include "brash/io/results.hpp"
#include "brash/model/case_keys.hpp"

namespace brash::recording {

namespace {

namespace fs = std::filesystem;

/// The files with the earlier rows of a run, beside its checkpoint and numbered from the oldest on.
class EarlierRows {
 public:
  explicit EarlierRows(std::string checkpoint) : checkpoint_(std::move(checkpoint)) {}

  void keep(const model::RunResults& rows) {
    const std::string path = path_of(digests_.size());
    digests_.push_back(io::write_earlier_rows(path, rows));
  }
  std::vector<std::string> paths() const {
    std::vector<std::string> all;
    for (std::size_t i = 0; i < digests_.size(); ++i) all.push_back(path_of(i));
    return all;
  }
  model::RunResults read(const std::string& path) const {
    const std::vector<std::string> all = paths();
    const auto file = std::ranges::find(all, path);
    BRASH_EXPECTS(file != all.end(), path);
    return io::read_earlier_rows(path, digests_[static_cast<std::size_t>(file - all.begin())]);
  }

  /// Their hashes, for a state; no table without files.
  std::vector<model::Table> tables() const {
    if (digests_.empty()) return {};
    return {model::Table{kTable, {{"sha256", "1", "SHA-256 of a file with earlier rows, without its seal", digests_}}}};
  }
  /// Takes them from a state.
  void read_from(const model::Checkpoint& checkpoint) {
    digests_.clear();
    const auto table = std::ranges::find(checkpoint.tables, kTable, &model::Table::name);
    if (table != checkpoint.tables.end()) digests_ = std::get<std::vector<std::string>>(table->column("sha256").values);
  }

  /// The names of the files of rows without their numbers.
  static std::string stem_of(const std::string& checkpoint) {
    return fs::path(checkpoint).replace_extension(".rows-").string();
  }
  /// Whether `name` is of a file of rows beside `checkpoint`.
  static bool is_of_rows(const std::string& checkpoint, const std::string& name) {
    const std::string prefix = fs::path(stem_of(checkpoint)).filename().string();
    return name.starts_with(prefix) && name.ends_with(kEnd) &&
           name.find_first_not_of("0123456789", prefix.size()) == name.size() - std::string_view(kEnd).size();
  }

 private:
  static constexpr const char* kTable = "earlier_rows";
  static constexpr const char* kEnd = ".nc";

  std::string path_of(std::size_t i) const { return fmt::format("{}{:04}{}", stem_of(checkpoint_), i + 1, kEnd); }

  std::string checkpoint_;
  std::vector<std::string> digests_{};
};

/// Puts the rows of `files` before those of `results`.
void put_before(model::RunResults& results, const std::vector<std::string>& files,
                const std::function<model::RunResults(const std::string& file)>& read) {
  model::RunResults all;
  const auto append = [&all](model::RunResults& part) {
    std::ranges::move(part.loads, std::back_inserter(all.loads));
    std::ranges::move(part.frames, std::back_inserter(all.frames));
    std::ranges::move(part.cracked_sheets, std::back_inserter(all.cracked_sheets));
  };
  for (const std::string& file : files) {
    model::RunResults part = read(file);
    append(part);
  }
  append(results);
  results.loads = std::move(all.loads);
  results.frames = std::move(all.frames);
  results.cracked_sheets = std::move(all.cracked_sheets);
}

std::vector<model::Table> joined(std::vector<model::Table> tables, const std::vector<model::Table>& more) {
  tables.insert(tables.end(), more.begin(), more.end());
  return tables;
}

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

std::vector<std::string> files_of_rows(const std::string& path) {
  std::vector<std::string> files;
  std::error_code ignored;
  const fs::path folder = fs::path(path).has_parent_path() ? fs::path(path).parent_path() : fs::path(".");
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (EarlierRows::is_of_rows(path, entry.path().filename().string()) && !entry.is_directory(ignored))
      files.push_back(entry.path().string());
  return files;
}

void remove_checkpoint(const std::string& path) {
  fs::remove(path);  // first: a state names its rows
  for (const std::string& file : files_of_rows(path)) fs::remove(file);
}

std::error_code move_checkpoint(const std::string& path, const std::string& to) {
  std::error_code status;
  const std::vector<std::string> rows = files_of_rows(path);
  fs::rename(path, to, status);
  if (status) return status;
  for (const std::string& file : rows)
    fs::rename(file, EarlierRows::stem_of(to) + file.substr(EarlierRows::stem_of(path).size()), status);
  return status;
}

model::RunResults with_earlier(const simulation::CheckpointStore& store, model::RunResults results) {
  put_before(results, store.earlier(), store.read_earlier);
  return results;
}

namespace {

/// @param write  writes a state with the tables of its rows' files.
simulation::CheckpointStore store_of(
    const std::string& path, bool resume, Rows rows,
    std::function<void(const model::Checkpoint&, const std::vector<model::Table>& of_rows)> write) {
  const auto earlier = std::make_shared<EarlierRows>(path);
  simulation::CheckpointStore store{
      .name = path,
      .keep = [earlier, write = std::move(write)](const model::Checkpoint& state) { write(state, earlier->tables()); },
      .earlier = [earlier] { return earlier->paths(); },
      .read_earlier = [earlier](const std::string& file) { return earlier->read(file); }};
  if (rows == Rows::kInFiles) store.keep_earlier = [earlier](const model::RunResults& part) { earlier->keep(part); };
  if (!resume) return store;
  store.newest = [path, rows, earlier]() -> std::optional<model::Checkpoint> {
    if (!fs::exists(path)) return std::nullopt;
    model::Checkpoint state = io::read_checkpoint(path);
    earlier->read_from(state);
    if (rows == Rows::kInMemory) {
      put_before(state.results, earlier->paths(), [earlier](const std::string& file) { return earlier->read(file); });
      *earlier = EarlierRows(path);
    }
    return state;
  };
  return store;
}

}  // namespace

simulation::CheckpointStore checkpoint_file(const std::string& path, bool resume, Rows rows) {
  return store_of(path, resume, rows, [path](const model::Checkpoint& state, const std::vector<model::Table>& of_rows) {
    io::write_checkpoint(path, state.resolved, joined(state.tables, of_rows), state.results);
  });
}

simulation::CheckpointStore checkpoint_file(const std::string& path, bool resume, const Inputs& inputs, Rows rows) {
  const model::Table models = models_of(inputs);
  // The results of a long run are many: a state with the tables of this run is written, and never copied with them.
  const auto write = [path, models](const model::Checkpoint& state, const std::vector<model::Table>& of_rows) {
    io::write_checkpoint(path, nameless(state.resolved),
                         joined(joined(state.tables, {models, this_program()}), of_rows), state.results);
  };
  simulation::CheckpointStore store = store_of(path, resume, rows, write);
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
    io::write_results(directory, resolved, run.results, run.earlier);
    outputs = {"run.nc", "history.csv", "events.csv", "summary.json"};
  } else if (kept == Kept::kHistory) {
    io::write_history(directory, run.results, run.earlier);
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
