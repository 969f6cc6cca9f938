// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

namespace brash {

inline constexpr double kPi = std::numbers::pi;
/// Standard gravity [m/s2], ISO 80000-3.
inline constexpr double kGravity = 9.80665;

constexpr double radians(double degrees) { return degrees * kPi / 180.0; }
constexpr double degrees(double radians) { return radians * 180.0 / kPi; }

}  // namespace brash
