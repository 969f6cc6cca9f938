// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <vector>

#include "brash/plate/plate.hpp"
#include "dissection.hpp"
#include "mesh.hpp"

namespace brash::plate {

/// Even loads on an edge of the mesh, per unit of its length.
struct EdgeForce {
  int edge = 0;
  Vec2 in_plane{};
  double out_of_plane = 0.0;
  double moment = 0.0;
  Vec2 outward{};  ///< unit normal out of the ice
};

/// A force out of the plane at a point of the reference triangle.
struct PointForce {
  int triangle = 0;
  double xi = 0.0;
  double eta = 0.0;
  double out_of_plane = 0.0;
};

/// Displacements of plane stress, in units of E h / (1 - nu^2) = 1; clamped on the edges tagged kFar.
///
/// @return the local unknowns of every triangle, shape=(2 n_lagrange, n_triangles), as `solve_membrane`.
Eigen::MatrixXd solve_sheet_membrane(const Mesh& mesh, const Dissection& dissection, int order, double poisson_ratio,
                                     const std::vector<EdgeForce>& forces);

/// A floating sheet that is bent, in units of k = l_c = D = 1.
struct SheetBending {
  double poisson_ratio = 0.3;
  double shear_stiffness = 0.0;     ///< kappa G h l_c^2 / D
  std::vector<int> triangles;       ///< those that bend, the others stay at rest
  const Eigen::MatrixXd* membrane;  ///< displacements whose stress acts on the slope of the deflection; may be null
  int membrane_order = 3;
};

/// Deflection and rotations, free on every edge. The rotation across the edges tagged kCrack, which lie on the x-axis,
/// has two values.
///
/// @return the local unknowns of every triangle, shape=(n_lagrange + 2 n_rotation, n_triangles), zero where the sheet
/// stays at rest; nothing where it buckles.
std::optional<Eigen::MatrixXd> solve_sheet_bending(const Mesh& mesh, const Dissection& dissection, int order,
                                                   const SheetBending& sheet, const std::vector<EdgeForce>& edge_forces,
                                                   const std::vector<PointForce>& point_forces);

/// Jacobian of the map from the reference triangle.
Eigen::Matrix2d jacobian_of(const Mesh& mesh, int triangle);

/// (1 - nu) e + nu tr(e) 1 of the vector field with these gradients, d_j u_i.
Tensor2 elastic(const Eigen::Matrix2d& gradient, double poisson_ratio);

}  // namespace brash::plate
