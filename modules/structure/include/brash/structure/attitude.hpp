// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "brash/core/vec.hpp"

namespace brash::structure {

/// Roll, pitch and heading of a rotation [rad]: it turns by the heading about z first, then by the pitch about its own
/// y, and by the roll about its own x last.
inline Vec3 attitude_of(const Quaternion& q) {
  return {std::atan2(2.0 * (q.w * q.x + q.y * q.z), 1.0 - 2.0 * (q.x * q.x + q.y * q.y)),
          std::asin(std::clamp(2.0 * (q.w * q.y - q.x * q.z), -1.0, 1.0)),
          std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z))};
}

}  // namespace brash::structure
