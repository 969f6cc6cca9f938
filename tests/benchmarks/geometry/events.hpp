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

/// The disc of an event divided by its cracks, for kernels that know polygons only; counter-clockwise.
std::vector<geometry::Ring> sectors(const Event& event);

/// How many events of a workload a peer of the given cost is asked for [us an event], about a second in all.
std::size_t affordable(double microseconds, const Workload& workload);

/// Processor time of this thread [s], without the time of other programs.
double processor_time();

}  // namespace brash::benchmarks
