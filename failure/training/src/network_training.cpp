// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/training/network_training.hpp"

#include <fmt/format.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "brash/meta_model/features.hpp"
#include "levenberg_marquardt.hpp"

namespace brash::training {

using namespace meta_model;

namespace {

/// Relative stress error that counts as one: the solver's own accuracy against elasticity is not better.
constexpr double kStressTolerance = 0.02;
/// Smallest error of l_break / l_c that counts as one: half an ice thickness.
constexpr double kLengthTolerance = 0.05;

/// Below this sigma/p ice of any strength is crushed before it bends (sigma_f / (R sigma_c) is about 1).
constexpr double kStressThatMatters = 0.25;

/// The targets that the network learns from a row.
std::array<double, kOutputs> targets_of(const Output& y) { return {std::log(y.sigma_over_p), y.lbreak_over_lc}; }

void check_rows(std::span<const Sample> samples) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& s = samples[i];
    const bool usable = s.input.c_lc > 0.0 && s.input.mu1 > 0.0 && s.output.sigma_over_p > 0.0 &&
                        std::isfinite(s.output.sigma_over_p) && std::isfinite(s.output.lbreak_over_lc);
    if (usable) continue;
    throw InputError(
        Complaint{fmt::format("training row {} (geometry {})", i, s.geometry),
                  fmt::format("c/l_c = {}, mu1 = {}, sigma/p = {}", s.input.c_lc, s.input.mu1, s.output.sigma_over_p),
                  "finite numbers above 0", "leave the row out or compute the database again"});
  }
}

