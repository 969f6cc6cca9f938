// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brash/core/vec.hpp"
#include "brash/geometry/origin.hpp"

namespace brash::cli {

/// One circumferential crack with its radial cracks.
struct CrackEvent {
  /// Collision point B, from the origin [m].
  Vec2 centre;
  /// Breaking length [m], > 0.
  double radius = 0.0;
  /// Number of wedges, at least 1; the radial cracks are then spread evenly.
  int wedges = 1;
  /// Where given, the radial cracks run at these angles instead [rad], counter-clockwise from x.
  std::optional<std::vector<double>> angles;
  /// Of the file, counted from 1.
  int line = 0;
};

/// Reads rows `x,y,radius,wedges[,angles]`, one event a line, with or without that header; empty lines and lines that
/// start with # are passed over. The angles of a row are separated by spaces or semicolons; `wedges` is then empty or
/// one more than the angles, or as many (a full circle). An angle beyond a full turn is refused: it is of degrees.
///
/// @param name    of the file, for messages.
/// @param origin  of the grid in the coordinates of the file; centres are relative to it.
/// @throws InputError naming file, line, column's name, value and the allowed values.
std::vector<CrackEvent> read_crack_events(const std::string& name, const std::string& text,
                                          const geometry::Origin& origin = {});

}  // namespace brash::cli
