// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <LinearMath/btTransform.h>

#include "brash/core/vec.hpp"

static_assert(sizeof(btScalar) == sizeof(double), "link bullet-float64: the plain package is single precision");

namespace brash::rigid_body {

inline btVector3 to_bullet(Vec3 v) { return {v.x, v.y, v.z}; }
inline Vec3 from_bullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
inline btTransform to_bullet(const Pose& p) {
  return btTransform(btQuaternion(p.rotation.x, p.rotation.y, p.rotation.z, p.rotation.w), to_bullet(p.position));
}

}  // namespace brash::rigid_body
