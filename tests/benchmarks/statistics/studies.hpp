// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sawtooth.hpp"
#include "table.hpp"

namespace brash::coverage {

/// Simulates records of a process and counts how often the intervals of one command hold the truth.
/// @param records  how many.
void study_history(const Process& process, int records, Table& table);      ///< mean, spectrum
void study_slow_change(const Process& process, int records, Table& table);  ///< mean, peaks that change over 10 s
void study_bootstrap(const Process& process, int records, Table& table);    ///< deviation, quantiles
void study_extremes(const Process& process, int records, Table& table);     ///< return levels of each law
void study_fatigue(const Process& process, int records, Table& table);      ///< equivalent loads
void study_comparison(const Process& process, int records, Table& table);   ///< `brash compare`, two sides alike
void study_trend(const Process& process, int records, Table& table);        ///< `brash trend`, no trend
void study_design(const Process& process, int records, Table& table);       ///< `brash design`, three states of the ice

}  // namespace brash::coverage
