// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "brash/core/contract.hpp"
#include "brash/plate/plate.hpp"
#include "fem.hpp"
#include "outline_domain.hpp"
#include "profiles.hpp"
#include "recovery.hpp"

namespace brash::plate {

tl::expected<UnitProfiles, PlateError> solve_outline(const OutlinePlate& plate, const MeshOptions& options) {
  BRASH_EXPECTS(plate.contact_length > 0.0, plate.contact_length);
  BRASH_EXPECTS(plate.thickness > 0.0, plate.thickness);
  BRASH_EXPECTS(plate.poisson_ratio >= 0.0 && plate.poisson_ratio < 0.5, plate.poisson_ratio);
  const auto failed = [](const std::string& what) { return tl::unexpected(PlateError{what}); };

  const auto sheet = sheet_behind(plate, options);
  if (!sheet) return failed(sheet.error());
  const auto mesh = mesh_domain(sheet->domain);
  if (!mesh) return failed(mesh.error());
  const double nu = plate.poisson_ratio;
  const double h = effective_thickness(plate.theory, plate.thickness);
  const auto membrane = solve_membrane(*mesh, kOrder, {nu, {{1.0, 0.0}, {0.0, 1.0}}, false});
  if (!membrane) return failed("membrane: " + membrane.error());
  const auto& [normal, tangential] = std::pair<const Field&, const Field&>(membrane->front(), membrane->back());
  const auto bending =
      solve_bending(*mesh, kOrder, {nu, shear_stiffness(nu, h), 1.0, {}, &normal, plate.in_plane_load});
  if (!bending) return tl::unexpected(PlateError{"bending: " + bending.error(), plate.in_plane_load > 0.0});

  UnitProfiles profiles;
  profiles.n_elements = static_cast<int>(mesh->triangles.size());
  // Stations cluster at B, to a tenth of the contact.
  profiles.station = make_stations(sheet->centre_line, sheet->base + kDense, {{0.0, 0.1 * plate.contact_length}});
  profiles.bending = recover_tensor(*bending, profiles.station, Parity::kNone);
  profiles.deflection = recover_deflection(*bending, profiles.station, Parity::kNone);
  profiles.normal = recover_tensor(normal, profiles.station, Parity::kNone);
  profiles.tangential = recover_tensor(tangential, profiles.station, Parity::kNone);
  for (const Vec2 root : sheet->roots) {
    const double radius = 0.5 * plate.thickness;
    profiles.root_bending = std::max(profiles.root_bending, at_root(*bending, root, radius).absolute);
    profiles.root_normal = std::max(profiles.root_normal, at_root(normal, root, radius).tensile);
    profiles.root_tangential = std::max(profiles.root_tangential, at_root(tangential, root, radius).absolute);
  }
  return profiles;
}

}  // namespace brash::plate
