// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet_fem.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "element.hpp"
#include "quadrature.hpp"
#include "sheet_numbering.hpp"
#include "substructures.hpp"

namespace brash::plate {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// The local unknowns of every triangle, zero where it is at rest.
Eigen::MatrixXd local_unknowns(const Numbering& numbers, const std::vector<double>& solution) {
  const auto n_triangles = static_cast<int>(numbers.groups_of.size());
  Eigen::MatrixXd local = Eigen::MatrixXd::Zero(numbers.n_local, n_triangles);
  for (int t = 0; t < n_triangles; ++t) {
    if (numbers.groups_of[at(t)].front() < 0) continue;
    const int* unknowns = numbers.element(t);
    for (int i = 0; i < numbers.n_local; ++i) local(i, t) = unknowns[i] < 0 ? 0.0 : solution[at(unknowns[i])];
  }
  return local;
}

/// A map from the reference triangle and what follows from it.
struct Map {
  Eigen::Matrix2d jacobian;
  Eigen::Matrix2d inverse;
  double area2;

  explicit Map(const Eigen::Matrix2d& j) : jacobian(j), inverse(j.inverse()), area2(j.determinant()) {}
};

/// Integrals of products of derivatives, int d_a phi_i d_b phi_j, of the first n functions of an element.
template <int n>
struct StiffnessTable {
  using Square = Eigen::Matrix<double, n, n>;
  Square k00, k01, k10, k11;

  explicit StiffnessTable(const ReferenceElement& element)
      : k00(element.stiffness(0, 0).topLeftCorner(n, n)),
        k01(element.stiffness(0, 1).topLeftCorner(n, n)),
        k10(element.stiffness(1, 0).topLeftCorner(n, n)),
        k11(element.stiffness(1, 1).topLeftCorner(n, n)) {}
};

/// Adds (1 - nu) e : e + nu (tr e)^2 to the two components that begin at row `first`.
template <int first, int n, typename Matrix>
void add_elasticity(const StiffnessTable<n>& table, const Map& map, double nu, Matrix& matrix) {
  const double half = 0.5 * (1.0 - nu);
  const auto add = [&](auto&& block, auto&& coefficient) {
    block += coefficient(0, 0) * table.k00 + coefficient(0, 1) * table.k01 + coefficient(1, 0) * table.k10 +
             coefficient(1, 1) * table.k11;
  };
  const auto& v = map.inverse;
  const double area2 = map.area2;
  add(matrix.template block<n, n>(first, first),
      [&](int a, int b) { return area2 * (v(a, 0) * v(b, 0) + half * v(a, 1) * v(b, 1)); });
  add(matrix.template block<n, n>(first + n, first + n),
      [&](int a, int b) { return area2 * (v(a, 1) * v(b, 1) + half * v(a, 0) * v(b, 0)); });
  add(matrix.template block<n, n>(first, first + n),
      [&](int a, int b) { return area2 * (half * v(a, 1) * v(b, 0) + nu * v(a, 0) * v(b, 1)); });
  matrix.template block<n, n>(first + n, first) = matrix.template block<n, n>(first, first + n).transpose();
}

/// Corners and middles of the edges of the reference triangle, in the order of a quadratic element.
constexpr std::array<Vec2, 6> kStressNodes{{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {0.5, 0.0}, {0.5, 0.5}, {0.0, 0.5}}};

/// Plane stress at kStressNodes of a triangle.
using NodalStress = std::array<Tensor2, 6>;

/// Integrals of the plate's energy on the reference triangle. The shear is taken with covariant rotations.
template <int kOrder>
struct BendingTable {
  static constexpr int n = (kOrder + 1) * (kOrder + 2) / 2;  ///< functions of the deflection
  static constexpr int m = n + kOrder - 1;                   ///< of a rotation
  static constexpr int kLocal = n + 2 * m;
  using Square = Eigen::Matrix<double, kLocal, kLocal>;
  using Deflection = Eigen::Matrix<double, n, n>;

