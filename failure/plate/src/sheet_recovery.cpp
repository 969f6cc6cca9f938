// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet_recovery.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "element.hpp"
#include "quadrature.hpp"
#include "sheet_fem.hpp"

namespace brash::plate {

namespace {

/// Points of a triangle at which its stress is sampled: as many squared.
constexpr int kSamples = 3;

std::size_t at_(int i) { return static_cast<std::size_t>(i); }

/// 1, x, y, x^2, x y, y^2, ... up to a degree; degree by degree.
template <int kDegree>
Eigen::Matrix<double, (kDegree + 1) * (kDegree + 2) / 2, 1> monomials(Vec2 p) {
  Eigen::Matrix<double, (kDegree + 1) * (kDegree + 2) / 2, 1> result;
  result(0) = 1.0;
  int n = 1;
  for (int degree = 1; degree <= kDegree; ++degree) {
    for (int j = 0; j < degree; ++j, ++n) result(n) = p.x * result(n - degree);
    result(n) = p.y * result(n - degree - 1);
    ++n;
  }
  return result;
}

constexpr int kPoints = kSamples * kSamples;

const std::vector<TrianglePoint>& sample_points() {
  static const std::vector<TrianglePoint> points = triangle_rule(kSamples);
  return points;
}

/// Gradients of the first n functions of an element at the sample points, two columns each.
template <int n>
using SlopeTable = Eigen::Matrix<double, n, 2 * kPoints>;

template <int n>
SlopeTable<n> slopes_of(int order) {
  SlopeTable<n> table;
  for (int s = 0; s < kPoints; ++s) {
    const auto& point = sample_points()[at_(s)];
    table.template middleCols<2>(2 * s) = reference_element(order).gradients(point.xi, point.eta).topRows(n);
  }
  return table;
}

using Stresses = Eigen::Matrix<double, 3, kPoints>;

/// Stresses of a vector field with n unknowns a component, at the sample points: xx, yy, xy.
template <int n>
Stresses stresses(const SlopeTable<n>& slopes, const double* unknowns, const Eigen::Matrix2d& inverse,
                  double poisson_ratio) {
  const Eigen::Map<const Eigen::Matrix<double, n, 2>> field(unknowns);
  const Eigen::Matrix<double, 2, 2 * kPoints> gradients = field.transpose().lazyProduct(slopes);
  Stresses result;
  for (int s = 0; s < kPoints; ++s) {
    const Tensor2 stress = elastic(gradients.template middleCols<2>(2 * s) * inverse, poisson_ratio);
    result.col(s) << stress.xx, stress.yy, stress.xy;
  }
  return result;
}

Stresses membrane_stresses(int order, const double* unknowns, const Eigen::Matrix2d& inverse, double poisson_ratio) {
  static const auto quadratic = slopes_of<6>(2);
  static const auto cubic = slopes_of<10>(3);
  return order == 2 ? stresses<6>(quadratic, unknowns, inverse, poisson_ratio)
                    : stresses<10>(cubic, unknowns, inverse, poisson_ratio);
}

/// The moments: stresses of the rotations, which have bubbles.
Stresses bending_stresses(int order, const double* unknowns, const Eigen::Matrix2d& inverse, double poisson_ratio) {
  static const auto quadratic = slopes_of<7>(2);
  static const auto cubic = slopes_of<12>(3);
  return order == 2 ? stresses<7>(quadratic, unknowns, inverse, poisson_ratio)
                    : stresses<12>(cubic, unknowns, inverse, poisson_ratio);
}

/// Sums of the products of two monomials up to degree 3, from the sums of the monomials up to degree 6.
Eigen::Matrix<double, 10, 10> products_of_cubics(const Eigen::Matrix<double, 28, 1>& moments) {
  const auto number = [](int degree, int j) { return degree * (degree + 1) / 2 + j; };
  Eigen::Matrix<double, 10, 10> result;
  for (int d = 0; d <= 3; ++d) {
    for (int i = 0; i <= d; ++i) {
      for (int e = 0; e <= 3; ++e) {
        for (int j = 0; j <= e; ++j) result(number(d, i), number(e, j)) = moments(number(d + e, i + j));
      }
    }
  }
  return result;
}

/// Corners and middles of the sides of the reference triangle.
constexpr std::array<std::array<double, 2>, 6> kNodes{{{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}}};

/// Values of the deflection's functions at kNodes.
const std::array<Eigen::VectorXd, 6>& nodal_values(int order) {
  const auto values = [](int k) {
    std::array<Eigen::VectorXd, 6> result;
    const auto& element = reference_element(k);
    for (std::size_t i = 0; i < 6; ++i)
      result[i] = element.values(kNodes[i][0], kNodes[i][1]).head(element.n_lagrange());
    return result;
  };
  static const std::array<std::array<Eigen::VectorXd, 6>, 2> tables{values(2), values(3)};
  return tables[at_(order - 2)];
}

}  // namespace

SheetRecovery::SheetRecovery(const Mesh& mesh, const SheetFields& fields)
    : mesh_(&mesh),
      fields_(&fields),
      around_(mesh.vertices.size()),
      samples_(mesh.triangles.size()),
      cubics_(2 * mesh.vertices.size()) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const int vertex : mesh.triangles[t]) around_[at_(vertex)].push_back(static_cast<int>(t));
  }
}

bool SheetRecovery::is_below(int triangle) const {
  return fields_->split && place_in(*mesh_, triangle, 1.0 / 3.0, 1.0 / 3.0).y < 0.0;
}

