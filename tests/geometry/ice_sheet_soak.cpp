// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <ctime>

#include "brash/geometry/ledger.hpp"
#include "oracle.hpp"
#include "soak_sequences.hpp"

// Sequences of random and adversarial events. `test_geometry_soak -- N` runs N events; the full soak is a million.
using namespace brash;
using namespace brash::geometry;

namespace {

long asked_events() {
  const auto& suite = boost::unit_test::framework::master_test_suite();
  return suite.argc > 1 ? std::atol(suite.argv[1]) : 10000;
}

ExactArea total(const std::vector<Polygon>& polygons) {
  ExactArea sum;
  for (const Polygon& polygon : polygons) sum += area(polygon);
  return sum;
}

ExactArea magnitude(ExactArea area) { return area < ExactArea{} ? ExactArea{} - area : area; }

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Counts {
  long events = 0, sequences = 0, pieces = 0, cracks = 0, rounded = 0, splits = 0, checks = 0, oracle = 0;
  double cut_seconds = 0.0;
  double worst_snap = 0.0;  ///< Of one sequence, over its first area.
};

/// Every piece by itself is a valid polygon of the area it says, and splits into parts of exactly its area.
void expect_valid_and_split(soak::Random& random, const Polygon& piece, Counts& counts) {
  const Polygon alone[] = {piece};
  const auto sheet = IceSheet::from_polygons(alone);
  BOOST_REQUIRE_MESSAGE(sheet.has_value(), "invalid piece: " << (sheet ? "" : sheet.error().what));
  const Point from = random.of(piece.outline);
  Point to = random.of(piece.outline);
  if (random.one_in(2)) to = soak::nudged(random, Point::of_units(to.x + (from.x - to.x) / 3, to.y));
  if (from == to) return;
  const Cut parts = split(piece, from, to);
  BOOST_REQUIRE((total(parts.pieces) + parts.snap == area(piece)));
  ++counts.splits;
}

void cut_and_count(soak::Random& random, IceSheet& sheet, const soak::Event& event, bool ask_oracle, Ledger& ledger,
                   Counts& counts) {
  const std::vector<Polygon> before = ask_oracle ? sheet.polygons() : std::vector<Polygon>{};
  const ExactArea area_before = sheet.area();
  const std::vector<Polygon> seen = event.cracks.empty() ? sheet.within(event.region) : std::vector<Polygon>{};
  const double start = processor_seconds();
  const Cut cut = sheet.cut(event.region, event.cracks);
  counts.cut_seconds += processor_seconds() - start;
  BOOST_REQUIRE((area_before == sheet.area() + total(cut.pieces) + cut.snap));
  if (event.cracks.empty()) BOOST_REQUIRE((cut.pieces == seen));
  ledger.floes += total(cut.pieces);
  ledger.snap += cut.snap;
  ++counts.events;
  counts.pieces += static_cast<long>(cut.pieces.size());
  counts.cracks += static_cast<long>(event.cracks.size());
  counts.rounded += cut.n_rounded;
  if (!cut.pieces.empty() && random.one_in(8)) expect_valid_and_split(random, random.of(cut.pieces), counts);
  if (!ask_oracle) return;
  const oracle::Deviation off = oracle::deviation(before, event.region, sheet, cut);
  BOOST_REQUIRE_MESSAGE(off.is_allowed(), off.sheet << ", " << off.pieces << " m2 off, allowed " << off.allowed);
  ++counts.oracle;
}

void run_sequence(std::uint64_t seed, long most_events, Counts& counts) {
  soak::Random random(seed);
  auto made = IceSheet::from_polygons(soak::make_sheet(random));
  BOOST_REQUIRE_MESSAGE(made.has_value(), (made ? "" : made.error().what));
  IceSheet sheet = std::move(*made);
  Ledger ledger;
  ledger.initial = sheet.area();
  soak::Events events;
  std::vector<Polygon> ice = sheet.polygons();
  // One sequence in eight has an event, early on, that is compared with exact Boolean operations.
  const int compared = random.one_in(8) ? random.below(30) : -1;
  for (int i = 0; i < most_events && i < 150; ++i) {
    if (i % 4 == 0) ice = sheet.polygons();
    if (ice.empty()) break;
    BOOST_TEST_CONTEXT("seed " << seed << ", event " << i) {
      cut_and_count(random, sheet, events.next(random, ice), i == compared, ledger, counts);
      if (random.one_in(16)) ledger.floes += total(sheet.release_detached());
      if (i % 50 == 49) {
        BOOST_REQUIRE_NO_THROW(sheet.check());
        ++counts.checks;
      }
    }
  }
  BOOST_TEST_CONTEXT("seed " << seed) {
    BOOST_REQUIRE_NO_THROW(sheet.check());
    ++counts.checks;
    ledger.sheet = total(sheet.polygons());
    BOOST_REQUIRE(ledger.closes());
    // An event moves a few edges of a metre or less by up to a grid unit, 1e-9 m, in a sheet of 30 m2 and more.
    const double snap = magnitude(ledger.snap).square_metres() / ledger.initial.square_metres();
    BOOST_REQUIRE(snap < 1e-9);
    counts.worst_snap = std::max(counts.worst_snap, snap);
  }
  ++counts.sequences;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(ice_sheet_soak)

BOOST_AUTO_TEST_CASE(random_and_adversarial_events_leave_valid_polygons_and_a_closed_ledger) {
  const long n_events = asked_events();
  Counts counts;
  const double start = processor_seconds();
  for (std::uint64_t seed = 1; counts.events < n_events; ++seed) run_sequence(seed, n_events - counts.events, counts);
  BOOST_TEST(counts.events == n_events);
  BOOST_TEST(counts.oracle > 0);
  BOOST_TEST_MESSAGE("events " << counts.events << " in " << counts.sequences << " sequences, cracks " << counts.cracks
                               << ", pieces " << counts.pieces << ", crossings rounded " << counts.rounded
                               << ", splits " << counts.splits << ", checks of the whole sheet " << counts.checks
                               << ", compared with exact Boolean operations " << counts.oracle
                               << ", largest snap over area " << counts.worst_snap << ", cuts " << counts.cut_seconds
                               << " s of " << processor_seconds() - start << " s processor time");
}

BOOST_AUTO_TEST_SUITE_END()
