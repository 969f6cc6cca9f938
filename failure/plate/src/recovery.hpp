// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "fem.hpp"

namespace brash::plate {

/// Parity of a field under reflection about the x-axis; kNone where the mesh covers both sides.
enum class Parity { kEven, kOdd, kNone };

/// Smooth values on the x-axis: around each vertex there a polynomial of the element's order is fitted to the samples
/// of the elements that meet in it (in the least-squares sense), and neighbouring polynomials are blended linearly.
///
/// An even field has even xx, yy and odd xy; an odd one the opposite. The fit knows it.
/// @param stations  places on the x-axis from 0, ascending, joined by edges of the mesh.
std::vector<Tensor2> recover_tensor(const Field& field, const std::vector<double>& stations, Parity parity);
std::vector<double> recover_deflection(const Field& field, const std::vector<double>& stations, Parity parity);

/// The same recovery of one even quantity (or one without parity), written as a sum over its values at the points of
/// the rule `triangle_rule(order + 1)` on some triangles; shape=(n_stations,).
struct RecoveryTerm {
  int triangle = 0;
  int point = 0;
  double weight = 0.0;
};
std::vector<std::vector<RecoveryTerm>> recovery_terms(const Mesh& mesh, int order, const std::vector<double>& stations,
                                                      Parity parity);

/// The tensor at a place off the nodes, from the element that contains it; nothing outside the mesh.
std::optional<Tensor2> tensor_at(const Field& field, Vec2 place);

/// Larger and smaller principal value.
double largest_principal(const Tensor2& t);
double smallest_principal(const Tensor2& t);

}  // namespace brash::plate
