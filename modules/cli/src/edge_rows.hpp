// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace brash::cli {

struct EdgePredictOptions {
  std::string case_file;               ///< its ice, water and the slope of its structure
  std::vector<std::string> overrides;  ///< "section.key=value" of the case
  std::vector<double> speeds;          ///< [m/s]; 0: the static plate
  std::string model;  ///< model file of a moving edge, `fem`, or empty: the one that comes with the program
  std::string rows;   ///< CSV file; empty: standard input
};

/// Reads rows `b_lc,c_lc,theta_deg,mu1,mu2` and prints each at each speed with `speed,N,t_break,w_edge,lbreak,first,
/// in_range`: the load at the circumferential crack [N], its time [s], the deflection of B and the breaking length [m],
/// and the crack that comes first.
/// @throws InputError for a case or a row that cannot be read.
void predict_moving_edges(const EdgePredictOptions& options);

}  // namespace brash::cli
