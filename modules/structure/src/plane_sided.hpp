// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "brash/structure/hull.hpp"

namespace brash::structure {

// Shapes with plane sides that stand between a keel and a top.
std::unique_ptr<const Hull> hull_of(const model::FacetedCone& cone);
std::unique_ptr<const Hull> hull_of(const model::Plane& plane);
std::unique_ptr<const Hull> hull_of(const model::WedgeBow& bow);

}  // namespace brash::structure
