// SPDX-License-Identifier: GPL-3.0-or-later
// Level ice with openings and cracks from files (docs/theory/ice.md).
#include "laid_ice.hpp"

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>

#include "brash/core/error.hpp"
#include "brash/ice/field.hpp"

namespace {

using namespace brash;
using namespace brash::ice;

constexpr const char* kChannel = "POLYGON((-1 -3, 31 -3, 31 3, -1 3, -1 -3))";

/// Its characteristic length is 3.3 m.
const failure::IceProperties kIce{.thickness = 0.33, .youngs_modulus = 0.35e9, .flexural_strength = 539e3};

/// A field of 30 m x 20 m whose files a test writes.
struct InFolder {
  std::filesystem::path folder = std::filesystem::temp_directory_path() / "brash_laid_ice";
  model::FieldSection field;

  InFolder() {
    std::filesystem::create_directories(folder);
    field.length = 30.0;
    field.width = 20.0;
  }
  ~InFolder() { std::filesystem::remove_all(folder); }

  std::string write(const std::string& name, const std::string& text) const {
    const std::string path = (folder / name).string();
    std::ofstream(path) << text;
    return path;
  }
  void open(const std::string& text) { field.openings = write("openings", text); }
  void crack(const std::string& text) { field.cracks = write("cracks", text); }
  void give(const std::string& text) { field.file = write("ice", text); }
  LaidIce lay() const { return lay_ice(field, kIce, {}); }

