// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/ice/plate.hpp"

#include <utility>

#include "brash/core/contract.hpp"

namespace brash::ice {

Plate::Plate(int level_ice, Hold hold, const failure::IceProperties& ice, std::vector<geometry::Polygon> outline)
    : level_ice_(level_ice), hold_(hold), ice_(ice), outline_(std::move(outline)) {}

Plate Plate::piece(geometry::Polygon outline, const failure::IceProperties& ice) const {
  return {level_ice_, Hold::kAfloat, ice, {std::move(outline)}};
}

std::vector<geometry::Polygon> Plate::outline() const { return sheet_ ? sheet_->polygons() : outline_; }

geometry::ExactArea Plate::area() const {
  if (sheet_) return sheet_->area();
  geometry::ExactArea sum;
  for (const geometry::Polygon& polygon : outline_) sum += geometry::area(polygon);
  return sum;
}

bool Plate::is_gone() const { return sheet_ ? sheet_->area() == geometry::ExactArea{} : outline_.empty(); }

const geometry::IceSheet& Plate::sheet() const {
  if (!sheet_) {
    auto laid = geometry::IceSheet::from_polygons(outline_);
    BRASH_EXPECTS(laid.has_value(), laid.has_value() ? "" : laid.error().what);
    sheet_ = std::move(*laid);
    outline_.clear();
  }
  return *sheet_;
}

geometry::IceSheet& Plate::sheet() { return const_cast<geometry::IceSheet&>(std::as_const(*this).sheet()); }

}  // namespace brash::ice
