// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/geometry/text.hpp"
#include "replay.hpp"

namespace brash::cli {

/// The ice of a run from above: level ice and floes, in the coordinates of the map that the case came from.
///
/// Floes keep their outlines: one that is tilted is laid flat where it is. So floes may overlap.
/// @param time  of the frame before it, or at it [s].
/// @throws InputError when the run has no frame at or before `time`.
geometry::Map ice_map(const Replay& run, double time);

}  // namespace brash::cli
