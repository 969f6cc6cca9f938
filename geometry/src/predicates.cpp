// SPDX-License-Identifier: GPL-3.0-or-later
#include "predicates.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace brash::geometry {

int side(Point a, Point b, Point c) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto exactly = [](Point p) { return Kernel::Point_2(static_cast<double>(p.x), static_cast<double>(p.y)); };
  return CGAL::orientation(exactly(a), exactly(b), exactly(c));
}

}  // namespace brash::geometry
