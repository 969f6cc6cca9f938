// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpolant.hpp"

#include <Eigen/Dense>
#include <algorithm>

#include "brash/core/contract.hpp"

namespace brash::meta_model {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Points nearer than this (in normalised features) are one point to the interpolation.
constexpr double kSamePoint = 1e-5;
/// A feature that deviates less than this takes one value.
constexpr double kNoSpread = 1e-12;
/// Keeps at zero the terms of the polynomial that the points cannot distinguish. The kernel's values are of order 1
/// and more.
constexpr double kRidge = 1e-10;

/// Root mean squares of the deviations from `middle`.
VectorXd spread_of(const MatrixXd& features, const VectorXd& middle) {
  return (features.colwise() - middle).rowwise().norm() / std::sqrt(double(features.cols()));
}

MatrixXd normalised(const MatrixXd& features, const VectorXd& offset, const VectorXd& factor) {
  return factor.cwiseInverse().asDiagonal() * (features.colwise() - offset);
}

/// Distances to the power 5, shape=(n_centres,).
VectorXd kernels(const MatrixXd& centres, const VectorXd& at) {
  const Eigen::ArrayXd square = (centres.colwise() - at).colwise().squaredNorm().transpose();
  return square.square() * square.sqrt();
}

/// 1, the features, and the products of two features.
VectorXd polynomial_terms(const VectorXd& x) {
  VectorXd terms(n_polynomial_terms(x.size()));
  terms(0) = 1.0;
  terms.segment(1, x.size()) = x;
  for (Index i = 0, n = 1 + x.size(); i < x.size(); ++i) {
    for (Index j = i; j < x.size(); ++j) terms(n++) = x(i) * x(j);
  }
  return terms;
}

}  // namespace

VectorXd Interpolant::operator()(const VectorXd& features) const {
  const VectorXd at = (features - offset).cwiseQuotient(factor);
  return weights * kernels(centres, at) + polynomial * polynomial_terms(at);
}

Index n_varying(const MatrixXd& features) {
  return (spread_of(features, features.rowwise().mean()).array() >= kNoSpread).count();
}

std::vector<Index> distinct_points(const MatrixXd& features) {
  const VectorXd middle = features.rowwise().mean();
  const VectorXd spread = spread_of(features, middle);
  const MatrixXd points = normalised(features, middle, spread.cwiseMax(kNoSpread));
  std::vector<Index> kept;
  for (Index i = 0; i < points.cols(); ++i) {
    const bool same = std::any_of(kept.begin(), kept.end(),
                                  [&](Index j) { return (points.col(i) - points.col(j)).norm() < kSamePoint; });
    if (!same) kept.push_back(i);
  }
  return kept;
}

Interpolant interpolate(const MatrixXd& features, const MatrixXd& values, const VectorXd& lengths) {
  const Index n = features.cols(), p = n_polynomial_terms(features.rows());
  BRASH_EXPECTS(n == values.cols() && lengths.size() == features.rows(), n, values.cols(), lengths.size());
  BRASH_EXPECTS(n > n_polynomial_terms(n_varying(features)), n, features.rows());
  Interpolant result;
  result.offset = features.rowwise().mean();
  const VectorXd spread = spread_of(features, result.offset);
  result.factor = (spread.array() < kNoSpread).select(1.0, spread).cwiseProduct(lengths);
  result.centres = normalised(features, result.offset, result.factor);

  MatrixXd system = MatrixXd::Zero(n + p, n + p);
  for (Index i = 0; i < n; ++i) {
    system.col(i).head(n) = kernels(result.centres, result.centres.col(i));
    system.col(i).tail(p) = polynomial_terms(result.centres.col(i));
  }
  system.topRightCorner(n, p) = system.bottomLeftCorner(p, n).transpose();
  system.bottomRightCorner(p, p).diagonal().setConstant(-kRidge);
  MatrixXd right = MatrixXd::Zero(n + p, values.rows());
  right.topRows(n) = values.transpose();
  const MatrixXd solution = system.partialPivLu().solve(right);
  result.weights = solution.topRows(n).transpose();
  result.polynomial = solution.bottomRows(p).transpose();
  return result;
}

}  // namespace brash::meta_model
