// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "brash/geometry/ice_sheet.hpp"

namespace brash::benchmarks {

/// One crack event as every kernel gets it: the disc, and the cracks from its centre to its vertices.
struct Event {
  geometry::Ring region;
  std::vector<geometry::Crack> cracks;
};

/// A round sheet with a ragged edge of `n_vertices`, and events along its free edge.
struct Workload {
  geometry::Polygon sheet;
  std::vector<Event> events;
};

/// Events are recorded by running them, so each one meets the edge that the ones before left.
Workload make_workload(std::int64_t n_vertices, int sides, std::size_t n_events);

}  // namespace brash::benchmarks