std::vector<int> SheetRecovery::patch(int vertex, bool below) const {
  std::vector<int> members;
  const auto add = [&](int v) {
    for (const int t : around_[at_(v)]) {
      if (is_below(t) == below && std::find(members.begin(), members.end(), t) == members.end()) members.push_back(t);
    }
  };
  add(vertex);
  std::size_t before = 0;
  while (members.size() < fields_->smallest_patch && members.size() > before) {
    before = members.size();
    for (std::size_t i = 0; i < before; ++i) {
      for (const int corner : mesh_->triangles[at_(members[i])]) add(corner);
    }
  }
  return members;
}

const SheetRecovery::Samples& SheetRecovery::samples(int triangle) {
  std::optional<Samples>& samples = samples_[at_(triangle)];
  if (samples) return *samples;
  samples.emplace();
  const Eigen::Matrix2d jacobian = jacobian_of(*mesh_, triangle);
  const Eigen::Matrix2d inverse = jacobian.inverse();
  const int n_deflection = reference_element(fields_->bending_order).n_lagrange();
  samples->area2 = jacobian.determinant();
  for (std::size_t s = 0; s < samples->places.size(); ++s) {
    const auto& point = sample_points()[s];
    samples->places[s] = place_in(*mesh_, triangle, point.xi, point.eta);
  }
  samples->values.topRows<3>() = bending_stresses(
      fields_->bending_order, fields_->bending.col(triangle).data() + n_deflection, inverse, fields_->poisson_ratio);
  samples->values.bottomRows<3>() = membrane_stresses(fields_->membrane_order, fields_->membrane.col(triangle).data(),
                                                      inverse, fields_->poisson_ratio);
  return *samples;
}

void SheetRecovery::add_samples(int triangle, const Cubic& cubic, Moments& moments, Fit& right) {
  const Samples& samples = this->samples(triangle);
  for (int s = 0; s < kPoints; ++s) {
    const auto phi = monomials<6>((samples.places[at_(s)] - cubic.centre) / cubic.scale);
    const double weight = sample_points()[at_(s)].weight * samples.area2;
    moments += weight * phi;
    right.noalias() += (weight * phi.head<kTerms>()) * samples.values.col(s).transpose();
  }
}

const SheetRecovery::Cubic& SheetRecovery::cubic(int vertex, bool below) {
  std::optional<Cubic>& known = cubics_[at_(2 * vertex + (below ? 1 : 0))];
  if (known) return *known;
  Cubic& cubic = known.emplace();
  const auto members = patch(vertex, below);
  cubic.centre = mesh_->vertices[at_(vertex)];
  double square = 0.0;
  for (const int t : members) {
    for (const int corner : mesh_->triangles[at_(t)]) {
      const Vec2 off = mesh_->vertices[at_(corner)] - cubic.centre;
      square = std::max(square, dot(off, off));
    }
  }
  cubic.scale = std::sqrt(square);
  Moments moments = Moments::Zero();
  Fit right = Fit::Zero();
  for (const int t : members) add_samples(t, cubic, moments, right);
  cubic.terms = products_of_cubics(moments).ldlt().solve(right);
  return cubic;
}

SheetState SheetRecovery::blend(int triangle, double xi, double eta) {
  const std::array<double, 3> shares{1.0 - xi - eta, xi, eta};
  const Vec2 place = place_in(*mesh_, triangle, xi, eta);
  const bool below = is_below(triangle);
  Values values = Values::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    if (shares[i] == 0.0) continue;
    const Cubic& around = cubic(mesh_->triangles[at_(triangle)][i], below);
    values += shares[i] * around.terms.transpose() * monomials<3>((place - around.centre) / around.scale);
  }
  return {
      .moment = {values(0), values(1), values(2)}, .membrane = {values(3), values(4), values(5)}, .deflection = 0.0};
}

SheetState SheetRecovery::at(int triangle, double xi, double eta) {
  SheetState state = blend(triangle, xi, eta);
  const auto& element = reference_element(fields_->bending_order);
  const int n = element.n_lagrange();
  state.deflection = fields_->bending.col(triangle).head(n).dot(element.values(xi, eta).head(n));
  return state;
}

std::vector<SheetPlace> SheetRecovery::at_nodes(const std::function<bool(Vec2)>& wanted) {
  const std::size_t n_vertices = mesh_->vertices.size();
  const int n = reference_element(fields_->bending_order).n_lagrange();
  std::vector<char> is_known(2 * (n_vertices + mesh_->edges.size()), 0);
  std::vector<SheetPlace> places;
  for (int triangle = 0; triangle < static_cast<int>(mesh_->triangles.size()); ++triangle) {
    for (std::size_t i = 0; i < kNodes.size(); ++i) {
      const std::size_t node = i < 3 ? at_(mesh_->triangles[at_(triangle)][i])
                                     : n_vertices + at_(mesh_->triangle_edges[at_(triangle)][i - 3]);
      char& known = is_known[2 * node + (is_below(triangle) ? 1 : 0)];
      if (known != 0) continue;
      known = 1;
      const auto& [xi, eta] = kNodes[i];
      const Vec2 at = place_in(*mesh_, triangle, xi, eta);
      if (!wanted(at)) continue;
      places.push_back({at, blend(triangle, xi, eta)});
      places.back().state.deflection =
          fields_->bending.col(triangle).head(n).dot(nodal_values(fields_->bending_order)[i]);
    }
  }
  return places;
}

}  // namespace brash::plate
