// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/meta_model/hump_network.hpp"
#include "lane.hpp"

namespace brash::meta_model {

/// Most units of a hidden layer.
inline constexpr int kMostUnits = 200;
/// Keeps the logarithm of a place finite at the tip: below it plate theory means nothing.
inline constexpr double kPlaceShift = 0.03;

using HumpLanes = std::array<Lane, kHumpFeatures>;

/// The features of HumpNetwork, not yet normalised.
HumpLanes hump_features_of(const std::array<Lane, kInputs>& input);

/// How the model file names the features that kFeatureNames lacks, the humps and the targets.
inline constexpr const char* kContactFeature = "ln(1 + 2 b_lc / c_lc)";
inline constexpr std::array<const char*, kHumps> kHumpNames{"near", "far"};
inline constexpr std::array<const char*, 2> kHumpTargets{"ln(sigma_over_p)", "ln(lbreak_over_lc + 0.03)"};

}  // namespace brash::meta_model
