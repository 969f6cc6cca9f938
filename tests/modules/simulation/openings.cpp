// SPDX-License-Identifier: GPL-3.0-or-later
// Runs in level ice with leads, channels, cracks and floes from files (docs/theory/ice.md).
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>

#include "brash/core/error.hpp"
#include "brash/io/case.hpp"
#include "brash/simulation/initial_floes.hpp"
#include "brash/simulation/run.hpp"

namespace {

using namespace brash;
using namespace brash::simulation;

/// The cone of the validation case in 40 m x 40 m of ice, whose files a test writes.
struct InFolder {
  std::filesystem::path folder = std::filesystem::temp_directory_path() / "brash_openings";

  InFolder() { std::filesystem::create_directories(folder); }
  ~InFolder() { std::filesystem::remove_all(folder); }

  std::string write(const std::string& name, const std::string& text) const {
    const std::string path = (folder / name).string();
    std::ofstream(path) << text;
    return path;
  }

  static model::Case cone(const std::vector<std::string>& more) {
    std::vector<std::string> overrides{"field.kind=level-ice", "field.length=40", "field.width=40", "time.duration=2"};
    overrides.insert(overrides.end(), more.begin(), more.end());
    return io::read_case(BRASH_SOURCE_DIR "/tests/experiments/field-of-file.toml", overrides);
  }
};

std::vector<double> loads(const model::Case& resolved) {
  std::vector<double> all;
  for (const model::LoadRow& row : run(resolved).results.loads) all.push_back(row.total.force.x);
  return all;
}

constexpr const char* kWhole = "POLYGON((0 -20, 40 -20, 40 20, 0 20, 0 -20))";

BOOST_FIXTURE_TEST_SUITE(openings, InFolder)

BOOST_AUTO_TEST_CASE(a_file_with_the_rectangle_gives_the_loads_of_the_rectangle) {
  const auto whole = loads(cone({"field.initial_crack=false"}));
  BOOST_TEST(*std::ranges::max_element(whole) > 0.0);
  BOOST_TEST(loads(cone({"field.file=" + write("whole.wkt", kWhole)})) == whole, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_crack_far_away_changes_no_load) {
  // More than six characteristic lengths from the structure on its way.
  const std::string crack = write("crack.wkt", "LINESTRING(36 -21, 36 21)");
  BOOST_TEST(loads(cone({"field.cracks=" + crack})) == loads(cone({"field.initial_crack=false"})),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_structure_in_its_own_channel_meets_no_load_and_closes_the_ledger) {
  const std::string channel = write("channel.wkt", "POLYGON((-1 -8, 41 -8, 41 8, -1 8, -1 -8))");
  const Run clear = run(cone({"field.openings=" + channel, "structure.start_distance=-10"}));
  for (const model::LoadRow& row : clear.results.loads) BOOST_REQUIRE(row.total.force.x == 0.0);
  BOOST_TEST(clear.summary.ledger.closes());
  BOOST_TEST(clear.summary.ledger.initial.square_metres() == 40.0 * 24.0);
  BOOST_TEST(clear.results.initial_sheet.size() == 2u);
}

BOOST_AUTO_TEST_CASE(a_channel_that_is_too_narrow_is_broken_on_both_sides) {
  const std::string channel = write("channel.wkt", "POLYGON((-1 -5, 41 -5, 41 5, -1 5, -1 -5))");
  const Run run = simulation::run(cone({"field.openings=" + channel, "time.duration=4", "output.statistics_from=1"}));
  int to_port = 0, to_starboard = 0;
  for (const model::CrackEvent& event : run.results.events) ++(event.at.y > 0.0 ? to_port : to_starboard);
  BOOST_TEST(to_port > 0);
  BOOST_TEST(to_starboard > 0);
  BOOST_TEST(run.summary.ledger.closes());
}

BOOST_AUTO_TEST_CASE(floes_of_the_file_float_in_the_channel_and_a_resumed_run_ends_with_the_same_bytes) {
  const std::string ice = write("ice.geojson", R"({"type":"FeatureCollection","features":[
    {"type":"Feature","properties":{},"geometry":{"type":"MultiPolygon","coordinates":[
      [[[0,-20],[40,-20],[40,-7],[0,-7],[0,-20]]],[[[0,7],[40,7],[40,20],[0,20],[0,7]]]]}},
    {"type":"Feature","properties":{"kind":"floe","thickness":0.2},"geometry":{"type":"Polygon","coordinates":
      [[[1,-6],[5,-6],[5,6],[1,6],[1,-6]]]}}]})");
  const model::Case resolved = cone({"field.file=" + ice, "structure.start_distance=6.9"});
  simulation::Simulation whole(resolved), first(resolved);
  BOOST_REQUIRE(whole.initial_births().size() == 1u);
  BOOST_TEST(whole.initial_births().front().thickness == 0.2);
  BOOST_TEST(whole.sheet().size() == 2u);
  BOOST_TEST(whole.ledger().initial.square_metres() == 2.0 * 40.0 * 13.0 + 4.0 * 12.0);
  for (int i = 0; i < 60; ++i) (void)whole.step(), (void)first.step();
  simulation::Simulation second(resolved, first.checkpoint());
  for (int i = 0; i < 60; ++i) (void)whole.step(), (void)second.step();
  BOOST_TEST((whole.checkpoint() == second.checkpoint()));
}

BOOST_AUTO_TEST_CASE(one_large_floe_breaks_as_a_plate_among_small_ones) {
  const std::string ice = write("ice.geojson", R"({"type":"FeatureCollection","features":[
    {"type":"Feature","properties":{"kind":"sheet"},"geometry":{"type":"Polygon","coordinates":
      [[[0,-18],[36,-18],[36,18],[0,18],[0,-18]]]}},
    {"type":"Feature","properties":{"kind":"floe"},"geometry":{"type":"Polygon","coordinates":
      [[[36.1,-5],[39,-5],[39,5],[36.1,5],[36.1,-5]]]}}]})");
  const Run run = simulation::run(cone({"field.file=" + ice, "field.border=free", "time.duration=3"}));
  BOOST_TEST(run.results.initial_sheet.size() == 1u);
  BOOST_TEST(run.results.floes.front().area == 29.0, boost::test_tools::tolerance(1e-8));
  BOOST_TEST(!run.results.events.empty());  // the plate's
  BOOST_TEST(run.summary.ledger.closes());
}

