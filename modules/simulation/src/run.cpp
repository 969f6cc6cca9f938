// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/simulation/run.hpp"

#include <fmt/chrono.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <new>
#include <optional>
#include <stdexcept>

#include "brash/core/error.hpp"
#include "brash/core/interruption.hpp"
#include "brash/floes/plan.hpp"
#include "brash/simulation/initial_floes.hpp"
#include "brash/simulation/setup.hpp"
#include "brash/simulation/warnings.hpp"
#include "stage_timer.hpp"
#include "summarise.hpp"

namespace brash::simulation {
namespace {

std::vector<std::vector<Vec2>> rings_of(std::span<const geometry::Polygon> polygons) {
  std::vector<std::vector<Vec2>> rings;
  for (const geometry::Polygon& polygon : polygons)
    std::ranges::move(floes::rings_in_metres(polygon), std::back_inserter(rings));
  return rings;
}

/// Turns step reports into results: the bookkeeping around the loop.
class Recorder {
 public:
  Recorder(const model::Case& resolved, const Simulation& simulation)
      : frame_interval_(1.0 / resolved.output.frames_per_second) {
    results_.initial_sheet = rings_of(simulation.sheet());
    add_births(simulation.initial_births());
    results_.frames.push_back(simulation.frame());
  }
  Recorder(const model::Case& resolved, model::RunResults so_far, std::size_t n_frames_before)
      : frame_interval_(1.0 / resolved.output.frames_per_second),
        results_(std::move(so_far)),
        n_frames_before_(n_frames_before) {
    n_bytes_ = bytes_of(results_.loads) + bytes_of(results_.frames) + bytes_of(results_.cracked_sheets);
  }

  void record(const Simulation& simulation, const StepReport& report) {
    add(results_.loads, report.loads);
    std::ranges::copy(report.events, std::back_inserter(results_.events));
    // Half a nanosecond absorbs the rounding of step times.
    const auto n_frames = static_cast<double>(n_frames_before_ + results_.frames.size());
    const bool has_frame = simulation.time() + 5e-10 >= frame_interval_ * n_frames;
    std::ranges::copy(report.splits, std::back_inserter(results_.splits));
    const bool sheets_move = has_frame && !simulation.sheet_motions().empty();
    if (!report.events.empty() || !report.splits.empty() || sheets_move)
      add(results_.cracked_sheets, {simulation.time(), rings_of(simulation.sheet())});
    add_births(report.births);
    for (const FloeDeath& death : report.deaths) {
      model::FloeRecord& floe = results_.floes[static_cast<std::size_t>(death.floe)];
      floe.death = simulation.time();
      floe.end = death.cause;
      floe.peak_stress = death.peak_stress;
    }
    if (has_frame) add(results_.frames, simulation.frame());
  }

  /// Size of the rows that are in memory.
  std::size_t n_bytes() const { return n_bytes_; }

  /// Gives all loads, frames and cracked sheets to `keep` but the newest of each.
  void keep_earlier(const std::function<void(const model::RunResults&)>& keep) {
    model::RunResults earlier;
    earlier.loads = all_but_newest(results_.loads);
    earlier.frames = all_but_newest(results_.frames);
    earlier.cracked_sheets = all_but_newest(results_.cracked_sheets);
    keep(earlier);
    n_frames_before_ += earlier.frames.size();
    n_bytes_ = bytes_of(results_.loads) + bytes_of(results_.frames) + bytes_of(results_.cracked_sheets);
  }

  /// Exchanges the results so far: a state is kept with them, and they come back.
  void swap_so_far(model::RunResults& other) { std::swap(results_, other); }

  model::RunResults finish(const Simulation& simulation) {
    for (model::FloeRecord& floe : results_.floes)
      if (floe.end == model::FloeEnd::kAlive) floe.death = simulation.time();
    for (const auto& [floe, stress] : simulation.peak_stresses())
      results_.floes[static_cast<std::size_t>(floe)].peak_stress = stress;
    results_.final_sheet = rings_of(simulation.sheet());
    return std::move(results_);
  }

 private:
  void add_births(std::span<const model::FloeRecord> births) {
    std::ranges::copy(births, std::back_inserter(results_.floes));
  }