  void refuses(const std::string& word) const {
    BOOST_CHECK_EXCEPTION((void)lay(), InputError, [&](const InputError& error) {
      const bool has = std::string(error.what()).find(word) != std::string::npos;
      BOOST_TEST(has, "\"" << word << "\" is not in:\n" << error.what());
      return has;
    });
  }
};

geometry::ExactArea area_of(const LaidIce& ice) {
  geometry::ExactArea sum;
  for (const geometry::Polygon& sheet : ice.sheets) sum += geometry::area(sheet);
  for (const GivenFloe& floe : ice.floes) sum += geometry::area(floe.outline);
  return sum;
}

/// Of a number of square metres that the grid holds exactly.
geometry::ExactArea square_metres(double side_x, double side_y) {
  const std::array<Vec2, 4> corners{Vec2{}, Vec2{side_x, 0.0}, Vec2{side_x, side_y}, Vec2{0.0, side_y}};
  return geometry::signed_area(geometry::ring(corners));
}

BOOST_FIXTURE_TEST_SUITE(laid_ice, InFolder)

BOOST_AUTO_TEST_CASE(without_files_the_ice_is_the_rectangle) {
  const LaidIce ice = lay();
  BOOST_REQUIRE(ice.sheets.size() == 1u);
  BOOST_TEST((geometry::area(ice.sheets.front()) == square_metres(30.0, 20.0)));
}

BOOST_AUTO_TEST_CASE(with_a_rough_first_edge_the_ice_is_the_rectangle_beyond_it) {
  model::Case c;
  c.ice.thickness = kIce.thickness;
  c.field = field;
  c.field.edge_roughness = 0.25;
  const Variation variation(c);
  const LaidIce ice = lay_ice(field, kIce, variation);
  BOOST_REQUIRE(ice.sheets.size() == 1u);
  const std::vector<Vec2> edge = variation.first_edge(field.width);
  double lost = 0.0;  // between the line x = 0 and the edge
  for (std::size_t i = 1; i < edge.size(); ++i) lost += 0.5 * (edge[i].x + edge[i - 1].x) * (edge[i - 1].y - edge[i].y);
  BOOST_TEST(std::abs(lost) > 0.01);
  // Corners are rounded to the grid of 1e-9 m.
  BOOST_TEST(std::abs(geometry::area(ice.sheets.front()).square_metres() - (600.0 - lost)) < 1e-6);
  BOOST_TEST(is_held(ice.sheets.front(), field, {}));
}

BOOST_AUTO_TEST_CASE(a_channel_leaves_two_sheets_and_exactly_their_area) {
  open(kChannel);
  const LaidIce ice = lay();
  BOOST_TEST(ice.sheets.size() == 2u);
  BOOST_TEST(ice.floes.empty());
  BOOST_TEST((area_of(ice) == square_metres(30.0, 14.0)));
}

BOOST_AUTO_TEST_CASE(openings_may_overlap_and_their_holes_keep_the_ice) {
  // A frame of 1 m around an island of 4 m x 4 m, and a lead over the frame and a part of the island.
  open(
      "POLYGON((8 -3, 14 -3, 14 3, 8 3, 8 -3), (9 -2, 9 2, 13 2, 13 -2, 9 -2)) POLYGON((12 -5, 15 -5, 15 5, 12 5, 12 "
      "-5))");
  const LaidIce ice = lay();
  BOOST_TEST(ice.sheets.size() == 1u);
  BOOST_REQUIRE(ice.floes.size() == 1u);
  BOOST_TEST((geometry::area(ice.floes.front().outline) == square_metres(3.0, 4.0)));
  // The union of both is 4 m x 6 m beside the lead of 3 m x 10 m, less the island that is left.
  BOOST_TEST((area_of(ice) == square_metres(30.0, 20.0) - square_metres(4.0, 6.0) - square_metres(3.0, 10.0) +
                                  square_metres(3.0, 4.0)));
}

BOOST_AUTO_TEST_CASE(a_crack_ends_on_another_one_that_the_ice_cuts_off) {
  field.length = field.width = 200.0;
  crack("LINESTRING (-200 93, 400 70)\nLINESTRING (145 79.775, 145 300)");
  const LaidIce ice = lay();
  BOOST_TEST(ice.sheets.size() + ice.floes.size() == 3u);
}

BOOST_AUTO_TEST_CASE(cracks_part_the_ice_and_keep_its_area) {
  open("POLYGON((10 -4, 20 -4, 20 4, 10 4, 10 -4))");
  // From the front edge to the opening, bent; from the opening to the far end; one across the opening alone.
  crack("LINESTRING(-1 0, 5 1, 10 0) LINESTRING(20 0, 31 0) LINESTRING(12 -3, 18 3)");
  const LaidIce ice = lay();
  BOOST_TEST(ice.sheets.size() == 2u);
  BOOST_TEST((area_of(ice) == square_metres(30.0, 20.0) - square_metres(10.0, 8.0)));
}

BOOST_AUTO_TEST_CASE(files_that_change_no_ice_are_told_with_both_places) {
  open("POLYGON((200 0, 210 0, 210 10, 200 10, 200 0))");
  crack("LINESTRING(200 0, 300 40)");
  const std::vector<IdleFile> idle = idle_files(field, kIce);
  BOOST_REQUIRE(idle.size() == 2u);
  BOOST_TEST(idle[0].key == "openings");
  BOOST_TEST(idle[0].taken == 0.0);
  BOOST_TEST((idle[0].reach.lower == Vec2{200.0, 0.0} && idle[0].reach.upper == Vec2{210.0, 10.0}));
  BOOST_TEST((idle[0].ice.lower == Vec2{0.0, -10.0} && idle[0].ice.upper == Vec2{30.0, 10.0}));
  BOOST_TEST(idle[1].key == "cracks");
  BOOST_TEST((idle[1].reach.upper == Vec2{300.0, 40.0}));
  // A crack from the front edge to a hole parts nothing, and opens the hole.
  open("POLYGON((10 -4, 20 -4, 20 4, 10 4, 10 -4))");
  crack("LINESTRING(-1 0, 10 0) LINESTRING(20 0, 31 0)");
  BOOST_TEST(idle_files(field, kIce).empty());
  crack("LINESTRING(-1 -10, 31 -10)");  // along a side
  BOOST_TEST(idle_files(field, kIce).size() == 1u);
}

BOOST_AUTO_TEST_CASE(land_is_cut_from_the_ice_and_holds_what_touches_it) {
  // An island in the middle, and a crack that parts a square of ice around it from the rest.
  field.shore = write("shore", "POLYGON((12 -2, 16 -2, 16 2, 12 2, 12 -2))");
  crack("LINESTRING(8 -6, 20 -6, 20 6, 8 6, 8 -6)");
  const LaidIce ice = lay();
  BOOST_TEST(ice.sheets.size() == 2u);
  BOOST_TEST(ice.floes.empty());
  BOOST_TEST((area_of(ice) == square_metres(1.0, 584.0)));
  field.shore.clear();
  BOOST_TEST(lay().sheets.size() == 1u);  // without land the square is a floe
  BOOST_TEST(lay().floes.size() == 1u);
}

BOOST_AUTO_TEST_CASE(land_holds_a_part_that_a_break_parts_from_the_sides) {
  field.shore = write("shore", "POLYGON((12 -2, 16 -2, 16 2, 12 2, 12 -2))");
  const std::array<Vec2, 8> around{Vec2{-1, -6}, {20, -6}, {20, 6}, {-1, 6}, {-1, 5}, {19, 5}, {19, -5}, {-1, -5}};
  const auto n_severed = [&] {
    Field laid(field, kIce);
    (void)laid.crush(laid.level_ice(0), geometry::ring(around));
    return laid.release_severed(laid.level_ice(0), {}, 0.01).pieces.size();
  };
  BOOST_TEST(n_severed() == 0u);
  field.shore.clear();
  BOOST_TEST(n_severed() == 1u);
}

BOOST_AUTO_TEST_CASE(a_floe_on_land_is_refused_with_its_place) {
  field.shore = write("shore", "POLYGON((12 -2, 16 -2, 16 2, 12 2, 12 -2))");
  give(R"({"type":"FeatureCollection","features":[
    {"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":
      [[[20,-10],[30,-10],[30,10],[20,10],[20,-10]]]}},
    {"type":"Feature","properties":{"kind":"floe"},"geometry":{"type":"Polygon","coordinates":
      [[[10,-1],[14,-1],[14,1],[10,1],[10,-1]]]}}]})");
  refuses("has a floe on land, at (13, 0) m");
}

