// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/simulator/growing_records.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace brash::simulator {
namespace {

/// A run without frames is shown so often [1/s].
constexpr double kFramesPerSecond = 15.0;

std::vector<Vec2> in_metres(const geometry::Ring& ring) {
  std::vector<Vec2> vertices;
  for (const geometry::Point point : ring) vertices.push_back(geometry::metres(point));
  return vertices;
}

std::vector<std::vector<Vec2>> rings_of(const std::vector<geometry::Polygon>& sheet) {
  std::vector<std::vector<Vec2>> rings;
  for (const geometry::Polygon& polygon : sheet) {
    rings.push_back(in_metres(polygon.outline));
    for (const geometry::Ring& hole : polygon.holes) rings.push_back(in_metres(hole));
  }
  return rings;
}

}  // namespace

GrowingRecords::GrowingRecords(const model::Case& resolved)
    : frame_interval_(1.0 /
                      (resolved.output.frames_per_second > 0.0 ? resolved.output.frames_per_second : kFramesPerSecond)),
      duration_(resolved.time.duration) {}

void GrowingRecords::begin_with(const model::RunResults& results) {
  begun_ = true;
  part_ = results;
  for (const model::FloeRecord& floe : results.floes)
    if (floe.end != model::FloeEnd::kAlive) ended_.push_back({floe.id, floe.death, floe.end});
  if (!results.frames.empty()) next_frame_ = results.frames.back().time + frame_interval_;
}

void GrowingRecords::begin(const simulation::Simulation& simulation) {
  if (std::exchange(begun_, true)) return;
  part_.floes = simulation.initial_births();
  part_.initial_sheet = rings_of(simulation.sheet());
}

bool GrowingRecords::take(const simulation::Simulation& simulation, const simulation::StepReport& report) {
  begin(simulation);
  part_.loads.push_back(report.loads);
  std::ranges::copy(report.events, std::back_inserter(part_.events));
  std::ranges::copy(report.splits, std::back_inserter(part_.splits));
  std::ranges::copy(report.births, std::back_inserter(part_.floes));
  for (const simulation::FloeDeath& death : report.deaths)
    ended_.push_back({death.floe, simulation.time(), death.cause});
  // Half a nanosecond absorbs the rounding of step times.
  const bool has_frame = simulation.time() + 5e-10 >= next_frame_ || simulation.time() + 5e-10 >= duration_;
  const bool sheets_move = has_frame && !simulation.sheet_motions().empty();
  if (!report.events.empty() || !report.splits.empty() || sheets_move)
    part_.cracked_sheets.push_back({simulation.time(), rings_of(simulation.sheet())});
  if (!has_frame) return false;
  add_frame(simulation);
  return true;
}

void GrowingRecords::add_frame(const simulation::Simulation& simulation) {
  begin(simulation);
  next_frame_ = simulation.time() + frame_interval_;
  part_.frames.push_back(simulation.frame());
}

std::string GrowingRecords::next() {
  std::string text = report::live_records(part_, ended_);
  part_ = {};
  ended_.clear();
  return text;
}

}  // namespace brash::simulator
