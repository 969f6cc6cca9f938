// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact.hpp"

#include <cstdlib>
#include <tuple>
#include <utility>

#include "brash/core/contract.hpp"

namespace brash::geometry::exact {

namespace {

Int128 magnitude(Int128 value) { return value < 0 ? -value : value; }

/// Quotient and remainder of length * numerator / denominator, bit by bit: no product that could overflow.
std::pair<std::int64_t, Int128> long_division(std::int64_t length, Int128 numerator, Int128 denominator) {
  std::int64_t quotient = 0;
  Int128 remainder = 0;
  for (int bit = 62; bit >= 0; --bit) {
    quotient *= 2;
    remainder *= 2;
    if ((length >> bit) & 1) remainder += numerator;
    for (; remainder >= denominator; remainder -= denominator) ++quotient;
  }
  return {quotient, remainder};
}

}  // namespace

std::int64_t scaled(std::int64_t length, Int128 numerator, Int128 denominator) {
  const std::int64_t size = length < 0 ? -length : length;
  std::int64_t quotient = 0;
  Int128 remainder = 0;
  if (size < (std::int64_t{1} << 34) && numerator < (static_cast<Int128>(1) << 92)) {
    const Int128 product = size * numerator;
    quotient = static_cast<std::int64_t>(product / denominator);
    remainder = product - quotient * denominator;
  } else {
    std::tie(quotient, remainder) = long_division(size, numerator, denominator);
  }
  // value = quotient + remainder / denominator; round half up, so half away from zero downwards for negative lengths.
  if (length >= 0) return quotient + (2 * remainder >= denominator ? 1 : 0);
  return -quotient - (2 * remainder > denominator ? 1 : 0);
}

Point rounded_crossing(Point a, Point b, Point c, Point d) {
  const auto reach = [](Point p, Point q) { return std::max(std::abs(q.x - p.x), std::abs(q.y - p.y)); };
  if (reach(c, d) < reach(a, b)) {
    std::swap(a, c);
    std::swap(b, d);
  }
  const Int128 from = turn(c, d, a);
  const Int128 to = turn(c, d, b);
  BRASH_EXPECTS((from < 0) != (to < 0) && from != 0 && to != 0, a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y);
  const Int128 numerator = magnitude(from);
  const Int128 denominator = magnitude(from) + magnitude(to);
  return a + Point::of_units(scaled(b.x - a.x, numerator, denominator), scaled(b.y - a.y, numerator, denominator));
}

int winding(std::span<const Point> ring, Point p, int scale) {
  int turns = 0;
  Point b = Point::of_units(scale * ring.back().x, scale * ring.back().y);
  for (const Point vertex : ring) {
    const Point a = b;
    b = Point::of_units(scale * vertex.x, scale * vertex.y);
    if (a.y <= p.y && p.y < b.y && side(a, b, p) > 0) ++turns;
    if (b.y <= p.y && p.y < a.y && side(a, b, p) < 0) --turns;
  }
  return turns;
}

bool is_met_before(Point a_from, Point a_to, Point b_from, Point b_to) {
  const auto [a_low, a_high] = a_from.y < a_to.y ? std::pair{a_from, a_to} : std::pair{a_to, a_from};
  const auto [b_low, b_high] = b_from.y < b_to.y ? std::pair{b_from, b_to} : std::pair{b_to, b_from};
  // Evaluated at the higher of the lower ends, or by direction where they start in one point.
  if (a_low.y >= b_low.y) {
    const int apart = side(b_low, b_high, a_low);
    return apart != 0 ? apart > 0 : side(b_low, b_high, a_high) > 0;
  }
  const int apart = side(a_low, a_high, b_low);
  return apart != 0 ? apart < 0 : side(a_low, a_high, b_high) < 0;
}

}  // namespace brash::geometry::exact
