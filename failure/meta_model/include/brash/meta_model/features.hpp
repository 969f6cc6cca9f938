// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "brash/meta_model/hump_network.hpp"
#include "brash/meta_model/network.hpp"

namespace brash::meta_model {

/// How the model file names the features and targets; a file with others is of another format.
inline constexpr std::array<const char*, kInputs> kFeatureNames{
    "ln(b_lc + 0.1)", "ln(c_lc)", "ln(1 + 2 b_lc tan(theta/2) / c_lc)", "ln(mu1)", "mu2^2"};
inline constexpr std::array<const char*, kOutputs> kTargetNames{"ln(sigma_over_p)", "lbreak_over_lc"};

/// The features of one input, not yet normalised.
std::array<double, kInputs> features_of(const Input& input);

/// Most units of a hidden layer of a HumpNetwork.
inline constexpr int kMostUnits = 200;
/// Keeps the logarithm of a place finite at the tip: below it plate theory means nothing.
inline constexpr double kPlaceShift = 0.03;
/// How the model file names the feature of a HumpNetwork that kFeatureNames lacks, the humps and the targets.
inline constexpr const char* kContactFeature = "ln(1 + 2 b_lc / c_lc)";
inline constexpr std::array<const char*, kHumps> kHumpNames{"near", "far"};
inline constexpr std::array<const char*, 2> kHumpTargets{"ln(sigma_over_p)", "ln(lbreak_over_lc + 0.03)"};

/// The features of one input of a HumpNetwork, not yet normalised.
std::array<double, kHumpFeatures> hump_features_of(const Input& input);

/// Whether the features of `x` are finite.
bool has_features(const Input& x);

bool finite(const std::vector<double>& values);
/// Contracts of model parameters.
void expect_valid(const Normalisation& normalisation);
void expect_valid(const Range& range);

}  // namespace brash::meta_model
