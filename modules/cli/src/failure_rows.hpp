// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "brash/meta_model/network.hpp"

namespace brash::cli {

/// One row of inputs.
struct PredictedRow {
  std::string text;  ///< as it was read
  meta_model::Input input;
  double lc_over_h = 0.0;  ///< 0: not stated
};

/// Reads rows `b_lc,c_lc,theta_deg,mu1,mu2[,lc_over_h]`.
/// @param path    CSV file; empty: standard input.
/// @param header  the first line.
/// @throws InputError with file, line and column of a row that cannot be read.
std::vector<PredictedRow> read_predicted_rows(const std::string& path, std::string& header);

struct PredictOptions {
  std::string model;  ///< model file, or `fem`
  std::string rows;   ///< CSV file; empty: standard input
};

/// Reads rows `b_lc,c_lc,theta_deg,mu1,mu2[,lc_over_h]` and prints them with `sigma_over_p,lbreak_over_lc,in_range`.
/// @throws InputError with file, line and column of a row that cannot be read.
void predict_rows(const PredictOptions& options);

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
