// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/geometry/area.hpp"

#include <algorithm>
#include <cmath>

namespace brash::geometry {
namespace {

__extension__ typedef unsigned __int128 UInt128;

/// One square metre is 2^60 squared grid units, so twice the area counts 2^-61 m2.
constexpr int kFractionBits = 61;

}  // namespace

double ExactArea::square_metres() const {
  // The conversion rounds to nearest even, the scaling is exact: the smallest step, 2^-61, is far from subnormal.
  return std::ldexp(static_cast<double>(twice_), -kFractionBits);
}

std::string ExactArea::to_string() const {
  const UInt128 magnitude = twice_ < 0 ? -static_cast<UInt128>(twice_) : static_cast<UInt128>(twice_);
  UInt128 whole = magnitude >> kFractionBits;
  UInt128 fraction = magnitude & ((UInt128{1} << kFractionBits) - 1);

  std::string text;
  do {
    text += static_cast<char>('0' + static_cast<int>(whole % 10));
    whole /= 10;
  } while (whole != 0);
  if (twice_ < 0) text += '-';
  std::reverse(text.begin(), text.end());

  // Ends after at most 61 digits, since 10^61 is a multiple of 2^61.
  if (fraction != 0) text += '.';
  while (fraction != 0) {
    fraction *= 10;
    text += static_cast<char>('0' + static_cast<int>(fraction >> kFractionBits));
    fraction &= (UInt128{1} << kFractionBits) - 1;
  }
  return text;
}

}  // namespace brash::geometry
