// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "brash/geometry/ice_sheet.hpp"
#include "brash/geometry/ledger.hpp"

using namespace brash;
using namespace brash::geometry;

namespace {

class Random {
 public:
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }

 private:
  std::mt19937_64 engine_{11};
};

ExactArea total(const std::vector<Polygon>& polygons) {
  ExactArea sum;
  for (const Polygon& polygon : polygons) sum += area(polygon);
  return sum;
}

/// Of the broken edge: straight sides of the first sheet are left out.
double vertices_per_metre(const IceSheet& sheet) {
  double length = 0.0;
  double vertices = 0.0;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const double edge = norm(metres(ring[(i + 1) % ring.size()]) - metres(ring[i]));
      if (edge > 2.0) continue;
      length += edge;
      vertices += 1.0;
    }
  };
  for (const Polygon& polygon : sheet.polygons()) {
    add(polygon.outline);
    for (const Ring& hole : polygon.holes) add(hole);
  }
  return vertices / length;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(ice_sheet_cascade)

BOOST_AUTO_TEST_CASE(a_hundred_thousand_events_on_the_edge_that_earlier_ones_left_close_the_ledger_and_grow_nothing) {
  constexpr int kEvents = 100000;
  Random random;
  const Vec2 corners[] = {{0, 0}, {400, 0}, {400, 400}, {0, 400}};
  IceSheet sheet = IceSheet::from_polygons(std::vector<Polygon>{{ring(corners), {}}}).value();
  Ledger ledger;
  ledger.initial = sheet.area();
  double density_after_a_tenth = 0.0;
  Vec2 at{0, 200};
  for (int i = 1; i <= kEvents; ++i) {
    // The next event lies on the free edge not far from the last one.
    const Vec2 near{at.x + random.uniform(-2, 2), at.y + random.uniform(-2, 2)};
    const auto chains = sheet.free_edge(near, 4.0);
    if (chains.empty()) {
      at = metres(sheet.polygons().front().outline.front());
      continue;
    }
    const std::vector<Vec2>& chain = chains[static_cast<std::size_t>(random.uniform(0, 0.999 * chains.size()))];
    at = chain[static_cast<std::size_t>(random.uniform(0, 0.999 * chain.size()))];
    const Cut cut = cut_circumferential(sheet, at, random.uniform(0.3, 1.0), 3 + i % 3, 16);
    ledger.floes += total(cut.pieces) + total(sheet.release_detached());
    ledger.snap += cut.snap;
    if (i % (kEvents / 4) == 0) {
      ledger.sheet = sheet.area();
      BOOST_TEST_REQUIRE(ledger.closes());
      BOOST_REQUIRE_NO_THROW(sheet.check());
    }
    if (i == kEvents / 10) density_after_a_tenth = vertices_per_metre(sheet);
  }
  // Stale features would gather along the edge; the edge keeps its look instead, within the scatter of a random front.
  BOOST_TEST(vertices_per_metre(sheet) < 1.5 * density_after_a_tenth);
  // An event moves a few edges of less than a metre by up to a grid unit, to either side at random.
  BOOST_TEST(std::abs(ledger.snap.square_metres()) < kEvents * 5.0 * kGridUnit);
  BOOST_TEST(ledger.floes.square_metres() > 1000.0);
  BOOST_TEST_MESSAGE("vertices " << sheet.n_vertices() << ", " << density_after_a_tenth << " then "
                                 << vertices_per_metre(sheet) << " a metre, snap " << ledger.snap.square_metres()
                                 << " m2, floes " << ledger.floes.square_metres() << " m2");
}

BOOST_AUTO_TEST_SUITE_END()
