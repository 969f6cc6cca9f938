// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/standards/crushing.hpp"

#include <cmath>

#include "brash/core/contract.hpp"

namespace brash::standards {

tl::expected<CrushingLoad, NotApplicable> global_crushing(const CrushingInput& in) {
  BRASH_EXPECTS(in.width > 0.0 && in.thickness > 0.0 && in.strength_coefficient > 0.0, in.width, in.thickness,
                in.strength_coefficient);
  constexpr double kLeastAspect = 2.0, kWidthExponent = -0.16;
  const double aspect = in.width / in.thickness;
  if (aspect < kLeastAspect) return tl::unexpected(NotApplicable{"the face is narrower than two thicknesses"});
  const double exponent = in.thickness < 1.0 ? -0.5 + in.thickness / 5.0 : -0.3;
  const double pressure = in.strength_coefficient * std::pow(in.thickness, exponent) * std::pow(aspect, kWidthExponent);
  return CrushingLoad{pressure * in.width * in.thickness, pressure};
}

}  // namespace brash::standards
