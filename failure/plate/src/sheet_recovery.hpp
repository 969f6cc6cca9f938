// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>
#include <functional>
#include <optional>
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

  /// At those corners of triangles and middles of their sides that are `wanted`; see SheetSolution::at_nodes.
  std::vector<SheetPlace> at_nodes(const std::function<bool(Vec2)>& wanted);

 private:
  static constexpr int kTerms = 10;
  static constexpr int kQuantities = 6;
  using Fit = Eigen::Matrix<double, kTerms, kQuantities>;
  using Moments = Eigen::Matrix<double, 28, 1>;  ///< sums of the monomials up to degree 6
  using Values = Eigen::Matrix<double, kQuantities, 1>;

  /// A cubic about a vertex.
  struct Cubic {
    Vec2 centre{};
    double scale = 1.0;
    Fit terms;
  };

  /// The stress of a triangle at its sample points: moments and membrane.
  struct Samples {
    double area2 = 0.0;
    std::array<Vec2, 9> places;
    Eigen::Matrix<double, kQuantities, 9> values;
  };

  bool is_below(int triangle) const;
  std::vector<int> patch(int vertex, bool below) const;
  const Cubic& cubic(int vertex, bool below);
  const Samples& samples(int triangle);
  void add_samples(int triangle, const Cubic& cubic, Moments& moments, Fit& right);
  /// All but the deflection.
  SheetState blend(int triangle, double xi, double eta);

  const Mesh* mesh_;
  const SheetFields* fields_;
  std::vector<std::vector<int>> around_;         ///< triangles of each vertex
  std::vector<std::optional<Samples>> samples_;  ///< of each triangle
  std::vector<std::optional<Cubic>> cubics_;     ///< of each vertex: above and below a crack
};

}  // namespace brash::plate
