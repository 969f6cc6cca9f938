// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "brash/analysis/resistance.hpp"
#include "brash/core/error.hpp"

namespace brash::analysis {
namespace {

constexpr double kLongestTravel = 0.02;  // of a step [m]
constexpr double kLongestStep = 0.02;    // [s]
constexpr double kIceAhead = 0.5;        // behind the end of a run, in lengths of the hull

void refuse_other_motions(const model::Case& ship, const std::string& case_file) {
  const auto* const towed = std::get_if<model::Towed>(&ship.structure.motion);
  if (towed == nullptr || !towed->path.empty())
    throw InputError(
        Complaint{case_file, "has a structure that is not towed at a constant speed",
                  "[structure.motion] kind = \"towed\" without a path",
                  "leave out [structure.motion]; the speed that a thrust gives comes from the resistance"});
  if (!ship.hull.length)
    throw InputError(Complaint{case_file, "has no length of a hull", "a ship with [hull] length",
                               "give hull.length, at the waterline; `brash new --kind ship` writes a case"});
}

/// The time step of a run [s].
double step_at(double speed) { return std::min(kLongestStep, kLongestTravel / speed); }

std::string list(const std::vector<double>& values) { return fmt::format("[{}]", fmt::join(values, ", ")); }

template <typename Of>
std::string list(const std::vector<double>& speeds, Of of) {
  std::vector<double> values;
  for (const double speed : speeds) values.push_back(of(speed));
  return list(values);
}

}  // namespace

std::string resistance_plan(const model::Case& ship, const std::string& case_file, const ResistanceGrid& grid) {
  refuse_other_motions(ship, case_file);
  const double length = *ship.hull.length, distance = grid.lengths * length;
  const double first = std::max(0.0, distance - length);  // [m], where the statistics begin
  const double ice = distance - ship.structure.start_distance + (0.5 + kIceAhead) * length;
  const auto millisecond = [](double time) { return std::round(1e3 * time) / 1e3; };
  return fmt::format(
      "# Resistance of a ship over thickness and speed. `brash resistance` made this plan and reads its results:\n"
      "# each run goes {:g} m, {:g} lengths of the hull, and the last {:g} m count.\n\n"
      "[campaign]\ncase = {}\nreplicates = {}\n\n"
      "[set]\nfield.length = {}\noutput.frames_per_second = 0\n\n"
      "[[grid]]\nice.thickness = {}\n\n"
      "[[grid]]\nstructure.speed = {}\ntime.step = {}\ntime.duration = {}\noutput.statistics_from = {}\n\n"
      "[output]\nkeep = \"history\"\n",
      distance, grid.lengths, distance - first, nlohmann::json(case_file).dump(), grid.replicates,
      std::max(ship.field.length, std::ceil(ice)), list(grid.thicknesses), list(grid.speeds),
      list(grid.speeds, step_at), list(grid.speeds, [&](double speed) { return millisecond(distance / speed); }),
      list(grid.speeds, [&](double speed) { return millisecond(first / speed); }));
}

}  // namespace brash::analysis
