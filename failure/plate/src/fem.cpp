// SPDX-License-Identifier: GPL-3.0-or-later
#include "fem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "brash/core/contract.hpp"
#include "condensed_system.hpp"
#include "element.hpp"
#include "quadrature.hpp"

namespace brash::plate {

namespace {

/// Shared nodes: the vertices, then order - 1 nodes on each edge from its lower to its higher vertex.
class Nodes {
 public:
  Nodes(const Mesh& mesh, int order) : mesh_(&mesh), order_(order) {}

  int count() const {
    return static_cast<int>(mesh_->vertices.size()) + edge_nodes() * static_cast<int>(mesh_->edges.size());
  }

  /// Global numbers of the boundary nodes of a triangle, in the order of the reference element.
  std::vector<int> of_triangle(std::size_t triangle) const {
    const auto& corners = mesh_->triangles[triangle];
    std::vector<int> nodes(corners.begin(), corners.end());
    for (std::size_t e = 0; e < 3; ++e) {
      const int edge = mesh_->triangle_edges[triangle][e];
      const bool forward = mesh_->edges[static_cast<std::size_t>(edge)][0] == corners[e];
      for (int i = 0; i < edge_nodes(); ++i) nodes.push_back(on_edge(edge, forward ? i : edge_nodes() - 1 - i));
    }
    return nodes;
  }

  /// Global numbers of the nodes of an edge, end to end.
  std::vector<int> of_edge(int edge) const {
    const auto& ends = mesh_->edges[static_cast<std::size_t>(edge)];
    std::vector<int> nodes{ends[0]};
    for (int i = 0; i < edge_nodes(); ++i) nodes.push_back(on_edge(edge, i));
    nodes.push_back(ends[1]);
    return nodes;
  }

 private:
  int edge_nodes() const { return order_ - 1; }
  int on_edge(int edge, int i) const { return static_cast<int>(mesh_->vertices.size()) + edge * edge_nodes() + i; }

