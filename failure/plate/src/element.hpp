// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>

#include "brash/core/vec.hpp"

namespace brash::plate {

/// The reference triangle of the plate element of order k and every integral on it that an affine element needs.
///
/// Deflection: Lagrange P_k. Rotations: P_k and k - 1 bubbles of degree k + 1 each. Shear: rotated Raviart-Thomas space
/// RT_{k-1}, onto which the rotations are reduced by their tangential moments on the edges (degree k - 1) and moments
/// inside (degree k - 2): the family of Brezzi, Fortin and Stenberg (MITC7 is k = 2), free of locking for every
/// thickness. Node order: 3 vertices, k - 1 nodes on each edge (0-1, 1-2, 2-0), the Lagrange nodes inside, the bubbles.
class ReferenceElement {
 public:
  /// @param order  k, 2 to 4.
  explicit ReferenceElement(int order);

  int order() const { return order_; }
  int n_lagrange() const { return (order_ + 1) * (order_ + 2) / 2; }
  int n_boundary() const { return 3 * order_; }
  int n_rotation() const { return n_lagrange() + order_ - 1; }
  int n_shear() const { return order_ * (order_ + 2); }

  /// Values, shape=(n_rotation,), and gradients, shape=(n_rotation, 2), of the Lagrange functions and the bubbles.
  Eigen::VectorXd values(double xi, double eta) const;
  Eigen::MatrixX2d gradients(double xi, double eta) const;

  /// Integrals of products of derivatives; stiffness(a, b)(i, j) = int d_a phi_i d_b phi_j, shape=(n_rotation,
  /// n_rotation).
  const Eigen::MatrixXd& stiffness(int a, int b) const { return stiffness_[index(a, b)]; }
  /// int phi_i phi_j of the Lagrange functions.
  const Eigen::MatrixXd& mass() const { return mass_; }
  /// int phi_i of the Lagrange functions.
  const Eigen::VectorXd& load() const { return load_; }
  /// Integrals of the functions of the unit edge 0-1 along it, end to end: the nodal loads of an even load.
  Eigen::VectorXd edge_load() const;
  /// Shear coefficients of the gradient of the deflection, shape=(n_shear, n_lagrange).
  const Eigen::MatrixXd& shear_of_deflection() const { return shear_of_deflection_; }
  /// Shear coefficients of the covariant rotation component a, shape=(n_shear, n_rotation).
  const Eigen::MatrixXd& shear_of_rotation(int a) const { return shear_of_rotation_[static_cast<std::size_t>(a)]; }
  /// Integrals of products of the components a and b of the shear functions.
  const Eigen::MatrixXd& shear_gram(int a, int b) const { return shear_gram_[index(a, b)]; }

 private:
  static std::size_t index(int a, int b) { return static_cast<std::size_t>(2 * a + b); }
  Eigen::VectorXd monomials(double xi, double eta) const;
  Eigen::MatrixX2d monomial_gradients(double xi, double eta) const;
  Eigen::MatrixX2d shear_basis(double xi, double eta) const;
  void build_lagrange();
  void build_integrals();
  void build_shear();
  template <typename Field>
  Eigen::MatrixXd shear_moments(const Field& field, int n_fields) const;

  int order_;
  Eigen::MatrixXd coefficients_;  ///< Lagrange basis in monomials, shape=(n_lagrange, n_lagrange)
  std::array<Eigen::MatrixXd, 4> stiffness_;
  Eigen::MatrixXd mass_;
  Eigen::VectorXd load_;
  Eigen::MatrixXd shear_of_deflection_;
  std::array<Eigen::MatrixXd, 2> shear_of_rotation_;
  std::array<Eigen::MatrixXd, 4> shear_gram_;
};

/// The reference element of that order, built once.
const ReferenceElement& reference_element(int order);

}  // namespace brash::plate
