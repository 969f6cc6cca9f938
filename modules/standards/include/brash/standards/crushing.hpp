// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tl/expected.hpp>

#include "brash/standards/applicability.hpp"

namespace brash::standards {

/// Level ice that crushes against a vertical face. SI.
struct CrushingInput {
  double width = 0.0;                   ///< w [m], > 0
  double thickness = 0.0;               ///< h [m], > 0
  double strength_coefficient = 2.8e6;  ///< C_R [Pa]: 2.8 MPa in the Arctic, 1.8 MPa in the Baltic
};

struct CrushingLoad {
  double horizontal = 0.0;  ///< F = p w h [N]
  double pressure = 0.0;    ///< p [Pa], mean over the contact's nominal area w h
};

/// Global load of ice that crushes over the whole width, once in many years:
///
///   p = C_R (h / 1 m)^n (w/h)^-0.16,  n = -0.5 + h/(5 m) below 1 m, -0.3 above     docs/theory/standards.md, (L5)
///
/// @returns NotApplicable for w/h < 2, where ice also escapes sideways.
/// @see ISO 19906:2010, A.8.2.4.3.3.
tl::expected<CrushingLoad, NotApplicable> global_crushing(const CrushingInput& input);

}  // namespace brash::standards