  const Mesh* mesh_;
  int order_;
};

/// Numbers the free unknowns of `n_components` a node; `is_held(side, component)` says which are zero on which side.
template <typename IsHeld>
std::pair<std::vector<int>, int> number_unknowns(const Mesh& mesh, const Nodes& nodes, int n_components,
                                                 const IsHeld& is_held) {
  std::vector<int> numbers(static_cast<std::size_t>(nodes.count() * n_components), 0);
  for (const auto& tagged : mesh.tagged) {
    for (const int node : nodes.of_edge(tagged.edge)) {
      for (int c = 0; c < n_components; ++c) {
        if (is_held(tagged.side, c)) numbers[static_cast<std::size_t>(node * n_components + c)] = -1;
      }
    }
  }
  int count = 0;
  for (auto& number : numbers) {
    if (number == 0) number = count++;
  }
  return {std::move(numbers), count};
}

Eigen::Matrix2d jacobian_of(const Mesh& mesh, std::size_t triangle) {
  const auto& corners = mesh.triangles[triangle];
  const Vec2 a = mesh.vertices[static_cast<std::size_t>(corners[0])];
  const Vec2 b = mesh.vertices[static_cast<std::size_t>(corners[1])] - a;
  const Vec2 c = mesh.vertices[static_cast<std::size_t>(corners[2])] - a;
  Eigen::Matrix2d jacobian;
  jacobian << b.x, c.x, b.y, c.y;
  return jacobian;
}

/// (1 - nu) e : e + nu (tr e)^2 on n functions a component, shape=(2 n, 2 n), components one after the other.
Eigen::MatrixXd elasticity(const ReferenceElement& element, const Eigen::Matrix2d& jacobian, double nu, int n) {
  const Eigen::Matrix2d inverse = jacobian.inverse();
  const double area2 = jacobian.determinant();
  std::array<Eigen::MatrixXd, 4> products;
  for (int alpha = 0; alpha < 2; ++alpha) {
    for (int beta = 0; beta < 2; ++beta) {
      auto& product = products[static_cast<std::size_t>(2 * alpha + beta)];
      product = Eigen::MatrixXd::Zero(n, n);
      for (int a = 0; a < 2; ++a) {
        for (int b = 0; b < 2; ++b) {
          product += area2 * inverse(a, alpha) * inverse(b, beta) * element.stiffness(a, b).topLeftCorner(n, n);
        }
      }
    }
  }
  const auto& [xx, xy, yx, yy] = products;
  Eigen::MatrixXd result(2 * n, 2 * n);
  const double half = 0.5 * (1.0 - nu);
  result.topLeftCorner(n, n) = xx + half * yy;
  result.bottomRightCorner(n, n) = yy + half * xx;
  result.topRightCorner(n, n) = half * yx + nu * xy;
  result.bottomLeftCorner(n, n) = result.topRightCorner(n, n).transpose();
  return result;
}

/// Shear energy of the reduced shear strain on [w; theta_x; theta_y].
Eigen::MatrixXd shear(const ReferenceElement& element, const Eigen::Matrix2d& jacobian) {
  const int n = element.n_lagrange();
  const int m = element.n_rotation();
  Eigen::MatrixXd strain(element.n_shear(), n + 2 * m);
  strain.leftCols(n) = element.shear_of_deflection();
  // The covariant components of the rotation are J^T theta.
  for (int alpha = 0; alpha < 2; ++alpha) {
    strain.middleCols(n + alpha * m, m) =
        -(element.shear_of_rotation(0) * jacobian(alpha, 0) + element.shear_of_rotation(1) * jacobian(alpha, 1));
  }
  const Eigen::Matrix2d metric = (jacobian.transpose() * jacobian).inverse() * jacobian.determinant();
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(element.n_shear(), element.n_shear());
  for (int a = 0; a < 2; ++a) {
    for (int b = 0; b < 2; ++b) gram += metric(a, b) * element.shear_gram(a, b);
  }
  return strain.transpose() * gram * strain;
}

/// Work of the in-plane stress on the slope of the deflection: int s_ab d_a phi_i d_b phi_j, shape=(n_lagrange,
/// n_lagrange). Negative where the stress is compressive.
Eigen::MatrixXd slope_work(const ReferenceElement& element, const Eigen::Matrix2d& jacobian, const Field& stress,
                           int triangle) {
  const int n = element.n_lagrange();
  const Eigen::Matrix2d inverse = jacobian.inverse();
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, n);
  // Slopes and stress are of degree k - 1 each.
  for (const auto& point : triangle_rule((3 * (element.order() - 1)) / 2 + 1)) {
    const Tensor2 s = stress.tensor(triangle, point.xi, point.eta);
    const Eigen::MatrixX2d slope = element.gradients(point.xi, point.eta).topRows(n) * inverse;
    Eigen::Matrix2d tensor;
    tensor << s.xx, s.xy, s.xy, s.yy;
    result += point.weight * jacobian.determinant() * slope * tensor * slope.transpose();
  }
  return result;
}

template <typename Add>
void for_each_tip_node(const Mesh& mesh, const Nodes& nodes, const ReferenceElement& element, const Add& add) {
  const Eigen::VectorXd weights = element.edge_load();
  for (const auto& tagged : mesh.tagged) {
    if (tagged.side != Side::kTip) continue;
    const auto& ends = mesh.edges[static_cast<std::size_t>(tagged.edge)];
    const double length =
        norm(mesh.vertices[static_cast<std::size_t>(ends[1])] - mesh.vertices[static_cast<std::size_t>(ends[0])]);
    const auto on_edge = nodes.of_edge(tagged.edge);
    for (std::size_t i = 0; i < on_edge.size(); ++i) add(on_edge[i], length * weights(static_cast<Eigen::Index>(i)));
  }
}

/// Shared unknowns of a triangle, component by component.
std::vector<int> unknowns_of(const std::vector<int>& nodes, const std::vector<int>& numbers, int n_components) {
  std::vector<int> result;
  for (int c = 0; c < n_components; ++c) {
    for (const int node : nodes) result.push_back(numbers[static_cast<std::size_t>(node * n_components + c)]);
  }
  return result;
}

CondensedSystem assemble_bending(const Mesh& mesh, int order, const BendingProblem& problem) {
  const auto& element = reference_element(order);
  const Nodes nodes(mesh, order);
  // Symmetry about a line: no rotation across it. Components: w, theta_x, theta_y.
  const auto [numbers, n_unknowns] = number_unknowns(mesh, nodes, 3, [](Side side, int component) {
    return (side == Side::kSymmetryY && component == 2) || (side == Side::kSymmetryX && component == 1);
  });
  const int n = element.n_lagrange();
  const int m = element.n_rotation();
  std::vector<int> interior;
  for (int i = element.n_boundary(); i < n; ++i) interior.push_back(i);
  for (int i = element.n_boundary(); i < m; ++i) interior.push_back(n + i);
  for (int i = element.n_boundary(); i < m; ++i) interior.push_back(n + m + i);

  CondensedSystem system(n_unknowns, 1, static_cast<int>(mesh.triangles.size()), n + 2 * m, std::move(interior));
  for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
    const Eigen::Matrix2d jacobian = jacobian_of(mesh, triangle);
    Eigen::MatrixXd stiffness = problem.shear_stiffness * shear(element, jacobian);
    stiffness.topLeftCorner(n, n) += jacobian.determinant() * element.mass();
    stiffness.bottomRightCorner(2 * m, 2 * m) += elasticity(element, jacobian, problem.poisson_ratio, m);
    if (problem.in_plane_load != 0.0) {
      stiffness.topLeftCorner(n, n) +=
          problem.in_plane_load * slope_work(element, jacobian, *problem.in_plane_stress, static_cast<int>(triangle));
    }
    Eigen::VectorXd load = Eigen::VectorXd::Zero(n + 2 * m);
    if (problem.pressure) {
      load.head(n) = problem.pressure(static_cast<int>(triangle)) * jacobian.determinant() * element.load();
    }
    system.add(stiffness, load, unknowns_of(nodes.of_triangle(triangle), numbers, 3));
  }
  for_each_tip_node(mesh, nodes, element, [&, &map = numbers](int node, double weight) {
    system.add_load(map[static_cast<std::size_t>(3 * node)], 0, problem.tip_line_load * weight);
  });
  return system;
}

}  // namespace