BOOST_AUTO_TEST_CASE(a_fixed_sheet_that_the_structure_cuts_in_two_stays_fast_on_both_sides) {
  simulation::Simulation through(
      cone({"field.length=8", "field.width=20", "field.initial_crack=false", "structure.waterline_width=2",
            "structure.height=2", "structure.height_under_water=1", "structure.speed=2", "structure.start_distance=2",
            "time.step=0.02", "time.duration=6"}));
  double largest = 0.0;
  for (int i = 0; i < 300; ++i)
    for (const model::FloeRecord& floe : through.step().births) largest = std::max(largest, floe.area);
  BOOST_TEST(largest > 0.0);
  BOOST_TEST(largest < 10.0);  // a half of the sheet has more than 60 m2
  geometry::Extent parts[2];
  for (const geometry::Polygon& part : through.sheet()) {
    const geometry::Extent box = geometry::extent(part);
    BOOST_TEST((box.lower.y == -10.0) != (box.upper.y == 10.0));  // each is held by one side
    parts[box.upper.y == 10.0 ? 1 : 0].add(box);
  }
  for (const geometry::Extent& half : parts) {
    BOOST_TEST(half.lower.x == 0.0);
    BOOST_TEST(half.upper.x == 8.0);
  }
  BOOST_TEST(through.ledger().closes());
}

BOOST_AUTO_TEST_CASE(the_start_is_clear_of_ice) {
  const auto refuses = [](const model::Case& resolved, const std::string& word) {
    BOOST_CHECK_EXCEPTION((void)initial_field(resolved), InputError, [&](const InputError& error) {
      return std::string(error.what()).find(word) != std::string::npos;
    });
    BOOST_CHECK_THROW((void)simulation::Simulation(resolved), InputError);
  };
  const std::string narrow = write("narrow.wkt", "POLYGON((-1 -5, 41 -5, 41 5, -1 5, -1 -5))");
  refuses(cone({"field.openings=" + narrow, "structure.start_distance=-10"}), "the structure starts inside the ice");
  const std::string hole = write("hole.wkt", "POLYGON((2 -8, 18 -8, 18 8, 2 8, 2 -8))");
  BOOST_TEST(initial_field(cone({"field.openings=" + hole, "structure.start_distance=-10"})).sheet_area ==
             1600.0 - 256.0);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
