// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/plate/plate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "brash/core/contract.hpp"
#include "domains.hpp"
#include "fem.hpp"
#include "recovery.hpp"
#include "solve_at_order.hpp"

namespace brash::plate {

namespace {

/// Polynomial order of the elements in production.
constexpr int kOrder = 3;
constexpr int kStations = 401;
/// The stations reach this far beyond the base line, over l_c; beyond kDense they are kThinning as dense.
constexpr double kReach = 4.0;
constexpr double kDense = 1.5;
constexpr double kThinning = 0.25;
/// The stations cluster at the tip and the base line: their spacing falls to where the distance from there is this
/// share of the half width of the protrusion.
constexpr double kClusterShare = 0.2;
/// Stations in a cluster for every e-fold of distance.
constexpr double kClusterWeight = 20.0;
/// h / l_c at which shear flexibility is negligible: Kirchhoff's limit to 1e-5 and well conditioned still.
constexpr double kThinPlate = 1e-3;
/// Points on the half disc around a root.
constexpr int kRootPoints = 36;

/// Number of stations between B and x, up to a factor: uniform stations and the two clusters.
double cumulative_stations(const WedgePlate& plate, double x) {
  const Vec2 root = root_of(plate);
  const double dense = root.x + kDense;
  const double length = dense + kThinning * (kReach - kDense);
  const double at_tip = kClusterShare * 0.5 * plate.contact_length;
  const double at_root = kClusterShare * root.y;
  const double n_uniform = 0.5 * kStations;
  return n_uniform / length * (std::min(x, dense) + kThinning * std::max(0.0, x - dense)) +
         kClusterWeight * std::log1p(x / at_tip) +
         kClusterWeight * std::copysign(std::log1p(std::abs(x - root.x) / at_root), x - root.x);
}

std::vector<double> stations_of(const WedgePlate& plate) {
  const double length = plate.depth + kReach;
  const double first = cumulative_stations(plate, 0.0);
  const double last = cumulative_stations(plate, length);
  std::vector<double> stations{0.0};
  for (int i = 1; i + 1 < kStations; ++i) {
    const double wanted = first + (last - first) * i / (kStations - 1);
    double low = stations.back();
    double high = length;
    // Bisection: 60 halvings reach the last bit.
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = 0.5 * (low + high);
      (cumulative_stations(plate, middle) < wanted ? low : high) = middle;
    }
    stations.push_back(high);
  }
  stations.push_back(length);
  return stations;
}

/// Largest absolute principal value of `field` on the circle of radius `radius` around `root`, and the largest signed.
struct RootExtremes {
  double absolute = 0.0;
  double tensile = 0.0;
};

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

}  // namespace

tl::expected<UnitProfiles, PlateError> solve(const WedgePlate& plate, const MeshOptions& options) {
  return solve_at_order(plate, options, kOrder);
}

tl::expected<UnitProfiles, PlateError> solve_at_order(const WedgePlate& plate, const MeshOptions& options, int order) {
  BRASH_EXPECTS(plate.depth >= 0.0 && plate.contact_length > 0.0, plate.depth, plate.contact_length);
  BRASH_EXPECTS(plate.angle >= 0.0 && plate.angle < std::numbers::pi, plate.angle);
  BRASH_EXPECTS(plate.thickness > 0.0, plate.thickness);
  BRASH_EXPECTS(plate.poisson_ratio >= 0.0 && plate.poisson_ratio < 0.5, plate.poisson_ratio);
  const auto failed = [](const std::string& what) { return tl::unexpected(PlateError{what}); };

  const auto mesh = mesh_domain(half_of_wedge_plate(plate, options));
  if (!mesh) return failed(mesh.error());
  const double nu = plate.poisson_ratio;
  const double h = plate.theory == Theory::kKirchhoff ? kThinPlate : plate.thickness;
  const auto bending = solve_bending(*mesh, order, {nu, shear_stiffness(nu, h), 1.0, {}});
  if (!bending) return failed("bending: " + bending.error());
  // A traction of 1 on the tip edge is the pressure p = N / h.
  const auto normal = solve_membrane(*mesh, order, {nu, {1.0, 0.0}, false});
  if (!normal) return failed("membrane, normal load: " + normal.error());
  const auto tangential = solve_membrane(*mesh, order, {nu, {0.0, 1.0}, true});
  if (!tangential) return failed("membrane, tangential load: " + tangential.error());

  UnitProfiles profiles;
  profiles.n_elements = static_cast<int>(mesh->triangles.size());
  profiles.station = stations_of(plate);
  profiles.bending = recover_tensor(*bending, profiles.station, Parity::kEven);
  profiles.deflection = recover_deflection(*bending, profiles.station, Parity::kEven);
  profiles.normal = recover_tensor(*normal, profiles.station, Parity::kEven);
  profiles.tangential = recover_tensor(*tangential, profiles.station, Parity::kOdd);
  if (plate.depth > 0.0) {
    const Vec2 root = root_of(plate);
    profiles.root_bending = at_root(*bending, root, 0.5 * plate.thickness).absolute;
    profiles.root_normal = at_root(*normal, root, 0.5 * plate.thickness).tensile;
    profiles.root_tangential = at_root(*tangential, root, 0.5 * plate.thickness).absolute;
  }
  return profiles;
}

}  // namespace brash::plate
