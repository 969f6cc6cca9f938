// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/geometry/ice_sheet.hpp"

namespace brash::geometry {

/// The ice in front of a contact as the paper's trapezoid (Fig. 2), and how well it fits.
struct Trapezoid {
  /// Wedge depth b: from the tip edge to the base line [m].
  double depth = 0.0;
  /// Contact length c: the tip edge [m].
  double contact_length = 0.0;
  /// Full opening angle theta between the sides [rad].
  double angle = 0.0;
  /// Area between the fitted outline and the free edge over the area of the fit's window [-].
  double error = 0.0;
  /// True when the edge was too distorted for recognition and was re-identified (Fig. 4).
  bool reidentified = false;
};

/// Where and how the free edge is fitted.
struct FitRequest {
  /// Collision point B on the free edge [m].
  Vec2 at;
  /// Unit vector from B into the ice.
  Vec2 towards;
  /// Contact length where it is known from the overlap [m]; 0 lets the fit find it.
  double contact_length = 0.0;
  /// Radius of the free edge that is looked at [m], of the order of the characteristic length.
  double reach = 0.0;
};

/// Fits the trapezoid (b, c, theta) of the free edge at B.
/// @see paper, Figs. 3 and 4; docs/theory/geometry.md.
Trapezoid fit_trapezoid(const IceSheet& sheet, const FitRequest& request);

}  // namespace brash::geometry
