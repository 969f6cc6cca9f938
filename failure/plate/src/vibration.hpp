// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <functional>

#include "fem.hpp"
#include "water.hpp"

namespace brash::plate {

/// A plate on moving water, K w + M w_tt = f (docs/theory/fracture-of-the-edge.md, (W1), (W6)), in the Krylov space of
/// K^-1 M from its static answer K^-1 f. There the motion is a sum of free vibrations, exact in time.
struct Vibration {
  Eigen::MatrixXd outputs;  ///< of the vectors of the space, shape=(n_outputs, n_vectors); the first is K^-1 f scaled
  double at_rest = 0.0;     ///< coefficient of the first in K^-1 f
  Eigen::VectorXd frequencies;  ///< of the vibrations, in sqrt(g / l_c)
  Eigen::MatrixXd shapes;       ///< of the vibrations in the vectors, orthonormal columns

  /// The outputs under the load f t from rest on, divided by t; t > 0.
  Eigen::VectorXd ramp(double t) const;
  /// The outputs under f at rest.
  Eigen::VectorXd at_rest_outputs() const { return at_rest * outputs.col(0); }
};

/// Linear in the local unknowns of every element.
using Outputs = std::function<Eigen::VectorXd(const Eigen::MatrixXd& local)>;

/// Lanczos' vectors with full orthogonalisation; k = 1, l_c = 1, g = 1 and the water's density is 1.
/// @param ice_mass   per area: rho_i h / (rho_w l_c).
/// @param n_vectors  the most; fewer where the space is exhausted.
Vibration reduce(const Mesh& mesh, int order, const BendingSystem& plate, const WaterUnderSheet& water, double ice_mass,
                 const Outputs& outputs_of, int n_vectors);

}  // namespace brash::plate
