// SPDX-License-Identifier: GPL-3.0-or-later
#include "vibration.hpp"

#include <cmath>
#include <vector>

#include "brash/core/contract.hpp"
#include "element.hpp"

namespace brash::plate {

namespace {

/// A vector this small against the first is lost in rounding.
constexpr double kExhausted = 1e-12;

double twice_area(const Mesh& mesh, Eigen::Index triangle) {
  const auto& t = mesh.triangles[static_cast<std::size_t>(triangle)];
  const Vec2 a = mesh.vertices[static_cast<std::size_t>(t[0])];
  return cross(mesh.vertices[static_cast<std::size_t>(t[1])] - a, mesh.vertices[static_cast<std::size_t>(t[2])] - a);
}

}  // namespace

Eigen::VectorXd Vibration::ramp(double t) const {
  const Eigen::ArrayXd phase = frequencies.array() * t;
  const Eigen::VectorXd amplitudes = (1.0 - phase.sin() / phase) * shapes.row(0).transpose().array();
  return at_rest * (outputs * (shapes * amplitudes));
}

Vibration reduce(const Mesh& mesh, int order, const BendingSystem& plate, const WaterUnderSheet& water, double ice_mass,
                 const Outputs& outputs_of, int n_vectors) {
  const auto& element = reference_element(order);
  const auto inertia = [&](const Eigen::MatrixXd& w) {
    Eigen::MatrixXd load = water.inertia(w);
    for (Eigen::Index t = 0; t < w.cols(); ++t)
      load.col(t) += ice_mass * twice_area(mesh, t) * element.mass() * w.col(t);
    return load;
  };

  Vibration result;
  std::vector<Eigen::MatrixXd> basis, loads;  // deflections of every element, and M times them
  std::vector<Eigen::VectorXd> outputs;
  Eigen::MatrixXd flexibility = Eigen::MatrixXd::Zero(n_vectors, n_vectors);
  Eigen::MatrixXd next = plate.answer().topRows(element.n_lagrange());
  Eigen::VectorXd next_outputs = outputs_of(plate.answer());
  for (int j = 0; j < n_vectors; ++j) {
    const Eigen::MatrixXd load = inertia(next);
    const double length = std::sqrt(next.cwiseProduct(load).sum());
    if (j == 0) result.at_rest = length;
    if (j > 0) {
      if (!(length > kExhausted * flexibility(0, 0))) break;
      flexibility(j, j - 1) = flexibility(j - 1, j) = length;
    }
    basis.emplace_back(next / length);
    loads.emplace_back(load / length);
    outputs.emplace_back(next_outputs / length);
    const Eigen::MatrixXd local = plate.answer_to(loads.back());
    next = local.topRows(next.rows());
    next_outputs = outputs_of(local);
    for (std::size_t i = loads.size(); i-- > 0;) {
      const double part = next.cwiseProduct(loads[i]).sum();
      if (i + 1 == loads.size()) flexibility(j, j) = part;
      next -= part * basis[i];
      next_outputs -= part * outputs[i];
    }
  }

  const auto n = static_cast<Eigen::Index>(basis.size());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(flexibility.topLeftCorner(n, n));
  BRASH_EXPECTS(solver.eigenvalues()(0) > 0.0, solver.eigenvalues()(0));
  result.frequencies = solver.eigenvalues().cwiseSqrt().cwiseInverse();
  result.shapes = solver.eigenvectors();
  result.outputs.resize(outputs.front().size(), n);
  for (Eigen::Index j = 0; j < n; ++j) result.outputs.col(j) = outputs[static_cast<std::size_t>(j)];
  return result;
}

}  // namespace brash::plate
