// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/meta_model/training.hpp"

#include <fmt/format.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "levenberg_marquardt.hpp"
#include "training_errors.hpp"

namespace brash::meta_model {
namespace {

/// Relative stress error that counts as one: the solver's own accuracy against elasticity is not better.
constexpr double kStressTolerance = 0.02;
/// Smallest error of l_break / l_c that counts as one: half an ice thickness.
constexpr double kLengthTolerance = 0.05;

constexpr std::array<Scale, kInputs> kInputScales{Scale::kLinear, Scale::kLogarithm, Scale::kLinear, Scale::kLogarithm,
                                                  Scale::kSquare};
constexpr std::array<Scale, kOutputs> kOutputScales{Scale::kLogarithm, Scale::kLinear};

double scaled(double value, Scale scale) {
  return scale == Scale::kLogarithm ? std::log(value) : scale == Scale::kSquare ? value * value : value;
}

std::array<double, kOutputs> to_array(const Output& y) { return {y.sigma_over_p, y.lbreak_over_lc}; }
using meta_model::to_array;

void check_rows(std::span<const Sample> samples) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& s = samples[i];
    const bool usable = s.input.c_lc > 0.0 && s.input.mu1 > 0.0 && s.output.sigma_over_p > 0.0 &&
                        std::isfinite(s.output.sigma_over_p) && std::isfinite(s.output.lbreak_over_lc);
    if (usable) continue;
    throw InputError(
        fmt::format("training row {} (geometry {}): c/l_c = {}, mu1 = {}, sigma/p = {} must be > 0 and finite; "
                    "leave the row out or compute the database again",
                    i, s.geometry, s.input.c_lc, s.input.mu1, s.output.sigma_over_p));
  }
}

/// Mean and deviation of the scaled values; a constant value gets the factor 1.
template <typename Value>
Normalisation z_score(std::span<const Sample> samples, Scale scale, Value value) {
  double sum = 0.0, sum_of_squares = 0.0;
  const auto n = static_cast<double>(samples.size());
  for (const Sample& s : samples) sum += scaled(value(s), scale);
  const double mean = sum / n;
  for (const Sample& s : samples) sum_of_squares += std::pow(scaled(value(s), scale) - mean, 2);
  const double deviation = std::sqrt(sum_of_squares / n);
  const double floor = 1e-9 * std::max(1.0, std::abs(mean));  // round-off of a constant column
  return {scale, mean, deviation > floor ? deviation : 1.0};
}

Range range_of(std::span<const Sample> samples) {
  auto lower = to_array(samples.front().input), upper = lower;
  for (const Sample& s : samples) {
    const auto x = to_array(s.input);
    for (int i = 0; i < kInputs; ++i) {
      lower[i] = std::min(lower[i], x[i]);
      upper[i] = std::max(upper[i], x[i]);
    }
  }
  return {to_input(lower), to_input(upper)};
}

NormalisedRows normalise(std::span<const Sample> samples, const NetworkParameters& p) {
  const auto n = static_cast<Eigen::Index>(samples.size());
  NormalisedRows rows{Eigen::MatrixXd(kInputs, n), Eigen::MatrixXd(kOutputs, n), Eigen::MatrixXd(kOutputs, n)};
  for (Eigen::Index r = 0; r < n; ++r) {
    const Sample& s = samples[static_cast<std::size_t>(r)];
    const auto x = to_array(s.input);
    const auto y = to_array(s.output);
    for (int i = 0; i < kInputs; ++i) {
      rows.x(i, r) = (scaled(x[i], p.inputs[i].scale) - p.inputs[i].offset) / p.inputs[i].factor;
    }
    for (int k = 0; k < kOutputs; ++k) {
      rows.y(k, r) = (scaled(y[k], p.outputs[k].scale) - p.outputs[k].offset) / p.outputs[k].factor;
    }
    const double half_width = 0.5 * (s.plateau_to - s.plateau_from);
    rows.tolerance(0, r) = kStressTolerance / p.outputs[0].factor;
    rows.tolerance(1, r) = std::max(half_width, kLengthTolerance) / p.outputs[1].factor;
  }
  return rows;
}

struct Split {
  std::vector<Sample> train, validation, test;
};