  static std::size_t size_of(const model::LoadRow&) { return sizeof(model::LoadRow); }
  static std::size_t size_of(const model::Frame& frame) {
    return sizeof frame + sizeof(model::FloePose) * frame.floes.size();
  }
  static std::size_t size_of(const model::CrackedSheet& sheet) {
    std::size_t n_bytes = sizeof sheet;
    for (const std::vector<Vec2>& ring : sheet.rings) n_bytes += sizeof ring + sizeof(Vec2) * ring.size();
    return n_bytes;
  }
  template <typename Row>
  static std::size_t bytes_of(const std::vector<Row>& rows) {
    std::size_t n_bytes = 0;
    for (const Row& row : rows) n_bytes += size_of(row);
    return n_bytes;
  }
  template <typename Row>
  void add(std::vector<Row>& rows, Row row) {
    n_bytes_ += size_of(row);
    rows.push_back(std::move(row));
  }
  /// Takes all rows but the newest out of `rows`.
  template <typename Row>
  static std::vector<Row> all_but_newest(std::vector<Row>& rows) {
    std::vector<Row> earlier = std::exchange(rows, {});
    if (earlier.empty()) return earlier;
    rows.push_back(std::move(earlier.back()));
    earlier.pop_back();
    return earlier;
  }

  double frame_interval_;
  model::RunResults results_;
  std::size_t n_frames_before_ = 0;  ///< that results_ had and has no more
  std::size_t n_bytes_ = 0;          ///< of the loads, frames and cracked sheets in results_
};

using Clock = std::chrono::steady_clock;

/// Asks a few times a second whether the run is to end, in the middle of a step too: one step may take minutes.
class Watch {
 public:
  explicit Watch(const RunOptions& options) : options_(options) {}

  /// Asks while it lives, and throws Interruption out of the work that it interrupts.
  class Scope {
   public:
    explicit Scope(Watch& watch) { current_ = &watch; }

   private:
    CheckedForInterruption checked_{&Watch::look};
  };

 private:
  static void look() {
    constexpr std::chrono::milliseconds kBetween{100};
    Watch& watch = *current_;
    const Clock::time_point now = Clock::now();
    if (now - watch.looked_ < kBetween) return;
    watch.looked_ = now;
    if (watch.options_.interrupted && watch.options_.interrupted()) throw Interruption{};
  }

  static inline thread_local Watch* current_ = nullptr;

