// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "domains.hpp"
#include "recovery.hpp"

namespace brash::plate {

namespace {

constexpr int kStations = 401;
/// Share of the spacing that is even.
constexpr double kEvenShare = 0.5;
/// Density of the stations beyond the dense part, relative to it.
constexpr double kThinning = 0.25;
/// Stations in a cluster for every e-fold of distance.
constexpr double kClusterWeight = 20.0;
/// Stations cluster at the tip and the base line, to this share of the half width of the protrusion there.
constexpr double kClusterShare = 0.2;
/// Points on the circle around a corner.
constexpr int kRootPoints = 36;

/// Number of stations up to x, up to a constant and a factor.
double cumulative(double x, double length, double dense, const std::vector<Cluster>& clusters) {
  const double measure = dense + kThinning * (length - dense);
  double result = kEvenShare * kStations / measure * (std::min(x, dense) + kThinning * std::max(0.0, x - dense));
  for (const auto& cluster : clusters) {
    const double distance = x - cluster.place;
    result += kClusterWeight * std::copysign(std::log1p(std::abs(distance) / cluster.scale), distance);
  }
  return result;
}

}  // namespace

std::vector<double> make_stations(double length, double dense, const std::vector<Cluster>& clusters) {
  dense = std::min(dense, length);
  const double first = cumulative(0.0, length, dense, clusters);
  const double last = cumulative(length, length, dense, clusters);
  std::vector<double> stations{0.0};
  for (int i = 1; i + 1 < kStations; ++i) {
    const double wanted = first + (last - first) * i / (kStations - 1);
    double low = stations.back();
    double high = length;
    // Bisection: 60 halvings reach the last bit.
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = 0.5 * (low + high);
      (cumulative(middle, length, dense, clusters) < wanted ? low : high) = middle;
    }
    stations.push_back(high);
  }
  stations.push_back(length);
  return stations;
}

std::vector<double> stations_of(const WedgePlate& plate) {
  std::vector<Cluster> clusters{{0.0, kClusterShare * 0.5 * plate.contact_length}};
  const double base = std::max(0.0, plate.depth);
  if (plate.depth >= 0.0) clusters.push_back({base, kClusterShare * root_of(plate).y});
  return make_stations(base + kReach, base + kDense, clusters);
}

RootExtremes at_root(const Field& field, Vec2 root, double radius) {
  RootExtremes extremes;
  for (int i = 0; i < kRootPoints; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + 0.5) / kRootPoints;
    const auto value = tensor_at(field, root + radius * Vec2{std::cos(angle), std::sin(angle)});
    if (!value) continue;
    extremes.tensile = std::max(extremes.tensile, largest_principal(*value));
    extremes.absolute = std::max({extremes.absolute, largest_principal(*value), -smallest_principal(*value)});
  }
  return extremes;
}

double effective_thickness(Theory theory, double thickness) {
  return theory == Theory::kKirchhoff ? kThinPlate : std::max(thickness, kThinPlate);
}

}  // namespace brash::plate
