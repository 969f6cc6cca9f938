// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "brash/database/database.hpp"
#include "brash/meta_model/profile_model.hpp"

namespace brash::cli {

/// What the card of a superposition says besides the errors.
struct ProfileCardContext {
  std::string model_file;
  std::string content_sha256;
  std::string database_file;
  std::string data_sha256;
  std::size_t n_geometries = 0;  ///< in the model that is written
  int n_modes = 0;
};

/// The model card (Markdown): errors of `tested`, which has not seen `left_out`, overall and by region.
std::string profile_card(const meta_model::ProfileModel& tested, const std::vector<const database::Record*>& left_out,
                         const ProfileCardContext& context);

}  // namespace brash::cli