  std::array<Square, 3> shear;  ///< for the metrics 00, 01 and 10 together, 11
  StiffnessTable<m> stiffness;
  Deflection mass;
  /// int psi_s d_a phi_i d_b phi_j with the quadratic functions psi of kStressNodes; ab = 00, 01 and 10 together, 11.
  std::array<std::array<Deflection, 3>, 6> slope_work;

  explicit BendingTable(const ReferenceElement& element) : stiffness(element), mass(element.mass()) {
    Eigen::MatrixXd strain(element.n_shear(), kLocal);
    strain << element.shear_of_deflection(), -element.shear_of_rotation(0), -element.shear_of_rotation(1);
    shear[0] = strain.transpose() * element.shear_gram(0, 0) * strain;
    shear[1] = strain.transpose() * (element.shear_gram(0, 1) + element.shear_gram(1, 0)) * strain;
    shear[2] = strain.transpose() * element.shear_gram(1, 1) * strain;
    for (auto& of_node : slope_work) of_node.fill(Deflection::Zero());
    for (const auto& point : triangle_rule(kOrder + 2)) {
      const Eigen::VectorXd psi = reference_element(2).values(point.xi, point.eta);
      const Eigen::Matrix<double, n, 2> slope = element.gradients(point.xi, point.eta).topRows(n);
      const Deflection mixed = slope.col(0) * slope.col(1).transpose();
      for (std::size_t s = 0; s < 6; ++s) {
        const double weight = point.weight * psi(static_cast<Eigen::Index>(s));
        slope_work[s][0] += weight * slope.col(0) * slope.col(0).transpose();
        slope_work[s][1] += weight * (mixed + mixed.transpose());
        slope_work[s][2] += weight * slope.col(1) * slope.col(1).transpose();
      }
    }
  }
};

/// Stiffness of the bent element.
template <int kOrder>
class BendingElement {
 public:
  BendingElement(const Mesh& mesh, const SheetBending& sheet, const std::vector<NodalStress>& stress)
      : mesh_(&mesh), sheet_(&sheet), stress_(&stress), table_(&table()) {}

  void operator()(int triangle, Eigen::MatrixXd& result) const {
    Eigen::Map<Square> matrix(result.data());
    const Map map(jacobian_of(*mesh_, triangle));
    const Eigen::Matrix2d metric = map.inverse * map.inverse.transpose() * (map.area2 * sheet_->shear_stiffness);
    const auto& [e00, e01, e11] = table_->shear;
    const Square covariant = metric(0, 0) * e00 + metric(0, 1) * e01 + metric(1, 1) * e11;

    matrix.template topLeftCorner<n, n>() = covariant.template topLeftCorner<n, n>() + map.area2 * table_->mass;
    if (!stress_->empty()) add_slope_work(triangle, map, matrix);
    const auto& j = map.jacobian;
    const auto rotated = [&](int c, int d) { return covariant.template block<m, m>(n + c * m, n + d * m); };
    for (int a = 0; a < 2; ++a) {
      auto with_deflection = matrix.template block<n, m>(0, n + a * m);
      with_deflection =
          j(a, 0) * covariant.template block<n, m>(0, n) + j(a, 1) * covariant.template block<n, m>(0, n + m);
      matrix.template block<m, n>(n + a * m, 0) = with_deflection.transpose();
      for (int b = a; b < 2; ++b) {
        matrix.template block<m, m>(n + a * m, n + b * m) =
            j(a, 0) * j(b, 0) * rotated(0, 0) + j(a, 0) * j(b, 1) * rotated(0, 1) + j(a, 1) * j(b, 0) * rotated(1, 0) +
            j(a, 1) * j(b, 1) * rotated(1, 1);
      }
    }
    add_elasticity<n>(table_->stiffness, map, sheet_->poisson_ratio, matrix);
  }

 private:
  using Table = BendingTable<kOrder>;
  using Square = typename Table::Square;
  static constexpr int n = Table::n;
  static constexpr int m = Table::m;

  static const Table& table() {
    static const Table table(reference_element(kOrder));
    return table;
  }

