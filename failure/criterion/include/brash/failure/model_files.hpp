// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "brash/model/case.hpp"

namespace brash::failure {

/// All model files that the criterion of a case and its moving edges read, as model_path() finds them.
std::vector<std::string> model_files(const model::FailureSection& failure);

/// Takes the models that come with the program from `folder` from now on, whatever the environment names: for a library
/// that carries them along.
void use_models_in(const std::string& folder);

}  // namespace brash::failure
