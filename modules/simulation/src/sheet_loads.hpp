// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "edge_contact.hpp"

namespace brash::simulation {

/// Gives a contact the free edge around it and the loads on this edge, for a criterion that solves the sheet:
/// LoadCase::outline and LoadCase::loads. Both stay empty where the contact does not lie on one piece of the edge.
///
/// Contacts with the structure have crushed the edge: a chord takes its place. Floes press on the edge as it is, or,
/// where they press farther from it than half the ice's thickness, on a disc inside the ice.
/// docs/theory/simulation.md, (S2).
///
/// @param all      contacts on the same sheet, `contact` among them.
/// @param contact  number of the contact in `all`.
/// @param joint    whether the other loads act too.
void place_loads(const EdgeModel& model, const geometry::IceSheet& sheet, const std::vector<EdgeContact>& all,
                 std::size_t contact, bool joint, failure::LoadCase& load);

/// The direction from the free edge nearest to `at` into the ice, square to that edge; nothing without an edge within
/// `reach` [m].
std::optional<Vec2> into_ice_near(const geometry::IceSheet& sheet, Vec2 at, double reach);

}  // namespace brash::simulation
