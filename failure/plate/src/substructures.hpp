// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <optional>
#include <vector>

#include "mesh.hpp"

namespace brash::plate {

/// A nested dissection of some triangles of a mesh: they are halved again and again, along short cuts.
class Dissection {
 public:
  /// A set of triangles: `order[from]` to `order[to - 1]`, with two halves unless it is a single one.
  struct Part {
    int from = 0;
    int to = 0;
    int left = -1;
    int right = -1;
  };

  Dissection(const Mesh& mesh, std::vector<int> triangles);

  const std::vector<int>& order() const { return order_; }
  /// Halves before their whole.
  const std::vector<Part>& parts() const { return parts_; }

 private:
  int dissect(const Mesh& mesh, int from, int to);
  void halve(const Mesh& mesh, int from, int to);

  std::vector<int> order_;
  std::vector<Part> parts_;
  std::vector<Vec2> centres_;
  std::vector<int> side_of_edge_;
};

/// Unknowns of a finite element system, shape=(n_triangles of the mesh, n_local): global numbers, -1 where held at
/// zero.
struct Numbering {
  int n_local = 0;
  int n_unknowns = 0;
  std::vector<int> of_element;

  const int* element(int triangle) const { return of_element.data() + static_cast<std::ptrdiff_t>(triangle) * n_local; }
};

/// Writes the stiffness of a triangle, shape=(n_local, n_local), symmetric.
using ElementStiffness = std::function<void(int triangle, Eigen::MatrixXd& stiffness)>;

/// Solves a symmetric positive definite system: every part of the dissection eliminates the unknowns that no triangle
/// outside it has, with dense matrices (the multifrontal method of Duff and Reid, ACM TOMS 9, 1983).
///
/// @param load  in: right-hand sides, shape=(n_unknowns, n_loads); out: the solutions.
/// @return whether the system is positive definite.
[[nodiscard]] bool solve_by_parts(const Dissection& dissection, const Numbering& numbering,
                                  const ElementStiffness& stiffness, Eigen::MatrixXd& load);

}  // namespace brash::plate
