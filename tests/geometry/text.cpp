// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/geometry/text.hpp"

#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "shapes.hpp"

namespace brash::geometry {
namespace {

using shapes::box;
using shapes::reversed;

/// Polygons that are awkward to write: no short decimals, far out, one unit thick, with holes.
std::vector<Polygon> awkward_polygons() {
  std::mt19937_64 generator(5);
  std::vector<Polygon> polygons;
  for (int i = 0; i < 50; ++i) {
    Polygon p{shapes::star(generator, 3 + i % 30, 0.1, {8000.0 * (2 * shapes::uniform(generator) - 1), -0.001}), {}};
    if (i % 3 == 0) p = {disc({-7000, 12}, 3, 40), {reversed(shapes::star(generator, 9, 0.2, {-7000.5, 12}))}};
    polygons.push_back(p);
  }
  polygons.push_back({shapes::units({{0, 0}, {1, 0}, {0, 1}}), {}});
  polygons.push_back(
      {shapes::units({{-(1LL << 43), -(1LL << 43)}, {1LL << 43, (1LL << 43) - 1}, {1LL << 43, 1LL << 43}}), {}});
  return polygons;
}

std::vector<Polygon> polygons_in(std::string_view text) { return polygons_of(read_polygons(text).value().features); }
std::vector<Feature> features_in(std::string_view text) { return read_polygons(text).value().features; }
std::vector<Crack> cracks_in(std::string_view text) { return read_lines(text).value().cracks; }

std::string fault_in(std::string_view text) {
  const auto result = read_polygons(text);
  return result ? "" : result.error().what;
}
std::string fault_in_lines(std::string_view text) {
  const auto result = read_lines(text);
  return result ? "" : result.error().what;
}

BOOST_AUTO_TEST_SUITE(wkt)

BOOST_AUTO_TEST_CASE(polygons_come_back_bit_by_bit) {
  const std::vector<Polygon> polygons = awkward_polygons();
  BOOST_TEST((polygons_in(to_wkt(polygons)) == polygons));
  for (const Polygon& p : polygons) {
    BOOST_TEST((polygons_in(to_wkt(std::span(&p, 1))) == std::vector<Polygon>{p}));
  }
  BOOST_TEST(polygons_in(to_wkt({})).empty());
}

BOOST_AUTO_TEST_CASE(the_text_is_plain_wkt) {
  const Polygon plate{box(0, 0, 4, 2), {reversed(box(1, 0.5, 2, 1.5))}};
  BOOST_TEST(to_wkt(std::span(&plate, 1)) ==
             "POLYGON ((0 0, 4 0, 4 2, 0 2, 0 0), (1 0.5, 1 1.5, 2 1.5, 2 0.5, 1 0.5))");
}

BOOST_AUTO_TEST_CASE(case_space_orientation_and_several_geometries_are_read) {
  const auto polygons = polygons_in(
      " polygon((0 0,0 1,+1 1,1e0 0,0 0))\n\nMultiPolygon ( ((2 0, 3 0, 3 1, 2 0)) , ((4 0,5 0,5 1,4 0)) ) POLYGON "
      "EMPTY");
  BOOST_REQUIRE(polygons.size() == 3u);
  BOOST_TEST((polygons.front().outline == box(0, 0, 1, 1)));
}

BOOST_AUTO_TEST_CASE(a_hole_comes_out_clockwise_either_way) {
  for (const char* hole : {"(1 1, 2 1, 2 2, 1 1)", "(1 1, 2 2, 2 1, 1 1)"}) {
    const auto polygons = polygons_in(std::string("POLYGON ((0 0, 9 0, 9 9, 0 0), ") + hole + ")");
    BOOST_TEST(signed_area(polygons[0].holes[0]).to_string() == "-0.5");
  }
}

BOOST_AUTO_TEST_CASE(faults_are_named_with_line_and_column) {
  BOOST_TEST(fault_in("") == "line 1, column 1: there is no geometry: POLYGON or MULTIPOLYGON is expected");
  BOOST_TEST(fault_in("\n  LINESTRING (0 0, 1 1)") ==
             "line 2, column 3: POLYGON or MULTIPOLYGON is expected, not LINESTRING");
  BOOST_TEST(fault_in("POLYGON T ((0 0, 1 0, 1 1, 0 0))") == "line 1, column 9: '(' or EMPTY is expected, not T");
  BOOST_TEST(fault_in("POLYGON ((0 0, 1 0,\n 1 x, 0 0))") == "line 2, column 4: a number is expected, not 'x'");
  BOOST_TEST(fault_in("POLYGON ((0 0, 1 0, 1 1 5, 0 0))") == "line 1, column 25: ')' is expected, not '5'");
  BOOST_TEST(fault_in("POLYGON ((0 0, 1 0, 1 1") == "line 1, column 24: ')' is expected, not the end of the text");
  BOOST_TEST(fault_in("POLYGON ((0 0, 1 0, 1 1, 0 1))") ==
             "line 1, column 10: the ring is not closed: its last position is not its first");
  BOOST_TEST(fault_in("POLYGON ((0 0, 1 0, 0 0))") ==
             "line 1, column 10: a ring needs at least 4 positions, this has 3");
  BOOST_TEST(fault_in("POLYGON ((0 0, 1 0, 2 0, 0 0))") == "line 1, column 10: the ring has no area");
  BOOST_TEST(fault_in("POLYGON ((0 0, 0 1, 0 1, 0 0))") ==
             "line 1, column 10: the ring has fewer than 3 different vertices");
  BOOST_TEST(fault_in("POLYGON ((0 0, 9000 0, 0 1, 0 0))") == "line 1, column 10: (9000, 0) is beyond +-8192 m");
  BOOST_TEST(fault_in("POLYGON ((0 0, nan 0, 0 1, 0 0))") == "line 1, column 10: (nan, 0) is beyond +-8192 m");
  BOOST_TEST(fault_in("POLYGON ((0 0, 1e999 0, 0 1, 0 0))") == "line 1, column 16: the number is out of range");
  BOOST_TEST(fault_in("POLYGON ((0 0, 1 0, 1 1, 0 0)) trailing") ==
             "line 1, column 32: POLYGON or MULTIPOLYGON is expected, not TRAILING");
}

BOOST_AUTO_TEST_CASE(faults_of_rounding_are_mended_and_counted_and_others_stay) {
  // A square with a whisker of 4e-11 m that rounding folds over its side, and one that is thinner than the grid.
  const Map folded = read_map(
                         "POLYGON ((0 0, 10 0, 10 10, 7.00000000004 10, 5.0000000005 17, 7 10, 3 10.0000000002, "
                         "2 10, 0 10, 0 0))")
                         .value();
  BOOST_REQUIRE(folded.features.size() == 1u);
  BOOST_TEST(fault_of(folded.features[0].polygon) == "");
  BOOST_TEST(std::abs(area(folded.features[0].polygon).square_metres() - 100.0) < 1e-7);
  const std::string hole = "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 2 1, 2 1.00000000001, 1 1))";
  const Map thin = read_polygons(hole).value();
  BOOST_TEST(thin.features.at(0).polygon.holes.empty());
  BOOST_TEST(thin.left_out == "rings thinner than the grid of 1 nm (1)");
  const Map none = read_polygons("POLYGON ((0 0, 1e-12 0, 0 1, 0 0)) POLYGON ((0 0, 1 0, 0 1, 0 0))").value();
  BOOST_REQUIRE(none.features.size() == 1u);
  BOOST_TEST(none.features[0].number == 1u);
  BOOST_TEST(none.left_out == "rings thinner than the grid of 1 nm (1)");
  // A true crossing stays, and every one is named.
  const Polygon bow = polygons_in("POLYGON ((0 0, 9 0, 9 2, 6 -1, 3 2, 0 -1, 0 0))").front();
  const std::string fault = fault_of(bow);
  for (const char* place : {"(1, 0)", "(5, 0)", "(7, 0)"}) BOOST_TEST(fault.find(place) != std::string::npos, fault);
}

BOOST_AUTO_TEST_CASE(a_floe_with_a_hair_of_a_whisker_is_read) {
  // The sides of the whisker are up to 2e-10 m apart and 3 m long: rounding lays one over the other, or across it.
  int n_mended = 0;
  for (int i = 0; i < 200; ++i) {
    const double x = 13.0 + 0.001 * i, y = 4.7 + 0.01 * i, apart = 1e-10 * (i % 5 - 2);
    const Map map =
        read_map(fmt::format("POLYGON ((0 0, 10 0, 10 3.1, {:.12f} {:.12f}, {:.12f} {:.12f}, 10 3.1, 10 10, "
                             "0 10, 0 0))",
                             x, y, 0.5 * (10.0 + x), 0.5 * (3.1 + y) + apart))
            .value();
    BOOST_REQUIRE(map.features.size() == 1u);
    const Polygon& floe = map.features[0].polygon;
    BOOST_TEST(fault_of(floe) == "");
    BOOST_TEST(std::abs(area(floe).square_metres() - 100.0) < 1e-8);
    n_mended += map.left_out.empty() ? 0 : 1;
  }
  BOOST_TEST(n_mended > 0);
}

BOOST_AUTO_TEST_CASE(what_the_plan_has_not_is_left_out_and_counted) {
  const Polygon triangle{box(0, 0, 1, 1), {}};
  for (const char* const text :
       {"\xef\xbb\xbfPOLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))", "POLYGON Z ((0 0 5, 1 0 5, 1 1 5, 0 1 nan, 0 0 5))",
        "POLYGONZM ((0 0 5 2, 1 0 5 2, 1 1 5 2, 0 1 5 2, 0 0 5 2))", "polygon m((0 0 5,1 0 5,1 1 -5,0 1 .5,0 0 5))",
        "POLYGON ((0 0 5, 1 0 5, 1 1 5, 0 1 5, 0 0 5))", "MULTIPOLYGON (EMPTY, ((0 0, 1 0, 1 1, 0 1, 0 0), EMPTY))",
        "SRID=0;POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))",
        "SRID=32633; MULTIPOLYGON Z EMPTY\nSRID=32633;"
        "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"})
    BOOST_TEST((polygons_in(text) == std::vector<Polygon>{triangle}), text);
  const Map map = read_map("SRID=32633;POLYGON Z ((0 0 5, 1 0 5, 1 1 5, 0 1 5, 0 0 5))").value();
  BOOST_TEST(map.left_out == "heights (5)");
  BOOST_TEST(map.crs == R"({"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::32633"}})");
  BOOST_TEST(read_map("POLYGON ((0 0, 1 0, 1 1, 0 0))").value().left_out == "");
  const Lines lines = read_lines("SRID=32633;MULTILINESTRING Z ((0 0 1, 1 2 1), EMPTY)").value();
  BOOST_TEST((lines.n_cracks == std::vector<std::size_t>{1}));
  BOOST_TEST(lines.left_out == "heights (2)");
  BOOST_TEST(name_of_crs(lines.crs) == "urn:ogc:def:crs:EPSG::32633");
  // A missing comma is no height, and degrees are no metres.
  BOOST_TEST(fault_in("POLYGON ((0 0 4 0, 4 4, 0 0))") == "line 1, column 23: a number is expected, not ','");
  BOOST_TEST(fault_in("SRID=4326;POLYGON EMPTY").starts_with("line 1, column 1: the coordinates are degrees"));
  BOOST_TEST(fault_in("SRID=32633;POLYGON EMPTY SRID=32634;POLYGON EMPTY") ==
             "line 1, column 26: SRID=32634 comes after SRID=32633");
  BOOST_TEST(fault_in("SRID=;POLYGON EMPTY") == "line 1, column 1: SRID= is followed by no code of EPSG");
}

BOOST_AUTO_TEST_CASE(lines_are_read_as_the_cracks_between_their_positions) {
  const auto point = [](double x, double y) { return snap({x, y}); };
  const auto cracks = cracks_in("linestring (0 0, 1 2, 1 2, 3 4)\nMULTILINESTRING ((5 5, 6 6), (7 7, 8 8))");
  const std::vector<std::pair<Point, Point>> expected{
      {point(0, 0), point(1, 2)}, {point(1, 2), point(3, 4)}, {point(5, 5), point(6, 6)}, {point(7, 7), point(8, 8)}};
  BOOST_REQUIRE(cracks.size() == expected.size());
  for (std::size_t i = 0; i < cracks.size(); ++i) BOOST_TEST((std::pair(cracks[i].from, cracks[i].to) == expected[i]));
  BOOST_TEST(cracks_in("LINESTRING EMPTY").empty());
}

BOOST_AUTO_TEST_CASE(faults_of_lines_are_named_with_their_place) {
  BOOST_TEST(fault_in_lines("") == "line 1, column 1: there is no geometry: LINESTRING or MULTILINESTRING is expected");
  BOOST_TEST(fault_in_lines("POLYGON ((0 0, 1 1))") ==
             "line 1, column 1: LINESTRING or MULTILINESTRING is expected, not POLYGON");
  BOOST_TEST(fault_in_lines("LINESTRING (1 1)") == "line 1, column 12: a line needs at least 2 positions, this has 1");
  BOOST_TEST(fault_in_lines("LINESTRING (0 0, 9000 1)") == "line 1, column 12: (9000, 1) is beyond +-8192 m");
  BOOST_TEST(fault_in_lines("LINESTRING (0 0, nan 1)") == "line 1, column 12: (nan, 1) is beyond +-8192 m");
}

BOOST_AUTO_TEST_CASE(every_cut_and_every_changed_byte_of_a_text_is_read_or_refused) {
  const std::string text =
      "MULTIPOLYGON (((0 0, 4 0, 4 2, 0 2, 0 0), (1 0.5, 1 1.5, 2 1.5, 1 0.5)), ((8 0, 9 0, 9 1, 8 0)))";
  for (std::size_t n = 0; n < text.size(); ++n) BOOST_TEST(!read_polygons(text.substr(0, n)).has_value());
  int n_read = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    for (const char c : {'(', ')', ',', ' ', '9', '-', '.', 'e', '\0', '\xff'}) {
      std::string changed = text;
      changed[i] = c;
      const auto result = read_polygons(changed);
      if (!result) {
        BOOST_TEST(result.error().what.starts_with("line 1, column "));
        continue;
      }
      ++n_read;
      for (const Feature& f : result->features)
        BOOST_TEST((signed_area(f.polygon.outline) > ExactArea{} || !fault_of(f.polygon).empty()));
    }
  }
  BOOST_TEST(n_read > 0);
}

BOOST_AUTO_TEST_CASE(deep_nesting_is_refused_without_descending) {
  BOOST_TEST(fault_in("POLYGON " + std::string(1000000, '(')) == "line 1, column 11: a number is expected, not '('");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(geojson)

std::vector<Feature> awkward_features() {
  std::vector<Feature> features;
  std::int64_t id = -2;
  for (const Polygon& p : awkward_polygons()) features.push_back({p, id % 2 ? "sheet" : "floe", id}), ++id;
  features.back().id = std::numeric_limits<std::int64_t>::max();
  return features;
}

BOOST_AUTO_TEST_CASE(features_come_back_bit_by_bit) {
  const std::vector<Feature> features = awkward_features();
  BOOST_TEST((features_in(to_geojson(features)) == features));
  BOOST_TEST(features_in(to_geojson({})).empty());
}

BOOST_AUTO_TEST_CASE(the_text_is_json_with_the_exact_area) {
  std::vector<Feature> features{{{box(0, 0, 4, 2), {reversed(box(1, 0.5, 2, 1.5))}}, "floe", 7}};
  const auto json = nlohmann::json::parse(to_geojson(features));
  BOOST_TEST(json["type"] == "FeatureCollection");
  const auto& feature = json["features"].at(0);
  BOOST_TEST(feature["properties"].dump() == R"({"area":7,"area_exact":"7","id":7,"kind":"floe"})");
  BOOST_TEST(feature["geometry"]["type"] == "Polygon");
  BOOST_TEST(feature["geometry"]["coordinates"].at(1).dump() == "[[1,0.5],[1,1.5],[2,1.5],[2,0.5],[1,0.5]]");
  features[0].thickness = 1.2;
  features[0].flexural_strength = 3e5;
  const auto own = nlohmann::json::parse(to_geojson(features))["features"].at(0)["properties"];
  BOOST_TEST(own["thickness"] == 1.2);
  BOOST_TEST(own["flexural_strength"] == 3e5);
  BOOST_TEST((features_in(to_geojson(features)) == features));
}

BOOST_AUTO_TEST_CASE(bare_geometries_collections_and_foreign_members_are_read) {
  const std::string ring = "[[0,0],[1,0],[1,1],[0,0]]", polygon = R"({"type":"Polygon","coordinates":[)" + ring + "]}";
  BOOST_TEST(features_in(polygon).size() == 1u);
  BOOST_TEST(features_in(R"({"type":"MultiPolygon","coordinates":[[)" + ring + "],[" + ring + "]]}").size() == 2u);
  const auto features = features_in(
      R"({"type":"FeatureCollection","name":"x","features":[{"type":"Feature","bbox":[0,0,1,1],"properties":null,"geometry":)" +
      polygon + R"(},{"type":"Feature","properties":{"kind":"floe","colour":"white"},"geometry":)" +
      R"({"type":"GeometryCollection","geometries":[)" + polygon + "," + polygon + "]}}]}");
  BOOST_REQUIRE(features.size() == 3u);
  BOOST_TEST((features.at(0).kind == "sheet" && features.at(0).id == 0));
  BOOST_TEST((features.at(2).kind == "floe" && features.at(2).id == 1));
}

BOOST_AUTO_TEST_CASE(shapes_of_a_map_that_is_wider_than_a_grid_are_read) {
  const std::string wkt =
      "POLYGON ((500000 7000000, 500040 7000000, 500040 7000020, 500000 7000020, 500000 7000000), "
      "(500010 7000005, 500020 7000005, 500020 7000010, 500010 7000005)) POLYGON ((600000.1 7100000, 600003.1 7100000, "
      "600000.1 7100002, 600000.1 7100000))";
  const std::string json = R"({"type":"MultiPolygon","coordinates":[[[[500000,7000000],[500040,7000000],)"
                           R"([500040,7000020],[500000,7000020],[500000,7000000]],[[500010,7000005],[500020,7000005],)"
                           R"([500020,7000010],[500010,7000005]]],[[[600000.1,7100000],[600003.1,7100000],)"
                           R"([600000.1,7100002],[600000.1,7100000]]]]})";
  BOOST_TEST(!read_map(wkt).has_value());
  for (const std::string& text : {wkt, json}) {
    const auto shapes = polygons_of(read_shapes(text).value().features);
    BOOST_REQUIRE(shapes.size() == 2u);
    BOOST_TEST(area(shapes[0]).to_string() == "775");
    BOOST_TEST(std::abs(area(shapes[1]).square_metres() - 3.0) < 1e-8);
  }
  BOOST_TEST(!read_shapes("POLYGON ((0 0, 17000 0, 0 1, 0 0))").has_value());
}

BOOST_AUTO_TEST_CASE(faults_are_named_with_line_and_column) {
  BOOST_TEST(fault_in("").starts_with("line 1, column 1: "));
  BOOST_TEST(fault_in("{\"type\":\n  oops}").starts_with("line 2, column 3: "));
  BOOST_TEST(fault_in(R"({"type":"FeatureCollection","features":[[]]})") ==
             "line 1, column 41: an object with \"type\" is expected");
  BOOST_TEST(fault_in(R"({"type":"Point","coordinates":[0,0]})").starts_with("line 1, column 1: Point is not read"));
  BOOST_TEST(fault_in("{\"type\":\"Polygon\",\n \"coordinates\":[[[0,0],[1,0],[1],[0,0]]]}") ==
             "line 2, column 30: a position of two numbers is expected");
  BOOST_TEST(fault_in("{\"type\":\"Polygon\",\n \"coordinates\":[[[0,0],[1,0],[1,1],[0,1]]]}") ==
             "line 2, column 17: the ring is not closed: its last position is not its first");
  BOOST_TEST(fault_in(R"({"type":"Polygon","type":"Polygon"})") == "line 1, column 1: \"type\" is given twice");
  BOOST_TEST(fault_in(R"({"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"kind":"berg"},"geometry":null}]})") ==
             "line 2, column 32: \"kind\" = \"berg\" is neither \"sheet\" nor \"floe\"");
  BOOST_TEST(fault_in("{\"type\":" + std::string(1000000, '[')) == "line 1, column 72: nested deeper than 64");
}