double shear_stiffness(double poisson_ratio, double thickness_over_lc) {
  return 5.0 * (1.0 - poisson_ratio) / (thickness_over_lc * thickness_over_lc);
}

Field::Field(const Mesh& mesh, int order, double poisson_ratio, Eigen::MatrixXd local, int first_row, int n_functions)
    : mesh_(&mesh),
      order_(order),
      poisson_ratio_(poisson_ratio),
      local_(std::move(local)),
      first_row_(first_row),
      n_functions_(n_functions) {}

Tensor2 Field::tensor(int triangle, double xi, double eta) const {
  const Eigen::Matrix2d jacobian = jacobian_of(*mesh_, static_cast<std::size_t>(triangle));
  const Eigen::MatrixX2d slope =
      reference_element(order_).gradients(xi, eta).topRows(n_functions_) * jacobian.inverse();
  const Eigen::RowVector2d x = local_.col(triangle).segment(first_row_, n_functions_).transpose() * slope;
  const Eigen::RowVector2d y =
      local_.col(triangle).segment(first_row_ + n_functions_, n_functions_).transpose() * slope;
  const double nu = poisson_ratio_;
  return {x(0) + nu * y(1), y(1) + nu * x(0), 0.5 * (1.0 - nu) * (x(1) + y(0))};
}

double Field::deflection(int triangle, double xi, double eta) const {
  const auto& element = reference_element(order_);
  BRASH_EXPECTS(first_row_ == element.n_lagrange(), first_row_);
  return local_.col(triangle).head(first_row_).dot(element.values(xi, eta).head(first_row_));
}

Vec2 Field::place(int triangle, double xi, double eta) const { return place_in(*mesh_, triangle, xi, eta); }

tl::expected<Field, std::string> solve_bending(const Mesh& mesh, int order, const BendingProblem& problem) {
  const auto& element = reference_element(order);
  return assemble_bending(mesh, order, problem).solve().map([&](const auto& locals) {
    return Field(mesh, order, problem.poisson_ratio, locals.front(), element.n_lagrange(), element.n_rotation());
  });
}

BendingSystem::BendingSystem(std::unique_ptr<CondensedSystem> system) : system_(std::move(system)) {}
BendingSystem::BendingSystem(BendingSystem&&) noexcept = default;
BendingSystem& BendingSystem::operator=(BendingSystem&&) noexcept = default;
BendingSystem::~BendingSystem() = default;

tl::expected<BendingSystem, std::string> BendingSystem::factorise(const Mesh& mesh, int order,
                                                                  const BendingProblem& problem) {
  BendingSystem result(std::make_unique<CondensedSystem>(assemble_bending(mesh, order, problem)));
  auto solved = result.system_->solve();
  if (!solved) return tl::unexpected(solved.error());
  result.answer_ = std::move(solved->front());
  return result;
}

