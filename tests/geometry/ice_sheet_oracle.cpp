// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <boost/test/unit_test.hpp>
#include <list>
#include <random>

#include "corpus.hpp"

// Every cut against CGAL's exact Boolean operations on the same polygons.
using namespace brash;
using namespace brash::geometry;

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using CgalRing = CGAL::Polygon_2<Kernel>;
using CgalPolygon = CGAL::Polygon_with_holes_2<Kernel>;

CgalRing to_cgal(const Ring& ring) {
  CgalRing result;
  for (const Point p : ring) result.push_back(Kernel::Point_2(metres(p).x, metres(p).y));
  return result;
}

CgalPolygon to_cgal(const Polygon& polygon) {
  CgalPolygon result(to_cgal(polygon.outline));
  for (const Ring& hole : polygon.holes) result.add_hole(to_cgal(hole));
  return result;
}

std::vector<CgalPolygon> to_cgal(const std::vector<Polygon>& polygons) {
  std::vector<CgalPolygon> result;
  for (const Polygon& polygon : polygons) result.push_back(to_cgal(polygon));
  return result;
}

Kernel::FT area_of(const CgalPolygon& polygon) {
  Kernel::FT area = polygon.outer_boundary().area();
  for (const CgalRing& hole : polygon.holes()) area += hole.area();
  return area;
}

template <typename Polygons>
Kernel::FT area_of(const Polygons& polygons) {
  Kernel::FT area = 0;
  for (const CgalPolygon& polygon : polygons) area += area_of(polygon);
  return area;
}

/// The ice outside the region.
std::vector<CgalPolygon> difference(const std::vector<CgalPolygon>& ice, const CgalPolygon& region) {
  std::vector<CgalPolygon> result;
  for (const CgalPolygon& polygon : ice) {
    CGAL::difference(polygon, region, std::back_inserter(result), CGAL::Tag_false());
  }
  return result;
}

/// Area that lies in exactly one of two sets of disjoint polygons [m2].
double mismatch(const std::vector<CgalPolygon>& a, const std::vector<CgalPolygon>& b) {
  Kernel::FT common = 0;
  for (const CgalPolygon& p : a) {
    for (const CgalPolygon& q : b) {
      if (!CGAL::do_overlap(p.bbox(), q.bbox())) continue;
      std::list<CgalPolygon> both;
      CGAL::intersection(p, q, std::back_inserter(both), CGAL::Tag_false());
      common += area_of(both);
    }
  }
  return CGAL::to_double(area_of(a) + area_of(b) - 2 * common);
}

double perimeter(const Ring& ring) {
  double length = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) length += norm(metres(ring[(i + 1) % ring.size()]) - metres(ring[i]));
  return length;
}

/// Cuts and compares sheet and pieces with the exact outcome, up to what rounding can do.
void cut_and_compare(IceSheet& sheet, const Ring& region, std::span<const Crack> cracks) {
  const std::vector<Polygon> before = sheet.polygons();
  const Cut cut = sheet.cut(region, cracks);
  sheet.check();
  const std::vector<CgalPolygon> ice = to_cgal(before);
  const CgalPolygon disc(to_cgal(region));
  const std::vector<CgalPolygon> rest = difference(ice, disc);
  // Leading an edge through the pixels it meets moves it by less than one grid unit, the new edges as well as the old.
  double length = perimeter(region);
  for (const Polygon& polygon : before) {
    length += perimeter(polygon.outline);
    for (const Ring& hole : polygon.holes) length += perimeter(hole);
  }
  const double allowed = length * kGridUnit;
  BOOST_TEST(mismatch(rest, to_cgal(sheet.polygons())) <= allowed);
  const double taken = CGAL::to_double(area_of(ice) - area_of(rest));
  ExactArea pieces;
  for (const Polygon& piece : cut.pieces) pieces += area(piece);
  BOOST_TEST(std::abs(taken - pieces.square_metres()) <= allowed);
}

double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(ice_sheet_oracle)

BOOST_AUTO_TEST_CASE(the_corpus_agrees_with_exact_boolean_operations) {
  for (const corpus::Case& c : corpus::read_all()) {
    BOOST_TEST_CONTEXT(c.name) {
      IceSheet sheet = IceSheet::from_polygons(c.ice).value();
      for (const corpus::Event& event : c.events) {
        if (event.region.empty()) {
          (void)sheet.release_detached();
        } else {
          cut_and_compare(sheet, event.region, event.cracks);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(random_events_agree_with_exact_boolean_operations) {
  std::mt19937_64 random(1);
  for (int run = 0; run < 20; ++run) {
    IceSheet sheet = IceSheet::from_polygons(std::vector<Polygon>{{disc({0, 0}, 6.0, 24, 0.1), {}}}).value();
    for (int i = 0; i < 12; ++i) {
      const double angle = uniform(random, 0.0, 6.28);
      const Vec2 centre = uniform(random, 4.0, 6.2) * Vec2{std::cos(angle), std::sin(angle)};
      const Ring region = disc(centre, uniform(random, 0.5, 2.0), 8 + i, angle);
      const Crack cracks[] = {{snap(centre), region[2]}, {snap(centre), region[5]}, {snap(centre), region[6]}};
      cut_and_compare(sheet, region, cracks);
    }
  }
}

BOOST_AUTO_TEST_CASE(degenerate_sequences_agree_with_exact_boolean_operations) {
  // Everything on a lattice of half metres, give or take a unit: vertices on edges, edges on edges, discs on discs.
  std::mt19937_64 random(2);
  const auto lattice = [&](int n) {
    const auto steps = static_cast<double>(random() % static_cast<unsigned>(n));
    return snap({0.5 * steps, 0.0}).x + static_cast<std::int64_t>(random() % 3) - 1;
  };
  for (int run = 0; run < 40; ++run) {
    const Ring outline{{0, 0}, snap({6, 0}), snap({6, 6}), snap({0, 6})};
    IceSheet sheet = IceSheet::from_polygons(std::vector<Polygon>{{outline, {}}}).value();
    for (int i = 0; i < 10; ++i) {
      const Point centre{lattice(13), lattice(13)};
      const double radius = 0.5 * static_cast<double>(1 + random() % 3);
      Ring region = disc(metres(centre), radius, random() % 2 ? 4 : 8);
      const Crack cracks[] = {{centre, region[0]}, {centre, region[2]}, {centre, {centre.x, lattice(13)}}};
      cut_and_compare(sheet, region, cracks);
      if (i % 4 == 3) (void)sheet.release_detached();
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
