// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "brash/core/plane.hpp"
#include "brash/core/prism.hpp"
#include "brash/core/vec.hpp"
#include "brash/hydrodynamics/damping.hpp"
#include "brash/model/choices.hpp"

namespace brash::hydrodynamics {

using model::DragLaw;
using model::FormDragAlong;

/// The water: free surface at z = 0.
struct Water {
  double density = 1025.0;  ///< rho_w [kg/m3]
  Vec3 current{};           ///< velocity of the water at the floe [m/s]
  DragLaw drag_law = DragLaw::kSurface;
  double form_drag = 1.0;        ///< C_d of Eq. 13 [-]
  double rotational_drag = 1.0;  ///< C_a of Eq. 14, kPaper only [-]
  double skin_friction = 0.005;  ///< along wetted faces [-]
  /// Gap to a neighbour at which half of the free stream reaches a face, kSurface only [m]; 0: nothing is shaded.
  double shading_gap = 0.0;
  FormDragAlong form_drag_along = FormDragAlong::kVelocity;  ///< kNormal: kSurface only
};

/// Beyond this multiple of Water::shading_gap a neighbour shades nothing.
inline constexpr double kShadingReach = 1.5;

/// Volume below the waterplane and its centroid in the world frame.
struct Displacement {
  double volume = 0.0;    ///< [m3]
  Vec3 centre{};          ///< centre of buoyancy [m]; the origin when nothing is submerged
  Vec3 centre_in_body{};  ///< the same point, body frame
};

/// Volume below the waterplane and its centroid, exact to rounding (docs/theory/water.md, (H1), (H2), (H3),
/// (H12)).
///
/// A floe that the waterplane cuts in its sides alone has it in closed form, (H12); of others the wetted faces are
/// clipped and joined to a point on the waterplane by signed cones (after Catto, 2006). Only `rings` and `thickness`
/// are used, so outlines that are not convex and holes need no division into parts.
Displacement displacement(const Prism& prism, const Pose& pose);

/// Velocity of a floe against the water, body frame.
Twist against_water(const Pose& pose, const Twist& twist, const Water& water);

/// The water's resistance to a floe's motion; body frame.
///
/// Both parts are dampers at the velocity V0 relative to the water at which they were taken, and in proportion to it:
/// at r V0 they are r times as strong (docs/theory/water.md, (H13)).
struct Drag {
  Damping form;              ///< of the whole velocity
  Wrench skin_friction;      ///< w0 at V0 about the centre of mass; at V it is w0 (w0 . V) / (w0 . V0)
  double skin_power = -1.0;  ///< w0 . V0 [W], < 0; of a scaled drag divided by the ratio

  /// The drag of a floe that moves alike, `ratio` times as fast.
  Drag scaled(double ratio) const;

  friend bool operator==(const Drag&, const Drag&) = default;
};

/// Form drag and skin friction of a floe that moves with `twist`.
///
/// DragLaw::kSurface: on each element dA of the wetted surface, with the velocity u relative to the water there,
///   df_drag = -0.5 C_d rho_w (1 - s) max(0, n . u) u dA     Eq. 13 for the element
///   df_skin = -0.5 C_f rho_w (1 - s) |u_t| u_t dA           u_t along the element
/// With FormDragAlong::kNormal the form drag is a pressure, with (n . u) n in place of u.
/// s is the share of the element's water that neighbours hold: a probe, `shading_gap` out along the normal, that is
/// deeper in a neighbour than half the gap counts 1, one that is as far out of it 0, linear between.
///
/// DragLaw::kPaper: with one velocity for the whole floe,
///   f_drag = -0.5 C_d rho_w A_proj U |U|                    (13)
///   t_drag = -0.5 C_a rho_w l_avg^3 A_sub Omega |Omega|     (14)
///   f_skin = -0.5 C_f rho_w A_f u_t |u_t|                   on each wetted face f, u_t at its wetted centroid
///
/// U       velocity relative to the water at the centre of buoyancy, where f_drag acts [m/s]
/// A_proj  wetted outer faces seen along U; faces that look against U do not count [m2]
/// l_avg   mean of length, breadth and thickness [m]
/// A_sub   wetted area, without the waterplane [m2]
///
/// @param neighbours  convex bodies near the floe that may shade it, world frame.
/// @param wet  displacement(prism, pose).
/// @see paper, Sec. 2.1.4; docs/theory/water.md, (H5), (H6), (H7), (H8), (H15).
Drag drag(const Prism& prism, const Pose& pose, const Twist& twist, const Water& water,
          std::span<const Solid> neighbours, const Displacement& wet);

/// Water's load on a floe, world axes, moments about its centre of mass.
struct WaterLoad {
  Wrench buoyancy;
  Wrench drag;           ///< form drag and rotational drag, Eqs. 13, 14
  Wrench skin_friction;  ///< tangential, on wetted faces
};

/// Buoyancy, and the load of `drag` at the velocity at the end of the step as weight, water and drag alone give it.
/// This is exact for the decay v' = -c |v| v and for a steady velocity, and it never reverses a motion.
///
/// @param wet  displacement of the floe in `pose`.
/// @param drag  at the velocity of the start of the step.
/// @param besides  other loads of the step that the drag's velocity is to heed; not part of the result. World axes.
/// @see docs/theory/water.md, (H9).
WaterLoad water_load(const Pose& pose, const Twist& twist, const Water& water, const StepInertia& step,
                     const Displacement& wet, const Drag& drag, const Wrench& besides = {});

/// The same with the drag of the start of the step.
inline WaterLoad water_load(const Prism& prism, const Pose& pose, const Twist& twist, const Water& water,
                            const StepInertia& step = {}, std::span<const Solid> neighbours = {}) {
  const Displacement wet = displacement(prism, pose);
  return water_load(pose, twist, water, step, wet, drag(prism, pose, twist, water, neighbours, wet));
}

}  // namespace brash::hydrodynamics
