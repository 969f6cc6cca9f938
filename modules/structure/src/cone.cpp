// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/structure/cone.hpp"

#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"

namespace brash::structure {

double radius_at(const Cone& cone, double z) {
  const double widening = z / std::tan(cone.angle);
  return 0.5 * cone.waterline_width + (cone.downward_breaking ? widening : -widening);
}

double displaced_volume(const Cone& cone) {
  const double top = radius_at(cone, 0.0), keel = radius_at(cone, -cone.height_under_water);
  return kPi * cone.height_under_water / 3.0 * (top * top + top * keel + keel * keel);
}

std::vector<Vec2> section(const Cone& cone, double z) {
  const double radius = radius_at(cone, z);
  BRASH_EXPECTS(radius > 0.0 && cone.facets >= 3, radius, z, cone.facets);
  std::vector<Vec2> ring;
  ring.reserve(static_cast<std::size_t>(cone.facets));
  for (int i = 0; i < cone.facets; ++i) {
    const double angle = 2.0 * kPi * i / cone.facets;
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return ring;
}

std::vector<Vec3> hull(const Cone& cone) {
  const double keel = -cone.height_under_water;
  std::vector<Vec3> vertices;
  vertices.reserve(2 * static_cast<std::size_t>(cone.facets));
  for (const double z : {keel, keel + cone.height})
    for (const Vec2 v : section(cone, z)) vertices.push_back({v.x, v.y, z});
  return vertices;
}

}  // namespace brash::structure