BOOST_AUTO_TEST_CASE(all_files_of_the_ice_share_the_origin) {
  field.origin = {500000.0, 7000000.0};
  open("POLYGON((499999 6999997, 500031 6999997, 500031 7000003, 499999 7000003, 499999 6999997))");
  crack("LINESTRING(500010 6999980, 500010 7000020)");
  const LaidIce there = lay();
  field.origin = {};
  open(kChannel);
  crack("LINESTRING(10 -20, 10 20)");
  const LaidIce here = lay();
  BOOST_TEST((there.sheets == here.sheets));
  BOOST_TEST(here.sheets.size() == 4u);
}

BOOST_AUTO_TEST_CASE(a_part_without_a_border_is_a_floe) {
  crack("LINESTRING(-1 -2, 5 -2, 5 2, -1 2)");  // around a part of the front edge
  const LaidIce ice = lay();
  BOOST_TEST(ice.sheets.size() == 1u);
  BOOST_REQUIRE(ice.floes.size() == 1u);
  BOOST_TEST((geometry::area(ice.floes.front().outline) == square_metres(5.0, 4.0)));
}

BOOST_AUTO_TEST_CASE(a_crack_that_ends_inside_the_ice_is_refused_with_its_place) {
  crack("LINESTRING(-1 0, 12 0)");
  refuses("ends inside the ice, at (12, 0) m: over 12 m it parts nothing");
  crack("LINESTRING(5 5, 12 5)");
  refuses("over 7 m");
  // Through to the side, and a branch that ends.
  crack("LINESTRING(6 -11, 6 11) LINESTRING(6 0, 9 3)");
  refuses("at (9, 3) m");
  // The tail of a line that parts the ice besides.
  crack("LINESTRING(6 -11, 6 11) LINESTRING(-1 0, 8 0)");
  refuses("at (8, 0) m: over 2 m");
  // A tail that no one could have drawn on purpose is cut off.
  crack("LINESTRING(6 -11, 6 11) LINESTRING(-1 0, 6.0005 0)");
  BOOST_TEST(lay().sheets.size() == 3u);
}

BOOST_AUTO_TEST_CASE(a_loop_of_two_cracks_that_end_on_each_other_parts_the_ice) {
  crack("LINESTRING(10 -11, 10 11) LINESTRING(20 -11, 20 11) LINESTRING(10 0, 20 0)");
  const LaidIce ice = lay();
  BOOST_TEST(ice.sheets.size() == 4u);
  BOOST_TEST((area_of(ice) == square_metres(30.0, 20.0)));
}

BOOST_AUTO_TEST_CASE(a_file_has_level_ice_with_holes_and_floes_in_them) {
  give(R"({"type":"FeatureCollection","features":[
    {"type":"Feature","properties":{"kind":"sheet"},"geometry":{"type":"Polygon","coordinates":
      [[[2,-10],[30,-10],[30,10],[2,10],[2,-10]],[[8,-3],[8,3],[14,3],[14,-3],[8,-3]]]}},
    {"type":"Feature","properties":{"kind":"floe","thickness":0.5},"geometry":{"type":"Polygon","coordinates":
      [[[9,-2],[13,-2],[13,2],[9,2],[9,-2]]]}}]})");
  const LaidIce ice = lay();
  BOOST_REQUIRE(ice.sheets.size() == 1u);
  BOOST_TEST(ice.sheets.front().holes.size() == 1u);
  BOOST_REQUIRE(ice.floes.size() == 1u);
  BOOST_TEST(ice.floes.front().thickness.value() == 0.5);
  BOOST_TEST((area_of(ice) == square_metres(28.0, 20.0) - square_metres(6.0, 6.0) + square_metres(4.0, 4.0)));
}

