// SPDX-License-Identifier: GPL-3.0-or-later
#include "axis_moments.hpp"

#include "brash/core/contract.hpp"
#include "element.hpp"
#include "quadrature.hpp"

namespace brash::plate {

namespace {

/// Derivatives of the rotations' functions along x and y at the points of the rule on one triangle, shape=(n_points,
/// n_rotation) each.
std::array<Eigen::MatrixXd, 2> slopes_on(const Mesh& mesh, std::size_t triangle,
                                         const std::vector<Eigen::MatrixX2d>& reference) {
  const auto at = [&](std::size_t i) { return mesh.vertices[static_cast<std::size_t>(mesh.triangles[triangle][i])]; };
  const Vec2 u = at(1) - at(0), v = at(2) - at(0);
  Eigen::Matrix2d jacobian;
  jacobian << u.x, v.x, u.y, v.y;
  const Eigen::Matrix2d inverse = jacobian.inverse();
  const auto n_points = static_cast<Eigen::Index>(reference.size());
  std::array<Eigen::MatrixXd, 2> result{Eigen::MatrixXd(n_points, reference.front().rows()),
                                        Eigen::MatrixXd(n_points, reference.front().rows())};
  for (Eigen::Index p = 0; p < n_points; ++p) {
    const Eigen::MatrixX2d slope = reference[static_cast<std::size_t>(p)] * inverse;
    for (std::size_t c = 0; c < 2; ++c) result[c].row(p) = slope.col(static_cast<Eigen::Index>(c)).transpose();
  }
  return result;
}

}  // namespace

AxisMoments::AxisMoments(const Mesh& mesh, int order, double poisson_ratio, const std::vector<double>& stations,
                         Parity parity)
    : order_(order) {
  const auto& element = reference_element(order);
  std::vector<Eigen::MatrixX2d> reference;
  for (const auto& point : triangle_rule(order + 1)) reference.push_back(element.gradients(point.xi, point.eta));

  const int m = element.n_rotation();
  const auto n_stations = static_cast<int>(stations.size());
  std::vector<Eigen::Triplet<double>> entries;
  const auto terms = recovery_terms(mesh, order, stations, parity);
  for (int i = 0; i < n_stations; ++i) {
    const auto& of_station = terms[static_cast<std::size_t>(i)];
    // The points of a triangle follow each other.
    for (std::size_t from = 0, to = 0; from < of_station.size(); from = to) {
      const int t = of_station[from].triangle;
      Eigen::RowVectorXd weights = Eigen::RowVectorXd::Zero(static_cast<Eigen::Index>(reference.size()));
      for (to = from; to < of_station.size() && of_station[to].triangle == t; ++to)
        weights(of_station[to].point) += of_station[to].weight;
      const auto [dx, dy] = slopes_on(mesh, static_cast<std::size_t>(t), reference);
      const Eigen::RowVectorXd x = weights * dx, y = weights * dy;
      for (int j = 0; j < m; ++j) {
        const int column = t * 2 * m + j;
        entries.emplace_back(i, column, x(j));
        entries.emplace_back(i, column + m, poisson_ratio * y(j));
        entries.emplace_back(n_stations + i, column, poisson_ratio * x(j));
        entries.emplace_back(n_stations + i, column + m, y(j));
      }
    }
  }
  operator_.resize(2 * n_stations, 2 * m * static_cast<Eigen::Index>(mesh.triangles.size()));
  operator_.setFromTriplets(entries.begin(), entries.end());
}

Eigen::VectorXd AxisMoments::operator()(const Eigen::MatrixXd& local) const {
  const int m = reference_element(order_).n_rotation();
  BRASH_EXPECTS(operator_.cols() == 2 * m * local.cols(), operator_.cols(), local.cols());
  const Eigen::MatrixXd rotations = local.bottomRows(2 * m);
  return operator_ * rotations.reshaped();
}

}  // namespace brash::plate
