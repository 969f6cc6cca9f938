// SPDX-License-Identifier: GPL-3.0-or-later
#include "profile_shape.hpp"

#include <algorithm>
#include <cmath>

namespace brash::meta_model {
namespace {

/// Stations cluster at the tip to this share of c, and before and behind the base line to these shares of the half
/// width there, but not to more than the last over l_c.
constexpr double kTipShare = 0.15;
constexpr double kBeforeShare = 0.3;
constexpr double kBehindShare = 0.2;
constexpr double kWidestCluster = 2.0;
/// The in-plane load spreads over 3 times the distance from the base line: about pi / 2 to each side.
constexpr double kSpread = 3.0;
/// Keeps the logarithm of the depth finite; about the thickness, below which profiles hardly depend on it.
constexpr double kDepthShift = 0.1;

double slope_of_side(const Geometry& g) { return std::tan(0.5 * g.theta); }

/// From the tip to just before the base line: evenly in ln((1 + x / tip) / (1 - x / end)).
void add_stations_before(const Geometry& g, int n, std::vector<double>& stations) {
  const double tip = kTipShare * g.c_lc / (1.0 + slope_of_side(g));
  const double end = g.b_lc + kBeforeShare * 0.5 * base_width(g);
  const double most = std::log((1.0 + g.b_lc / tip) / (1.0 - g.b_lc / end));
  for (int i = 0; i < n; ++i) {
    const double ratio = std::exp(most * i / n);
    stations.push_back(end * (ratio - 1.0) / (ratio + end / tip));
  }
}

/// From the base line to the end: evenly in ln(1 + (x - b) / cluster).
void add_stations_behind(const Geometry& g, double reach, int n, std::vector<double>& stations) {
  const double cluster = kBehindShare * std::min(0.5 * base_width(g), kWidestCluster);
  for (int i = 0; i < n; ++i) {
    stations.push_back(g.b_lc + cluster * (std::pow(1.0 + reach / cluster, i / (n - 1.0)) - 1.0));
  }
}

}  // namespace

double base_width(const Geometry& g) { return g.c_lc + 2.0 * g.b_lc * slope_of_side(g); }

BeamScale beam_at(const Geometry& g, double x) {
  const double width = g.c_lc + 2.0 * std::min(x, g.b_lc) * slope_of_side(g) + kSpread * std::max(x - g.b_lc, 0.0);
  const double lever = x + 0.3 * width;
  return {.membrane = width / g.c_lc, .bending = 30.0 * width / g.c_lc / (1.0 + 20.0 * lever)};
}

ProfileShape shape_of(const Geometry& g, double reach, int n_before, int n_behind) {
  ProfileShape shape;
  add_stations_before(g, n_before, shape.station);
  add_stations_behind(g, reach, n_behind, shape.station);
  for (const double x : shape.station) {
    const BeamScale beam = beam_at(g, x);
    shape.membrane.push_back(beam.membrane);
    shape.bending.push_back(beam.bending);
  }
  return shape;
}

Eigen::VectorXd bending_features(const Geometry& g) {
  return Eigen::Vector<double, 5>(std::log(g.b_lc + kDepthShift), std::log(g.c_lc), std::log(base_width(g) / g.c_lc),
                                  std::log1p(2.0 * g.b_lc / g.c_lc), std::log(g.h_lc));
}

Eigen::VectorXd membrane_features(const Geometry& g) {
  return Eigen::Vector3d(std::log(g.c_lc), std::log(base_width(g) / g.c_lc), std::log1p(2.0 * g.b_lc / g.c_lc));
}

}  // namespace brash::meta_model
