// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/structure/hull.hpp"

namespace brash::structure {

/// Particulars of a ship, every one known; SI, radians.
struct Particulars {
  double length, breadth, draught, depth;
  double stem_angle, stern_angle;  ///< from the horizontal
  double flare;                    ///< of the sides from the vertical, outwards above
  double bow, midbody, run;        ///< lengths of the waterline's three parts, from the stem
  double fullness;                 ///< p of the bow's waterline: 1 a wedge, 2 a parabola, more a blunter bow
};

/// The particulars of [hull] with the defaults of the missing ones: docs/theory/structures.md. The first five keys are
/// there.
Particulars particulars_of(const model::HullSection& hull);

/// Half the breadth of the parallel part at the height z over the water [m]. It is positive from keel to deck.
double half_breadth_at(const Particulars& ship, double z);

/// Length of the parallel part at the height z over the water [m]. It is positive from keel to deck.
double midbody_at(const Particulars& ship, double z);

/// The hull as a closed mesh. It is convex; its sides are plane. docs/theory/structures.md, (K4)
TriangleMesh ship_mesh(const Particulars& ship);

}  // namespace brash::structure
