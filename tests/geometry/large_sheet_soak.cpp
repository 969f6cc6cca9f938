// SPDX-License-Identifier: GPL-3.0-or-later
// Sheets of 100 000 vertices: they are cut as small ones are, and hold no more memory than their vertices take.
#include <malloc.h>

#include <boost/test/unit_test.hpp>

#include "brash/geometry/ice_sheet.hpp"
#include "shapes.hpp"

using namespace brash;
using namespace brash::geometry;

namespace {

constexpr int kVertices = 100000;
constexpr double kSpacing = 0.15;                 // m
constexpr double kLength = kVertices * kSpacing;  // of the sheet, about the origin: coordinates end at kMaxCoordinate
static_assert(0.5 * kLength < kMaxCoordinate);

double heap_in_use() {
  const struct mallinfo2 info = ::mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

/// A sheet whose free edge is ragged.
Polygon ragged_sheet(std::mt19937_64& random) {
  std::vector<Vec2> outline;
  for (int i = 0; i < kVertices; ++i) outline.push_back({kSpacing * i - 0.5 * kLength, shapes::uniform(random)});
  outline.push_back({0.5 * kLength, 100.0});
  outline.push_back({-0.5 * kLength, 100.0});
  return {ring(outline), {}};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_large_sheet_is_cut_ten_thousand_times_and_its_memory_follows_its_vertices) {
  std::mt19937_64 random(8);
  const double before = heap_in_use();
  IceSheet sheet = IceSheet::from_polygons(std::vector<Polygon>{ragged_sheet(random)}).value();
  const double bytes_a_vertex = (heap_in_use() - before) / static_cast<double>(sheet.n_vertices());
  BOOST_TEST_MESSAGE(sheet.n_vertices() << " vertices, " << bytes_a_vertex << " bytes each");
  for (int i = 1; i <= 10000; ++i) {
    const Vec2 centre{kLength * (shapes::uniform(random) - 0.5), 60.0 * shapes::uniform(random)};
    const ExactArea whole = sheet.area();
    const Cut cut = cut_circumferential(sheet, centre, 0.5 + 2.5 * shapes::uniform(random), 3 + i % 3);
    ExactArea pieces;
    for (const Polygon& piece : cut.pieces) pieces += area(piece);
    BOOST_REQUIRE((whole == sheet.area() + pieces + cut.snap));
    if (i % 1000 != 0) continue;
    sheet.check();
    const double now = (heap_in_use() - before) / static_cast<double>(sheet.n_vertices());
    BOOST_TEST_MESSAGE(i << " cuts: " << sheet.n_vertices() << " vertices, " << now << " bytes each");
    // Vectors that grow by doubling hold at most twice the memory they need.
    BOOST_TEST(now < 2.0 * bytes_a_vertex);
  }
}
