// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/training/hump_training.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "brash/meta_model/features.hpp"
#include "layered_fit.hpp"

namespace brash::training {

using namespace meta_model;

namespace {

/// Relative stress error that counts as one, and the sigma/p below which ice is crushed before it bends.
constexpr double kStressTolerance = 0.005;
constexpr double kStressThatMatters = 0.25;
/// Error of a place that counts as one, over half the plateau's width; and its smallest (of the logarithm).
constexpr double kPlateauShare = 0.3;
constexpr double kPlaceTolerance = 0.01;
/// A hump that does not answer may err by its distance from the one that does; its stress is not learned below this
/// share of the larger.
constexpr double kLoserShare = 0.3;
constexpr double kLoserPlace = 50.0;

double ln_place(double place) { return std::log(place + kPlaceShift); }

/// A target that a network learns from a row: value and the error that counts as one.
struct Target {
  double value = 0.0;
  double tolerance = 1.0;
};

double largest_stress(const HumpSample& s) {
  return std::max(s.humps[0].output.sigma_over_p, s.humps[1].output.sigma_over_p);
}

Target stress_target(const HumpSample& s, std::size_t hump) {
  const double top = largest_stress(s);
  const double stress = std::max(s.humps[hump].output.sigma_over_p, kLoserShare * top);
  const double below = 1.0 - stress / top;
  return {std::log(stress), kStressTolerance * std::max(1.0, kStressThatMatters / top) + kLoserShare * below};
}

Target place_target(const HumpSample& s, std::size_t hump) {
  const Hump& h = s.humps[hump];
  const double half_width = 0.5 * (ln_place(h.plateau_to) - ln_place(h.plateau_from));
  const double below = 1.0 - std::max(h.output.sigma_over_p / largest_stress(s), 0.0);
  return {ln_place(h.output.lbreak_over_lc),
          std::max(kPlateauShare * half_width, kPlaceTolerance) * (1.0 + kLoserPlace * below)};
}

Normalisation z_score(const Eigen::VectorXd& values) {
  const double mean = values.mean();
  const double deviation = std::sqrt((values.array() - mean).square().mean());
  const double floor = 1e-9 * std::max(1.0, std::abs(mean));  // round-off of a constant column
  return {mean, deviation > floor ? deviation : 1.0};
}

/// All rows with their features; the features' normalisation goes into `p`.
Eigen::MatrixXd normalised_features(std::span<const HumpSample> samples, HumpParameters& p) {
  Eigen::MatrixXd x(kHumpFeatures, static_cast<Eigen::Index>(samples.size()));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto features = hump_features_of(samples[i].input);
    for (std::size_t k = 0; k < features.size(); ++k) x(Eigen::Index(k), Eigen::Index(i)) = features[k];
  }
  for (Eigen::Index k = 0; k < x.rows(); ++k) {
    const Normalisation n = z_score(x.row(k).transpose());
    p.features[static_cast<std::size_t>(k)] = n;
    x.row(k).array() = (x.row(k).array() - n.offset) / n.factor;
  }
  return x;
}

struct Split {
  std::vector<Eigen::Index> training, validation;
};

Split split_rows(std::size_t n, int validate_every) {
  Split split;
  for (std::size_t i = 0; i < n; ++i) {
    (i % static_cast<std::size_t>(validate_every) == 0 ? split.validation : split.training).push_back(Eigen::Index(i));
  }
  return split;
}

LayeredRows select(const Eigen::MatrixXd& x, const Eigen::VectorXd& y, const Eigen::VectorXd& tolerance,
                   const std::vector<Eigen::Index>& rows) {
  return {x(Eigen::all, rows), y(rows), tolerance(rows)};
}

/// Trains one network for target(row).
template <typename MakeTarget>
LayeredFit train_one(std::span<const HumpSample> samples, const Eigen::MatrixXd& x, MakeTarget target,
                     const HumpTrainingOptions& options, unsigned long number, LayeredNetwork& network) {
  Eigen::VectorXd y(x.cols()), tolerance(x.cols());
  for (Eigen::Index i = 0; i < x.cols(); ++i) {
    const Target t = target(samples[static_cast<std::size_t>(i)]);
    y[i] = t.value;
    tolerance[i] = t.tolerance;
  }
  network.target = z_score(y);
  y = (y.array() - network.target.offset) / network.target.factor;
  tolerance /= network.target.factor;
  const Split split = split_rows(samples.size(), options.validate_every);
  constexpr unsigned long kStride = 7919;  // keeps the networks of neighbouring seeds apart
  return fit_layers(select(x, y, tolerance, split.training), select(x, y, tolerance, split.validation), options,
                    static_cast<unsigned long>(options.seed) * kStride + number + 1, network.weights);
}

Range range_of(std::span<const HumpSample> samples) {
  auto lower = to_array(samples.front().input), upper = lower;
  for (const HumpSample& s : samples) {
    const auto x = to_array(s.input);
    for (int i = 0; i < kInputs; ++i) {
      lower[i] = std::min(lower[i], x[i]);
      upper[i] = std::max(upper[i], x[i]);
    }
  }
  return {to_input(lower), to_input(upper)};
}

}  // namespace

TrainedHumps train_humps(std::span<const HumpSample> samples, const HumpTrainingOptions& options) {
  BRASH_EXPECTS(options.validate_every > 1 && options.validate_every % 2 == 1 && options.max_iterations > 0,
                options.validate_every);
  const std::size_t n_learned = samples.size() - (samples.size() + options.validate_every - 1) / options.validate_every;
  if (n_learned < n_weights(kHumpFeatures, options.hidden)) {
    throw InputError(fmt::format("{} rows cannot fix {} weights of a network; raise `geometries` in the plan",
                                 n_learned, n_weights(kHumpFeatures, options.hidden)));
  }
  HumpParameters p;
  p.hidden = options.hidden;
  p.range = range_of(samples);
  p.thickness_over_lc = options.thickness_over_lc;
  p.data_sha256 = options.data_sha256;
  const Eigen::MatrixXd x = normalised_features(samples, p);
  std::vector<LayeredFit> fits;
  for (std::size_t hump = 0; hump < kHumps; ++hump) {
    fits.push_back(train_one(
        samples, x, [hump](const HumpSample& s) { return stress_target(s, hump); }, options, 2 * hump, p.stress[hump]));
    fits.back().name = fmt::format("{} hump, {}", kHumpNames[hump], kHumpTargets[0]);
    fits.push_back(train_one(
        samples, x, [hump](const HumpSample& s) { return place_target(s, hump); }, options, 2 * hump + 1,
        p.place[hump]));
    fits.back().name = fmt::format("{} hump, {}", kHumpNames[hump], kHumpTargets[1]);
  }
  return {HumpNetwork(std::move(p)), std::move(fits)};
}

}  // namespace brash::training
