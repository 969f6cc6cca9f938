// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/core/prism.hpp"
#include "brash/core/vec.hpp"

namespace brash::hydrodynamics {

/// The water: free surface at z = 0.
struct Water {
  double density = 1025.0;         ///< rho_w [kg/m3]
  Vec2 current{};                  ///< [m/s]
  double form_drag = 1.0;          ///< C_d of Eq. 13 [-]
  double rotational_drag = 1.0;    ///< C_a of Eq. 14 [-]
  double skin_friction = 0.005;    ///< along wetted faces [-]
};

/// Volume below the waterplane and its centroid in the world frame.
struct Displacement {
  double volume = 0.0;  ///< [m3]
  Vec3 centre{};        ///< centre of buoyancy [m]
};

/// Exact for prisms in any attitude (Catto's clipping of convex polyhedra).
Displacement displacement(const Prism& prism, const Pose& pose);

/// Water's load on a floe, moments about its centre of mass.
struct WaterLoad {
  Wrench buoyancy;
  Wrench drag;           ///< form drag and rotational drag, Eqs. 13, 14
  Wrench skin_friction;
};

/// Buoyancy, form drag (Eq. 13, shaded faces excluded), rotational drag (Eq. 14) and skin friction.
WaterLoad water_load(const Prism& prism, const Pose& pose, const Twist& twist, const Water& water);

}  // namespace brash::hydrodynamics
