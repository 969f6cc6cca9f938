// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <string>

namespace brash::geometry {

__extension__ typedef __int128 Int128;

/// Area of a grid polygon, exact: twice the area as a whole number of squared grid units.
class ExactArea {
 public:
  constexpr ExactArea() = default;
  constexpr explicit ExactArea(Int128 twice) : twice_(twice) {}

  constexpr Int128 twice_in_grid_units() const { return twice_; }
  /// The nearest double [m2].
  double square_metres() const;
  /// The exact area [m2] as a decimal number (the grid is dyadic, so it ends).
  std::string to_string() const;

  friend constexpr auto operator<=>(const ExactArea& a, const ExactArea& b) { return a.twice_ <=> b.twice_; }
  friend constexpr bool operator==(const ExactArea& a, const ExactArea& b) { return a.twice_ == b.twice_; }
  friend constexpr ExactArea operator+(ExactArea a, ExactArea b) { return ExactArea(a.twice_ + b.twice_); }
  friend constexpr ExactArea operator-(ExactArea a, ExactArea b) { return ExactArea(a.twice_ - b.twice_); }
  constexpr ExactArea& operator+=(ExactArea other) { return *this = *this + other; }
  constexpr ExactArea& operator-=(ExactArea other) { return *this = *this - other; }

 private:
  Int128 twice_ = 0;
};

}  // namespace brash::geometry
