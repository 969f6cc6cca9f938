// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace brash::meta_model {

/// Interpolates along one axis of a grid: by cubic splines without a knot beside the ends, by a polynomial through all
/// points where there are less than five.
class GridAxis {
 public:
  GridAxis() = default;
  /// @param points  rising.
  explicit GridAxis(std::vector<double> points);

  /// The weights of the points for the value at `x`, shape=(n_points,). Beyond the ends the spline continues.
  Eigen::VectorXd weights(double x) const;

 private:
  std::vector<double> points_;
  Eigen::MatrixXd curvatures_;  ///< second derivatives of the spline at the points, per value there
};

}  // namespace brash::meta_model
