// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "brash/training/hump_training.hpp"

namespace brash::training {

/// Rows as one layered network sees them.
struct LayeredRows {
  Eigen::MatrixXd x;          ///< features, normalised; shape=(n_features, n)
  Eigen::VectorXd y;          ///< target, normalised; shape=(n,)
  Eigen::VectorXd tolerance;  ///< the error of y that counts as one; shape=(n,)
};

/// Fits the weights of a layered network to `training` and puts the weights with the smallest loss of `validation` into
/// `weights`; more rows than weights. The weights are in the order of LayeredNetwork.
LayeredFit fit_layers(const LayeredRows& training, const LayeredRows& validation, const HumpTrainingOptions& options,
                      unsigned long seed, std::vector<double>& weights);

}  // namespace brash::training
