// SPDX-License-Identifier: GPL-3.0-or-later
#include "layered_fit.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multilarge_nlinear.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

#include <Eigen/Dense>
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

}  // namespace

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

}  // namespace brash::training