/// Shuffles the geometries and deals them out; at least one each.
Split split_by_geometry(std::span<const Sample> samples, const TrainingOptions& options) {
  std::set<int> unique;
  for (const Sample& s : samples) unique.insert(s.geometry);
  std::vector<int> geometries(unique.begin(), unique.end());
  constexpr std::size_t kFewest = 10;  // below this a share of 15 % is no sample
  if (geometries.size() < kFewest) {
    throw InputError(fmt::format("the database has {} solved geometries, training needs at least {}; raise "
                                 "`geometries` in the plan",
                                 geometries.size(), kFewest));
  }
  gsl_rng* rng = gsl_rng_alloc(gsl_rng_ranlxd2);
  gsl_rng_set(rng, static_cast<unsigned long>(options.seed) + 1);
  gsl_ran_shuffle(rng, geometries.data(), geometries.size(), sizeof(int));
  gsl_rng_free(rng);

  const auto share = [&](double fraction) {
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(fraction * static_cast<double>(unique.size()))));
  };
  const std::size_t n_test = share(options.test_share), n_validation = share(options.validation_share);
  const auto first = geometries.begin();
  const std::set<int> test(first, first + static_cast<std::ptrdiff_t>(n_test));
  const std::set<int> validation(first + static_cast<std::ptrdiff_t>(n_test),
                                 first + static_cast<std::ptrdiff_t>(n_test + n_validation));
  Split split;
  for (const Sample& s : samples) {
    (test.contains(s.geometry) ? split.test : validation.contains(s.geometry) ? split.validation : split.train)
        .push_back(s);
  }
  return split;
}

NetworkParameters with_weights(NetworkParameters p, const WeightLayout& l, const Eigen::VectorXd& w) {
  p.hidden = l.hidden;
  p.w1.assign(w.data(), w.data() + l.b1());
  p.b1.assign(w.data() + l.b1(), w.data() + l.w2());
  p.w2.assign(w.data() + l.w2(), w.data() + l.b2());
  p.b2.assign(w.data() + l.b2(), w.data() + l.size());
  return p;
}

}  // namespace

Trained train(std::span<const Sample> samples, const TrainingOptions& options) {
  BRASH_EXPECTS(options.hidden > 0 && options.starts > 0, options.hidden, options.starts);
  BRASH_EXPECTS(options.validation_share > 0.0 && options.test_share > 0.0 &&
                    options.validation_share + options.test_share < 0.9,
                options.validation_share, options.test_share);
  check_rows(samples);
  const Split split = split_by_geometry(samples, options);
  const WeightLayout layout{options.hidden};
  if (split.train.size() * kOutputs < static_cast<std::size_t>(layout.size())) {
    throw InputError(fmt::format("{} training rows cannot fix {} weights; raise `geometries` in the plan or take fewer "
                                 "hidden units",
                                 split.train.size(), layout.size()));
  }

  NetworkParameters p;
  for (int i = 0; i < kInputs; ++i) {
    p.inputs[i] = z_score(split.train, kInputScales[i], [i](const Sample& s) { return to_array(s.input)[i]; });
  }
  for (int k = 0; k < kOutputs; ++k) {
    p.outputs[k] = z_score(split.train, kOutputScales[k], [k](const Sample& s) { return to_array(s.output)[k]; });
  }
  p.range = range_of(samples);
  p.thickness_over_lc = options.thickness_over_lc;
  p.data_sha256 = options.data_sha256;

  const NormalisedRows training = normalise(split.train, p), validation = normalise(split.validation, p);
  TrainingReport report;
  Eigen::VectorXd weights;
  for (int number = 0; number < options.starts; ++number) {
    const StartResult result = fit_from_random_start(training, validation, options, number);
    report.starts.push_back(result.start);
    const double least = report.starts[static_cast<std::size_t>(report.best_start)].validation_loss;
    if (number == 0 || result.start.validation_loss < least) {
      report.best_start = number;
      weights = result.weights;
    }
  }

  Network network(with_weights(std::move(p), layout, weights));
  report.train = errors(network, split.train);
  report.validation = errors(network, split.validation);
  report.test = errors(network, split.test);
  report.regions = errors_by_region(network, split.test);
  return {std::move(network), std::move(report)};
}

}  // namespace brash::meta_model
