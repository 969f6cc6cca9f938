// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

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
  /// Collision point B on the free edge [m], or the middle of the overlap's chord: then the ice ahead of the chord
  /// counts as crushed, and b is the depth of ice still standing behind it.
  Vec2 at;
  /// Unit vector from B into the ice.
  Vec2 towards;
  /// Contact length where it is known from the overlap [m]; 0 lets the fit find it.
  double contact_length = 0.0;
  /// Radius of the free edge that is looked at [m], of the order of the characteristic length.
  double reach = 0.0;
};

/// Fits the trapezoid (b, c, theta) to the free edge, given as polylines with the ice on their left [m].
///
/// In the frame of B (x along `towards`, y to its left) the edge is read as a depth over y and the trapezoid as 0 on
/// the tip edge |y| <= c/2, rising along the sides to b. The fit has the least area between the two within the window
/// |y| <= reach, 0 <= x <= reach, whose area is 2 reach^2: over b in [0, reach], theta in [0, 150 deg] and, where the
/// request leaves it open, c in [0, reach]. A tie goes to b = 0; b = 0 has theta = 0.
///
/// - Ice ahead of the tip line counts as standing on it: an edge that is concave at B has b = 0.
/// - A chain through B that is not a function of y, ends in the window although there are other edges, or fits worse
///   than 0.1 is replaced by the ice that faces the structure: at each y the ice with the smallest x of all edges.
///   The result is then `reidentified`.
/// - Without any edge: b = 0 with error 1.
///
/// Always returns a trapezoid. The same input gives the same bits.
/// @see paper, Figs. 3 and 4; docs/theory/fracture-of-the-edge.md, (T1), (T2).
Trapezoid fit_trapezoid(std::span<const std::vector<Vec2>> edges, const FitRequest& request);

/// The same to the free edge of `sheet` within the window.
Trapezoid fit_trapezoid(const IceSheet& sheet, const FitRequest& request);

/// Whether the request's direction leads into the ice: at once from a place on the free edge, and within the reach from
/// one beside it. Without an edge within the reach there is no way to know, and it does.
bool leads_into_ice(const IceSheet& sheet, const FitRequest& request);

}  // namespace brash::geometry
