// SPDX-License-Identifier: GPL-3.0-or-later
#include <numbers>

#include "brash/core/contract.hpp"
#include "brash/geometry/trapezoid.hpp"

namespace brash::geometry {

Trapezoid fit_trapezoid(const IceSheet& sheet, const FitRequest& request) {
  BRASH_EXPECTS(request.reach > 0.0, request.reach);
  // The circle around the window's corners.
  return fit_trapezoid(sheet.free_edge(request.at, std::numbers::sqrt2 * request.reach), request);
}

}  // namespace brash::geometry
