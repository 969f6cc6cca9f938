// SPDX-License-Identifier: GPL-3.0-or-later
#include "water.hpp"

#include <Eigen/Sparse>
#include <algorithm>

#include "brash/core/contract.hpp"
#include "element.hpp"
#include "quadrature.hpp"
#include "triangle_potential.hpp"

namespace brash::plate {

namespace {

bool is_symmetry(Side side) { return side == Side::kSymmetryY || side == Side::kCrack; }

/// Numbers the vertices where the potential is not zero.
std::pair<std::vector<int>, int> number_vertices(const Mesh& mesh) {
  std::vector<int> unknown(mesh.vertices.size(), 0);
  for (const auto& tagged : mesh.tagged) {
    if (is_symmetry(tagged.side) || tagged.side == Side::kInterior) continue;
    for (const int vertex : mesh.edges[static_cast<std::size_t>(tagged.edge)])
      unknown[static_cast<std::size_t>(vertex)] = -1;
  }
  int count = 0;
  for (int& number : unknown)
    if (number == 0) number = count++;
  return {std::move(unknown), count};
}

using Sparse = Eigen::SparseMatrix<double>;

/// The two components of the gradient on every triangle, shape=(n_triangles, n_unknowns) each.
std::array<Sparse, 2> gradients(const Mesh& mesh, const std::vector<int>& unknown, int n_unknowns) {
  std::array<std::vector<Eigen::Triplet<double>>, 2> entries;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto at = [&](std::size_t i) { return mesh.vertices[static_cast<std::size_t>(mesh.triangles[t][i % 3])]; };
    const double area2 = cross(at(1) - at(0), at(2) - at(0));
    for (std::size_t i = 0; i < 3; ++i) {
      const int column = unknown[static_cast<std::size_t>(mesh.triangles[t][i])];
      if (column < 0) continue;
      // The edge opposite to the vertex, turned by a right angle.
      const Vec2 opposite = at(i + 2) - at(i + 1);
      entries[0].emplace_back(static_cast<int>(t), column, -opposite.y / area2);
      entries[1].emplace_back(static_cast<int>(t), column, opposite.x / area2);
    }
  }
  std::array<Sparse, 2> result;
  for (std::size_t c = 0; c < 2; ++c) {
    result[c].resize(static_cast<Eigen::Index>(mesh.triangles.size()), n_unknowns);
    result[c].setFromTriplets(entries[c].begin(), entries[c].end());
  }
  return result;
}

Eigen::MatrixXd energy(const Sparse& gradient, const Eigen::MatrixXd& potentials) {
  const Eigen::MatrixXd half = potentials * gradient;
  return gradient.transpose() * half;
}

/// The quadratic form of the potential.
Eigen::MatrixXd assemble(const Mesh& mesh, const std::vector<int>& unknown, int n_unknowns) {
  const auto [x, y] = gradients(mesh, unknown, n_unknowns);
  Eigen::MatrixXd potentials = mutual_potentials(mesh, false);
  const bool mirrored =
      std::any_of(mesh.tagged.begin(), mesh.tagged.end(), [](const TaggedEdge& e) { return is_symmetry(e.side); });
  if (!mirrored) return energy(x, potentials) + energy(y, potentials);
  // On the other side of the x-axis the gradient has the opposite y.
  const Eigen::MatrixXd images = mutual_potentials(mesh, true);
  potentials += images;
  Eigen::MatrixXd result = energy(x, potentials);
  potentials -= 2.0 * images;
  result += energy(y, potentials);
  return result;
}

/// int lambda_a phi_j on the reference triangle.
Eigen::MatrixXd moments_of(int order) {
  const auto& element = reference_element(order);
  Eigen::MatrixXd moments = Eigen::MatrixXd::Zero(3, element.n_lagrange());
  for (const auto& point : triangle_rule(order + 1)) {
    const Eigen::Vector3d lambda(1.0 - point.xi - point.eta, point.xi, point.eta);
    moments += point.weight * lambda * element.values(point.xi, point.eta).head(element.n_lagrange()).transpose();
  }
  return moments;
}

}  // namespace

WaterUnderSheet::WaterUnderSheet(const Mesh& mesh, int order)
    : mesh_(&mesh), moments_(moments_of(order)), area2_(static_cast<Eigen::Index>(mesh.triangles.size())) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto at = [&](std::size_t i) { return mesh.vertices[static_cast<std::size_t>(mesh.triangles[t][i])]; };
    area2_(static_cast<Eigen::Index>(t)) = cross(at(1) - at(0), at(2) - at(0));
  }
  int n_unknowns = 0;
  std::tie(unknown_, n_unknowns) = number_vertices(mesh);
  factor_.compute(assemble(mesh, unknown_, n_unknowns));
  BRASH_EXPECTS(factor_.info() == Eigen::Success, n_unknowns);
}

Eigen::VectorXd WaterUnderSheet::potential(const Eigen::MatrixXd& velocities) const {
  BRASH_EXPECTS(velocities.cols() == area2_.size() && velocities.rows() == moments_.cols(), velocities.rows());
  const Eigen::MatrixXd flux = moments_ * velocities * area2_.asDiagonal();
  Eigen::VectorXd right = Eigen::VectorXd::Zero(factor_.rows());
  const auto for_each_corner = [&](const auto& visit) {
    for (std::size_t t = 0; t < mesh_->triangles.size(); ++t) {
      for (Eigen::Index i = 0; i < 3; ++i) {
        const int number = unknown_[static_cast<std::size_t>(mesh_->triangles[t][static_cast<std::size_t>(i)])];
        if (number >= 0) visit(number, i, static_cast<Eigen::Index>(t));
      }
    }
  };
  for_each_corner([&](int number, Eigen::Index i, Eigen::Index t) { right(number) += flux(i, t); });
  factor_.solveInPlace(right);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh_->vertices.size()));
  for (std::size_t v = 0; v < unknown_.size(); ++v)
    if (unknown_[v] >= 0) result(static_cast<Eigen::Index>(v)) = right(unknown_[v]);
  return result;
}

Eigen::MatrixXd WaterUnderSheet::inertia(const Eigen::MatrixXd& deflections) const {
  const Eigen::VectorXd phi = potential(deflections);
  Eigen::MatrixXd corners(3, area2_.size());
  for (Eigen::Index t = 0; t < corners.cols(); ++t)
    for (Eigen::Index i = 0; i < 3; ++i)
      corners(i, t) = phi(mesh_->triangles[static_cast<std::size_t>(t)][static_cast<std::size_t>(i)]);
  return moments_.transpose() * corners * area2_.asDiagonal();
}

}  // namespace brash::plate
