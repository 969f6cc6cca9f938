// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's optimal partition (Greene) as the measure of how many parts are needed.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Partition_traits_2.h>
#include <CGAL/is_y_monotone_2.h>
#include <CGAL/partition_2.h>

#include <boost/test/unit_test.hpp>
#include <list>

#include "brash/geometry/polygon.hpp"
#include "shapes.hpp"

namespace brash::geometry {
namespace {

using Traits = CGAL::Partition_traits_2<CGAL::Exact_predicates_inexact_constructions_kernel>;

/// Grid coordinates are below 2^53, so doubles hold them and CGAL's predicates are exact on them.
Traits::Polygon_2 to_cgal(const Ring& ring) {
  Traits::Polygon_2 polygon;
  for (const Point p : ring) polygon.push_back({static_cast<double>(p.x), static_cast<double>(p.y)});
  return polygon;
}

struct Counts {
  std::size_t ours = 0;
  std::size_t fewest = 0;

  void add(const Ring& ring) {
    const Traits::Polygon_2 polygon = to_cgal(ring);
    std::list<Traits::Polygon_2> optimal, parts;
    CGAL::optimal_convex_partition_2(polygon.vertices_begin(), polygon.vertices_end(), std::back_inserter(optimal));
    for (const Ring& part : convex_parts({ring, {}})) parts.push_back(to_cgal(part));
    BOOST_TEST(CGAL::convex_partition_is_valid_2(polygon.vertices_begin(), polygon.vertices_end(), parts.begin(),
                                                 parts.end()));
    ours += parts.size();
    fewest += optimal.size();
  }
};

BOOST_AUTO_TEST_SUITE(parts_against_the_optimum)

BOOST_AUTO_TEST_CASE(wedges_have_the_fewest_parts) {
  std::mt19937_64 generator(11);
  Counts counts;
  for (int i = 0; i < 400; ++i) counts.add(shapes::wedge(generator));
  BOOST_TEST(counts.ours == counts.fewest);
}

BOOST_AUTO_TEST_CASE(wild_stars_of_up_to_thirty_vertices_have_the_fewest_parts) {
  std::mt19937_64 generator(12);
  Counts counts;
  for (int i = 0; i < 200; ++i) counts.add(shapes::star(generator, 6 + i % 25, 0.25));
  BOOST_TEST(counts.ours == counts.fewest);
}

BOOST_AUTO_TEST_CASE(large_stars_are_divided_as_well_into_less_than_half_again_as_many) {
  std::mt19937_64 generator(13);
  Counts counts;
  for (int i = 0; i < 5; ++i) counts.add(shapes::star(generator, 40, 0.25));
  // Hertel and Mehlhorn guarantee four times the fewest; 1.4 measured on stars of up to 30 vertices.
  BOOST_TEST(static_cast<double>(counts.ours) <= 1.5 * static_cast<double>(counts.fewest));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
}  // namespace brash::geometry
