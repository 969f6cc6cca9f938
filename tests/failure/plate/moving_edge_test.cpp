// SPDX-License-Identifier: GPL-3.0-or-later
// Added masses with closed forms, the static limit of a moving edge, and its responses against an independent
// finite-element and boundary-element calculation.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <iostream>
#include <numbers>
#include <vector>

#include "brash/plate/edge_responses.hpp"
#include "element.hpp"
#include "mesh.hpp"
#include "triangle_potential.hpp"
#include "water.hpp"

namespace plate = brash::plate;
using brash::Vec2;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kOrder = 2;

/// The half y > 0 of an ellipse, as a polygon of the same area with sides of about `size`; elements of that size,
/// smaller by `grading` at the edge.
plate::Mesh half_ellipse(double a, double b, double size, double grading) {
  const int n_sides = static_cast<int>(std::ceil(kPi * std::max(a, b) / size));
  const double step = kPi / n_sides;
  const double factor = std::sqrt(step / std::sin(step));
  plate::Domain domain;
  domain.largest_size = size;
  Vec2 last{factor * a, 0.0};
  for (int i = 1; i <= n_sides; ++i) {
    Vec2 next{factor * a * std::cos(i * step), factor * b * std::sin(i * step)};
    if (i == n_sides) next.y = 0.0;
    domain.segments.push_back({last, next, plate::Side::kFree});
    domain.sizes.push_back({last, next, size * grading, 0.3});
    last = next;
  }
  domain.segments.push_back({last, {factor * a, 0.0}, plate::Side::kSymmetryY});
  auto mesh = plate::mesh_domain(domain);
  BOOST_REQUIRE(mesh.has_value());
  return *mesh;
}

/// Of the whole body that moves with unit acceleration.
double added_mass(const plate::Mesh& mesh) {
  const plate::WaterUnderSheet water(mesh, kOrder);
  const auto n = static_cast<Eigen::Index>(mesh.triangles.size());
  return 2.0 * water.inertia(Eigen::MatrixXd::Ones(plate::reference_element(kOrder).n_lagrange(), n)).sum();
}

double ellipse(double a, double b) {
  return 2.0 * kPi * a * b * b / (3.0 * std::comp_ellint_2(std::sqrt(1.0 - b * b / (a * a))));
}

double report(const char* what, double found, double wanted) {
  std::cout << what << ": " << found << ", exact " << wanted << ", error " << 100.0 * (found / wanted - 1.0) << " %\n";
  return std::abs(found / wanted - 1.0);
}

plate::EdgeResponses solved(const plate::EdgeGeometry& geometry) {
  auto responses = plate::solve(geometry);
  BOOST_REQUIRE_MESSAGE(responses.has_value(), (responses ? "" : responses.error().what));
  return *responses;
}

