// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace brash::meta_model {

/// Interpolates vectors between scattered points: fifth powers of the distances to the points and a polynomial of
/// degree 2, so it passes through all the points and reproduces quadratics.
struct Interpolant {
  Eigen::VectorXd offset;      ///< of the features, shape=(n_features,)
  Eigen::VectorXd factor;      ///< of the features; distances are measured in (feature - offset) / factor
  Eigen::MatrixXd centres;     ///< normalised points, shape=(n_features, n_centres)
  Eigen::MatrixXd weights;     ///< of the powers of the distances, shape=(n_values, n_centres)
  Eigen::MatrixXd polynomial;  ///< of the terms of polynomial_terms(), shape=(n_values, n_terms)

  /// The values at a point, features not normalised.
  Eigen::VectorXd operator()(const Eigen::VectorXd& features) const;
};

/// Number of terms of a polynomial of degree 2.
constexpr Eigen::Index n_polynomial_terms(Eigen::Index n_features) { return (n_features + 1) * (n_features + 2) / 2; }

/// Number of features that take several values.
///
/// @param features  shape=(n_features, n_points).
Eigen::Index n_varying(const Eigen::MatrixXd& features);

/// Numbers of the points that differ from all before them.
///
/// @param features  shape=(n_features, n_points).
std::vector<Eigen::Index> distinct_points(const Eigen::MatrixXd& features);

/// @param features  of distinct points, shape=(n_features, n_points); more points than the polynomial of the varying
///                  features has terms. With fewer, the distances have no weight.
/// @param values    shape=(n_values, n_points).
/// @param lengths   how far each feature's deviation reaches compared with the others', shape=(n_features,).
Interpolant interpolate(const Eigen::MatrixXd& features, const Eigen::MatrixXd& values, const Eigen::VectorXd& lengths);

}  // namespace brash::meta_model
