// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet_fem.hpp"

#include <array>
#include <numeric>
#include <utility>

#include "element.hpp"
#include "quadrature.hpp"
#include "substructures.hpp"

namespace brash::plate {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Boundary nodes of a triangle in the order of the reference element: vertices, then order - 1 nodes an edge.
std::vector<int> nodes_of(const Mesh& mesh, int order, int triangle) {
  const auto& corners = mesh.triangles[at(triangle)];
  std::vector<int> nodes(corners.begin(), corners.end());
  for (std::size_t e = 0; e < 3; ++e) {
    const int edge = mesh.triangle_edges[at(triangle)][e];
    const bool forward = mesh.edges[at(edge)][0] == corners[e];
    const int first = static_cast<int>(mesh.vertices.size()) + edge * (order - 1);
    for (int i = 0; i < order - 1; ++i) nodes.push_back(first + (forward ? i : order - 2 - i));
  }
  return nodes;
}

/// Nodes of an edge, end to end.
std::vector<int> nodes_of_edge(const Mesh& mesh, int order, int edge) {
  std::vector<int> nodes{mesh.edges[at(edge)][0]};
  for (int i = 0; i < order - 1; ++i) nodes.push_back(static_cast<int>(mesh.vertices.size()) + edge * (order - 1) + i);
  nodes.push_back(mesh.edges[at(edge)][1]);
  return nodes;
}

int n_nodes(const Mesh& mesh, int order) {
  return static_cast<int>(mesh.vertices.size()) + (order - 1) * static_cast<int>(mesh.edges.size());
}

/// Whether each node lies on an edge with that tag.
std::vector<char> nodes_on(const Mesh& mesh, int order, Side side) {
  std::vector<char> marks(at(n_nodes(mesh, order)), 0);
  for (const auto& tagged : mesh.tagged) {
    if (tagged.side != side) continue;
    for (const int node : nodes_of_edge(mesh, order, tagged.edge)) marks[at(node)] = 1;
  }
  return marks;
}

bool is_below_the_axis(const Mesh& mesh, int triangle) {
  double y = 0.0;
  for (const int corner : mesh.triangles[at(triangle)]) y += mesh.vertices[at(corner)].y;
  return y < 0.0;
}

Numbering number_membrane(const Mesh& mesh, const ReferenceElement& element) {
  const int order = element.order();
  const int n = element.n_lagrange();
  const int n_inner = n - element.n_boundary();
  const auto held = nodes_on(mesh, order, Side::kFar);
  Numbering numbers{2 * n, 2 * n_nodes(mesh, order), {}};
  numbers.of_element.reserve(mesh.triangles.size() * at(2 * n));
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const auto nodes = nodes_of(mesh, order, t);
    for (int c = 0; c < 2; ++c) {
      for (const int node : nodes) numbers.of_element.push_back(held[at(node)] != 0 ? -1 : 2 * node + c);
      for (int i = 0; i < n_inner; ++i) numbers.of_element.push_back(numbers.n_unknowns++);
    }
  }
  return numbers;
}

/// Components: w, theta_x, theta_y. Below a crack theta_y has numbers of its own.
Numbering number_bending(const Mesh& mesh, const ReferenceElement& element) {
  const int order = element.order();
  const auto cracked = nodes_on(mesh, order, Side::kCrack);
  const int count = n_nodes(mesh, order);
  const std::array<int, 3> n_inner{element.n_lagrange() - element.n_boundary(),
                                   element.n_rotation() - element.n_boundary(),
                                   element.n_rotation() - element.n_boundary()};
  Numbering numbers{element.n_lagrange() + 2 * element.n_rotation(), 4 * count, {}};
  numbers.of_element.reserve(mesh.triangles.size() * at(numbers.n_local));
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const auto nodes = nodes_of(mesh, order, t);
    const bool below = is_below_the_axis(mesh, t);
    for (int c = 0; c < 3; ++c) {
      for (const int node : nodes) {
        const bool own = c == 2 && below && cracked[at(node)] != 0;
        numbers.of_element.push_back(own ? 3 * count + node : 3 * node + c);
      }
      for (int i = 0; i < n_inner[at(c)]; ++i) numbers.of_element.push_back(numbers.n_unknowns++);
    }
  }
  return numbers;
}