std::string with_properties(const std::string& properties) {
  return R"({"type":"Feature","properties":)" + properties +
         R"(,"geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,0]]]}})";
}

BOOST_AUTO_TEST_CASE(null_is_as_good_as_no_property) {
  const auto features = features_in(with_properties(R"({"kind":null,"id":null,"thickness":null})"));
  BOOST_TEST((features.at(0).kind == "sheet" && features.at(0).id == 0 && !features.at(0).thickness));
}

BOOST_AUTO_TEST_CASE(a_whole_number_may_be_written_with_a_point) {
  BOOST_TEST(features_in(with_properties(R"({"id":3.0})")).at(0).id == 3);
  BOOST_TEST(features_in(with_properties(R"({"id":-2e3})")).at(0).id == -2000);
  for (const char* id : {"3.5", "1e300", "9007199254740993.0", "\"3\"", "true"}) {
    const Map map = read_map(with_properties(fmt::format("{{\"id\":{}}}", id))).value();
    BOOST_TEST(map.features.at(0).id == 0);
    BOOST_TEST(map.left_out == "ids that are not whole numbers (1)");
  }
}

BOOST_AUTO_TEST_CASE(heights_and_features_without_geometry_are_left_out_and_counted) {
  const std::string text = R"({"type":"FeatureCollection","features":[{"type":"Feature","geometry":null},)"
                           R"({"type":"Feature","properties":{}},{"type":"Feature","properties":{"id":"A-17"},)"
                           R"("geometry":{"type":"Polygon","coordinates":[[[0,0,2],[1,0,2],[1,1,2,7],[0,0,2]]]}}]})";
  const Map map = read_map(text).value();
  BOOST_REQUIRE(map.features.size() == 1u);
  BOOST_TEST(map.features[0].id == 2);
  BOOST_TEST(map.left_out == "heights (4), features without geometry (2), ids that are not whole numbers (1)");
  BOOST_TEST((read_polygons(text).value() == map));
  BOOST_TEST(read_lines(R"({"type":"LineString","coordinates":[[0,0,1],[1,0,1]]})").value().left_out == "heights (2)");
}

