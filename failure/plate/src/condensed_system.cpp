// SPDX-License-Identifier: GPL-3.0-or-later
#include "condensed_system.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>

#include "brash/core/contract.hpp"

namespace brash::plate {

CondensedSystem::CondensedSystem(int n_unknowns, int n_loads, int n_elements, int n_local, std::vector<int> interior)
    : interior_(std::move(interior)), load_(Eigen::MatrixXd::Zero(n_unknowns, n_loads)), n_local_(n_local) {
  for (int i = 0; i < n_local; ++i) {
    if (std::find(interior_.begin(), interior_.end(), i) == interior_.end()) shared_.push_back(i);
  }
  entries_.reserve(static_cast<std::size_t>(n_elements) * shared_.size() * (shared_.size() + 1) / 2);
  unknowns_.reserve(static_cast<std::size_t>(n_elements));
  elimination_.reserve(static_cast<std::size_t>(n_elements));
}

void CondensedSystem::add(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& load,
                          const std::vector<int>& unknowns) {
  BRASH_EXPECTS(unknowns.size() == shared_.size(), unknowns.size(), shared_.size());
  const auto n_shared = static_cast<Eigen::Index>(shared_.size());
  Eigen::MatrixXd condensed = stiffness(shared_, shared_);
  Eigen::MatrixXd shared_load = load(shared_, Eigen::all);
  Eigen::MatrixXd elimination(static_cast<Eigen::Index>(interior_.size()), n_shared + load_.cols());
  if (!interior_.empty()) {
    const Eigen::MatrixXd coupling = stiffness(interior_, shared_);
    elimination.leftCols(n_shared) = coupling;
    elimination.rightCols(load_.cols()) = load(interior_, Eigen::all);
    const Eigen::MatrixXd inner = stiffness(interior_, interior_);
    elimination = inner.llt().solve(elimination).eval();
    condensed.noalias() -= coupling.transpose() * elimination.leftCols(n_shared);
    shared_load.noalias() -= coupling.transpose() * elimination.rightCols(load_.cols());
  }
  for (Eigen::Index j = 0; j < n_shared; ++j) {
    const int column = unknowns[static_cast<std::size_t>(j)];
    if (column < 0) continue;
    load_.row(column) += shared_load.row(j);
    for (Eigen::Index i = 0; i < n_shared; ++i) {
      const int row = unknowns[static_cast<std::size_t>(i)];
      if (row >= column) entries_.emplace_back(row, column, condensed(i, j));
    }
  }
  unknowns_.push_back(unknowns);
  elimination_.push_back(std::move(elimination));
}

tl::expected<std::vector<Eigen::MatrixXd>, std::string> CondensedSystem::solve() const {
  Eigen::SparseMatrix<double> matrix(load_.rows(), load_.rows());
  matrix.setFromTriplets(entries_.begin(), entries_.end());
  const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower> factor(matrix);
  if (factor.info() != Eigen::Success) return tl::unexpected(std::string("the stiffness is not positive definite"));
  const Eigen::MatrixXd solutions = factor.solve(load_);
  std::vector<Eigen::MatrixXd> result;
  for (Eigen::Index which = 0; which < solutions.cols(); ++which) {
    result.push_back(expand(solutions.col(which), which));
  }
  return result;
}

Eigen::MatrixXd CondensedSystem::expand(const Eigen::VectorXd& solution, Eigen::Index which) const {
  Eigen::MatrixXd local(n_local_, static_cast<Eigen::Index>(unknowns_.size()));
  const auto n_shared = static_cast<Eigen::Index>(shared_.size());
  for (std::size_t e = 0; e < unknowns_.size(); ++e) {
    Eigen::VectorXd shared(n_shared);
    for (Eigen::Index i = 0; i < n_shared; ++i) {
      const int unknown = unknowns_[e][static_cast<std::size_t>(i)];
      shared(i) = unknown >= 0 ? solution(unknown) : 0.0;
    }
    const auto column = static_cast<Eigen::Index>(e);
    local(shared_, column) = shared;
    if (interior_.empty()) continue;
    local(interior_, column) = elimination_[e].col(n_shared + which) - elimination_[e].leftCols(n_shared) * shared;
  }
  return local;
}

}  // namespace brash::plate
