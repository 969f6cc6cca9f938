// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace brash::structure {

/// An elastic line without bending.
struct Line {
  double length = 0.0;     ///< without tension [m]
  double weight = 0.0;     ///< in water [N/m], > 0
  double stiffness = 0.0;  ///< E A [N]
};

/// The pull of a line on the body at its upper end.
struct LinePull {
  double horizontal = 0.0;  ///< towards the anchor [N], >= 0
  double downward = 0.0;    ///< [N], >= 0
  double energy = 0.0;      ///< of the line's weight and stretch, against the slack line on the bed [J]
};

/// The pull of a line from an anchor on a flat bed. Where the line is long it lies on the bed without friction.
/// @param span  horizontal distance of the ends [m], >= 0.
/// @param rise  of the upper end above the anchor [m], > 0.
/// @see docs/theory/structures.md, (B11)
LinePull pull_of(const Line& line, double span, double rise);

}  // namespace brash::structure
