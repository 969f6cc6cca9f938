// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "brash/database/database.hpp"
#include "brash/meta_model/profile_model.hpp"

namespace brash::cli {

struct PredictOptions {
  std::string model;  ///< model file, or `fem`
  std::string rows;   ///< CSV file; empty: standard input
};

/// Reads rows `b_lc,c_lc,theta_deg,mu1,mu2[,lc_over_h]` and prints them with `sigma_over_p,lbreak_over_lc,in_range`.
/// @throws InputError with file, line and column of a row that cannot be read.
void predict_rows(const PredictOptions& options);

/// The training sample for a ProfileModel from a solved record.
meta_model::ProfileSample to_profile_sample(const database::Record& record);

}  // namespace brash::cli
