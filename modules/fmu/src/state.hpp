// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "brash/fmu/variables.hpp"
#include "brash/model/checkpoint.hpp"
#include "track.hpp"

namespace brash::fmu {

/// The phases of an instance (FMI 2.0.4, Sec. 4.2.4; FMI 3.0.2, Sec. 2.3 and 4.2.1).
enum class Phase { kInstantiated, kInitialization, kStepping, kTerminated };

/// All that the next call of an instance depends on.
struct State {
  Phase phase = Phase::kInstantiated;
  double start_time = 0.0;  ///< of the host, when the simulation is at 0 s [s]
  std::optional<double> stop_time;
  std::int64_t n_steps = 0;  ///< of the simulation
  double remainder = 0.0;    ///< time of the host past these steps, less than one step [s]
  model::Case resolved;      ///< with the parameters that the host has set
  Inputs inputs;             ///< of a driven structure
  Track track;               ///< of a driven structure
  Outputs outputs;
  std::optional<model::Checkpoint> checkpoint;  ///< of a simulation that has begun
};

/// `state` as bytes, nothing rounded, with their digest. The path of a model file is not in the bytes.
/// @param token  of the unit.
std::string to_bytes(const State& state, const std::string& token);

/// @throws InputError when the bytes are damaged, or of another unit.
State state_from(std::string_view bytes, const std::string& token);

}  // namespace brash::fmu
