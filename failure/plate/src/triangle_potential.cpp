// SPDX-License-Identifier: GPL-3.0-or-later
#include "triangle_potential.hpp"

#include <cmath>
#include <numbers>

#include "quadrature.hpp"

namespace brash::plate {

namespace {

/// Triangles are far from each other where their centres are further apart than so many times their longest edges
/// together. The three-point rules then err by less than 1e-3 of a potential.
constexpr double kFar = 1.25;
/// Points of the rule along each direction for the outer integral over a near triangle, and over the same.
constexpr int kNearPoints = 3;
constexpr int kSamePoints = 5;
/// A place this near to the line of an edge, over its length, sees no area on either side of it.
constexpr double kOnLine = 1e-12;

/// A triangle and its three-point rule of degree 2.
struct Panel {
  std::array<Vec2, 3> corners;
  std::array<Vec2, 3> points;
  Vec2 centre;
  double area = 0.0;
  double longest = 0.0;
};

Panel panel_of(const std::array<Vec2, 3>& corners) {
  Panel panel{.corners = corners, .points = {}, .centre = {}};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 a = corners[i], b = corners[(i + 1) % 3], c = corners[(i + 2) % 3];
    panel.points[i] = (2.0 / 3.0) * a + (1.0 / 6.0) * b + (1.0 / 6.0) * c;
    panel.centre = panel.centre + a / 3.0;
    panel.longest = std::max(panel.longest, norm(b - a));
  }
  panel.area = 0.5 * std::abs(cross(corners[1] - corners[0], corners[2] - corners[0]));
  return panel;
}

std::vector<Panel> panels_of(const Mesh& mesh, bool reflected) {
  std::vector<Panel> panels;
  for (const auto& triangle : mesh.triangles) {
    std::array<Vec2, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = mesh.vertices[static_cast<std::size_t>(triangle[i])];
      if (reflected) corners[i].y = -corners[i].y;
    }
    panels.push_back(panel_of(corners));
  }
  return panels;
}

double far_pair(const Panel& a, const Panel& b) {
  double sum = 0.0;
  for (const Vec2& p : a.points) {
    for (const Vec2& q : b.points) {
      const double x = p.x - q.x, y = p.y - q.y;
      sum += 1.0 / std::sqrt(x * x + y * y);
    }
  }
  return a.area * b.area * sum / 9.0;
}

/// The exact potential of `inner` under a rule with `n` points along each direction of `outer`.
double near_pair(const Panel& outer, const Panel& inner, const std::vector<TrianglePoint>& rule) {
  double sum = 0.0;
  for (const auto& point : rule) {
    const auto& c = outer.corners;
    sum += point.weight * potential(inner.corners, c[0] + point.xi * (c[1] - c[0]) + point.eta * (c[2] - c[0]));
  }
  return 2.0 * outer.area * sum;
}

}  // namespace

double potential(const std::array<Vec2, 3>& triangle, Vec2 place) {
  double sum = 0.0;
  for (std::size_t e = 0; e < 3; ++e) {
    // Green's formula: each edge gives its signed distance times the integral of ds / r along it.
    const Vec2 from = triangle[e] - place, to = triangle[(e + 1) % 3] - place;
    const double length = norm(to - from);
    const Vec2 along = (to - from) / length;
    const double distance = cross(from, along);
    if (std::abs(distance) < kOnLine * length) continue;
    sum += distance *
           (std::asinh(dot(to, along) / std::abs(distance)) - std::asinh(dot(from, along) / std::abs(distance)));
  }
  return std::abs(sum);
}

Eigen::MatrixXd mutual_potentials(const Mesh& mesh, bool reflected) {
  const std::vector<Panel> panels = panels_of(mesh, false);
  const std::vector<Panel> others = panels_of(mesh, reflected);
  const auto near_rule = triangle_rule(kNearPoints), same_rule = triangle_rule(kSamePoints);
  const auto n = static_cast<Eigen::Index>(panels.size());
  Eigen::MatrixXd result(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Panel& b = others[static_cast<std::size_t>(j)];
    for (Eigen::Index i = j; i < n; ++i) {
      const Panel& a = panels[static_cast<std::size_t>(i)];
      double value = 0.0;
      if (norm(a.centre - b.centre) > kFar * (a.longest + b.longest))
        value = far_pair(a, b);
      else if (i == j && !reflected)
        value = near_pair(a, b, same_rule);
      else
        value = a.area < b.area ? near_pair(a, b, near_rule) : near_pair(b, a, near_rule);
      result(i, j) = result(j, i) = value / (2.0 * std::numbers::pi);
    }
  }
  return result;
}

}  // namespace brash::plate