BOOST_AUTO_TEST_CASE(outlines_that_touch_stay_apart_beside_openings_and_cracks) {
  give("MULTIPOLYGON(((0 -10, 30 -10, 30 0, 0 0, 0 -10)),((0 0, 30 0, 30 10, 0 10, 0 0)))");
  BOOST_TEST(lay().sheets.size() == 2u);
  open("POLYGON((10 4, 12 4, 12 6, 10 6, 10 4))");
  BOOST_TEST(lay().sheets.size() == 2u);
  crack("LINESTRING(20 0, 20 11)");  // ends at the edge of the other
  const LaidIce ice = lay();
  BOOST_TEST(ice.sheets.size() == 3u);
  BOOST_TEST((area_of(ice) == square_metres(30.0, 20.0) - square_metres(2.0, 2.0)));
}

BOOST_AUTO_TEST_CASE(outlines_that_touch_stay_apart_beside_one_that_touches_itself) {
  field.border = model::Border::kFree;
  give(
      "MULTIPOLYGON(((0 0, 5 0, 5 5, 0 5, 0 0)),((5 0, 10 0, 10 5, 5 5, 5 0)),"
      "((15 0, 17 2, 19 0, 19 4, 17 2, 15 4, 15 0)))");
  open("POLYGON((25 6, 26 6, 26 7, 25 7, 25 6))");  // beside the ice
  const LaidIce ice = lay();
  BOOST_TEST(ice.sheets.size() + ice.floes.size() == 4u);  // two squares and two triangles
  BOOST_TEST((area_of(ice) == square_metres(10.0, 5.0) + square_metres(2.0, 4.0)));
}

BOOST_AUTO_TEST_CASE(faults_of_files_are_refused_with_the_remedy) {
  give("POLYGON((2 -5, 20 -5, 20 5, 2 5, 2 -5))");
  refuses("write field.border = \"free\"");
  give("POLYGON((2 -10, 40 -10, 40 10, 2 10, 2 -10))");
  refuses("field.length = 30");
  give(R"({"type":"Feature","properties":{"thickness":0.5},"geometry":{"type":"Polygon","coordinates":
      [[[2,-10],[30,-10],[30,10],[2,10],[2,-10]]]}})");
  refuses("level ice with ice properties of its own");
  give(R"({"type":"Feature","properties":{"kind":"floe"},"geometry":{"type":"Polygon","coordinates":
      [[[2,-10],[30,-10],[30,10],[2,10],[2,-10]]]}})");
  refuses("holds floes alone");
  field.file.clear();
  open("POLYGON((0 0, 4 4, 4 0, 0 3, 0 0))");
  refuses("polygon 0");
  open("POLYGON((-1 -11, 31 -11, 31 11, -1 11, -1 -11))");
  refuses("leaves no ice");
  crack("LINESTRING(26 -11, 26 11)");
  refuses("openings with ");  // the crack is no fault of its own
  field.cracks.clear();
  open(kChannel);
  crack("POLYGON((0 0, 4 4, 4 0, 0 0))");
  refuses("areas of open water go to field.openings");
}

BOOST_AUTO_TEST_CASE(large_parts_are_sheets_that_drift_and_small_ones_floes_beside_them) {
  field.border = model::Border::kFree;
  crack("LINESTRING(26 -11, 26 11)");
  // The part is 4 m broad, and five characteristic lengths are more.
  const LaidIce ice = lay();
  BOOST_TEST(ice.sheets.size() == 1u);
  BOOST_TEST(ice.floes.size() == 1u);
  field.smallest_plate = 0.1;
  BOOST_TEST(lay().sheets.size() == 2u);
  BOOST_TEST(lay().floes.empty());
}

BOOST_AUTO_TEST_CASE(a_field_has_a_plate_for_each_sheet_and_hands_the_floes_over) {
  open(kChannel);
  crack("LINESTRING(-1 -5, 5 -5, 5 -2)");
  Field laid(field, kIce);
  BOOST_TEST(laid.level_ice().size() == 2u);
  BOOST_TEST(laid.level_ice()[1].level_ice() == 1);
  BOOST_TEST(laid.ledger().initial.square_metres() == 30.0 * 14.0 - 5.0 * 2.0);
  for (const Plate& floe : laid.take_loose()) laid.add_floe(floe);
  BOOST_TEST(laid.ledger().initial.square_metres() == 30.0 * 14.0);
  BOOST_TEST(laid.ledger().closes());
  BOOST_TEST(laid.take_loose().empty());
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