  const RunOptions& options_;
  Clock::time_point looked_ = Clock::now();
};

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// The counts of a run that its results do not hold.
struct Counts {
  RunSummary summary;

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    auto& counts = self.summary;
    visit("n_substepped", "1", "steps that were cut into parts", counts.n_substepped);
    visit("n_below_range", "1", "assessments below the failure model's range", counts.n_below_range);
    BreakCounts::visit(counts.breaks, visit);
    model::SheetSolves::visit(counts.sheets, visit);
    model::KeptCounts::visit(counts.verdicts, visit);
    visit("n_above_range", "1", "assessments above the failure model's range", counts.n_above_range);
    visit("n_steps_too_long", "1", "births with a collision time below the step", counts.n_steps_too_long);
    visit("sum_of_last_changes", "m s-1", "last change of the contacts' solution, summed over the steps",
          counts.sum_of_last_changes);
    visit("largest_last_change", "m s-1", "the largest", counts.largest_last_change);
    visit("n_unsettled_steps", "1", "steps whose contacts are not settled", counts.n_unsettled_steps);
  }
};

/// A simulation with its records and counts: all that a checkpoint holds.
struct Progress {
  Simulation simulation;
  Recorder recorder;
  Counts counts;
  std::vector<model::Warning> earlier_warnings{};  ///< that the state to continue from brought along
  double recording_seconds = 0.0;
  double checkpoint_seconds = 0.0;       ///< of the recording
  double last_checkpoint_seconds = 0.0;  ///< of the last checkpoint alone
  StageTimer timer{};
  Clock::time_point begun = Clock::now();
  Clock::time_point last_checkpoint = begun;  ///< or the beginning
  std::optional<model::Checkpoint> known{};   ///< a state of some steps ago, without results
  std::int64_t known_steps = 0;               ///< done in that state
  Clock::time_point known_since{};
  double known_cost = 0.0;  ///< time that it took to keep
};

constexpr const char* kWarnings = "warnings";  ///< the table of a checkpoint

/// The warnings in a table of a checkpoint: a column of their kinds, one of their texts.
std::vector<model::Warning> warnings_in(const model::Checkpoint& checkpoint) {
  const auto table = std::ranges::find(checkpoint.tables, kWarnings, &model::Table::name);
  if (table == checkpoint.tables.end()) return {};
  const auto& ids = std::get<std::vector<std::string>>(table->column("id").values);
  const auto& texts = std::get<std::vector<std::string>>(table->column("text").values);
  std::vector<model::Warning> warnings;
  for (std::size_t i = 0; i < ids.size(); ++i) warnings.push_back({ids[i], texts[i]});
  return warnings;
}

/// So many steps at most are made again to find the state before one that failed or was interrupted.
constexpr std::int64_t kStepsAgain = 100;
/// And so many seconds of such steps, unless states take more than this share of the time.
constexpr double kSecondsAgain = 1.0;
constexpr double kKnownShare = 0.01;

/// Calls `take` with the rows of each file of the store, oldest first.
template <typename Take>
void for_each_earlier(const CheckpointStore& store, const Take& take) {
  if (!store.earlier) return;
  for (const std::string& file : store.earlier()) take(store.read_earlier(file));
}

Progress begin(const model::Case& resolved, const RunOptions& options) {
  std::optional<model::Checkpoint> saved = options.checkpoint.newest ? options.checkpoint.newest() : std::nullopt;
  if (!saved) {
    Simulation simulation(resolved, options.threads);
    Recorder recorder(resolved, simulation);
    return {std::move(simulation), std::move(recorder), {}};
  }
  try {
    std::size_t n_frames = 0;
    for_each_earlier(options.checkpoint, [&](const model::RunResults& part) { n_frames += part.frames.size(); });
    Progress progress{
        Simulation(resolved, *saved, options.threads), Recorder(resolved, std::move(saved->results), n_frames), {}};
    model::restore(*saved, "counts", progress.counts);
    progress.earlier_warnings = warnings_in(*saved);
    return progress;
  } catch (const InputError& error) {
    throw InputError(options.checkpoint.name + ": " + error.what());
  } catch (const std::logic_error& error) {  // a value that is missing, or a body that cannot be
    throw InputError(Complaint{options.checkpoint.name, std::string("holds no state of a run: ") + error.what(),
                               "a checkpoint that this version of the program wrote",
                               "use an older checkpoint, or start the run again"});
  }
}

/// Makes the setup first, where there is none.
std::optional<Progress> begin_unless_interrupted(const model::Case& resolved, const RunOptions& options, Watch& watch,
                                                 std::shared_ptr<const Setup>& setup) {
  try {
    const Watch::Scope watched(watch);
    if (!setup) setup = std::make_shared<const Setup>(resolved);
    return begin(resolved, options);
  } catch (const Interruption&) {
    return std::nullopt;
  }
}

/// A checkpoint holds all results so far, and would take a growing part of a long run's time: a new one that takes as
/// long as the last waits until all have taken no more than this share of it.
constexpr double kCheckpointShare = 0.005;
/// But no longer than this: so much work at most is lost with a machine [s of wall time].
constexpr double kLongestWithoutCheckpoint = 120.0;
/// And no checkpoint that takes long comes sooner than so many times its own duration.
constexpr double kLongestShare = 10.0;

/// Whether a checkpoint is to be kept after `done` steps. @param every  steps between two; 0: none.
bool is_checkpoint_due(const Progress& progress, std::int64_t done, std::int64_t every) {
  if (every <= 0) return false;
  const double since = seconds_since(progress.last_checkpoint);
  if (since >= std::max(kLongestWithoutCheckpoint, kLongestShare * progress.last_checkpoint_seconds)) return true;
  return done % every == 0 && progress.checkpoint_seconds + progress.last_checkpoint_seconds <=
                                  kCheckpointShare * seconds_since(progress.begun);
}

/// Lends the results so far to a state while it lives: a copy would double the memory of a long run.
class Lent {
 public:
  Lent(Recorder& recorder, model::Checkpoint& saved) : recorder_(recorder), saved_(saved) {
    recorder_.swap_so_far(saved_.results);
  }
  Lent(const Lent&) = delete;
  Lent& operator=(const Lent&) = delete;
  ~Lent() { recorder_.swap_so_far(saved_.results); }

