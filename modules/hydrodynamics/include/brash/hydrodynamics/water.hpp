// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/core/prism.hpp"
#include "brash/core/vec.hpp"

namespace brash::hydrodynamics {

/// The water: free surface at z = 0.
struct Water {
  double density = 1025.0;       ///< rho_w [kg/m3]
  Vec2 current{};                ///< [m/s]
  double form_drag = 1.0;        ///< C_d of Eq. 13 [-]
  double rotational_drag = 1.0;  ///< C_a of Eq. 14 [-]
  double skin_friction = 0.005;  ///< along wetted faces [-]
};

/// Volume below the waterplane and its centroid in the world frame.
struct Displacement {
  double volume = 0.0;  ///< [m3]
  Vec3 centre{};        ///< centre of buoyancy [m]; the origin when nothing is submerged
};

/// Volume below the waterplane and its centroid, exact to rounding for a prism in any attitude.
///
/// The wetted faces are clipped by the waterplane and joined to a point on it by signed cones (after Catto, 2006). Only
/// `rings` and `thickness` are used, so outlines that are not convex and holes need no division into parts.
Displacement displacement(const Prism& prism, const Pose& pose);

/// Water's load on a floe, world axes, moments about its centre of mass.
struct WaterLoad {
  Wrench buoyancy;
  Wrench drag;           ///< form drag and rotational drag, Eqs. 13, 14
  Wrench skin_friction;  ///< tangential, on wetted faces
};

/// How a floe yields to drag during a step, so that an explicit step cannot overshoot.
struct StepInertia {
  double dt = 0.0;              ///< [s]; 0: the drag of this instant
  double mass = 1.0;            ///< with added mass [kg], > 0
  Vec3 inertia{1.0, 1.0, 1.0};  ///< principal moments in the body frame, with added mass [kg m2], > 0
};

/// Buoyancy, form drag, rotational drag and skin friction of a floe that moves with `twist`.
///
///   f_drag = -0.5 C_d rho_w A_proj U |U|                    (13)
///   t_drag = -0.5 C_a rho_w l_avg^3 A_sub Omega |Omega|     (14)
///   f_skin = -0.5 C_f rho_w A_f u_t |u_t|                   on each wetted face f
///
/// U       velocity relative to the water at the centre of buoyancy, where f_drag acts [m/s]
/// A_proj  wetted outer faces seen along U; faces that look against U are shaded and do not count [m2]
/// l_avg   mean of length, breadth and thickness [m]
/// A_sub   wetted area, without the waterplane [m2]
/// u_t     velocity relative to the water along face f at the centroid of its wetted part [m/s]
///
/// Quadratic drag in an explicit step of dt overshoots where dt times force exceeds the momentum: a floe of 3 m that
/// turns at 8 rad/s would turn faster in each step of 0.01 s. With `step` the drag is the mean over a step in which it
/// acts alone, f / (1 + |f| dt / (m |U|)), exact for v' = -c v |v|; for a turning floe likewise about each principal
/// axis, where m is the effective mass at the centre of buoyancy. It tends to Eqs. 13 and 14 as dt -> 0.
///
/// Linear in the ring edges; no heap memory for up to 32 of them.
/// @see paper, Sec. 2.1.4; docs/theory/hydrodynamics.md.
WaterLoad water_load(const Prism& prism, const Pose& pose, const Twist& twist, const Water& water,
                     const StepInertia& step = {});

}  // namespace brash::hydrodynamics