BOOST_AUTO_TEST_CASE(ice_that_a_floe_cannot_have_is_refused) {
  const auto fault = [](const std::string& properties) {
    const auto map = read_map(with_properties(properties));
    return map ? "" : map.error().what;
  };
  BOOST_TEST(
      fault(R"({"thickness":"0.5"})") ==
      "line 1, column 32: \"thickness\" = \"0.5\" is not a number of metres above 0: write one, without quotes, or "
      "remove the property");
  BOOST_TEST(fault(R"({"thickness":0})").find("\"thickness\" = 0 is not a number") != std::string::npos);
  BOOST_TEST(fault(R"({"flexural_strength":-1.5})").find("= -1.5 is not a number of pascals") != std::string::npos);
  BOOST_TEST(fault(R"({"flexural_strength":[]})").find("is not a number of pascals") != std::string::npos);
  BOOST_TEST(fault(R"({"thickness":0.5,"flexural_strength":null})") == "");
}

BOOST_AUTO_TEST_CASE(lines_are_kept_apart_and_have_a_crs) {
  const Lines wkt = read_lines("LINESTRING (0 0, 1 2, 3 4) MULTILINESTRING ((5 5, 5 5), (7 7, 8 8))").value();
  BOOST_TEST((wkt.n_cracks == std::vector<std::size_t>{2, 0, 1}));
  BOOST_TEST(wkt.cracks.size() == 3u);
  const Lines json = read_lines(R"({"type":"MultiLineString","crs":{"type":"name","properties":{"name":"EPSG:32633"}},)"
                                R"("coordinates":[[[0,0],[1,2],[3,4]],[[7,7],[8,8]]]})")
                         .value();
  BOOST_TEST((json.n_cracks == std::vector<std::size_t>{2, 1}));
  BOOST_TEST(name_of_crs(json.crs) == "EPSG:32633");
  BOOST_TEST(name_of_crs("") == "");
  BOOST_TEST(name_of_crs("[1]") == "");
  BOOST_TEST(are_same_crs("EPSG:32633", "urn:ogc:def:crs:EPSG::32633"));
  BOOST_TEST(!are_same_crs("EPSG:32633", "EPSG:32635"));
  BOOST_TEST(!are_same_crs("EPSG:32633", "ESRI:32633"));
  BOOST_TEST(fault_in_lines(R"({"type":"LineString","coordinates":[]})") ==
             "line 1, column 36: a line needs at least 2 positions, this has 0");
}

