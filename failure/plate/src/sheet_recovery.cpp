// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet_recovery.hpp"

#include <algorithm>

#include "element.hpp"
#include "quadrature.hpp"
#include "sheet_fem.hpp"

namespace brash::plate {

namespace {

/// Points of a triangle at which its stress is sampled: as many squared.
constexpr int kSamples = 3;

std::size_t at_(int i) { return static_cast<std::size_t>(i); }

/// 1, x, y, x^2, x y, ... y^3.
Eigen::Matrix<double, 10, 1> monomials(Vec2 p) {
  const double x = p.x;
  const double y = p.y;
  Eigen::Matrix<double, 10, 1> result;
  result << 1.0, x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y;
  return result;
}

/// The sample points with the gradients of an element there.
struct SampleTable {
  std::vector<TrianglePoint> points;
  std::vector<Eigen::MatrixX2d> gradients;

  explicit SampleTable(const ReferenceElement& element) : points(triangle_rule(kSamples)) {
    for (const auto& point : points) gradients.push_back(element.gradients(point.xi, point.eta));
  }
};

const SampleTable& samples_of(int order) {
  static const std::array<SampleTable, 2> tables{SampleTable(reference_element(2)), SampleTable(reference_element(3))};
  return tables[at_(order - 2)];
}

}  // namespace

SheetRecovery::SheetRecovery(const Mesh& mesh, const SheetFields& fields)
    : mesh_(&mesh), fields_(&fields), around_(mesh.vertices.size()) {
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

void SheetRecovery::add_samples(int triangle, const Cubic& cubic, Eigen::Matrix<double, kTerms, kTerms>& normal,
                                Fit& right) const {
  const auto& membrane_samples = samples_of(fields_->membrane_order);
  const auto& bending_samples = samples_of(fields_->bending_order);
  const int n = reference_element(fields_->membrane_order).n_lagrange();
  const int m = reference_element(fields_->bending_order).n_rotation();
  const int first = reference_element(fields_->bending_order).n_lagrange();
  const Eigen::Matrix2d jacobian = jacobian_of(*mesh_, triangle);
  const Eigen::Matrix2d inverse = jacobian.inverse();
  const double area2 = jacobian.determinant();
  const auto stress = [&](const auto& x, const auto& y, const auto& slope) {
    Eigen::Matrix2d gradient;
    gradient.row(0) = x.transpose() * slope;
    gradient.row(1) = y.transpose() * slope;
    return elastic(gradient * inverse, fields_->poisson_ratio);
  };
  for (std::size_t s = 0; s < bending_samples.points.size(); ++s) {
    const auto& point = bending_samples.points[s];
    const Tensor2 moment = stress(fields_->bending.col(triangle).segment(first, m),
                                  fields_->bending.col(triangle).segment(first + m, m), bending_samples.gradients[s]);
    const Tensor2 membrane = stress(fields_->membrane.col(triangle).head(n), fields_->membrane.col(triangle).tail(n),
                                    membrane_samples.gradients[s].topRows(n));
    Values values;
    values << moment.xx, moment.yy, moment.xy, membrane.xx, membrane.yy, membrane.xy;
    const auto phi = monomials((place_in(*mesh_, triangle, point.xi, point.eta) - cubic.centre) / cubic.scale);
    const double weight = point.weight * area2;
    normal.noalias() += weight * phi * phi.transpose();
    right.noalias() += weight * phi * values.transpose();
  }
}

const SheetRecovery::Cubic& SheetRecovery::cubic(int vertex, bool below) {
  const auto [entry, is_new] = cubics_.try_emplace({vertex, below});
  Cubic& cubic = entry->second;
  if (!is_new) return cubic;
  const auto members = patch(vertex, below);
  cubic.centre = mesh_->vertices[at_(vertex)];
  cubic.scale = 0.0;
  for (const int t : members) {
    for (const int corner : mesh_->triangles[at_(t)]) {
      cubic.scale = std::max(cubic.scale, norm(mesh_->vertices[at_(corner)] - cubic.centre));
    }
  }
  Eigen::Matrix<double, kTerms, kTerms> normal = Eigen::Matrix<double, kTerms, kTerms>::Zero();
  Fit right = Fit::Zero();
  for (const int t : members) add_samples(t, cubic, normal, right);
  cubic.terms = normal.ldlt().solve(right);
  return cubic;
}

SheetState SheetRecovery::at(int triangle, double xi, double eta) {
  const std::array<double, 3> shares{1.0 - xi - eta, xi, eta};
  const Vec2 place = place_in(*mesh_, triangle, xi, eta);
  const bool below = is_below(triangle);
  Values values = Values::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const Cubic& around = cubic(mesh_->triangles[at_(triangle)][i], below);
    values += shares[i] * around.terms.transpose() * monomials((place - around.centre) / around.scale);
  }
  const auto& element = reference_element(fields_->bending_order);
  const int n = element.n_lagrange();
  return {.moment = {values(0), values(1), values(2)},
          .membrane = {values(3), values(4), values(5)},
          .deflection = fields_->bending.col(triangle).head(n).dot(element.values(xi, eta).head(n))};
}

}  // namespace brash::plate
