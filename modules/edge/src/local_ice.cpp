// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/edge/local_ice.hpp"

namespace brash::edge {

LocalIce::LocalIce(const EdgeModel& sheet, const failure::IceProperties& ice)
    : sheet_(sheet), ice_(ice), criterion_(sheet.variation ? sheet.criterion.for_ice(ice) : nullptr) {}

LocalIce::LocalIce(const EdgeModel& sheet, Vec2 place)
    : LocalIce(sheet, sheet.variation ? sheet.variation->at(sheet.ice, place) : sheet.ice) {}

LocalIce::LocalIce(const EdgeModel& sheet, const EdgeContact& contact)
    : LocalIce(sheet, sheet.variation ? contact.ice : sheet.ice) {}

}  // namespace brash::edge
