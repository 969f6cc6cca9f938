// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "brash/model/case.hpp"
#include "brash/simulation/simulation.hpp"
#include "brash/simulator/growing_records.hpp"

namespace brash::simulator {

/// A simulation that a page steps and draws. Texts are JSON; units are SI.
class Session {
 public:
  /// @throws InputError when the failure model cannot be read.
  explicit Session(model::Case resolved);

  /// What a page needs before the first step: the manifest of the run, and the arrays of the structure under the names
  /// of a report's blocks.
  std::string head() const;

  /// Records of the start: ice and structure before the first step.
  std::string start();

  /// Makes `n_steps` steps, fewer at the end of the case, and gives their records (report::live_records()). The last
  /// step always has a frame.
  /// @throws RunError as Simulation::step().
  std::string advance(int n_steps);

  double time() const { return simulation_.time(); }
  bool is_done() const;

 private:
  model::Case case_;
  simulation::Simulation simulation_;
  GrowingRecords records_;
  std::int64_t n_steps_ = 0;
};

/// What `brash check` says of a case: `toml`, the resolved case; `derived`, rows of name, value and unit; `warnings`
/// with id and text. JSON.
/// @throws InputError when the failure model cannot be read.
std::string description(const model::Case& resolved);

}  // namespace brash::simulator
