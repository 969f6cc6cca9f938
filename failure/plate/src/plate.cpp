// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/plate/plate.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "brash/core/contract.hpp"
#include "brash/core/interruption.hpp"
#include "domains.hpp"
#include "fem.hpp"
#include "profiles.hpp"
#include "recovery.hpp"
#include "solve_at_order.hpp"

namespace brash::plate {

namespace {

/// The bent plate alone, or with the terms of its series.
tl::expected<InPlaneSeries, std::string> bend(const Mesh& mesh, int order, const WedgePlate& plate,
                                              const BendingProblem& problem) {
  if (plate.with_in_plane_terms) return solve_in_plane_series(mesh, order, problem);
  return solve_bending(mesh, order, problem).map([](Field field) {
    return InPlaneSeries{.terms = {std::move(field)}};
  });
}

InPlaneTerms in_plane_terms(const InPlaneSeries& series, const std::vector<double>& stations, Parity parity) {
  InPlaneTerms terms{.buckling_load = series.buckling_load,
                     .first = recover_tensor(series.terms[1], stations, parity),
                     .rest = recover_tensor(series.terms[2], stations, parity)};
  for (Tensor2& t : terms.first) t = series.buckling_load * t;
  for (Tensor2& t : terms.rest) t = series.buckling_load * series.buckling_load * t;
  return terms;
}

}  // namespace

tl::expected<UnitProfiles, PlateError> solve(const WedgePlate& plate, const MeshOptions& options) {
  return solve_at_order(plate, options, kOrder);
}

tl::expected<UnitProfiles, PlateError> solve_at_order(const WedgePlate& plate, const MeshOptions& options, int order) {
  look_for_interruption();
  BRASH_EXPECTS(std::isfinite(plate.depth) && plate.contact_length > 0.0, plate.depth, plate.contact_length);
  BRASH_EXPECTS(plate.angle >= 0.0 && plate.angle < std::numbers::pi, plate.angle);
  BRASH_EXPECTS(plate.thickness > 0.0, plate.thickness);
  BRASH_EXPECTS(plate.poisson_ratio >= 0.0 && plate.poisson_ratio < 0.5, plate.poisson_ratio);
  BRASH_EXPECTS(plate.in_plane_load >= 0.0, plate.in_plane_load);
  BRASH_EXPECTS(!plate.with_in_plane_terms || plate.in_plane_load == 0.0, plate.in_plane_load);
  const auto failed = [](const std::string& what) { return tl::unexpected(PlateError{what}); };

  const auto mesh = mesh_domain(half_of_wedge_plate(plate, options));
  if (!mesh) return failed(mesh.error());
  const double nu = plate.poisson_ratio;
  const double h = effective_thickness(plate.theory, plate.thickness);
  // A traction of 1 on the tip edge is the pressure p = N / h.
  const auto normal = solve_membrane(*mesh, order, {nu, {{1.0, 0.0}}, false});
  if (!normal) return failed("membrane, normal load: " + normal.error());
  const auto bending =
      bend(*mesh, order, plate, {nu, shear_stiffness(nu, h), 1.0, {}, &normal->front(), plate.in_plane_load});
  if (!bending) return tl::unexpected(PlateError{"bending: " + bending.error(), plate.in_plane_load > 0.0});
  const auto tangential = solve_membrane(*mesh, order, {nu, {{0.0, 1.0}}, true});
  if (!tangential) return failed("membrane, tangential load: " + tangential.error());

  UnitProfiles profiles;
  profiles.n_elements = static_cast<int>(mesh->triangles.size());
  profiles.station = stations_of(plate);
  // Moments are smooth across the centre line only where the sheet is whole.
  const Parity of_moments = plate.split ? Parity::kNone : Parity::kEven;
  const Field& bent = bending->terms.front();
  profiles.bending = recover_tensor(bent, profiles.station, of_moments);
  profiles.deflection = recover_deflection(bent, profiles.station, Parity::kEven);
  if (plate.with_in_plane_terms) profiles.in_plane = in_plane_terms(*bending, profiles.station, of_moments);
  profiles.normal = recover_tensor(normal->front(), profiles.station, Parity::kEven);
  profiles.tangential = recover_tensor(tangential->front(), profiles.station, Parity::kOdd);
  if (plate.depth > 0.0) {
    const Vec2 root = root_of(plate);
    profiles.root_bending = at_root(bent, root, 0.5 * plate.thickness).absolute;
    profiles.root_normal = at_root(normal->front(), root, 0.5 * plate.thickness).tensile;
    profiles.root_tangential = at_root(tangential->front(), root, 0.5 * plate.thickness).absolute;
  }
  return profiles;
}

std::optional<UnitProfiles> compressed(UnitProfiles profiles, double in_plane_load) {
  const InPlaneTerms& terms = profiles.in_plane;
  BRASH_EXPECTS(terms.buckling_load > 0.0 && in_plane_load >= 0.0, terms.buckling_load, in_plane_load);
  const double r = in_plane_load / terms.buckling_load;
  if (r >= 1.0) return std::nullopt;
  for (std::size_t i = 0; i < profiles.bending.size(); ++i)
    profiles.bending[i] = profiles.bending[i] + r * terms.first[i] + r * r / (1.0 - r) * terms.rest[i];
  return profiles;
}

}  // namespace brash::plate
