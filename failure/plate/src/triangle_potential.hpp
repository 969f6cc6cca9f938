// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>
#include <vector>

#include "brash/core/vec.hpp"
#include "mesh.hpp"

namespace brash::plate {

/// int dA / |x - place| over a plane triangle, for a place of its plane, in closed form.
double potential(const std::array<Vec2, 3>& triangle, Vec2 place);

/// Mutual potentials of the triangles of a mesh, G(i, j) = int int dA_i dA_j / (2 pi |x_i - x_j|), shape=(n_triangles,
/// n_triangles), symmetric.
///
/// The potential of the larger triangle is exact where they are near each other, and both integrals are of Gauss'
/// rules elsewhere.
/// @param reflected  whether the triangles j are reflected about the x-axis first.
Eigen::MatrixXd mutual_potentials(const Mesh& mesh, bool reflected);

}  // namespace brash::plate
