// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/failure/criterion.hpp"
#include "brash/plate/edge_responses.hpp"

namespace brash::failure {

/// A sloping surface that is driven into a straight tip edge square to it, at rest before the first touch.
struct EdgePush {
  double speed = 0.0;           ///< V along the plan normal [m/s], > 0
  double slope = 0.0;           ///< a, from the horizontal [rad], in (0, pi/2)
  double friction = 0.0;        ///< mu of the crushing force, >= 0
  double mu1 = 0.0;             ///< P / N [-], > 0
  double contact_length = 0.0;  ///< c [m], held fixed
};

/// How a moving edge breaks.
struct EdgeBreak {
  double load = 0.0;             ///< N at the circumferential crack [N]
  double time = 0.0;             ///< from the first touch [s]
  double deflection = 0.0;       ///< of B [m], positive as it is pushed
  double breaking_length = 0.0;  ///< [m]
  bool radial_first = false;     ///< the edge cracked at B before
  double radial_load = 0.0;      ///< N at that crack, or 0 [N]
};

/// Follows the edge in time until the largest stress on the centre line reaches the flexural strength. With Q = mu1 N /
/// c the edge gives way by w(Q), and
///
///     d = V t - w cot a,  N = sigma_c R c d tan a (1 + mu cot a).
///
/// N stays linear in d, also beyond the depth at which the surface cuts through the ice. The sheet stays whole after a
/// radial crack. In-plane stresses are static.
/// @param responses  of the geometry with this contact length.
/// @see docs/theory/fracture-of-the-edge.md, (W5)
EdgeBreak break_edge(const plate::EdgeResponses& responses, const IceProperties& ice, const EdgePush& push);

/// The same for a speed that tends to zero: the static plate. Its time is zero.
EdgeBreak break_edge_at_rest(const plate::EdgeResponses& responses, const IceProperties& ice, const EdgePush& push);

/// rho_i h / (rho_w l_c) [-].
double mass_ratio(const IceProperties& ice, double ice_density);

}  // namespace brash::failure
