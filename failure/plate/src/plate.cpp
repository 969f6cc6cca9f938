// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/plate/plate.hpp"

#include <numbers>

#include "brash/core/contract.hpp"
#include "domains.hpp"
#include "fem.hpp"
#include "profiles.hpp"
#include "recovery.hpp"
#include "solve_at_order.hpp"

namespace brash::plate {

namespace {

/// Stations cluster at the tip and the base line, to this share of the half width of the protrusion there.
constexpr double kClusterShare = 0.2;

std::vector<double> stations_of(const WedgePlate& plate) {
  const Vec2 root = root_of(plate);
  return make_stations(plate.depth + kReach, plate.depth + kDense,
                       {{0.0, kClusterShare * 0.5 * plate.contact_length}, {root.x, kClusterShare * root.y}});
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
  BRASH_EXPECTS(plate.in_plane_load >= 0.0, plate.in_plane_load);
  const auto failed = [](const std::string& what) { return tl::unexpected(PlateError{what}); };

  const auto mesh = mesh_domain(half_of_wedge_plate(plate, options));
  if (!mesh) return failed(mesh.error());
  const double nu = plate.poisson_ratio;
  const double h = effective_thickness(plate.theory, plate.thickness);
  // A traction of 1 on the tip edge is the pressure p = N / h.
  const auto normal = solve_membrane(*mesh, order, {nu, {{1.0, 0.0}}, false});
  if (!normal) return failed("membrane, normal load: " + normal.error());
  const auto bending =
      solve_bending(*mesh, order, {nu, shear_stiffness(nu, h), 1.0, {}, &normal->front(), plate.in_plane_load});
  if (!bending) return tl::unexpected(PlateError{"bending: " + bending.error(), plate.in_plane_load > 0.0});
  const auto tangential = solve_membrane(*mesh, order, {nu, {{0.0, 1.0}}, true});
  if (!tangential) return failed("membrane, tangential load: " + tangential.error());

  UnitProfiles profiles;
  profiles.n_elements = static_cast<int>(mesh->triangles.size());
  profiles.station = stations_of(plate);
  // Moments are smooth across the centre line only where the sheet is whole.
  profiles.bending = recover_tensor(*bending, profiles.station, plate.split ? Parity::kNone : Parity::kEven);
  profiles.deflection = recover_deflection(*bending, profiles.station, Parity::kEven);
  profiles.normal = recover_tensor(normal->front(), profiles.station, Parity::kEven);
  profiles.tangential = recover_tensor(tangential->front(), profiles.station, Parity::kOdd);
  if (plate.depth > 0.0) {
    const Vec2 root = root_of(plate);
    profiles.root_bending = at_root(*bending, root, 0.5 * plate.thickness).absolute;
    profiles.root_normal = at_root(normal->front(), root, 0.5 * plate.thickness).tensile;
    profiles.root_tangential = at_root(tangential->front(), root, 0.5 * plate.thickness).absolute;
  }
  return profiles;
}

}  // namespace brash::plate