double largest(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

void check_static_limit(const plate::EdgeGeometry& g) {
  const auto moving = solved(g);
  const auto fixed = plate::solve(plate::WedgePlate{.depth = g.depth,
                                                    .contact_length = g.contact_length,
                                                    .angle = g.angle,
                                                    .thickness = g.thickness,
                                                    .split = g.split});
  BOOST_REQUIRE(fixed.has_value());
  std::vector<double> bending, normal;
  for (const auto& t : fixed->bending) bending.push_back(t.xx);
  for (const auto& t : fixed->normal) normal.push_back(-t.xx);
  std::vector<double> moving_normal;
  for (const double n : moving.axis_normal) moving_normal.push_back(-n);
  BOOST_TEST(report("static moment on the axis", largest(moving.static_axis_moment), largest(bending)) < 1e-3);
  BOOST_TEST(report("membrane stress", largest(moving_normal), largest(normal)) < 1e-3);
  if (g.split) return;  // the static deflections are smoothed across the crack, the static edge moment is zero
  BOOST_TEST(report("static deflection", moving.static_deflection, fixed->deflection.front()) < 1e-3);
  BOOST_TEST(report("static moment along the edge", moving.static_edge_moment, fixed->bending.front().yy) < 1e-3);
}

/// Ramp over t: the reference's step responses, integrated.
struct Reference {
  double time, deflection, edge_moment;
};

void check_against(const plate::EdgeGeometry& geometry, const std::vector<Reference>& rows) {
  const auto r = solved(geometry);
  for (const Reference& row : rows) {
    const auto w = plate::series_weights(r.time, row.time);
    double deflection = 0.0, edge_moment = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
      deflection += w.weight[i] * r.deflection[w.first + i];
      edge_moment += w.weight[i] * r.edge_moment[w.first + i];
    }
    // Within 1.5 %: half of it is the integration of the reference.
    std::cout << "t " << row.time << ": ";
    BOOST_TEST(report("deflection", deflection, row.deflection) < 0.015);
    std::cout << "t " << row.time << ": ";
    BOOST_TEST(report("moment along the edge", edge_moment, row.edge_moment) < 0.02);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_potential_of_a_triangle_is_that_of_its_points) {
  // Far away the area counts alone; at the middle of a side of a right triangle the integral is elementary.
  const std::array<Vec2, 3> triangle{{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}};
  BOOST_TEST(std::abs(plate::potential(triangle, {300.0, 400.0}) * 500.0 - 0.5) < 1e-3);
  BOOST_TEST(std::abs(plate::potential(triangle, {0.0, 0.0}) - std::sqrt(2.0) * std::asinh(1.0)) < 1e-12);
}

BOOST_AUTO_TEST_CASE(a_disc_moves_the_mass_of_water_that_potential_flow_says) {
  BOOST_TEST(report("disc", added_mass(half_ellipse(1.0, 1.0, 0.15, 0.1)), 4.0 / 3.0) < 0.005);
}

BOOST_AUTO_TEST_CASE(an_ellipse_moves_the_mass_of_water_that_potential_flow_says) {
  BOOST_TEST(report("ellipse 2:1", added_mass(half_ellipse(2.0, 1.0, 0.2, 0.1)), ellipse(2.0, 1.0)) < 0.005);
  BOOST_TEST(report("ellipse 1:2", added_mass(half_ellipse(1.0, 2.0, 0.2, 0.1)), ellipse(2.0, 1.0)) < 0.005);
}

BOOST_AUTO_TEST_CASE(the_added_mass_converges_with_the_size_of_the_elements) {
  // The potential falls as a square root at the edge: linear elements of one size are of first order.
  const double coarse = report("disc, size 0.2", added_mass(half_ellipse(1.0, 1.0, 0.2, 1.0)), 4.0 / 3.0);
  const double fine = report("disc, size 0.1", added_mass(half_ellipse(1.0, 1.0, 0.1, 1.0)), 4.0 / 3.0);
  BOOST_TEST(coarse / fine > 1.7);
}

BOOST_AUTO_TEST_CASE(the_middle_of_a_long_strip_moves_its_mass_of_water) {
  constexpr double kLength = 8.0;
  plate::Domain domain;
  domain.segments = {{{-kLength, 0.0}, {kLength, 0.0}, plate::Side::kSymmetryY},
                     {{kLength, 0.0}, {kLength, 1.0}, plate::Side::kFree},
                     {{kLength, 1.0}, {-kLength, 1.0}, plate::Side::kFree},
                     {{-kLength, 1.0}, {-kLength, 0.0}, plate::Side::kFree},
                     {{-1.0, 0.0}, {-1.0, 1.0}, plate::Side::kInterior},
                     {{1.0, 0.0}, {1.0, 1.0}, plate::Side::kInterior}};
  domain.largest_size = 0.5;
  domain.sizes = {{{-2.0, 1.0}, {2.0, 1.0}, 0.015, 0.3}};
  const auto mesh = plate::mesh_domain(domain);
  BOOST_REQUIRE(mesh.has_value());
  const plate::WaterUnderSheet water(*mesh, kOrder);
  const auto load = water.inertia(Eigen::MatrixXd::Ones(plate::reference_element(kOrder).n_lagrange(),
                                                        static_cast<Eigen::Index>(mesh->triangles.size())));
  double mass = 0.0;  // of |x| < 1, both halves
  for (std::size_t t = 0; t < mesh->triangles.size(); ++t) {
    double x = 0.0;
    for (const int v : mesh->triangles[t]) x += mesh->vertices[static_cast<std::size_t>(v)].x / 3.0;
    if (std::abs(x) < 1.0) mass += 2.0 * load.col(static_cast<Eigen::Index>(t)).sum();
  }
  // The ends take about (half width / length)^2 / 4.
  BOOST_TEST(report("strip, per length", 0.5 * mass, 0.5 * kPi) < 0.01);
}

BOOST_AUTO_TEST_CASE(a_moving_edge_at_rest_is_the_static_plate) {
  check_static_limit({.depth = 0.0, .contact_length = 0.3});
  check_static_limit({.depth = 0.4, .contact_length = 0.3, .angle = kPi / 3.0});
  check_static_limit({.depth = 0.4, .contact_length = 0.3, .angle = kPi / 3.0, .split = true});
}

BOOST_AUTO_TEST_CASE(a_straight_edge_answers_a_ramp_as_the_reference) {
  check_against({.depth = 0.0, .contact_length = 0.3, .mass_ratio = 0.0886, .thickness = 0.1009},
                {{0.1282, 0.01748, -0.10484},
                 {0.2650, 0.03220, -0.12633},
                 {0.5477, 0.05774, -0.14688},
                 {1.1322, 0.09713, -0.16403},
                 {2.3403, 0.13764, -0.17301}});
}

BOOST_AUTO_TEST_CASE(a_protrusion_answers_a_ramp_as_the_reference) {
  check_against({.depth = 0.4, .contact_length = 0.3, .angle = kPi / 3.0, .mass_ratio = 0.0886, .thickness = 0.1009},
                {{0.1282, 0.03795, -0.06498},
                 {0.2650, 0.07509, -0.08291},
                 {0.5477, 0.12587, -0.09395},
                 {1.1322, 0.18706, -0.09970},
                 {2.3403, 0.23685, -0.10138}});
}

BOOST_AUTO_TEST_CASE(the_weights_of_a_series_reproduce_cubics_in_the_logarithm) {
  std::vector<double> time, values;
  const auto f = [](double t) {
    return 1.0 + std::log(t) - 0.3 * std::pow(std::log(t), 2) + 0.1 * std::pow(std::log(t), 3);
  };
  for (int i = 0; i < 9; ++i) {
    time.push_back(0.03 * std::pow(2.0, i));
    values.push_back(f(time.back()));
  }
  for (const double t : {0.031, 0.1, 0.5, 2.0, 7.6}) {
    const auto w = plate::series_weights(time, t);
    double value = 0.0;
    for (std::size_t i = 0; i < 4; ++i) value += w.weight[i] * values[w.first + i];
    BOOST_TEST(std::abs(value - f(t)) < 1e-12);
    BOOST_TEST(w.at_rest == 0.0);
  }
  BOOST_TEST(plate::series_weights(time, 0.015).weight[0] == 0.5);
  const auto late = plate::series_weights(time, 2.0 * time.back());
  BOOST_TEST(late.weight[3] == 0.5);
  BOOST_TEST(late.at_rest == 0.5);
}
