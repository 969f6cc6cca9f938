// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <vector>

#include "mesh.hpp"
#include "recovery.hpp"

namespace brash::plate {

/// Maps the rotations of any bending field on a mesh to its recovered moments on the x-axis, as recover_tensor does.
/// For many fields on one mesh: the patches are fitted once.
class AxisMoments {
 public:
  AxisMoments(const Mesh& mesh, int order, double poisson_ratio, const std::vector<double>& stations, Parity parity);

  /// The moments xx, then yy, at the stations, shape=(2 n_stations,).
  /// @param local  unknowns of every element as of BendingSystem.
  Eigen::VectorXd operator()(const Eigen::MatrixXd& local) const;

 private:
  int order_;
  Eigen::SparseMatrix<double, Eigen::RowMajor> operator_;  ///< on the rotations, element by element
};

}  // namespace brash::plate
