// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "brash/core/vec.hpp"

namespace brash::geometry {

/// The free edge as depth over distance from the centre line, on both sides of it.
///
/// Frame of the collision point B: x into the ice along `towards`, y to its left. Depths are held within [0, reach]:
/// ice ahead of the tip line counts as standing on it, and deeper than `reach` nothing is looked at.
class Profile {
 public:
  /// Depth, linear from `x0` at distance `s0` from the centre line to `x1` at `s1`.
  struct Piece {
    double s0;
    double x0;
    double s1;
    double x1;
  };

  /// The connected chain through B; nothing when it is not a function of y all over the window.
  static std::optional<Profile> of_chain(std::span<const std::vector<Vec2>> edges_in_frame, double reach);
  /// The ice that faces a structure at x < 0: at each y the ice with the smallest x of all the edges.
  static Profile of_envelope(std::span<const std::vector<Vec2>> edges_in_frame, double reach);

  double reach() const { return reach_; }
  /// Pieces of one side (0: y > 0, 1: y < 0) in the order of s, from 0 to reach without a gap.
  const std::vector<Piece>& side(int which) const { return sides_[which]; }

 private:
  explicit Profile(double reach) : reach_(reach) {}
  /// Appends pieces up to `to`, cut to the window in s and depth.
  void append(int side, Vec2 from, Vec2 to);
  /// Appends pieces up to `to`; the side's last depth, or `from`'s, is held over the stretch before `from`.
  void add(int side, Vec2 from, Vec2 to);
  /// Takes both sides from a line that runs from +y to -y without stepping back.
  void read(std::span<const Vec2> line);
  /// Holds the last depth to the end of the window.
  void close();

  double reach_;
  std::vector<Piece> sides_[2];
};

}  // namespace brash::geometry
