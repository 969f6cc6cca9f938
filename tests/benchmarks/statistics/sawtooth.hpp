// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "brash/analysis/load_history.hpp"
#include "brash/statistics/random.hpp"

namespace brash::coverage {

/// A load that rises straight from 20 to a random peak and drops. Cycles last 1 s on average, with a deviation of 0.3
/// s.
struct Process {
  std::string name;
  std::function<double(double)> peak;  ///< level that a peak exceeds with a probability
};

/// Peaks with a bounded, a light, an exponential and a heavy tail.
std::vector<Process> processes();

/// A record of about `cycles` cycles, every 0.05 s. It begins and ends with a whole cycle.
/// @param scale  factor of all loads.
/// @param slow   deviation of a factor of the peaks that changes over 10 s, with the mean 1; 0: independent peaks.
analysis::LoadHistory record(const Process& process, int cycles, statistics::RandomStream& stream, double scale = 1.0,
                             double slow = 0.0);

/// Mean length of a cycle [s], by summation.
double mean_cycle();
/// Mean load, by integration over the peaks.
double mean_load(const Process& process);
/// Damage per cycle at an exponent, by integration over the peaks.
double damage_of_cycle(const Process& process, double exponent);

/// Statistics of a record of 100 000 cycles.
struct Truth {
  double deviation = 0.0;
  double quantile_50 = 0.0, quantile_95 = 0.0, quantile_99 = 0.0;
  std::vector<double> spectrum;  ///< densities that segments of `segment` s have on average
};

Truth truth_of(const Process& process, double segment);

}  // namespace brash::coverage
