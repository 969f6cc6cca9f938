// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle.hpp"
#include "peers.hpp"

// CGAL's exact Boolean operations are the reference: they see every coordinate of a result as the rational it is.
namespace brash::benchmarks {

using namespace geometry::oracle;

namespace {

CgalRing ring_of(const std::vector<Vec2>& loop) {
  CgalRing ring;
  for (const Vec2 p : loop) ring.push_back(Kernel::Point_2(p.x, p.y));
  return ring;
}

}  // namespace

double exact_area(const std::vector<geometry::Polygon>& ice, const geometry::Ring& region) {
  return CGAL::to_double(area_of(difference(to_cgal(ice), CgalPolygon(to_cgal(region)))));
}

double exact_area(const Loops& loops) {
  // By hand: CGAL's area() of a ring asks for a simple one.
  Kernel::FT twice = 0;
  for (const std::vector<Vec2>& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 a = loop[i];
      const Vec2 b = loop[(i + 1) % loop.size()];
      twice += Kernel::FT(a.x) * b.y - Kernel::FT(a.y) * b.x;
    }
  }
  return 0.5 * CGAL::to_double(twice);
}

bool are_simple(const Loops& loops) {
  for (const std::vector<Vec2>& loop : loops) {
    if (loop.size() < 3 || !ring_of(loop).is_simple()) return false;
  }
  return true;
}

}  // namespace brash::benchmarks
