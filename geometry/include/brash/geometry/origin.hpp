// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "brash/core/vec.hpp"
#include "brash/geometry/area.hpp"

namespace brash::geometry {

/// A number of metres as it is written in decimals. Exact: a double no longer holds the grid at 9 000 000 m.
class Decimal {
 public:
  constexpr Decimal() = default;
  explicit constexpr Decimal(std::int64_t metres) : whole_(metres) {}
  /// The number that all of `text` writes, such as "9000000.25", "-1.5" or "4e5". Digits after the 31st decimal are
  /// dropped: 31 decimals hold every half of a grid unit.
  /// @return nothing when it is not such a number, or is one of 10^15 m or more.
  static std::optional<Decimal> parse(std::string_view text);

  /// The nearest grid point from `origin`, halves away from zero [grid units]; docs/theory/geometry.md, (3).
  /// @return nothing beyond kMaxCoordinate of the origin.
  std::optional<std::int64_t> grid_units_from(const Decimal& origin) const;
  /// The fewest decimals that grid_units_from(`origin`) reads as `units`; at most ten when the origin is whole.
  static Decimal of_grid_units(std::int64_t units, const Decimal& origin);

  double nearest_double() const;
  /// Every digit, without an exponent.
  std::string to_string() const;

  friend Decimal operator-(const Decimal& a, const Decimal& b);
  friend constexpr bool operator==(const Decimal&, const Decimal&) = default;
  friend constexpr std::strong_ordering operator<=>(const Decimal& a, const Decimal& b) {
    if (const auto order = a.whole_ <=> b.whole_; order != 0) return order;
    return a.fraction_ < b.fraction_   ? std::strong_ordering::less
           : a.fraction_ > b.fraction_ ? std::strong_ordering::greater
                                       : std::strong_ordering::equal;
  }

 private:
  constexpr Decimal(std::int64_t whole, Int128 fraction) : whole_(whole), fraction_(fraction) {}
  Decimal rounded(int n_decimals) const;

  std::int64_t whole_ = 0;  ///< the largest whole number that is not larger
  Int128 fraction_ = 0;     ///< what is left, in [0, 1) m [10^-31 m]
};

/// Where the grid of a map has its zero, in the coordinates of the map.
struct Origin {
  Decimal x;
  Decimal y;

  friend constexpr bool operator==(const Origin&, const Origin&) = default;
};

/// The fewest decimals that read to these numbers of metres, each within +-10^15.
Origin origin_from_metres(Vec2 metres);
/// Reads "X,Y", also with blanks around its numbers.
std::optional<Origin> origin_from_text(std::string_view text);
/// "X,Y", every digit.
std::string to_string(const Origin& origin);

}  // namespace brash::geometry
