// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/core/vec.hpp"

namespace brash::simulation {

/// World axes to load axes and back: x as the ice drifts against the structure, z upwards (a half turn about z).
inline Vec3 in_load_axes(Vec3 v) { return {-v.x, -v.y, v.z}; }
inline Wrench in_load_axes(const Wrench& w) { return {in_load_axes(w.force), in_load_axes(w.moment)}; }
inline Twist in_load_axes(const Twist& t) { return {in_load_axes(t.linear), in_load_axes(t.angular)}; }

}  // namespace brash::simulation
