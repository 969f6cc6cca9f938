// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "brash/failure/criterion.hpp"
#include "brash/plate/edge_responses.hpp"

namespace brash::failure {

/// The vertical force on an ice edge over time, from the first touch on; linear between its steps.
class EdgeHistory {
 public:
  /// A force at a time.
  struct Knot {
    double time = 0.0;   ///< [s]
    double force = 0.0;  ///< P [N], >= 0
  };
  /// What a load that grew long ago has become: the sum of its changes of slope [N/s] and of each times its time [N].
  struct Settled {
    double slope = 0.0;
    double moment = 0.0;
  };

  /// @param start  of the first touch [s]; there is no force yet.
  explicit EdgeHistory(double start) : knots_{{start, 0.0}} {}
  EdgeHistory(std::vector<Knot> knots, Settled settled) : knots_(std::move(knots)), settled_(settled) {}

  /// The force has grown or fallen evenly since the last step.
  /// @param memory  changes of slope older than this are settled [s].
  void extend(double time, double force, double memory);

  const std::vector<Knot>& knots() const { return knots_; }
  const Settled& settled() const { return settled_; }
  double time() const { return knots_.back().time; }
  double force() const { return knots_.back().force; }

  /// The force as a sum of responses: `of_time[i]` times the i-th value of a series of EdgeResponses and `at_rest`
  /// times its static value [N].
  struct Weights {
    std::vector<double> of_time;
    double at_rest = 0.0;

    double of(const double* series, std::size_t stride, double static_value) const;
  };
  /// @param at      time >= time(); until then the force continues as in its last step [s].
  /// @param period  T = sqrt(l_c/g) [s].
  Weights weights(const std::vector<double>& series_time, double period, double at) const;

 private:
  double slope_after(std::size_t knot) const;

  std::vector<Knot> knots_;
  Settled settled_;
};

/// Bends floating edges in time. It knows the responses of a trapezoid and says how another sheet with that trapezoid
/// differs from one at rest.
/// @see docs/theory/simulation.md, (S5)
class EdgeDynamics {
 public:
  using Responses = std::function<plate::EdgeResponses(const plate::EdgeGeometry&)>;

  /// @param responses    of any trapezoid, inside a range or moved into it.
  /// @param ice_density  [kg/m3].
  EdgeDynamics(Responses responses, const IceProperties& ice, double ice_density);

  /// The same for ice of another thickness [m]: it shares the responses.
  EdgeDynamics of_thickness(double thickness) const;

  /// Time after which an edge has come to rest under an even force [s].
  double memory() const { return memory_; }

  /// How far B has moved at `at` under its force, positive as pushed [m].
  /// @param load  its trapezoid counts.
  double deflection(const LoadCase& load, const EdgeHistory& history, double at) const;

  /// The sheet at rest that bends as the moving one does at the end of `history`.
  EdgeMotion motion(const LoadCase& load, const EdgeHistory& history) const;

 private:
  plate::EdgeGeometry geometry(const LoadCase& load, bool split) const;
  SheetMotion sheet_motion(const LoadCase& load, const EdgeHistory& history, bool split) const;

  Responses responses_;
  IceProperties ice_;
  double l_c_;
  double period_;
  double ice_density_;
  double mass_ratio_;
  double memory_ = 0.0;
};

/// With the responses that come with the program: the responses of the nearest trapezoid in their range.
/// @throws InputError when their files cannot be read.
EdgeDynamics make_edge_dynamics(const IceProperties& ice, double ice_density);

}  // namespace brash::failure
