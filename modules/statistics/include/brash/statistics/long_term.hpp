// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "brash/statistics/laws.hpp"

namespace brash::statistics {

/// A law of extremes in one state of the ice, and how long the state lasts.
struct IceState {
  LawFit fit;
  double rate = 0.0;   ///< fitted values a second: 1/block, or peaks a second [1/s]
  double hours = 0.0;  ///< of the state in a year [h]
};

/// Expected number of exceedances of a level, a year, over several states of the ice; with 95 % bounds.
///
/// N(x) = sum of 3600 hours rate exceedance(x). The bounds add the bounds of each state, from the profile likelihood of
/// its levels: of one state its own, and wide for several. Bounds are interpolated between 64 levels.
/// @see ISO 19906:2019, 7.2.2 (probabilities of environmental actions); docs/theory/statistics.md, (S14).
class LongTerm {
 public:
  /// @param states      at least one, hours > 0.
  /// @param rarest      least expected number that is asked for, > 0.
  /// @param confidence  of the bounds.
  LongTerm(const std::vector<IceState>& states, double rarest, double confidence = 0.95);

  /// Exceedances of level x, a year.
  double exceedances(double x) const;
  /// The part of each state in them, shape=(n_states,).
  std::vector<double> shares(double x) const;
  /// Level with the annual probability 1 - exp(-N(x)) = `probability`, in (0, 1).
  Estimate level(double probability) const;

 private:
  /// Bounds of the levels of one state at falling probabilities of exceedance by one value.
  struct Curve {
    double a_year = 0.0;                 ///< values a year
    std::vector<double> log_exceedance;  ///< falling
    std::vector<double> lower, upper;    ///< rising
    /// Exceedances a year of x by one of the two curves.
    double exceedances(const std::vector<double>& levels, double x) const;
  };
  /// Level that is exceeded as often as expected a year, by the fitted laws.
  double central(double expected) const;
  /// The same by the curves of a bound.
  double solve(std::vector<double> Curve::*levels, double expected) const;

  std::vector<IceState> states_;
  std::vector<Curve> curves_;
};

}  // namespace brash::statistics
