// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/plate/plate.hpp"
#include "mesh.hpp"

namespace brash::plate {

/// The half y >= 0 of the sheet with its trapezoidal protrusion or bay.
Domain half_of_wedge_plate(const WedgePlate& plate, const MeshOptions& options);

/// The same for a sheet that moves water, which needs small elements along the free edges.
///
/// @param reach  of the sheet beyond protrusion or bay, sideways and inwards, over l_c.
/// @param scale  of all sizes; 1: production.
Domain half_of_moving_plate(const WedgePlate& plate, double reach, double scale);

/// The corner between side and base line, y > 0; re-entrant where the edge protrudes.
Vec2 root_of(const WedgePlate& plate);

}  // namespace brash::plate
