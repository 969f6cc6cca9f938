// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "brash/model/case.hpp"
#include "brash/model/records.hpp"
#include "brash/report/live.hpp"
#include "brash/simulation/simulation.hpp"

namespace brash::simulator {

/// The records that a running simulation leaves for a page that draws it. It reads the simulation and changes
/// nothing of it.
class GrowingRecords {
 public:
  explicit GrowingRecords(const model::Case& resolved);

  /// Begins with an earlier part of the run.
  void begin_with(const model::RunResults& results);

  /// Takes a step.
  /// @return whether a frame was due: then there is something to draw.
  bool take(const simulation::Simulation& simulation, const simulation::StepReport& report);

  /// Adds a frame of now, as before the first step.
  void add_frame(const simulation::Simulation& simulation);

  /// What was taken since the last call, as report::live_records() writes it.
  std::string next();

 private:
  void begin(const simulation::Simulation& simulation);

  double frame_interval_;  ///< [s]
  double duration_;        ///< [s]
  double next_frame_ = 0.0;
  bool begun_ = false;
  model::RunResults part_;
  std::vector<report::EndedFloe> ended_;
};

}  // namespace brash::simulator
