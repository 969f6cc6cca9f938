// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "brash/meta_model/edge_responses.hpp"
#include "brash/plate/edge_responses.hpp"

namespace brash::failure {

using meta_model::EdgeResponseModel;
using plate::EdgeGeometry;
using plate::EdgeResponses;
using plate::series_weights;
using plate::SeriesWeights;

/// The file of the EdgeResponseModel that comes with the program; found as model_path() finds its files.
std::string edge_model_path();

}  // namespace brash::failure