/// Mean and deviation of value(row); a constant value gets the factor 1.
template <typename Value>
Normalisation z_score(std::span<const Sample> samples, Value value) {
  double sum = 0.0, sum_of_squares = 0.0;
  const auto n = static_cast<double>(samples.size());
  for (const Sample& s : samples) sum += value(s);
  const double mean = sum / n;
  for (const Sample& s : samples) sum_of_squares += std::pow(value(s) - mean, 2);
  const double deviation = std::sqrt(sum_of_squares / n);
  const double floor = 1e-9 * std::max(1.0, std::abs(mean));  // round-off of a constant column
  return {mean, deviation > floor ? deviation : 1.0};
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

/// The outputs that one network serves.
using Group = std::vector<int>;

NormalisedRows normalise(std::span<const Sample> samples, const NetworkParameters& p, const Group& group) {
  const auto n = static_cast<Eigen::Index>(samples.size());
  const auto n_outputs = static_cast<Eigen::Index>(group.size());
  NormalisedRows rows{Eigen::MatrixXd(kInputs, n), Eigen::MatrixXd(n_outputs, n), Eigen::MatrixXd(n_outputs, n)};
  for (Eigen::Index r = 0; r < n; ++r) {
    const Sample& s = samples[static_cast<std::size_t>(r)];
    const auto x = features_of(s.input);
    const auto y = targets_of(s.output);
    const std::array<double, kOutputs> tolerance{
        kStressTolerance * std::max(1.0, kStressThatMatters / s.output.sigma_over_p),
        std::max(0.5 * (s.plateau_to - s.plateau_from), kLengthTolerance)};
    for (int i = 0; i < kInputs; ++i) rows.x(i, r) = (x[i] - p.features[i].offset) / p.features[i].factor;
    for (Eigen::Index row = 0; row < n_outputs; ++row) {
      const int k = group[static_cast<std::size_t>(row)];
      rows.y(row, r) = (y[k] - p.targets[k].offset) / p.targets[k].factor;
      rows.tolerance(row, r) = tolerance[k] / p.targets[k].factor;
    }
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
  constexpr std::size_t kFewest = 10;  // below this a share of 15 % is not a sample
  if (geometries.size() < kFewest) {
    throw InputError(Complaint{"the database", fmt::format("has {} solved geometries", geometries.size()),
                               fmt::format("at least {} for training", kFewest), "raise `geometries` in the plan"});
  }
  gsl_rng* rng = gsl_rng_alloc(gsl_rng_ranlxd2);
  gsl_rng_set(rng, static_cast<unsigned long>(options.seed) + 1);
  gsl_ran_shuffle(rng, geometries.data(), geometries.size(), sizeof(int));
  gsl_rng_free(rng);

  const auto share = [&](double fraction) {
    return std::max<std::size_t>(1,
                                 static_cast<std::size_t>(std::lround(fraction * static_cast<double>(unique.size()))));
  };
  const std::size_t n_test = share(options.test_share), n_validation = share(options.validation_share);
  const auto first = geometries.begin();
  const std::set<int> test(first, first + static_cast<std::ptrdiff_t>(n_test));
  const std::set<int> validation(first + static_cast<std::ptrdiff_t>(n_test),
                                 first + static_cast<std::ptrdiff_t>(n_test + n_validation));
  Split split;
  for (const Sample& s : samples) {
    (test.contains(s.geometry)         ? split.test
     : validation.contains(s.geometry) ? split.validation
                                       : split.train)
        .push_back(s);
  }
  return split;
}

/// Puts the hidden units of one network after the units of `p`; W2 is still shape=(hidden, kOutputs) here.
void append(NetworkParameters& p, const Group& group, const WeightLayout& l, const Eigen::VectorXd& w) {
  p.hidden += l.hidden;
  p.w1.insert(p.w1.end(), w.data(), w.data() + l.b1());
  p.b1.insert(p.b1.end(), w.data() + l.b1(), w.data() + l.w2());
  p.w2.resize(static_cast<std::size_t>(p.hidden * kOutputs), 0.0);
  p.b2.resize(kOutputs, 0.0);
  for (int row = 0; row < l.outputs; ++row) {
    const int k = group[static_cast<std::size_t>(row)];
    p.b2[k] = w[l.b2() + row];
    for (int j = 0; j < l.hidden; ++j) {
      p.w2[static_cast<std::size_t>((p.hidden - l.hidden + j) * kOutputs + k)] = w[l.w2() + row * l.hidden + j];
    }
  }
}

void transpose_w2(NetworkParameters& p) {
  const std::vector<double> by_unit = p.w2;
  for (int j = 0; j < p.hidden; ++j) {
    for (int k = 0; k < kOutputs; ++k) p.w2[k * p.hidden + j] = by_unit[j * kOutputs + k];
  }
}

/// Normalisation, range and provenance; no weights yet.
NetworkParameters without_weights(std::span<const Sample> all, std::span<const Sample> training,
                                  const TrainingOptions& options) {
  NetworkParameters p;
  for (int i = 0; i < kInputs; ++i) {
    p.features[i] = z_score(training, [i](const Sample& s) { return features_of(s.input)[i]; });
  }
  for (int k = 0; k < kOutputs; ++k) {
    p.targets[k] = z_score(training, [k](const Sample& s) { return targets_of(s.output)[k]; });
  }
  p.range = range_of(all);
  p.thickness_over_lc = options.thickness_over_lc;
  p.data_sha256 = options.data_sha256;
  return p;
}

/// Trains one network from its random starts, appends the best one's units to `p` and the starts to `report`.
void train_group(const Group& group, const Split& split, const TrainingOptions& options, NetworkParameters& p,
                 TrainingReport& report) {
  const WeightLayout layout{options.hidden, static_cast<int>(group.size())};
  const NormalisedRows training = normalise(split.train, p, group), validation = normalise(split.validation, p, group);
  if (training.y.size() < layout.size()) {
    throw InputError(Complaint{
        "the database", fmt::format("{} training rows cannot fix {} weights", split.train.size(), layout.size()),
        "at least as many rows as weights", "raise `geometries` in the plan, or take fewer hidden units"});
  }
  std::vector<StartResult> results;
  for (int number = 0; number < options.starts; ++number) {
    results.push_back(fit_from_random_start(layout, training, validation, options, number));
    results.back().start.serves = group.size() > 1 ? "both" : kTargetNames[group.front()];
  }
  const auto best = std::min_element(results.begin(), results.end(), [](const auto& a, const auto& b) {
    return a.start.validation_loss < b.start.validation_loss;
  });
  best->start.kept = true;
  append(p, group, layout, best->weights);
  for (const StartResult& result : results) report.starts.push_back(result.start);
}

double root_mean_square(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace

Trained train(std::span<const Sample> samples, const TrainingOptions& options) {
  BRASH_EXPECTS(options.hidden > 0 && options.starts > 0, options.hidden, options.starts);
  BRASH_EXPECTS(
      options.validation_share > 0.0 && options.test_share > 0.0 && options.validation_share + options.test_share < 0.9,
      options.validation_share, options.test_share);
  check_rows(samples);
  const Split split = split_by_geometry(samples, options);
  NetworkParameters p = without_weights(samples, split.train, options);
  TrainingReport report;
  const std::vector<Group> groups = options.separate ? std::vector<Group>{{0}, {1}} : std::vector<Group>{{0, 1}};
  for (const Group& group : groups) train_group(group, split, options, p, report);
  transpose_w2(p);

  Network network(std::move(p));
  report.train = errors(network, split.train);
  report.validation = errors(network, split.validation);
  report.test = errors(network, split.test);
  report.regions = errors_by_region(network, split.test);
  return {std::move(network), std::move(report)};
}

double quantile(std::span<const double> sorted, double share) {
  BRASH_EXPECTS(!sorted.empty() && share >= 0.0 && share <= 1.0, sorted.size(), share);
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

Errors errors(const Network& network, std::span<const Sample> samples) {
  Errors result;
  if (samples.empty()) return result;
  std::vector<double> stress, absolute, length;
  std::set<int> geometries;
  double bias = 0.0, on_plateau = 0.0;
  for (const Sample& s : samples) {
    const Output predicted = network.predict(s.input);
    const double stress_error = predicted.sigma_over_p / s.output.sigma_over_p - 1.0;
    bias += stress_error;
    stress.push_back(std::abs(stress_error));
    absolute.push_back(std::abs(predicted.sigma_over_p - s.output.sigma_over_p));
    length.push_back(std::abs(predicted.lbreak_over_lc - s.output.lbreak_over_lc));
    on_plateau += predicted.lbreak_over_lc >= s.plateau_from && predicted.lbreak_over_lc <= s.plateau_to ? 1.0 : 0.0;
    geometries.insert(s.geometry);
  }
  std::sort(stress.begin(), stress.end());
  std::sort(absolute.begin(), absolute.end());
  std::sort(length.begin(), length.end());
  const auto n = static_cast<double>(samples.size());
  constexpr double kHigh = 0.95;
  return {.n_rows = samples.size(),
          .n_geometries = geometries.size(),
          .stress_bias = bias / n,
          .stress_rms = root_mean_square(stress),
          .stress_median = quantile(stress, 0.5),
          .stress_95 = quantile(stress, kHigh),
          .stress_max = stress.back(),
          .stress_absolute_95 = quantile(absolute, kHigh),
          .length_rms = root_mean_square(length),
          .length_median = quantile(length, 0.5),
          .length_95 = quantile(length, kHigh),
          .length_on_plateau = on_plateau / n};
}

std::vector<Region> errors_by_region(const Network& network, const std::vector<Sample>& samples) {
  using Part = bool (*)(const Input&, const Output&);
  static constexpr std::array<std::pair<const char*, Part>, 16> kParts{{
      {"b < 0 (bay)", [](const Input& x, const Output&) { return x.b_lc < 0.0; }},
      {"b < 0.25 l_c", [](const Input& x, const Output&) { return x.b_lc >= 0.0 && x.b_lc < 0.25; }},
      {"0.25 l_c <= b < l_c", [](const Input& x, const Output&) { return x.b_lc >= 0.25 && x.b_lc < 1.0; }},
      {"b >= l_c", [](const Input& x, const Output&) { return x.b_lc >= 1.0; }},
      {"c < 0.1 l_c", [](const Input& x, const Output&) { return x.c_lc < 0.1; }},
      {"0.1 l_c <= c < 0.5 l_c", [](const Input& x, const Output&) { return x.c_lc >= 0.1 && x.c_lc < 0.5; }},
      {"c >= 0.5 l_c", [](const Input& x, const Output&) { return x.c_lc >= 0.5; }},
      {"theta < 45 deg", [](const Input& x, const Output&) { return x.theta < radians(45.0); }},
      {"45 deg <= theta < 90 deg",
       [](const Input& x, const Output&) { return x.theta >= radians(45.0) && x.theta < radians(90.0); }},
      {"theta >= 90 deg", [](const Input& x, const Output&) { return x.theta >= radians(90.0); }},
      {"mu1 < 0.3", [](const Input& x, const Output&) { return x.mu1 < 0.3; }},
      {"0.3 <= mu1 < 1", [](const Input& x, const Output&) { return x.mu1 >= 0.3 && x.mu1 < 1.0; }},
      {"mu1 >= 1", [](const Input& x, const Output&) { return x.mu1 >= 1.0; }},
      {"sigma/p < 0.25 (crushed first)", [](const Input&, const Output& y) { return y.sigma_over_p < 0.25; }},
      {"sigma/p >= 0.25", [](const Input&, const Output& y) { return y.sigma_over_p >= 0.25; }},
      {"sigma/p >= 0.25 and 0.3 <= mu1 < 1",
       [](const Input& x, const Output& y) { return y.sigma_over_p >= 0.25 && x.mu1 >= 0.3 && x.mu1 < 1.0; }},
  }};
  std::vector<Region> regions;
  for (const auto& [name, holds] : kParts) {
    std::vector<Sample> part;
    std::copy_if(samples.begin(), samples.end(), std::back_inserter(part),
                 [&holds = holds](const Sample& s) { return holds(s.input, s.output); });
    if (!part.empty()) regions.push_back({name, errors(network, part)});
  }
  return regions;
}

}  // namespace brash::training
