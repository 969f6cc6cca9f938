// SPDX-License-Identifier: GPL-3.0-or-later
#include "condensed_system.hpp"

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
    const Eigen::LLT<Eigen::MatrixXd> inner_factor(inner);
    elimination = inner_factor.solve(elimination).eval();
    inner_inverse_.push_back(inner_factor.solve(Eigen::MatrixXd::Identity(inner.rows(), inner.cols())));
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

tl::expected<std::vector<Eigen::MatrixXd>, std::string> CondensedSystem::solve() {
  Eigen::SparseMatrix<double> matrix(load_.rows(), load_.rows());
  matrix.setFromTriplets(entries_.begin(), entries_.end());
  factor_ = std::make_unique<decltype(factor_)::element_type>(matrix);
  if (factor_->info() != Eigen::Success) return tl::unexpected(std::string("the stiffness is not positive definite"));
  const Eigen::MatrixXd solutions = factor_->solve(load_);
  const auto n_shared = static_cast<Eigen::Index>(shared_.size());
  std::vector<Eigen::MatrixXd> result;
  for (Eigen::Index which = 0; which < solutions.cols(); ++which) {
    result.push_back(
        expand(solutions.col(which), [&](std::size_t e) { return elimination_[e].col(n_shared + which); }));
  }
  return result;
}

Eigen::MatrixXd CondensedSystem::solve_again(const Eigen::MatrixXd& element_loads) const {
  BRASH_EXPECTS(factor_ && element_loads.rows() == n_local_, element_loads.rows(), n_local_);
  const auto n_shared = static_cast<Eigen::Index>(shared_.size());
  Eigen::VectorXd load = Eigen::VectorXd::Zero(load_.rows());
  for (std::size_t e = 0; e < unknowns_.size(); ++e) {
    const auto column = element_loads.col(static_cast<Eigen::Index>(e));
    Eigen::VectorXd shared = column(shared_);
    if (!interior_.empty()) shared -= elimination_[e].leftCols(n_shared).transpose() * column(interior_);
    for (Eigen::Index i = 0; i < n_shared; ++i) {
      const int unknown = unknowns_[e][static_cast<std::size_t>(i)];
      if (unknown >= 0) load(unknown) += shared(i);
    }
  }
  return expand(factor_->solve(load), [&](std::size_t e) -> Eigen::VectorXd {
    return inner_inverse_[e] * element_loads.col(static_cast<Eigen::Index>(e))(interior_);
  });
}

/// The local unknowns of every element; `inner(e)` is K_ii^-1 f_i of element e.
Eigen::MatrixXd CondensedSystem::expand(const Eigen::VectorXd& solution,
                                        const std::function<Eigen::VectorXd(std::size_t)>& inner) const {
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
    if (!interior_.empty()) local(interior_, column) = inner(e) - elimination_[e].leftCols(n_shared) * shared;
  }
  return local;
}

}  // namespace brash::plate
