// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "mesh.hpp"

namespace brash::plate {

/// Deep water of density 1 under a floating sheet, as the sheet feels it when it accelerates: potential flow that is at
/// rest far away, with zero potential on the open water around the sheet (waves on it are slow).
///
/// The potential on the sheet is continuous and linear on the triangles of the sheet's mesh, and solves
/// int int grad phi(x) . grad psi(y) / (2 pi |x - y|) = int v psi for the velocity v of the sheet (Galerkin's boundary
/// elements). A mesh with a line of symmetry on the x-axis represents both of its sides.
/// @see docs/theory/fracture-of-the-edge.md, (W2), (W3)
class WaterUnderSheet {
 public:
  /// @param order  of the deflection on every triangle.
  WaterUnderSheet(const Mesh& mesh, int order);

  /// The loads on the elements that accelerate the water with the sheet.
  /// @param deflections  nodal values on every element, shape=(n_lagrange, n_elements).
  Eigen::MatrixXd inertia(const Eigen::MatrixXd& deflections) const;

  /// The potential at the vertices for those velocities, shape=(n_vertices,).
  Eigen::VectorXd potential(const Eigen::MatrixXd& velocities) const;

 private:
  const Mesh* mesh_;
  Eigen::MatrixXd moments_;   ///< int lambda_a phi_j on the reference triangle, shape=(3, n_lagrange)
  Eigen::VectorXd area2_;     ///< twice the area of every element
  std::vector<int> unknown_;  ///< of every vertex; -1 on open water
  Eigen::LLT<Eigen::MatrixXd> factor_;
};

}  // namespace brash::plate
