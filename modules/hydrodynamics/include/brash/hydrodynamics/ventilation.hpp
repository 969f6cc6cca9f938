// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/core/prism.hpp"
#include "brash/core/vec.hpp"

namespace brash::hydrodynamics {

/// The part of a floe's upper face that lies below the waterplane, with its upper side up.
struct SunkTop {
  double mean_depth = 0.0;  ///< [m]; 0: no part, or the face looks down
  /// Way from its edge over which water must run to cover it [m]. 0: the face is out of the water.
  /// Half the short side, the longest way, if a face with a part in the water looks down.
  double run = 0.0;
  /// Hydrostatic load on it, that a dry top lacks [N], [N m]; world axes, moment about the centre of mass.
  Wrench pressure{};
  bool looks_down = false;  ///< the face holds no air
};

/// The sunk part of the upper face of a floe in `pose` (docs/theory/water.md, (H20)).
/// @param density  of the water [kg/m3], > 0.
SunkTop sunk_top(const Prism& prism, const Pose& pose, double density);

/// How far water has run in over the top after another `dt` [s]: a dam-break front [m]
/// (docs/theory/water.md, (H21), (H23)). A face that looks down into the water is covered at once.
/// @param ran  how far it has run in so far [m].
/// @see Ritter, 1892; Lu, Loset and Lubbad, Int. Conf. Port Ocean Eng. Arctic Cond., 2012.
double ran_in_after(double ran, const SunkTop& top, double dt);

/// Share of the sunk top that is wet [-]. @param ran  as of ran_in_after() [m].
double flooded_share(double ran, const SunkTop& top);

}  // namespace brash::hydrodynamics