  void add_slope_work(int triangle, const Map& map, Eigen::Map<Square>& matrix) const {
    for (std::size_t s = 0; s < 6; ++s) {
      const Tensor2& stress = (*stress_)[at(triangle)][s];
      Eigen::Matrix2d tensor;
      tensor << stress.xx, stress.xy, stress.xy, stress.yy;
      const Eigen::Matrix2d covariant = map.area2 * map.inverse * tensor * map.inverse.transpose();
      const auto& [w00, w01, w11] = table_->slope_work[s];
      matrix.template topLeftCorner<n, n>() += covariant(0, 0) * w00 + covariant(0, 1) * w01 + covariant(1, 1) * w11;
    }
  }

  const Mesh* mesh_;
  const SheetBending* sheet_;
  const std::vector<NodalStress>* stress_;
  const Table* table_;
};

/// Stress of the membrane at kStressNodes of every triangle.
template <int kOrder>
std::vector<NodalStress> nodal_stress(const Mesh& mesh, const Eigen::MatrixXd& displacement, double poisson_ratio) {
  constexpr int n = (kOrder + 1) * (kOrder + 2) / 2;
  std::array<Eigen::Matrix<double, n, 2>, 6> gradients;
  for (std::size_t s = 0; s < 6; ++s)
    gradients[s] = reference_element(kOrder).gradients(kStressNodes[s].x, kStressNodes[s].y).template topRows<n>();
  std::vector<NodalStress> result(mesh.triangles.size());
  for (int t = 0; t < static_cast<int>(result.size()); ++t) {
    const Eigen::Matrix2d inverse = jacobian_of(mesh, t).inverse();
    const Eigen::Map<const Eigen::Matrix<double, n, 2>> field(displacement.col(t).data());
    for (std::size_t s = 0; s < 6; ++s)
      result[at(t)][s] = elastic(field.transpose() * gradients[s] * inverse, poisson_ratio);
  }
  return result;
}

std::vector<NodalStress> nodal_stress(const Mesh& mesh, const SheetBending& sheet) {
  if (sheet.membrane == nullptr) return {};
  return sheet.membrane_order == 2 ? nodal_stress<2>(mesh, *sheet.membrane, sheet.poisson_ratio)
                                   : nodal_stress<3>(mesh, *sheet.membrane, sheet.poisson_ratio);
}

/// Calls visit(node, share) for the nodes of a loaded edge.
/// @param weights  ReferenceElement::edge_load().
template <typename Visit>
void share_out(const Mesh& mesh, int order, const Eigen::VectorXd& weights, const EdgeForce& force,
               const Visit& visit) {
  const auto& ends = mesh.edges[at(force.edge)];
  const double length = norm(mesh.vertices[at(ends[1])] - mesh.vertices[at(ends[0])]);
  const auto nodes = nodes_of_edge(mesh, order, force.edge);
  for (std::size_t i = 0; i < nodes.size(); ++i) visit(nodes[i], length * weights(static_cast<Eigen::Index>(i)));
}

template <int kOrder>
ElementStiffness membrane_stiffness(const Mesh& mesh, double poisson_ratio) {
  constexpr int n = (kOrder + 1) * (kOrder + 2) / 2;
  static const StiffnessTable<n> table(reference_element(kOrder));
  return [&mesh, poisson_ratio](int triangle, Eigen::MatrixXd& result) {
    Eigen::Map<Eigen::Matrix<double, 2 * n, 2 * n>> matrix(result.data());
    matrix.setZero();
    add_elasticity<0>(table, Map(jacobian_of(mesh, triangle)), poisson_ratio, matrix);
  };
}

std::vector<double> bending_load(const Mesh& mesh, const ReferenceElement& element, const SheetNumbering& sheet,
                                 const std::vector<EdgeForce>& edge_forces,
                                 const std::vector<PointForce>& point_forces) {
  std::vector<double> load(at(sheet.numbers.n_unknowns), 0.0);
  const Eigen::VectorXd weights = element.edge_load();
  for (const EdgeForce& force : edge_forces) {
    const auto& ends = mesh.edges[at(force.edge)];
    const bool below = mesh.vertices[at(ends[0])].y + mesh.vertices[at(ends[1])].y < 0.0;
    share_out(mesh, element.order(), weights, force, [&](int node, double share) {
      load[at(sheet.unknown(node, 0, below))] += share * force.out_of_plane;
      load[at(sheet.unknown(node, 1, below))] += share * force.moment * force.outward.x;
      load[at(sheet.unknown(node, 2, below))] += share * force.moment * force.outward.y;
    });
  }
  for (const PointForce& force : point_forces) {
    const Eigen::VectorXd values = element.values(force.xi, force.eta);
    const int* unknowns = sheet.numbers.element(force.triangle);
    for (int i = 0; i < element.n_lagrange(); ++i) load[at(unknowns[i])] += force.out_of_plane * values(i);
  }
  return load;
}

}  // namespace

