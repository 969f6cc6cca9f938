// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <functional>
#include <memory>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace brash::plate {

/// A symmetric positive definite finite element system whose interior unknowns are eliminated element by element.
class CondensedSystem {
 public:
  /// @param n_unknowns  unknowns that elements share.
  /// @param n_loads     right-hand sides.
  /// @param interior    local numbers of the unknowns inside each element; the rest, in order, are shared.
  CondensedSystem(int n_unknowns, int n_loads, int n_elements, int n_local, std::vector<int> interior);

  /// Adds the next element.
  /// @param stiffness  shape=(n_local, n_local), symmetric.
  /// @param load       shape=(n_local, n_loads).
  /// @param unknowns   global number of each shared local unknown, -1 where it is held at zero.
  void add(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& load, const std::vector<int>& unknowns);

  /// Adds to right-hand side number `which`.
  void add_load(int unknown, int which, double value) {
    if (unknown >= 0) load_(unknown, which) += value;
  }

  /// Factorises once and solves; for each load the local unknowns of every element, shape=(n_local, n_elements).
  tl::expected<std::vector<Eigen::MatrixXd>, std::string> solve();

  /// After solve(), with the same factors: the answer to other loads on the elements, shape=(n_local, n_elements) both.
  Eigen::MatrixXd solve_again(const Eigen::MatrixXd& element_loads) const;

 private:
  Eigen::MatrixXd expand(const Eigen::VectorXd& solution,
                         const std::function<Eigen::VectorXd(std::size_t)>& inner) const;

  std::vector<int> interior_;
  std::vector<int> shared_;
  Eigen::MatrixXd load_;
  std::vector<Eigen::Triplet<double>> entries_;  ///< lower triangle
  std::vector<std::vector<int>> unknowns_;
  std::vector<Eigen::MatrixXd> elimination_;    ///< K_ii^-1 K_ib and, in the last columns, K_ii^-1 f_i
  std::vector<Eigen::MatrixXd> inner_inverse_;  ///< K_ii^-1
  std::unique_ptr<Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower>> factor_;  ///< from solve() on
  int n_local_;
};

}  // namespace brash::plate