 private:
  Recorder& recorder_;
  model::Checkpoint& saved_;
};

void keep_checkpoint(const CheckpointStore& store, model::Checkpoint saved, Progress& progress) {
  const Lent results(progress.recorder, saved);
  model::save(saved, "counts", progress.counts);
  for (const model::Warning& warning : progress.earlier_warnings) add_warning(saved, warning);
  store.keep(saved);
}

void count(RunSummary& counts, const StepReport& report, Vec2 current) {
  counts.n_substepped += report.n_substeps > 1 ? 1 : 0;
  counts.n_below_range += report.n_below_range;
  counts.breaks += report.breaks;
  counts.sheets += report.sheets;
  counts.verdicts += report.verdicts;
  counts.n_above_range += report.n_above_range;
  counts.n_steps_too_long += report.n_steps_too_long;
  counts.sum_of_last_changes += report.last_change;
  counts.largest_last_change = std::max(counts.largest_last_change, report.last_change);
  counts.n_unsettled_steps += report.last_change > settled_residual(report.loads.velocity, current) ? 1 : 0;
}

/// Keeps a state every now and then, from which the next ones can be made again.
void know_state(Progress& progress, std::int64_t n_steps) {
  const double age = seconds_since(progress.known_since);
  const bool is_old =
      n_steps - progress.known_steps >= kStepsAgain || (age > kSecondsAgain && age * kKnownShare > progress.known_cost);
  if (progress.known && !is_old) return;
  const Clock::time_point start = Clock::now();
  progress.known = progress.simulation.checkpoint();
  progress.known_steps = n_steps;
  progress.known_since = Clock::now();
  progress.known_cost = seconds_since(start);
}

/// The state after `n_steps`: the steps since one that is known, made again, lead to it to the bit.
Simulation made_again(const model::Case& resolved, const RunOptions& options, const Progress& progress,
                      std::int64_t n_steps) {
  Simulation again(resolved, progress.known.value(), options.threads);
  for (std::int64_t n = progress.known_steps; n < n_steps; ++n) static_cast<void>(again.step());
  return again;
}

/// Keeps the state after `n_steps`, before a step that failed. @return the line about it for the error message.
std::string keep_reproducer(const model::Case& resolved, const RunOptions& options, Progress& progress,
                            std::int64_t n_steps) {
  if (!options.checkpoint.keep) return {};
  try {
    keep_checkpoint(options.checkpoint, made_again(resolved, options, progress, n_steps).checkpoint(), progress);
  } catch (const std::exception& error) {
    return fmt::format("\n  the state before it could not be kept: {}", error.what());
  }
  return "\n  kept:    the state before the step, in " + options.checkpoint.name +
         ": --resume repeats the failure, for a closer look";
}

/// One step; nothing when it is interrupted, with the state before it. A step that fails leaves nothing that could pass
/// for a result, and the state before it, which repeats it.
std::optional<StepReport> step(const model::Case& resolved, const RunOptions& options, Progress& progress,
                               Watch& watch) {
  const double from = progress.simulation.time();
  const std::int64_t n_steps = std::llround(from / resolved.time.step);
  know_state(progress, n_steps);
  try {
    const Watch::Scope watched(watch);
    return progress.simulation.step();
  } catch (const Interruption&) {
    progress.simulation = made_again(resolved, options, progress, n_steps);
    return std::nullopt;
  } catch (const std::bad_alloc&) {
    throw;  // the step is not at fault
  } catch (const std::exception& error) {
    throw RunError(
        fmt::format("step {} failed, from t = {:.9g} s: {}{}\n  remedy:  start the run again with a shorter step and "
                    "more sweeps of contacts, such as --set time.step={:.3g} --set contact.iterations={}",
                    n_steps + 1, from, error.what(), keep_reproducer(resolved, options, progress, n_steps),
                    0.5 * resolved.time.step, std::min(2 * resolved.contact.iterations, 10'000)));
  }
}

/// Steps until the end or an interruption. @return whether the end was reached.
bool advance(const model::Case& resolved, const RunOptions& options, Progress& progress, Watch& watch) {
  const double dt = resolved.time.step;
  const auto n_steps = std::llround(resolved.time.duration / dt);
  const auto checkpoint_every = std::llround(resolved.output.checkpoint_interval / dt);
  for (auto done = std::llround(progress.simulation.time() / dt); done < n_steps;) {
    const std::optional<StepReport> report = step(resolved, options, progress, watch);
    const StageTimer::Scope clock(progress.timer, progress.recording_seconds);
    if (report) {
      ++done;
      progress.recorder.record(progress.simulation, *report);
      count(progress.counts.summary, *report, resolved.water.current);
      if (options.observer) options.observer(progress.simulation, *report);
      if (options.checkpoint.keep_earlier && progress.recorder.n_bytes() > options.most_bytes_in_memory)
        progress.recorder.keep_earlier(options.checkpoint.keep_earlier);
    }
    const bool interrupted = !report || (options.interrupted && options.interrupted());
    if (options.checkpoint.keep && (interrupted || is_checkpoint_due(progress, done, checkpoint_every))) {
      const Clock::time_point start = Clock::now();
      keep_checkpoint(options.checkpoint, progress.simulation.checkpoint(), progress);
      progress.last_checkpoint_seconds = seconds_since(start);
      progress.checkpoint_seconds += progress.last_checkpoint_seconds;
      progress.last_checkpoint = Clock::now();
    }
    if (interrupted) return false;
  }
  return true;
}

}  // namespace

void add_warning(model::Checkpoint& checkpoint, const model::Warning& warning) {
  auto table = std::ranges::find(checkpoint.tables, kWarnings, &model::Table::name);
  if (table == checkpoint.tables.end())
    table = checkpoint.tables.insert(table, {kWarnings,
                                             {{"id", "1", "kind of a warning", std::vector<std::string>{}},
                                              {"text", "1", "text of a warning", std::vector<std::string>{}}}});
  std::get<std::vector<std::string>>(table->column("id").values).push_back(warning.id);
  std::get<std::vector<std::string>>(table->column("text").values).push_back(warning.text);
}

Run run(const model::Case& resolved, const RunOptions& options) {
  Run finished;
  finished.started_at = fmt::format("{:%FT%TZ}", fmt::gmtime(std::time(nullptr)));
  const Clock::time_point start = Clock::now();
  Watch watch(options);
  finished.setup = options.setup;
  std::optional<Progress> begun = begin_unless_interrupted(resolved, options, watch, finished.setup);
  if (!begun) return finished;
  Progress& progress = *begun;
  finished.resumed_from = progress.simulation.time();
  const double water = open_water(resolved);
  if (options.begun) options.begun();
  finished.complete = advance(resolved, options, progress, watch);
  finished.results = progress.recorder.finish(progress.simulation);
  progress.counts.summary.ledger = progress.simulation.ledger();
  if (finished.complete) {
    progress.counts.summary.window = finished.setup->window;
    RowSummary rows(resolved, progress.counts.summary.window);
    for_each_earlier(options.checkpoint, [&](const model::RunResults& part) { rows.add(part); });
    rows.add(finished.results);
    finished.summary = summarise(resolved, finished.results, rows, water, progress.counts.summary);
    finished.summary.warnings = std::move(progress.earlier_warnings);
    finished.loads_seen = rows.loads_seen();
  }
  if (options.checkpoint.earlier) finished.earlier = options.checkpoint.earlier();
  finished.stage_times = progress.simulation.stage_times();
  finished.stage_times.recording = progress.recording_seconds;
  finished.wall_seconds = seconds_since(start);
  finished.threads = options.threads;
  return finished;
}

}  // namespace brash::simulation