Eigen::Matrix2d jacobian_of(const Mesh& mesh, int triangle) {
  const auto& corners = mesh.triangles[at(triangle)];
  const Vec2 a = mesh.vertices[at(corners[0])];
  const Vec2 b = mesh.vertices[at(corners[1])] - a;
  const Vec2 c = mesh.vertices[at(corners[2])] - a;
  Eigen::Matrix2d jacobian;
  jacobian << b.x, c.x, b.y, c.y;
  return jacobian;
}

Tensor2 elastic(const Eigen::Matrix2d& gradient, double poisson_ratio) {
  const double nu = poisson_ratio;
  return {gradient(0, 0) + nu * gradient(1, 1), gradient(1, 1) + nu * gradient(0, 0),
          0.5 * (1.0 - nu) * (gradient(0, 1) + gradient(1, 0))};
}

Eigen::MatrixXd solve_sheet_membrane(const Mesh& mesh, const Dissection& dissection, int order, double poisson_ratio,
                                     const std::vector<EdgeForce>& forces) {
  const auto& element = reference_element(order);
  const SheetNumbering sheet = number_membrane(mesh, element);
  std::vector<double> load(at(sheet.numbers.n_unknowns), 0.0);
  const Eigen::VectorXd weights = element.edge_load();
  for (const EdgeForce& force : forces) {
    share_out(mesh, element.order(), weights, force, [&](int node, double share) {
      if (sheet.unknown(node, 0, false) < 0) return;
      load[at(sheet.unknown(node, 0, false))] += share * force.in_plane.x;
      load[at(sheet.unknown(node, 1, false))] += share * force.in_plane.y;
    });
  }
  const bool is_free = std::all_of(load.begin(), load.end(), [](double value) { return value == 0.0; });
  const auto stiffness =
      order == 2 ? membrane_stiffness<2>(mesh, poisson_ratio) : membrane_stiffness<3>(mesh, poisson_ratio);
  // Plane stress on a clamped sheet is positive definite.
  if (is_free || !solve_by_parts(dissection, sheet.numbers, stiffness, load)) std::fill(load.begin(), load.end(), 0.0);
  return local_unknowns(sheet.numbers, load);
}

std::optional<Eigen::MatrixXd> solve_sheet_bending(const Mesh& mesh, const Dissection& dissection, int order,
                                                   const SheetBending& sheet, const std::vector<EdgeForce>& edge_forces,
                                                   const std::vector<PointForce>& point_forces) {
  const auto& element = reference_element(order);
  const SheetNumbering numbering = number_bending(mesh, element, sheet.triangles);
  auto load = bending_load(mesh, element, numbering, edge_forces, point_forces);
  const auto stress = nodal_stress(mesh, sheet);
  const auto stiffness = order == 2 ? ElementStiffness(BendingElement<2>(mesh, sheet, stress))
                                    : ElementStiffness(BendingElement<3>(mesh, sheet, stress));
  if (!solve_by_parts(dissection, numbering.numbers, stiffness, load)) return std::nullopt;
  return local_unknowns(numbering.numbers, load);
}

}  // namespace brash::plate
