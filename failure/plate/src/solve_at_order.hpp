// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/plate/plate.hpp"

namespace brash::plate {

/// `solve` with elements of another polynomial order, 2 to 4: for convergence studies.
tl::expected<UnitProfiles, PlateError> solve_at_order(const WedgePlate& plate, const MeshOptions& options, int order);

/// The element size at the tip, over l_c, that `solve` takes on its own.
double production_tip_size(const WedgePlate& plate);

}  // namespace brash::plate
