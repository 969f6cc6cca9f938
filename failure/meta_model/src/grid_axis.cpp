// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid_axis.hpp"

#include <Eigen/Dense>
#include <algorithm>

#include "brash/core/contract.hpp"

namespace brash::meta_model {
namespace {

/// Fewer points take a polynomial.
constexpr std::size_t kFewest = 5;

}  // namespace

GridAxis::GridAxis(std::vector<double> points) : points_(std::move(points)) {
  BRASH_EXPECTS(!points_.empty() && std::is_sorted(points_.begin(), points_.end()), points_.size());
  if (points_.size() < kFewest) return;
  const auto n = static_cast<Eigen::Index>(points_.size());
  const auto width = [&](Eigen::Index i) {
    return points_[static_cast<std::size_t>(i) + 1] - points_[static_cast<std::size_t>(i)];
  };
  // Slopes are continuous inside; third derivatives at the second and the last but one point.
  Eigen::MatrixXd left = Eigen::MatrixXd::Zero(n, n), right = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 1; i + 1 < n; ++i) {
    left.row(i).segment(i - 1, 3) << width(i - 1) / 6.0, (width(i - 1) + width(i)) / 3.0, width(i) / 6.0;
    right.row(i).segment(i - 1, 3) << 1.0 / width(i - 1), -1.0 / width(i - 1) - 1.0 / width(i), 1.0 / width(i);
  }
  for (const auto& [row, first] : {std::pair<Eigen::Index, Eigen::Index>(0, 0), {n - 1, n - 3}})
    left.row(row).segment(first, 3) << 1.0 / width(first), -1.0 / width(first) - 1.0 / width(first + 1),
        1.0 / width(first + 1);
  curvatures_ = left.partialPivLu().solve(right);
}

Eigen::VectorXd GridAxis::weights(double x) const {
  const auto n = static_cast<Eigen::Index>(points_.size());
  Eigen::VectorXd result = Eigen::VectorXd::Zero(n);
  if (points_.size() < kFewest) {
    for (Eigen::Index i = 0; i < n; ++i) {
      result(i) = 1.0;
      for (Eigen::Index j = 0; j < n; ++j) {
        const double at = points_[static_cast<std::size_t>(i)], other = points_[static_cast<std::size_t>(j)];
        if (j != i) result(i) *= (x - other) / (at - other);
      }
    }
    return result;
  }
  const auto above = std::upper_bound(points_.begin() + 1, points_.end() - 1, x) - points_.begin();
  const Eigen::Index i = above - 1;
  const double width = points_[static_cast<std::size_t>(above)] - points_[static_cast<std::size_t>(i)];
  const double b = (x - points_[static_cast<std::size_t>(i)]) / width, a = 1.0 - b;
  result(i) = a;
  result(i + 1) = b;
  result += width * width / 6.0 *
            ((a * a * a - a) * curvatures_.row(i) + (b * b * b - b) * curvatures_.row(i + 1)).transpose();
  return result;
}

}  // namespace brash::meta_model
