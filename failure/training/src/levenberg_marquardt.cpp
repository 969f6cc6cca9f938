// SPDX-License-Identifier: GPL-3.0-or-later
#include "levenberg_marquardt.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

#include <cmath>
#include <memory>

#include "brash/core/contract.hpp"

namespace brash::training {

using namespace meta_model;

namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The step is done when the weights move relatively less than this; far below the resolution of the validation loss.
constexpr double kWeightTolerance = 1e-10;

struct Problem {
  WeightLayout layout;
  const NormalisedRows* rows;
};

Eigen::Map<const RowMatrix> w1_of(const WeightLayout& l, const double* w) { return {w, l.hidden, kInputs}; }
Eigen::Map<const Vector> b1_of(const WeightLayout& l, const double* w) { return {w + l.b1(), l.hidden}; }
Eigen::Map<const RowMatrix> w2_of(const WeightLayout& l, const double* w) { return {w + l.w2(), l.outputs, l.hidden}; }
Eigen::Map<const Vector> b2_of(const WeightLayout& l, const double* w) { return {w + l.b2(), l.outputs}; }

/// S(W1 X + b1), shape=(hidden, n).
Matrix hidden_units(const WeightLayout& layout, const double* w, const Matrix& x) {
  Matrix a = w1_of(layout, w) * x;
  a.colwise() += b1_of(layout, w);
  return (1.0 / (1.0 + (-a.array()).exp())).matrix();
}

/// (y_predicted - y) / tolerance, shape=(outputs, n).
Matrix residuals(const WeightLayout& layout, const double* w, const NormalisedRows& rows, const Matrix& s) {
  Matrix y = w2_of(layout, w) * s;
  y.colwise() += b2_of(layout, w);
  return ((y - rows.y).array() / rows.tolerance.array()).matrix();
}

int evaluate(const gsl_vector* weights, void* context, gsl_vector* f) {
  const Problem& problem = *static_cast<const Problem*>(context);
  const Matrix s = hidden_units(problem.layout, weights->data, problem.rows->x);
  const Matrix r = residuals(problem.layout, weights->data, *problem.rows, s);
  if (!r.allFinite()) return GSL_EDOM;
  // Residual k of row i has the index outputs i + k: the column-major order of r.
  Eigen::Map<Vector>(f->data, r.size()) = Eigen::Map<const Vector>(r.data(), r.size());
  return GSL_SUCCESS;
}

int differentiate(const gsl_vector* weights, void* context, gsl_matrix* jacobian) {
  const Problem& problem = *static_cast<const Problem*>(context);
  const WeightLayout& l = problem.layout;
  const NormalisedRows& rows = *problem.rows;
  const Matrix s = hidden_units(l, weights->data, rows.x);
  const auto w2 = w2_of(l, weights->data);
  gsl_matrix_set_zero(jacobian);
  for (Eigen::Index row = 0; row < rows.x.cols(); ++row) {
    for (int k = 0; k < l.outputs; ++k) {
      double* d = jacobian->data + static_cast<std::size_t>(l.outputs * row + k) * jacobian->tda;
      const double scale = 1.0 / rows.tolerance(k, row);
      for (int j = 0; j < l.hidden; ++j) {
        const double unit = s(j, row);
        const double slope = scale * w2(k, j) * unit * (1.0 - unit);
        for (int i = 0; i < kInputs; ++i) d[j * kInputs + i] = slope * rows.x(i, row);
        d[l.b1() + j] = slope;
        d[l.w2() + k * l.hidden + j] = scale * unit;
      }
      d[l.b2() + k] = scale;
    }
  }
  return GSL_SUCCESS;
}

struct FreeRng {
  void operator()(gsl_rng* rng) const { gsl_rng_free(rng); }
};
struct FreeVector {
  void operator()(gsl_vector* vector) const { gsl_vector_free(vector); }
};
struct FreeWorkspace {
  void operator()(gsl_multifit_nlinear_workspace* w) const { gsl_multifit_nlinear_free(w); }
};

/// Small random weights: hidden units start in different directions and unsaturated, outputs near their mean.
std::unique_ptr<gsl_vector, FreeVector> random_weights(const WeightLayout& layout, std::uint64_t seed, int number) {
  const std::unique_ptr<gsl_rng, FreeRng> rng(gsl_rng_alloc(gsl_rng_ranlxd2));
  constexpr unsigned long kStride = 7919;  // keeps the starts of neighbouring seeds apart
  gsl_rng_set(rng.get(), static_cast<unsigned long>(seed) * kStride + static_cast<unsigned long>(number) + 1);
  std::unique_ptr<gsl_vector, FreeVector> w(gsl_vector_alloc(static_cast<std::size_t>(layout.size())));
  for (int i = 0; i < layout.size(); ++i) {
    const double deviation = i < layout.w2() ? 1.0 : 0.3;
    gsl_vector_set(w.get(), static_cast<std::size_t>(i), gsl_ran_gaussian(rng.get(), deviation));
  }
  return w;
}

std::unique_ptr<gsl_multifit_nlinear_workspace, FreeWorkspace> make_solver(std::size_t n, std::size_t p) {
  gsl_multifit_nlinear_parameters parameters = gsl_multifit_nlinear_default_parameters();
  parameters.trs = gsl_multifit_nlinear_trs_lm;
  parameters.scale = gsl_multifit_nlinear_scale_levenberg;
  parameters.solver = gsl_multifit_nlinear_solver_cholesky;
  return std::unique_ptr<gsl_multifit_nlinear_workspace, FreeWorkspace>(
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &parameters, n, p));
}

