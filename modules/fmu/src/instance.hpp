// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "brash/fmu/unit.hpp"
#include "brash/fmu/variables.hpp"
#include "brash/simulation/simulation.hpp"
#include "state.hpp"

namespace brash::fmu {

/// A call that changed nothing. The host may continue with other arguments.
class Discarded : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One simulation in a host, whichever version of the standard the host speaks. A call that throws anything but
/// Discarded leaves the instance terminated: reset() or restore() bring it back.
class Instance {
 public:
  /// @param resources  folder of the unit's resources.
  /// @param token      of the host; the unit's own.
  /// @throws InputError when the resources cannot be read or the token is of another unit.
  Instance(const std::string& resources, const std::string& token);

  /// @param start_time  of the host at the beginning; the simulation is then at 0 s.
  void set_up(double start_time, std::optional<double> stop_time);
  void enter_initialization();
  /// Lays the ice, with the parameters as they are now.
  void exit_initialization();
  void terminate();
  /// As it was when it was made.
  void reset();

  double number(unsigned reference) const;
  std::int64_t whole_number(unsigned reference) const;
  struct Setting {
    unsigned reference = 0;
    Number value;
  };
  /// Sets all of these, or none where one is refused.
  void set(const std::vector<Setting>& settings);

  /// Follows a step of the host in whole time steps of the case. The part of one that is left comes with the next call.
  /// A step in which no time step ends leaves the outputs as they are.
  /// @param from  present time of the host [s].
  void step(double from, double size);
  /// Present time of the host [s].
  double time() const {
    return state_.start_time + static_cast<double>(state_.n_steps) * state_.resolved.time.step + state_.remainder;
  }

  State state() const;
  void restore(State state);

  /// What the host should know of the call that has just succeeded; empty: nothing.
  std::string take_warning() { return std::exchange(warning_, {}); }

  Phase phase() const { return state_.phase; }
  const std::string& token() const { return unit_.token; }
  /// The call that is under way has failed.
  void fail() { state_.phase = Phase::kTerminated; }

 private:
  void expect(const char* call, std::initializer_list<Phase> phases) const;
  const Variable& variable(unsigned reference) const;
  Number value(unsigned reference) const;
  void check(const Variable& v, Number value) const;
  void place_structure();
  void follow(double size);
  void drive(double time);
  std::int64_t n_steps_of(double from, double size) const;
  double time_past_steps(double time) const;

  std::string resources_;
  Unit unit_;
  std::vector<Variable> variables_;
  State state_;
  std::string warning_;
  std::optional<simulation::Simulation> simulation_;
};

}  // namespace brash::fmu
