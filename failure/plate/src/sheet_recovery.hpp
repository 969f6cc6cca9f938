// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>
#include <map>
#include <vector>

#include "brash/plate/sheet.hpp"
#include "mesh.hpp"

namespace brash::plate {

/// The fields of a solved sheet: local unknowns of every triangle.
struct SheetFields {
  int membrane_order = 3;
  int bending_order = 3;
  double poisson_ratio = 0.3;
  bool split = false;              ///< along the x-axis
  std::size_t smallest_patch = 3;  ///< fewest triangles to which a cubic is fitted
  Eigen::MatrixXd membrane;
  Eigen::MatrixXd bending;
};

/// Smooth stress of a sheet: around each vertex a cubic is fitted to the stress of the triangles that meet there, and
/// the cubics of a triangle's corners are blended (Zienkiewicz and Zhu, IJNME 33, 1992). A split sheet has other cubics
/// on each side of the x-axis.
class SheetRecovery {
 public:
  SheetRecovery(const Mesh& mesh, const SheetFields& fields);

  /// At a point of a triangle.
  SheetState at(int triangle, double xi, double eta);

 private:
  static constexpr int kTerms = 10;
  static constexpr int kQuantities = 6;
  using Fit = Eigen::Matrix<double, kTerms, kQuantities>;
  using Values = Eigen::Matrix<double, kQuantities, 1>;

  /// A cubic about a vertex.
  struct Cubic {
    Vec2 centre{};
    double scale = 1.0;
    Fit terms;
  };

  bool is_below(int triangle) const;
  std::vector<int> patch(int vertex, bool below) const;
  const Cubic& cubic(int vertex, bool below);
  void add_samples(int triangle, const Cubic& cubic, Eigen::Matrix<double, kTerms, kTerms>& normal, Fit& right) const;

  const Mesh* mesh_;
  const SheetFields* fields_;
  std::vector<std::vector<int>> around_;  ///< triangles of each vertex
  std::map<std::pair<int, bool>, Cubic> cubics_;
};

}  // namespace brash::plate
