// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "brash/meta_model/network.hpp"

namespace brash::training {

using meta_model::Input;
using meta_model::Network;
using meta_model::Output;

/// One labelled row of the database.
struct Sample {
  Input input;
  Output output;
  double plateau_from = 0.0;  ///< |AB| / l_c where the stress first exceeds 99 % of its peak
  double plateau_to = 0.0;    ///< where it last does
  int geometry = 0;           ///< rows of one geometry share one plate solution and stay in one part of the split
};

struct TrainingOptions {
  int hidden = 10;           ///< hidden units of a network, as the paper
  bool separate = true;      ///< a network for each output (W1 10x5, W2 10x1, as the paper prints), or one for both
  int starts = 6;            ///< random starts of a network; the one with the smallest validation loss is kept
  int max_iterations = 500;  ///< of Levenberg-Marquardt, each start
  int patience = 40;         ///< iterations without a smaller validation loss before a start ends
  double validation_share = 0.15;  ///< of the geometries
  double test_share = 0.15;        ///< of the geometries
  std::uint64_t seed = 1;          ///< of split and starts
  double thickness_over_lc = 0.1;  ///< h / l_c of the samples
  std::string data_sha256{};       ///< of the database file, passed on to the model
};

/// Errors over a set of rows. The stress error of a row is predicted / computed - 1.
struct Errors {
  std::size_t n_rows = 0;
  std::size_t n_geometries = 0;
  double stress_bias = 0.0;         ///< mean
  double stress_rms = 0.0;          ///< root mean square
  double stress_median = 0.0;       ///< median of the size
  double stress_95 = 0.0;           ///< 95 % quantile of the size
  double stress_max = 0.0;          ///< largest size
  double stress_absolute_95 = 0.0;  ///< 95 % quantile of the size of (predicted - computed) sigma/p
  double length_rms = 0.0;          ///< of l_break / l_c
  double length_median = 0.0;       ///< median of the size
  double length_95 = 0.0;           ///< 95 % quantile of the size
  double length_on_plateau = 0.0;   ///< share of rows whose predicted place has 99 % of the peak stress or more
};

/// Errors of the test rows in a part of the range.
struct Region {
  std::string name;
  Errors errors;
};

/// How one random start went.
struct Start {
  std::string serves{};  ///< the output or "both"
  bool kept = false;
  int iterations = 0;
  double training_loss = 0.0;
  double validation_loss = 0.0;  ///< smallest; its weights are the start's result
  std::string ended{};           ///< "patience", "converged", "iterations" or the solver's message
};

struct TrainingReport {
  Errors train;
  Errors validation;
  Errors test;
  std::vector<Region> regions;
  std::vector<Start> starts;
};

struct Trained {
  Network network;
  TrainingReport report;
};

/// Trains the network of Eq. 17 by Levenberg-Marquardt (GSL multifit_nlinear) on the sum of squares of
///
///   ln(sigma_predicted / sigma) / t_sigma,   t_sigma = 0.02 max(1, 0.25 / (sigma/p)),   and
///   (l_predicted - l) / t_l,                 t_l = max(half width of the 99 % plateau, 0.05),
///
/// so both residuals count in units of an error that would not matter. Where sigma/p is small the ice is crushed before
/// it bends and an absolute error counts. The same samples and options give the same network.
///
/// Geometries, not rows, are divided into training, validation and test parts.
/// @throws InputError when there are too few geometries to divide, or a row cannot be used (stress, c or mu1 <= 0).
/// @see docs/theory/fracture-of-the-edge.md
Trained train(std::span<const Sample> samples, const TrainingOptions& options);

/// Quantile of sorted values, linear between order statistics; used for all model cards.
/// @param sorted  rising, at least one.
/// @param share   in [0, 1].
double quantile(std::span<const double> sorted, double share);

/// Errors of `network` on `samples`.
Errors errors(const Network& network, std::span<const Sample> samples);

/// Entries of a model card besides the numbers of the training.
struct CardContext {
  std::string model_file;      ///< name of the model file
  std::string content_sha256;  ///< of the model file, as Network::write returns it
  std::string database_file;   ///< name of the database file
  std::string errors_file;     ///< name of the file of error_table
  std::string command;         ///< that trains the network
};

/// The errors of the three parts, and of the test rows by region (CSV).
std::string error_table(const TrainingReport& report);

/// The model card (Markdown): range, errors in a few words, uses for which the model is unfit, and its making.
std::string model_card(const Network& network, const TrainingReport& report, const TrainingOptions& options,
                       const CardContext& context);

/// Errors in the parts of the range that behave differently; parts without rows are left out.
std::vector<Region> errors_by_region(const Network& network, const std::vector<Sample>& samples);

}  // namespace brash::training
