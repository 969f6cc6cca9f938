// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/structure/ship.hpp"

#include <cmath>
#include <vector>

#include "brash/core/constants.hpp"
#include "frustum.hpp"
#include "mesh_hull.hpp"

namespace brash::structure {
namespace {

/// Chords of each of the four curves of a waterline. Their area is short of the curves' by 1 / (4 n^2).
constexpr int kChords = 24;

/// Half of the waterline at the height z, on the port side from the stem to the stern. docs/theory/structures.md, (K4)
std::vector<Vec2> port_side(const Particulars& ship, double z) {
  const double b = half_breadth_at(ship, z), widened = b / half_breadth_at(ship, 0.0);
  const double stem = 0.5 * ship.length + z / std::tan(ship.stem_angle);
  const double stern = -0.5 * ship.length - z / std::tan(ship.stern_angle);
  std::vector<Vec2> side;
  for (int i = 0; i <= kChords; ++i) {
    const double t = static_cast<double>(i) / kChords;
    side.push_back({stem - widened * ship.bow * t, b * (1.0 - std::pow(1.0 - t, ship.fullness))});
  }
  for (int i = kChords; i >= 0; --i) {
    const double t = static_cast<double>(i) / kChords;
    side.push_back({stern + widened * ship.run * t, b * t * (2.0 - t)});
  }
  return side;
}

std::vector<Vec3> ring(const Particulars& ship, double z) {
  std::vector<Vec3> ring;
  const std::vector<Vec2> port = port_side(ship, z);
  for (const Vec2 p : port) ring.push_back({p.x, p.y, z});
  for (std::size_t i = port.size() - 2; i > 0; --i) ring.push_back({port[i].x, -port[i].y, z});
  return ring;
}

}  // namespace

Particulars particulars_of(const model::HullSection& hull) {
  Particulars ship{};
  ship.length = hull.length.value();
  ship.breadth = hull.breadth.value();
  ship.draught = hull.draught.value();
  ship.depth = hull.depth.value_or(1.5 * ship.draught);
  ship.stem_angle = hull.stem_angle.value();
  ship.stern_angle = hull.stern_angle.value_or(kPi / 4.0);
  ship.flare = hull.flare.value_or(0.0);
  const double wedge = 0.5 * ship.breadth / std::tan(hull.waterline_angle.value());
  ship.bow = hull.bow_length.value_or(2.0 * wedge);
  ship.fullness = ship.bow / wedge;  // docs/theory/structures.md, (K5)
  ship.midbody = hull.midbody.value_or(0.5 * (ship.length - ship.bow));
  ship.run = ship.length - ship.bow - ship.midbody;
  return ship;
}

double half_breadth_at(const Particulars& ship, double z) { return 0.5 * ship.breadth + z * std::tan(ship.flare); }

double midbody_at(const Particulars& ship, double z) {
  const double lean = 1.0 / std::tan(ship.stem_angle) + 1.0 / std::tan(ship.stern_angle);
  const double widened = half_breadth_at(ship, z) / half_breadth_at(ship, 0.0);
  return ship.length + z * lean - widened * (ship.bow + ship.run);
}

TriangleMesh ship_mesh(const Particulars& ship) {
  return Frustum(ring(ship, -ship.draught), ring(ship, ship.depth - ship.draught)).mesh();
}

std::unique_ptr<const Hull> hull_of(const model::Ship& ship) {
  return std::make_unique<MeshHull>(
      std::make_shared<const MeshBody>(ship_mesh(particulars_of(ship.hull)), MeshReport{}));
}

}  // namespace brash::structure
