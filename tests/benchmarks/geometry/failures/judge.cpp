// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>

#include "oracle.hpp"
#include "peers.hpp"

// CGAL's exact Boolean operations are the reference: they see every coordinate of a result as the rational it is.
namespace brash::benchmarks {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

CGAL::Polygon_2<Kernel> ring_of(const std::vector<Vec2>& loop) {
  CGAL::Polygon_2<Kernel> ring;
  for (const Vec2 p : loop) ring.push_back(Kernel::Point_2(p.x, p.y));
  return ring;
}

}  // namespace

double exact_area(const std::vector<geometry::Polygon>& ice, const geometry::Ring& region) {
  return geometry::oracle::area_outside(ice, region);
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
