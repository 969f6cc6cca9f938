// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/simulation/run.hpp"

#include <fmt/chrono.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "brash/core/error.hpp"
#include "plan.hpp"
#include "summarise.hpp"

namespace brash::simulation {
namespace {

std::vector<std::vector<Vec2>> rings_of(std::span<const geometry::Polygon> polygons) {
  std::vector<std::vector<Vec2>> rings;
  for (const geometry::Polygon& polygon : polygons) std::ranges::move(rings_in_metres(polygon), std::back_inserter(rings));
  return rings;
}

/// Turns step reports into results: the bookkeeping around the loop.
class Recorder {
 public:
  Recorder(const io::Case& resolved, const Simulation& simulation)
      : frame_interval_(1.0 / resolved.output.frames_per_second) {
    results_.initial_sheet = rings_of(simulation.sheet());
    add_births(simulation.initial_births());
    results_.frames.push_back(simulation.frame());
  }

  void record(const Simulation& simulation, const StepReport& report) {
    results_.loads.push_back(report.loads);
    std::ranges::copy(report.events, std::back_inserter(results_.events));
    add_births(report.births);
    for (const FloeDeath& death : report.deaths) {
      io::FloeRecord& floe = results_.floes[static_cast<std::size_t>(death.floe)];
      floe.death = simulation.time();
      floe.end = death.cause;
      floe.peak_stress = death.peak_stress;
    }
    // Half a nanosecond absorbs the rounding of step times.
    if (simulation.time() + 5e-10 >= frame_interval_ * static_cast<double>(results_.frames.size()))
      results_.frames.push_back(simulation.frame());
  }

  io::RunResults finish(const Simulation& simulation) {
    for (io::FloeRecord& floe : results_.floes)
      if (floe.end == io::FloeEnd::kAlive) floe.death = simulation.time();
    results_.final_sheet = rings_of(simulation.sheet());
    return std::move(results_);
  }

 private:
  void add_births(std::span<const io::FloeRecord> births) { std::ranges::copy(births, std::back_inserter(results_.floes)); }

  double frame_interval_;
  io::RunResults results_;
};

}  // namespace

Run run(const io::Case& resolved, const Observer& observer) {
  const std::string started_at = fmt::format("{:%FT%TZ}", fmt::gmtime(std::time(nullptr)));
  const auto start = std::chrono::steady_clock::now();
  Simulation simulation(resolved);
  Recorder recorder(resolved, simulation);
  RunSummary counts;
  const auto n_steps = static_cast<std::int64_t>(std::llround(resolved.time.duration / resolved.time.step));
  for (std::int64_t i = 0; i < n_steps; ++i) {
    const StepReport report = simulation.step();
    recorder.record(simulation, report);
    counts.n_substepped += report.n_substeps > 1 ? 1 : 0;
    counts.n_below_range += report.n_below_range;
    counts.n_above_range += report.n_above_range;
    counts.n_steps_too_long += report.n_steps_too_long;
    if (observer) observer(simulation, report);
  }
  if (!simulation.ledger().closes())
    throw RunError("the ledger does not close: " + simulation.ledger().missing().to_string() + " m2 are missing");

  Run finished;
  finished.results = recorder.finish(simulation);
  counts.ledger = simulation.ledger();
  finished.summary = summarise(resolved, finished.results, counts);
  finished.started_at = started_at;
  finished.stage_times = simulation.stage_times();
  finished.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return finished;
}

}  // namespace brash::simulation
