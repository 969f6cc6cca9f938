// SPDX-License-Identifier: GPL-3.0-or-later
#include "element.hpp"

#include <cmath>
#include <vector>

#include "brash/core/contract.hpp"
#include "quadrature.hpp"

namespace brash::plate {

namespace {

constexpr std::array<Vec2, 3> kCorners{{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}};

double power(double base, int exponent) {
  double result = 1.0;
  for (int i = 0; i < exponent; ++i) result *= base;
  return result;
}

std::vector<Vec2> lagrange_nodes(int k) {
  std::vector<Vec2> nodes(kCorners.begin(), kCorners.end());
  for (std::size_t e = 0; e < 3; ++e) {
    for (int i = 1; i < k; ++i) {
      nodes.push_back(kCorners[e] + (static_cast<double>(i) / k) * (kCorners[(e + 1) % 3] - kCorners[e]));
    }
  }
  for (int j = 1; j < k; ++j) {
    for (int i = 1; i + j < k; ++i) nodes.push_back({static_cast<double>(i) / k, static_cast<double>(j) / k});
  }
  return nodes;
}

}  // namespace

ReferenceElement::ReferenceElement(int order) : order_(order) {
  BRASH_EXPECTS(order >= 2 && order <= 4, order);
  build_lagrange();
  build_integrals();
  build_shear();
}

Eigen::VectorXd ReferenceElement::monomials(double xi, double eta) const {
  Eigen::VectorXd result(n_lagrange());
  int n = 0;
  for (int degree = 0; degree <= order_; ++degree) {
    for (int j = 0; j <= degree; ++j) result(n++) = power(xi, degree - j) * power(eta, j);
  }
  return result;
}

Eigen::MatrixX2d ReferenceElement::monomial_gradients(double xi, double eta) const {
  Eigen::MatrixX2d result = Eigen::MatrixX2d::Zero(n_lagrange(), 2);
  int n = 0;
  for (int degree = 0; degree <= order_; ++degree) {
    for (int j = 0; j <= degree; ++j, ++n) {
      const int i = degree - j;
      if (i > 0) result(n, 0) = i * power(xi, i - 1) * power(eta, j);
      if (j > 0) result(n, 1) = j * power(xi, i) * power(eta, j - 1);
    }
  }
  return result;
}

void ReferenceElement::build_lagrange() {
  const auto nodes = lagrange_nodes(order_);
  Eigen::MatrixXd vandermonde(n_lagrange(), n_lagrange());
  for (int i = 0; i < n_lagrange(); ++i) {
    const Vec2 node = nodes[static_cast<std::size_t>(i)];
    vandermonde.row(i) = monomials(node.x, node.y).transpose();
  }
  coefficients_ = vandermonde.inverse().transpose();
}

Eigen::VectorXd ReferenceElement::values(double xi, double eta) const {
  Eigen::VectorXd result(n_rotation());
  result.head(n_lagrange()) = coefficients_ * monomials(xi, eta);
  const double bubble = 27.0 * xi * eta * (1.0 - xi - eta);
  for (int j = 0; j < order_ - 1; ++j) {
    result(n_lagrange() + j) = bubble * power(xi, order_ - 2 - j) * power(eta, j);
  }
  return result;
}

Eigen::MatrixX2d ReferenceElement::gradients(double xi, double eta) const {
  Eigen::MatrixX2d result(n_rotation(), 2);
  result.topRows(n_lagrange()) = coefficients_ * monomial_gradients(xi, eta);
  for (int j = 0; j < order_ - 1; ++j) {
    // xi^a eta^b (1 - xi - eta) with a = k - 1 - j, b = j + 1
    const int a = order_ - 1 - j;
    const int b = j + 1;
    const double zeta = 1.0 - xi - eta;
    result(n_lagrange() + j, 0) = 27.0 * power(xi, a - 1) * power(eta, b) * (a * zeta - xi);
    result(n_lagrange() + j, 1) = 27.0 * power(xi, a) * power(eta, b - 1) * (b * zeta - eta);
  }
  return result;
}

Eigen::VectorXd ReferenceElement::edge_load() const {
  Eigen::VectorXd along = Eigen::VectorXd::Zero(order_ + 1);
  for (const auto& point : line_rule(order_ + 1)) {
    const Eigen::VectorXd phi = values(point.s, 0.0);
    along(0) += point.weight * phi(0);
    for (int i = 1; i < order_; ++i) along(i) += point.weight * phi(2 + i);
    along(order_) += point.weight * phi(1);
  }
  return along;
}

void ReferenceElement::build_integrals() {
  for (auto& matrix : stiffness_) matrix = Eigen::MatrixXd::Zero(n_rotation(), n_rotation());
  mass_ = Eigen::MatrixXd::Zero(n_lagrange(), n_lagrange());
  load_ = Eigen::VectorXd::Zero(n_lagrange());
  for (const auto& point : triangle_rule(order_ + 2)) {
    const Eigen::VectorXd phi = values(point.xi, point.eta).head(n_lagrange());
    const Eigen::MatrixX2d slope = gradients(point.xi, point.eta);
    mass_ += point.weight * phi * phi.transpose();
    load_ += point.weight * phi;
    for (int a = 0; a < 2; ++a) {
      for (int b = 0; b < 2; ++b) {
        stiffness_[index(a, b)] += point.weight * slope.col(a) * slope.col(b).transpose();
      }
    }
  }
}

Eigen::MatrixX2d ReferenceElement::shear_basis(double xi, double eta) const {
  // [P_{k-1}]^2 and (eta, -xi) times the homogeneous polynomials of degree k - 1.
  Eigen::MatrixX2d result = Eigen::MatrixX2d::Zero(n_shear(), 2);
  int n = 0;
  for (int degree = 0; degree < order_; ++degree) {
    for (int j = 0; j <= degree; ++j) {
      const double value = power(xi, degree - j) * power(eta, j);
      result(n++, 0) = value;
      result(n++, 1) = value;
      if (degree == order_ - 1) result.row(n++) << eta * value, -xi * value;
    }
  }
  return result;
}

template <typename Field>
Eigen::MatrixXd ReferenceElement::shear_moments(const Field& field, int n_fields) const {
  Eigen::MatrixXd moments = Eigen::MatrixXd::Zero(n_shear(), n_fields);
  int row = 0;
  // Tangential moments on each edge against s^0 .. s^{k-1}.
  for (std::size_t e = 0; e < 3; ++e, row += order_) {
    const Vec2 tangent = kCorners[(e + 1) % 3] - kCorners[e];
    for (const auto& point : line_rule(order_ + 2)) {
      const Vec2 place = kCorners[e] + point.s * tangent;
      const Eigen::MatrixX2d f = field(place.x, place.y);
      const Eigen::VectorXd along = f.col(0) * tangent.x + f.col(1) * tangent.y;
      for (int j = 0; j < order_; ++j) {
        moments.row(row + j) += point.weight * power(point.s - 0.5, j) * along.transpose();
      }
    }
  }
  // Moments inside against [P_{k-2}]^2.
  for (const auto& point : triangle_rule(order_ + 3)) {
    const Eigen::MatrixX2d f = field(point.xi, point.eta);
    int n = row;
    for (int degree = 0; degree <= order_ - 2; ++degree) {
      for (int j = 0; j <= degree; ++j) {
        const double test = point.weight * power(point.xi, degree - j) * power(point.eta, j);
        moments.row(n++) += test * f.col(0).transpose();
        moments.row(n++) += test * f.col(1).transpose();
      }
    }
  }
  return moments;
}

void ReferenceElement::build_shear() {
  const Eigen::MatrixXd basis =
      shear_moments([this](double xi, double eta) { return shear_basis(xi, eta); }, n_shear());
  const Eigen::PartialPivLU<Eigen::MatrixXd> solver(basis);
  shear_of_deflection_ = solver.solve(shear_moments(
      [this](double xi, double eta) -> Eigen::MatrixX2d { return gradients(xi, eta).topRows(n_lagrange()); },
      n_lagrange()));
  for (int a = 0; a < 2; ++a) {
    const auto component = [this, a](double xi, double eta) {
      Eigen::MatrixX2d field = Eigen::MatrixX2d::Zero(n_rotation(), 2);
      field.col(a) = values(xi, eta);
      return field;
    };
    shear_of_rotation_[static_cast<std::size_t>(a)] = solver.solve(shear_moments(component, n_rotation()));
  }
  for (auto& gram : shear_gram_) gram = Eigen::MatrixXd::Zero(n_shear(), n_shear());
  for (const auto& point : triangle_rule(order_ + 1)) {
    const Eigen::MatrixX2d f = shear_basis(point.xi, point.eta);
    for (int a = 0; a < 2; ++a) {
      for (int b = 0; b < 2; ++b) shear_gram_[index(a, b)] += point.weight * f.col(a) * f.col(b).transpose();
    }
  }
}

const ReferenceElement& reference_element(int order) {
  static const std::array<ReferenceElement, 3> elements{ReferenceElement(2), ReferenceElement(3), ReferenceElement(4)};
  BRASH_EXPECTS(order >= 2 && order <= 4, order);
  return elements[static_cast<std::size_t>(order - 2)];
}

}  // namespace brash::plate