Vector position(const gsl_multifit_nlinear_workspace* solver) {
  const gsl_vector* w = gsl_multifit_nlinear_position(solver);
  Vector result(static_cast<Eigen::Index>(w->size));
  for (std::size_t i = 0; i < w->size; ++i) result[static_cast<Eigen::Index>(i)] = gsl_vector_get(w, i);
  return result;
}

}  // namespace

double loss(const WeightLayout& layout, const Vector& weights, const NormalisedRows& rows) {
  const Matrix s = hidden_units(layout, weights.data(), rows.x);
  return residuals(layout, weights.data(), rows, s).squaredNorm() / static_cast<double>(rows.y.size());
}

StartResult fit_from_random_start(const WeightLayout& layout, const NormalisedRows& training,
                                  const NormalisedRows& validation, const TrainingOptions& options, int number) {
  gsl_set_error_handler_off();  // every code is checked below
  Problem problem{layout, &training};
  const auto n = static_cast<std::size_t>(training.y.size());
  const auto p = static_cast<std::size_t>(layout.size());
  BRASH_EXPECTS(n >= p, n, p);

  gsl_multifit_nlinear_fdf system{};
  system.f = evaluate;
  system.df = differentiate;
  system.n = n;
  system.p = p;
  system.params = &problem;
  const auto solver = make_solver(n, p);
  const auto first = random_weights(layout, options.seed, number);
  int code = gsl_multifit_nlinear_init(first.get(), &system, solver.get());
  BRASH_EXPECTS(code == GSL_SUCCESS, gsl_strerror(code));

  StartResult best{position(solver.get()), {.ended = "iterations"}};
  best.start.validation_loss = loss(layout, best.weights, validation);
  int last_gain = 0;
  for (int iteration = 1; iteration <= options.max_iterations; ++iteration) {
    code = gsl_multifit_nlinear_iterate(solver.get());
    best.start.iterations = iteration;
    if (code != GSL_SUCCESS) {
      best.start.ended = code == GSL_ENOPROG ? "no smaller loss found" : gsl_strerror(code);
      break;
    }
    const Vector weights = position(solver.get());
    if (const double now = loss(layout, weights, validation); now < best.start.validation_loss) {
      best.start.validation_loss = now;
      best.weights = weights;
      last_gain = iteration;
    } else if (iteration - last_gain >= options.patience) {
      best.start.ended = "patience";
      break;
    }
    int info = 0;
    if (gsl_multifit_nlinear_test(kWeightTolerance, 0.0, 0.0, &info, solver.get()) == GSL_SUCCESS) {
      best.start.ended = "converged";
      break;
    }
  }
  best.start.training_loss = loss(layout, best.weights, training);
  return best;
}

}  // namespace brash::training