Eigen::MatrixXd BendingSystem::answer_to(const Eigen::MatrixXd& loads) const {
  Eigen::MatrixXd of_elements = Eigen::MatrixXd::Zero(answer_.rows(), answer_.cols());
  of_elements.topRows(loads.rows()) = loads;
  return system_->solve_again(of_elements);
}

tl::expected<InPlaneSeries, std::string> solve_in_plane_series(const Mesh& mesh, int order,
                                                               const BendingProblem& problem) {
  BRASH_EXPECTS(problem.in_plane_stress != nullptr && problem.in_plane_load == 0.0, problem.in_plane_load);
  const auto& element = reference_element(order);
  const int n = element.n_lagrange();
  CondensedSystem system = assemble_bending(mesh, order, problem);
  const auto solved = system.solve();
  if (!solved) return tl::unexpected(solved.error());

  std::vector<Eigen::MatrixXd> w{solved->front()};  // local unknowns of w_0, w_1, w_2
  std::vector<Eigen::MatrixXd> loads;               // G w_0, G w_1
  for (int i = 0; i < 2; ++i) {
    Eigen::MatrixXd load = Eigen::MatrixXd::Zero(w.back().rows(), w.back().cols());
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
      const auto column = static_cast<Eigen::Index>(triangle);
      load.col(column).head(n) =
          -slope_work(element, jacobian_of(mesh, triangle), *problem.in_plane_stress, static_cast<int>(triangle)) *
          w.back().col(column).head(n);
    }
    w.push_back(system.solve_again(load));
    loads.push_back(std::move(load));
  }
  const double work = w[1].cwiseProduct(loads[1]).sum();  // <w_1, G w_1>; <w_1, K w_1> = <w_1, G w_0>
  InPlaneSeries series{
      .terms = {},
      .buckling_load = work > 0.0 ? w[1].cwiseProduct(loads[0]).sum() / work : std::numeric_limits<double>::infinity()};
  for (const Eigen::MatrixXd& local : w)
    series.terms.emplace_back(mesh, order, problem.poisson_ratio, local, n, element.n_rotation());
  return series;
}

tl::expected<std::vector<Field>, std::string> solve_membrane(const Mesh& mesh, int order,
                                                             const MembraneProblem& problem) {
  const auto& element = reference_element(order);
  const Nodes nodes(mesh, order);
  // Held: everything far away; across the centre line the displacement that is odd about it.
  const int odd = problem.antisymmetric ? 0 : 1;
  const auto [numbers, n_unknowns] = number_unknowns(mesh, nodes, 2, [odd](Side side, int component) {
    return side == Side::kFar || ((side == Side::kSymmetryY || side == Side::kCrack) && component == odd);
  });
  const int n = element.n_lagrange();
  std::vector<int> interior;
  for (int i = element.n_boundary(); i < n; ++i) interior.push_back(i);
  for (int i = element.n_boundary(); i < n; ++i) interior.push_back(n + i);

  const int n_loads = static_cast<int>(problem.tip_tractions.size());
  CondensedSystem system(n_unknowns, n_loads, static_cast<int>(mesh.triangles.size()), 2 * n, std::move(interior));
  for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
    const Eigen::MatrixXd stiffness = elasticity(element, jacobian_of(mesh, triangle), problem.poisson_ratio, n);
    system.add(stiffness, Eigen::MatrixXd::Zero(2 * n, n_loads), unknowns_of(nodes.of_triangle(triangle), numbers, 2));
  }
  for_each_tip_node(mesh, nodes, element, [&, &map = numbers](int node, double weight) {
    for (int which = 0; which < n_loads; ++which) {
      const Vec2 traction = problem.tip_tractions[static_cast<std::size_t>(which)];
      system.add_load(map[static_cast<std::size_t>(2 * node)], which, traction.x * weight);
      system.add_load(map[static_cast<std::size_t>(2 * node + 1)], which, traction.y * weight);
    }
  });
  return system.solve().map([&](const auto& locals) {
    std::vector<Field> fields;
    for (const auto& local : locals) fields.emplace_back(mesh, order, problem.poisson_ratio, local, 0, n);
    return fields;
  });
}

}  // namespace brash::plate
