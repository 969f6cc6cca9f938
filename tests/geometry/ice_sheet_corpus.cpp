// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>

#include "corpus.hpp"

using namespace brash;
using namespace brash::geometry;

namespace {

ExactArea total(const std::vector<Polygon>& polygons) {
  ExactArea sum;
  for (const Polygon& polygon : polygons) sum += area(polygon);
  return sum;
}

/// Laid back together, pieces and sheet make one valid sheet of the same area: they overlap nowhere.
void expect_tiling(const std::vector<Polygon>& pieces, const IceSheet& sheet) {
  std::vector<Polygon> together = sheet.polygons();
  together.insert(together.end(), pieces.begin(), pieces.end());
  const auto whole = IceSheet::from_polygons(together);
  BOOST_TEST_REQUIRE(whole.has_value(), (whole ? "" : whole.error().what));
  BOOST_TEST((whole->area() == total(together)));
}

void run(const corpus::Case& c) {
  auto made = IceSheet::from_polygons(c.ice);
  BOOST_TEST_REQUIRE(made.has_value(), (made ? "" : made.error().what));
  IceSheet sheet = std::move(*made);
  std::vector<std::size_t> n_pieces;
  for (const corpus::Event& event : c.events) {
    const ExactArea before = sheet.area();
    Cut cut;
    if (event.region.empty()) {
      cut.pieces = sheet.release_detached();
      BOOST_TEST(sheet.polygons().size() <= 1u);
    } else {
      const std::vector<Polygon> seen = sheet.within(event.region);
      cut = sheet.cut(event.region, event.cracks);
      if (event.cracks.empty()) BOOST_TEST((cut.pieces == seen));
    }
    n_pieces.push_back(cut.pieces.size());
    BOOST_TEST((before == sheet.area() + total(cut.pieces) + cut.snap));
    sheet.check();
    expect_tiling(cut.pieces, sheet);
  }
  if (!c.pieces.empty()) BOOST_TEST(n_pieces == c.pieces, boost::test_tools::per_element());
  const std::vector<Polygon> parts = sheet.polygons();
  if (c.parts >= 0) BOOST_TEST(parts.size() == static_cast<std::size_t>(c.parts));
  std::size_t holes = 0;
  for (const Polygon& part : parts) holes += part.holes.size();
  if (c.holes >= 0) BOOST_TEST(holes == static_cast<std::size_t>(c.holes));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(ice_sheet_corpus)

BOOST_AUTO_TEST_CASE(every_named_degenerate_case_holds_as_written_mirrored_turned_and_reversed) {
  for (const corpus::Case& c : corpus::read_all()) {
    for (const corpus::Case& variant : corpus::variants(c)) {
      BOOST_TEST_CONTEXT(variant.name) {
        try {
          run(variant);
        } catch (const std::logic_error& error) {
          BOOST_ERROR(error.what());
        }
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
