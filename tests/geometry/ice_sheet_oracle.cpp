// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "corpus.hpp"
#include "oracle.hpp"

// Every cut against CGAL's exact Boolean operations on the same polygons.
using namespace brash;
using namespace brash::geometry;

namespace {

/// Cuts and compares sheet and pieces with the exact outcome, up to the largest rounding error.
void cut_and_compare(IceSheet& sheet, const Ring& region, std::span<const Crack> cracks) {
  const std::vector<Polygon> before = sheet.polygons();
  const Cut cut = sheet.cut(region, cracks);
  sheet.check();
  const oracle::Deviation off = oracle::deviation(before, region, sheet, cut);
  BOOST_TEST(off.is_allowed(), off.sheet << " and " << off.pieces << " m2 off, allowed " << off.allowed);
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
    const Ring outline{Point{}, snap({6, 0}), snap({6, 6}), snap({0, 6})};
    IceSheet sheet = IceSheet::from_polygons(std::vector<Polygon>{{outline, {}}}).value();
    for (int i = 0; i < 10; ++i) {
      const auto x = lattice(13), y = lattice(13);
      const Point centre = Point::of_units(x, y);
      const double radius = 0.5 * static_cast<double>(1 + random() % 3);
      Ring region = disc(metres(centre), radius, random() % 2 ? 4 : 8);
      const Crack cracks[] = {
          {centre, region[0]}, {centre, region[2]}, {centre, Point::of_units(centre.x, lattice(13))}};
      cut_and_compare(sheet, region, cracks);
      if (i % 4 == 3) (void)sheet.release_detached();
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