BOOST_AUTO_TEST_CASE(a_polygon_says_why_it_is_not_simple) {
  const auto fault = [](std::string_view text) { return fault_of(polygons_in(text).front()); };
  BOOST_TEST(fault("POLYGON ((0 0, 3 2, 3 0, 0 1, 0 0))").starts_with("crosses itself at (1, 0.6666"));
  BOOST_TEST(fault("POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 2 1, 2 2, 1 1))") == "");
  BOOST_TEST(fault("POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (10 1, 12 1, 12 2, 10 1))") != "");
}

BOOST_AUTO_TEST_CASE(every_cut_and_every_changed_byte_of_a_text_is_read_or_refused) {
  const std::vector<Feature> features{{{box(0, 0, 4, 2), {reversed(box(1, 0.5, 2, 1.5))}}, "floe", 7}};
  std::string text = to_geojson(features);
  text.pop_back();  // the final line break is no part of the value
  for (std::size_t n = 0; n < text.size(); ++n) BOOST_TEST(!read_polygons(text.substr(0, n)).has_value());
  int n_read = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    for (const char c : {'[', ']', ',', '{', '}', '"', '9', '-', '\\', '\0', '\xff'}) {
      std::string changed = text;
      changed[i] = c;
      const auto result = read_polygons(changed);
      if (result)
        ++n_read;
      else
        BOOST_TEST(result.error().what.starts_with("line "));
    }
  }
  BOOST_TEST(n_read > 0);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
}  // namespace brash::geometry
