// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "brash/training/network_training.hpp"

namespace brash::training {

/// Rows as the network sees them; y and tolerance are normalised targets and the errors that count as one.
struct NormalisedRows {
  Eigen::MatrixXd x;          ///< shape=(kInputs, n)
  Eigen::MatrixXd y;          ///< shape=(outputs, n)
  Eigen::MatrixXd tolerance;  ///< shape=(outputs, n)
};

/// All weights of Eq. 17 in one vector: W1 row by row, b1, W2 row by row, b2.
struct WeightLayout {
  int hidden = 0;
  int outputs = 0;
  int b1() const { return hidden * meta_model::kInputs; }
  int w2() const { return b1() + hidden; }
  int b2() const { return w2() + hidden * outputs; }
  int size() const { return b2() + outputs; }
};

struct StartResult {
  Eigen::VectorXd weights;
  Start start;
};

/// Mean of the squared residuals of `rows`.
double loss(const WeightLayout& layout, const Eigen::VectorXd& weights, const NormalisedRows& rows);

/// Minimises the loss of `training` from the random start `number`; returns the weights with the least validation loss.
StartResult fit_from_random_start(const WeightLayout& layout, const NormalisedRows& training,
                                  const NormalisedRows& validation, const TrainingOptions& options, int number);

}  // namespace brash::training
