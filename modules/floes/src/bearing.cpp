// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/floes/bearing.hpp"

#include <algorithm>
#include <cmath>

#include "brash/core/contract.hpp"

namespace brash::floes {

void add_contact(Bearing& bearing, const rigid_body::ContactLoad& contact) {
  const Vec3 normal = -contact.normal_force * contact.normal;
  const Vec3 at = contact.point;
  const double weight = norm(normal);
  bearing.force += normal - contact.friction_force;
  bearing.thrust += plan(normal);
  bearing.weight += weight;
  bearing.first += weight * at;
  bearing.second[0] += weight * at.x * at.x;
  bearing.second[1] += weight * at.x * at.y;
  bearing.second[2] += weight * at.y * at.y;
}

void approach(Bearing& mean, const Bearing& now, double share) {
  mean.force += share * (now.force - mean.force);
  mean.thrust += share * (now.thrust - mean.thrust);
  mean.weight += share * (now.weight - mean.weight);
  mean.first += share * (now.first - mean.first);
  for (std::size_t i = 0; i < 3; ++i) mean.second[i] += share * (now.second[i] - mean.second[i]);
}

LineLoad line_load(const Bearing& bearing, Vec2 towards) {
  BRASH_EXPECTS(bearing.weight > 0.0, bearing.weight);
  LineLoad load{.middle = bearing.first / bearing.weight, .towards = towards};
  const Vec2 side = perpendicular(towards);
  const double square = (side.x * side.x * bearing.second[0] + 2.0 * side.x * side.y * bearing.second[1] +
                         side.y * side.y * bearing.second[2]) /
                        bearing.weight;
  const double offset = dot(side, plan(load.middle));
  load.length = std::sqrt(12.0 * std::max(0.0, square - offset * offset));  // an even load's variance is length^2 / 12
  load.normal = dot(plan(bearing.force), towards);
  load.across = dot(plan(bearing.force), side);
  load.out_of_plane = std::abs(bearing.force.z);
  return load;
}

}  // namespace brash::floes