/// The local unknowns of every triangle.
Eigen::MatrixXd local_unknowns(const Numbering& numbers, const Eigen::MatrixXd& solution, std::size_t n_triangles,
                               const std::vector<int>& triangles) {
  Eigen::MatrixXd local = Eigen::MatrixXd::Zero(numbers.n_local, static_cast<Eigen::Index>(n_triangles));
  for (const int t : triangles) {
    const int* unknowns = numbers.element(t);
    for (int i = 0; i < numbers.n_local; ++i) local(i, t) = unknowns[i] < 0 ? 0.0 : solution(unknowns[i], 0);
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

/// Adds (1 - nu) e : e + nu (tr e)^2 to the two components that begin at row `first` with m rows each; n functions.
void add_elasticity(const ReferenceElement& element, const Map& map, double nu, int first, int n,
                    Eigen::MatrixXd& matrix) {
  const double half = 0.5 * (1.0 - nu);
  const auto add = [&](int rows, int columns, auto&& coefficient) {
    matrix.block(first + rows * n, first + columns * n, n, n) +=
        coefficient(0, 0) * element.stiffness(0, 0).topLeftCorner(n, n) +
        coefficient(0, 1) * element.stiffness(0, 1).topLeftCorner(n, n) +
        coefficient(1, 0) * element.stiffness(1, 0).topLeftCorner(n, n) +
        coefficient(1, 1) * element.stiffness(1, 1).topLeftCorner(n, n);
  };
  const auto& v = map.inverse;
  const double area2 = map.area2;
  add(0, 0, [&](int a, int b) { return area2 * (v(a, 0) * v(b, 0) + half * v(a, 1) * v(b, 1)); });
  add(1, 1, [&](int a, int b) { return area2 * (v(a, 1) * v(b, 1) + half * v(a, 0) * v(b, 0)); });
  const auto mixed = [&](int a, int b) { return area2 * (half * v(a, 1) * v(b, 0) + nu * v(a, 0) * v(b, 1)); };
  add(0, 1, mixed);
  matrix.block(first + n, first, n, n) = matrix.block(first, first + n, n, n).transpose();
}

/// Shear energies of the reference triangle on [w; covariant rotations], for the metrics 00, 01 and 10 together, 11.
struct ShearTable {
  std::array<Eigen::MatrixXd, 3> energy;

  explicit ShearTable(const ReferenceElement& element) {
    Eigen::MatrixXd strain(element.n_shear(), element.n_lagrange() + 2 * element.n_rotation());
    strain << element.shear_of_deflection(), -element.shear_of_rotation(0), -element.shear_of_rotation(1);
    energy[0] = strain.transpose() * element.shear_gram(0, 0) * strain;
    energy[1] = strain.transpose() * (element.shear_gram(0, 1) + element.shear_gram(1, 0)) * strain;
    energy[2] = strain.transpose() * element.shear_gram(1, 1) * strain;
  }
};

/// Corners and middles of the edges of the reference triangle, in the order of a quadratic element.
constexpr std::array<Vec2, 6> kStressNodes{{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {0.5, 0.0}, {0.5, 0.5}, {0.0, 0.5}}};

/// int psi_s d_a phi_i d_b phi_j with the quadratic functions psi of kStressNodes; ab = 00, 01 and 10 together, 11.
struct SlopeTable {
  std::array<std::array<Eigen::MatrixXd, 3>, 6> work;

  explicit SlopeTable(const ReferenceElement& element) {
    const int n = element.n_lagrange();
    for (auto& of_node : work) of_node.fill(Eigen::MatrixXd::Zero(n, n));
    for (const auto& point : triangle_rule(element.order() + 2)) {
      const Eigen::VectorXd psi = reference_element(2).values(point.xi, point.eta);
      const Eigen::MatrixX2d slope = element.gradients(point.xi, point.eta).topRows(n);
      const Eigen::MatrixXd mixed = slope.col(0) * slope.col(1).transpose();
      for (std::size_t s = 0; s < 6; ++s) {
        const double weight = point.weight * psi(static_cast<Eigen::Index>(s));
        work[s][0] += weight * slope.col(0) * slope.col(0).transpose();
        work[s][1] += weight * (mixed + mixed.transpose());
        work[s][2] += weight * slope.col(1) * slope.col(1).transpose();
      }
    }
  }
};

/// Stiffness of the bent element.
class BendingElement {
 public:
  BendingElement(const Mesh& mesh, int order, const SheetBending& sheet)
      : mesh_(&mesh), element_(&reference_element(order)), sheet_(&sheet) {
    static const std::array<ShearTable, 2> shear{ShearTable(reference_element(2)), ShearTable(reference_element(3))};
    static const std::array<SlopeTable, 2> slope{SlopeTable(reference_element(2)), SlopeTable(reference_element(3))};
    shear_ = &shear[at(order - 2)];
    slope_ = &slope[at(order - 2)];
    for (std::size_t s = 0; s < 6; ++s) {
      gradients_[s] = reference_element(sheet.membrane_order).gradients(kStressNodes[s].x, kStressNodes[s].y);
    }
  }

  void operator()(int triangle, Eigen::MatrixXd& matrix) {
    const int n = element_->n_lagrange();
    const int m = element_->n_rotation();
    const Map map(jacobian_of(*mesh_, triangle));
    const Eigen::Matrix2d metric = map.inverse * map.inverse.transpose() * (map.area2 * sheet_->shear_stiffness);
    const auto& [e00, e01, e11] = shear_->energy;
    covariant_ = metric(0, 0) * e00 + metric(0, 1) * e01 + metric(1, 1) * e11;

    matrix.topLeftCorner(n, n) = covariant_.topLeftCorner(n, n) + map.area2 * element_->mass();
    if (sheet_->membrane != nullptr) add_slope_work(triangle, map, matrix);
    const auto& j = map.jacobian;
    const auto rotated = [&](int c, int d) { return covariant_.block(n + c * m, n + d * m, m, m); };
    for (int a = 0; a < 2; ++a) {
      auto with_deflection = matrix.block(0, n + a * m, n, m);
      with_deflection = j(a, 0) * covariant_.block(0, n, n, m) + j(a, 1) * covariant_.block(0, n + m, n, m);
      matrix.block(n + a * m, 0, m, n) = with_deflection.transpose();
      for (int b = a; b < 2; ++b) {
        matrix.block(n + a * m, n + b * m, m, m) =
            j(a, 0) * j(b, 0) * rotated(0, 0) + j(a, 0) * j(b, 1) * rotated(0, 1) + j(a, 1) * j(b, 0) * rotated(1, 0) +
            j(a, 1) * j(b, 1) * rotated(1, 1);
      }
    }
    add_elasticity(*element_, map, sheet_->poisson_ratio, n, m, matrix);
  }

 private:
  void add_slope_work(int triangle, const Map& map, Eigen::MatrixXd& matrix) const {
    const int n = element_->n_lagrange();
    const auto n_membrane = reference_element(sheet_->membrane_order).n_lagrange();
    const auto displacement = sheet_->membrane->col(triangle);
    for (std::size_t s = 0; s < 6; ++s) {
      Eigen::Matrix2d gradient;
      gradient.row(0) = displacement.head(n_membrane).transpose() * gradients_[s].topRows(n_membrane) * map.inverse;
      gradient.row(1) = displacement.tail(n_membrane).transpose() * gradients_[s].topRows(n_membrane) * map.inverse;
      const Tensor2 stress = elastic(gradient, sheet_->poisson_ratio);
      Eigen::Matrix2d tensor;
      tensor << stress.xx, stress.xy, stress.xy, stress.yy;
      const Eigen::Matrix2d covariant = map.area2 * map.inverse * tensor * map.inverse.transpose();
      const auto& [w00, w01, w11] = slope_->work[s];
      matrix.topLeftCorner(n, n) += covariant(0, 0) * w00 + covariant(0, 1) * w01 + covariant(1, 1) * w11;
    }
  }

  const Mesh* mesh_;
  const ReferenceElement* element_;
  const SheetBending* sheet_;
  const ShearTable* shear_;
  const SlopeTable* slope_;
  std::array<Eigen::MatrixX2d, 6> gradients_;
  Eigen::MatrixXd covariant_;
};

std::vector<int> all_of(const Mesh& mesh) {
  std::vector<int> triangles(mesh.triangles.size());
  std::iota(triangles.begin(), triangles.end(), 0);
  return triangles;
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

Eigen::MatrixXd solve_sheet_membrane(const Mesh& mesh, int order, double poisson_ratio,
                                     const std::vector<EdgeForce>& forces) {
  const auto& element = reference_element(order);
  const int n = element.n_lagrange();
  const Numbering numbers = number_membrane(mesh, element);
  Eigen::MatrixXd load = Eigen::MatrixXd::Zero(numbers.n_unknowns, 1);
  const Eigen::VectorXd weights = element.edge_load();
  for (const EdgeForce& force : forces) {
    const auto& ends = mesh.edges[at(force.edge)];
    const double length = norm(mesh.vertices[at(ends[1])] - mesh.vertices[at(ends[0])]);
    const auto nodes = nodes_of_edge(mesh, order, force.edge);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const double share = length * weights(static_cast<Eigen::Index>(i));
      load(2 * nodes[i]) += share * force.in_plane.x;
      load(2 * nodes[i] + 1) += share * force.in_plane.y;
    }
  }
  const auto triangles = all_of(mesh);
  if (load.isZero(0.0)) return Eigen::MatrixXd::Zero(numbers.n_local, static_cast<Eigen::Index>(triangles.size()));
  const auto stiffness = [&](int triangle, Eigen::MatrixXd& matrix) {
    matrix.setZero();
    add_elasticity(element, Map(jacobian_of(mesh, triangle)), poisson_ratio, 0, n, matrix);
  };
  // Plane stress on a clamped sheet is positive definite.
  if (!solve_by_parts(Dissection(mesh, triangles), numbers, stiffness, load)) load.setZero();
  return local_unknowns(numbers, load, mesh.triangles.size(), triangles);
}

std::optional<Eigen::MatrixXd> solve_sheet_bending(const Mesh& mesh, int order, const SheetBending& sheet,
                                                   const std::vector<EdgeForce>& edge_forces,
                                                   const std::vector<PointForce>& point_forces) {
  const auto& element = reference_element(order);
  const int n = element.n_lagrange();
  const Numbering numbers = number_bending(mesh, element);
  Eigen::MatrixXd load = Eigen::MatrixXd::Zero(numbers.n_unknowns, 1);
  const Eigen::VectorXd weights = element.edge_load();
  const auto cracked = nodes_on(mesh, order, Side::kCrack);
  const int count = n_nodes(mesh, order);
  for (const EdgeForce& force : edge_forces) {
    const auto& ends = mesh.edges[at(force.edge)];
    const double length = norm(mesh.vertices[at(ends[1])] - mesh.vertices[at(ends[0])]);
    const bool below = mesh.vertices[at(ends[0])].y + mesh.vertices[at(ends[1])].y < 0.0;
    const auto nodes = nodes_of_edge(mesh, order, force.edge);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const double share = length * weights(static_cast<Eigen::Index>(i));
      const int node = nodes[i];
      load(3 * node) += share * force.out_of_plane;
      load(3 * node + 1) += share * force.moment * force.outward.x;
      load(below && cracked[at(node)] != 0 ? 3 * count + node : 3 * node + 2) += share * force.moment * force.outward.y;
    }
  }
  for (const PointForce& force : point_forces) {
    const Eigen::VectorXd values = element.values(force.xi, force.eta);
    const int* unknowns = numbers.element(force.triangle);
    for (int i = 0; i < n; ++i) load(unknowns[i]) += force.out_of_plane * values(i);
  }
  BendingElement stiffness(mesh, order, sheet);
  if (!solve_by_parts(Dissection(mesh, sheet.triangles), numbers, std::ref(stiffness), load)) return std::nullopt;
  return local_unknowns(numbers, load, mesh.triangles.size(), sheet.triangles);
}

}  // namespace brash::plate
