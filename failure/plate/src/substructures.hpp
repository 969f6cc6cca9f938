// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>
#include <functional>
#include <vector>

#include "dissection.hpp"

namespace brash::plate {

/// Unknowns of a finite element system. Those that belong to the same triangles form a group: of a vertex, of an edge,
/// of the inside of a triangle.
struct Numbering {
  static constexpr std::size_t kMostGroups = 10;  ///< of a triangle
  /// The unknowns from `first` on.
  struct Group {
    int first = 0;
    int size = 0;
  };
  using Groups = std::array<int, kMostGroups>;

  int n_local = 0;
  int n_unknowns = 0;
  std::vector<Group> groups;
  std::vector<Groups> groups_of;  ///< of every triangle, then -1; none where the triangle is at rest
  std::vector<int> of_element;    ///< shape=(n_triangles, n_local), -1 where held at zero

  const int* element(int triangle) const { return of_element.data() + static_cast<std::ptrdiff_t>(triangle) * n_local; }
};

/// Writes the stiffness of a triangle, shape=(n_local, n_local), symmetric.
using ElementStiffness = std::function<void(int triangle, Eigen::MatrixXd& stiffness)>;

/// Solves a symmetric positive definite system: every part of the dissection eliminates the unknowns that no triangle
/// outside it has, with dense matrices (the multifrontal method of Duff and Reid, ACM TOMS 9, 1983).
///
/// @param load  in: the right-hand side, shape=(n_unknowns,); out: the solution, where a triangle has the unknown.
/// @return whether the system is positive definite.
[[nodiscard]] bool solve_by_parts(const Dissection& dissection, const Numbering& numbering,
                                  const ElementStiffness& stiffness, std::vector<double>& load);

}  // namespace brash::plate
