// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "brash/edge/edge_contact.hpp"

namespace brash::edge {

/// A frame in the plane of the sheet.
struct Frame {
  Vec2 origin{};
  Vec2 x{1.0, 0.0};  ///< unit

  Vec2 turned(Vec2 v) const { return {dot(v, x), dot(v, perpendicular(x))}; }
  Vec2 place(Vec2 point) const { return turned(point - origin); }
  Vec2 on_sheet(Vec2 point) const { return origin + point.x * x + point.y * perpendicular(x); }
};

/// Gives a contact the free edge around it and the loads on this edge, for a criterion that solves the sheet:
/// LoadCase::outline and LoadCase::loads. Both stay empty where the contact does not lie on one piece of the edge.
///
/// Contacts with the structure have crushed the edge: a chord takes its place. Floes press on the edge as it is, or,
/// where they press farther from it than half the ice's thickness, on a disc inside the ice.
/// docs/theory/simulation.md, (S3).
///
/// @return the frame of `load`: origin B, x into the ice; on the sheet [m].
///
/// @param all      contacts on the same sheet, `contact` among them.
/// @param contact  number of the contact in `all`.
/// @param joint    whether the other loads act too.
std::optional<Frame> place_loads(const EdgeModel& model, const geometry::IceSheet& sheet,
                                 const std::vector<EdgeContact>& all, std::size_t contact, bool joint,
                                 failure::LoadCase& load);

/// The direction from the free edge nearest to `at` into the ice, square to that edge; nothing without an edge within
/// `reach` [m].
std::optional<Vec2> into_ice_near(const geometry::IceSheet& sheet, Vec2 at, double reach);

}  // namespace brash::edge
