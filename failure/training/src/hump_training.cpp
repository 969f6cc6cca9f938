// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/training/hump_training.hpp"

#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multilarge_nlinear.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

#include <Eigen/Core>
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <memory>

#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "brash/meta_model/features.hpp"

namespace brash::training {

using namespace meta_model;

namespace {

/// Rows as one layered network sees them.
struct LayeredRows {
  Eigen::MatrixXd x;          ///< features, normalised; shape=(n_features, n)
  Eigen::VectorXd y;          ///< target, normalised; shape=(n,)
  Eigen::VectorXd tolerance;  ///< the error of y that counts as one; shape=(n,)
};

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The step is done when the weights move relatively less than this; far below the resolution of the validation loss.
constexpr double kWeightTolerance = 1e-9;
/// Rows whose derivatives are computed together: their matrices fit the cache.
constexpr Eigen::Index kBlock = 512;

/// Where the weights of one layer stand.
struct Layer {
  Eigen::Index inputs, outputs, from;
  Eigen::Index offsets() const { return from + inputs * outputs; }
  Eigen::Map<const RowMatrix> w(const double* weights) const { return {weights + from, outputs, inputs}; }
  Eigen::Map<const Vector> b(const double* weights) const { return {weights + offsets(), outputs}; }
};

struct Problem {
  std::vector<Layer> layers;
  const LayeredRows* rows = nullptr;
};

std::vector<Layer> layers_of(Eigen::Index n_inputs, const std::vector<int>& hidden) {
  std::vector<Layer> layers;
  Eigen::Index from = 0, width = n_inputs;
  std::vector<int> widths = hidden;
  widths.push_back(1);
  for (const int units : widths) {
    layers.push_back({width, units, from});
    from += units * (width + 1);
    width = units;
  }
  return layers;
}

/// The inputs of each layer, then the outputs of the last; x has a column a row of the data.
std::vector<Matrix> forward(const std::vector<Layer>& layers, const double* w, const Matrix& x) {
  std::vector<Matrix> values{x};
  for (const Layer& layer : layers) {
    Matrix a = layer.w(w) * values.back();
    a.colwise() += layer.b(w);
    const bool last = layer.outputs == 1 && &layer == &layers.back();
    values.push_back(last ? a : Matrix((1.0 / (1.0 + (-a.array()).exp())).matrix()));
  }
  return values;
}

Vector residuals(const Problem& problem, const double* w) {
  const LayeredRows& rows = *problem.rows;
  return (forward(problem.layers, w, rows.x).back().row(0).transpose() - rows.y).cwiseQuotient(rows.tolerance);
}

/// Derivatives of the residuals of `n` rows from `first`, shape=(n, n_weights).
RowMatrix derivatives(const Problem& problem, const double* w, Eigen::Index n_weights, Eigen::Index first,
                      Eigen::Index n) {
  const auto values = forward(problem.layers, w, problem.rows->x.middleCols(first, n));
  RowMatrix d(n, n_weights);
  Matrix slope = problem.rows->tolerance.segment(first, n).cwiseInverse().transpose();  // of the outputs of a layer
  for (std::size_t k = problem.layers.size(); k-- > 0;) {
    const Layer& layer = problem.layers[k];
    for (Eigen::Index row = 0; row < n; ++row) {
      for (Eigen::Index j = 0; j < layer.outputs; ++j) {
        d.row(row).segment(layer.from + j * layer.inputs, layer.inputs) =
            slope(j, row) * values[k].col(row).transpose();
        d(row, layer.offsets() + j) = slope(j, row);
      }
    }
    if (k > 0) {
      const auto unit = values[k].array();
      slope = ((layer.w(w).transpose() * slope).array() * unit * (1.0 - unit)).matrix().eval();
    }
  }
  return d;
}

int evaluate(const gsl_vector* weights, void* context, gsl_vector* f) {
  const Vector r = residuals(*static_cast<const Problem*>(context), weights->data);
  if (!r.allFinite()) return GSL_EDOM;
  Eigen::Map<Vector>(f->data, r.size()) = r;
  return GSL_SUCCESS;
}

/// v = J u or J^T u, and J^T J (its lower half), block of rows by block.
int differentiate(CBLAS_TRANSPOSE_t transposed, const gsl_vector* weights, const gsl_vector* u, void* context,
                  gsl_vector* v, gsl_matrix* square) {
  const Problem& problem = *static_cast<const Problem*>(context);
  const Eigen::Index n = problem.rows->y.size(), p = static_cast<Eigen::Index>(weights->size);
  Matrix sum = Matrix::Zero(square != nullptr ? p : 0, square != nullptr ? p : 0);
  Vector product = Vector::Zero(transposed == CblasTrans ? p : n);
  for (Eigen::Index first = 0; first < n; first += kBlock) {
    const Eigen::Index size = std::min(kBlock, n - first);
    const RowMatrix d = derivatives(problem, weights->data, p, first, size);
    if (square != nullptr) sum.selfadjointView<Eigen::Lower>().rankUpdate(d.transpose());
    if (v == nullptr) continue;
    if (transposed == CblasTrans) {
      product += d.transpose() * Eigen::Map<const Vector>(u->data + first, size);
    } else {
      product.segment(first, size) = d * Eigen::Map<const Vector>(u->data, p);
    }
  }
  if (v != nullptr) Eigen::Map<Vector>(v->data, product.size()) = product;
  for (Eigen::Index i = 0; i < sum.rows(); ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      gsl_matrix_set(square, static_cast<std::size_t>(i), static_cast<std::size_t>(j), sum(i, j));
    }
  }
  return GSL_SUCCESS;
}

struct FreeRng {
  void operator()(gsl_rng* rng) const { gsl_rng_free(rng); }
};
struct FreeSolver {
  void operator()(gsl_multilarge_nlinear_workspace* w) const { gsl_multilarge_nlinear_free(w); }
};
using Solver = std::unique_ptr<gsl_multilarge_nlinear_workspace, FreeSolver>;

/// Hidden units start in different directions, the more inputs the smaller; outputs near their mean.
Vector first_weights(const std::vector<Layer>& layers, unsigned long seed) {
  const std::unique_ptr<gsl_rng, FreeRng> rng(gsl_rng_alloc(gsl_rng_ranlxd2));
  gsl_rng_set(rng.get(), seed);
  Vector w(layers.back().offsets() + 1);
  for (const Layer& layer : layers) {
    const double deviation = (&layer == &layers.back() ? 0.5 : 2.0) / std::sqrt(static_cast<double>(layer.inputs));
    for (Eigen::Index i = layer.from; i < layer.offsets() + layer.outputs; ++i) {
      w[i] = gsl_ran_gaussian(rng.get(), deviation);
    }
  }
  return w;
}

Solver make_solver(std::size_t n, std::size_t p) {
  gsl_multilarge_nlinear_parameters parameters = gsl_multilarge_nlinear_default_parameters();
  parameters.trs = gsl_multilarge_nlinear_trs_lm;
  parameters.scale = gsl_multilarge_nlinear_scale_levenberg;
  parameters.solver = gsl_multilarge_nlinear_solver_cholesky;
  return Solver(gsl_multilarge_nlinear_alloc(gsl_multilarge_nlinear_trust, &parameters, n, p));
}

double loss(const Problem& problem, const Vector& weights) {
  return residuals(problem, weights.data()).squaredNorm() / static_cast<double>(problem.rows->y.size());
}

Vector position(const gsl_multilarge_nlinear_workspace* solver) {
  const gsl_vector* w = gsl_multilarge_nlinear_position(solver);
  return Eigen::Map<const Vector>(w->data, static_cast<Eigen::Index>(w->size));
}

/// Fits the weights of a layered network to `training` and puts the weights with the smallest loss of `validation` into
/// `weights`; more rows than weights. The weights are in the order of LayeredNetwork.
LayeredFit fit_layers(const LayeredRows& training, const LayeredRows& validation, const HumpTrainingOptions& options,
                      unsigned long seed, std::vector<double>& weights) {
  gsl_set_error_handler_off();  // every code is checked below
  Problem problem{layers_of(training.x.rows(), options.hidden), &training};
  const Problem check{problem.layers, &validation};
  Vector best = first_weights(problem.layers, seed);
  const auto n = static_cast<std::size_t>(training.y.size()), p = static_cast<std::size_t>(best.size());
  BRASH_EXPECTS(n >= p, n, p);

  gsl_multilarge_nlinear_fdf system{};
  system.f = evaluate;
  system.df = differentiate;
  system.n = n;
  system.p = p;
  system.params = &problem;
  const Solver solver = make_solver(n, p);
  const gsl_vector_view first = gsl_vector_view_array(best.data(), p);
  int code = gsl_multilarge_nlinear_init(&first.vector, &system, solver.get());
  BRASH_EXPECTS(code == GSL_SUCCESS, gsl_strerror(code));

  LayeredFit fit{.validation_loss = loss(check, best), .ended = "iterations"};
  for (int last_gain = 0; fit.iterations < options.max_iterations;) {
    code = gsl_multilarge_nlinear_iterate(solver.get());
    ++fit.iterations;
    if (code != GSL_SUCCESS) {
      fit.ended = code == GSL_ENOPROG ? "no smaller loss found" : gsl_strerror(code);
      break;
    }
    const Vector now = position(solver.get());
    if (const double value = loss(check, now); value < fit.validation_loss) {
      fit.validation_loss = value;
      best = now;
      last_gain = fit.iterations;
    } else if (fit.iterations - last_gain >= options.patience) {
      fit.ended = "patience";
      break;
    }
    int info = 0;
    if (gsl_multilarge_nlinear_test(kWeightTolerance, 0.0, 0.0, &info, solver.get()) == GSL_SUCCESS) {
      fit.ended = "converged";
      break;
    }
  }
  fit.training_loss = loss(problem, best);
  weights.assign(best.data(), best.data() + best.size());
  return fit;
}

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
