// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/geometry/origin.hpp"

#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "brash/geometry/text.hpp"
#include "shapes.hpp"

namespace brash::geometry {
namespace {

Decimal decimal(std::string_view text) { return Decimal::parse(text).value(); }
Origin origin(std::string_view text) { return origin_from_text(text).value(); }

BOOST_AUTO_TEST_SUITE(decimals)

BOOST_AUTO_TEST_CASE(decimals_are_read_and_written_with_every_digit) {
  const std::pair<const char*, const char*> cases[] = {
      {"9000000.0000000009313225746154785", "9000000.0000000009313225746154785"},
      {"-1.5", "-1.5"},
      {"+.25", "0.25"},
      {"4e5", "400000"},
      {"-12.5e-3", "-0.0125"},
      {"000123.4500e1", "1234.5"},
      {"-0", "0"},
      {"1e-40", "0"},
      {"999999999999999.9", "999999999999999.9"}};
  for (const auto& [text, expected] : cases) BOOST_TEST(decimal(text).to_string() == expected);
  for (const char* text : {"", "-", ".", "1e", "nan", "inf", "1e15", "1 ", "1.2.3", "0x1", "1e99999999999"})
    BOOST_TEST(!Decimal::parse(text).has_value(), text);
}

BOOST_AUTO_TEST_CASE(differences_are_exact_where_doubles_are_not) {
  // Half a grid unit is 2^-31 m; a double at 9 000 000 holds 2^-30 m only.
  const Decimal far = decimal("9000000");
  BOOST_TEST(decimal("9000000.0000000004656612873077392578125").grid_units_from(far).value() == 1);
  BOOST_TEST(decimal("9000000.0000000004656612873077392578124").grid_units_from(far).value() == 0);
  BOOST_TEST(decimal("8999999.9999999995343387126922607421875").grid_units_from(far).value() == -1);
  BOOST_TEST(decimal("9008192").grid_units_from(far).value() == 1LL << 43);
  BOOST_TEST(!decimal("9008192.000000001").grid_units_from(far).has_value());
  BOOST_TEST((decimal("0.1") - decimal("0.3")).to_string() == "-0.2");
  BOOST_TEST(decimal("-0.2").nearest_double() == -0.2);
}

BOOST_AUTO_TEST_CASE(the_fewest_decimals_of_a_grid_point_are_at_most_ten_and_read_back) {
  std::mt19937_64 generator(1);
  for (const char* text : {"9000000", "-4000000", "500000.123"}) {
    const Decimal zero = decimal(text);
    for (int i = 0; i < 2000; ++i) {
      const auto units = static_cast<std::int64_t>(generator() >> 20) - (1LL << 43);
      const Decimal written = Decimal::of_grid_units(units, zero);
      BOOST_TEST(written.grid_units_from(zero).value() == units);
      const std::string digits = written.to_string();
      const std::size_t point = digits.find('.');
      BOOST_TEST((point == std::string::npos || digits.size() - point - 1 <= 10u), digits);
      BOOST_TEST((decimal(digits) == written));
    }
    BOOST_TEST(Decimal::of_grid_units(0, zero).to_string() == text);
  }
  BOOST_TEST(Decimal::of_grid_units(1LL << 29, decimal("7000000")).to_string() == "7000000.5");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(maps)

/// A square of floes with ragged outlines on a raster of 3 m, some with a hole.
std::vector<Feature> floes(int n_side) {
  std::mt19937_64 generator(7);
  std::vector<Feature> features;
  for (int i = 0; i < n_side * n_side; ++i) {
    const Vec2 centre{3.0 * (i % n_side - n_side / 2), 3.0 * (i / n_side - n_side / 2)};
    Polygon floe{shapes::star(generator, 8 + i % 20, 0.5, centre), {}};
    if (i % 7 == 0)
      floe.holes.push_back(shapes::reversed(shapes::box(centre.x - 0.1, centre.y, centre.x, centre.y + 0.1)));
    features.push_back({std::move(floe), i % 2 == 0 ? "floe" : "sheet", i});
  }
  return features;
}

BOOST_AUTO_TEST_CASE(a_projected_map_of_ten_thousand_floes_keeps_its_bytes) {
  const Map map{floes(100), origin("500000,9000000"), R"({"type":"name","properties":{"name":"EPSG:32633"}})", false};
  const std::string text = map_to_geojson(map);
  const Map again = read_map(text).value();
  BOOST_TEST((again == map));
  BOOST_TEST((map_to_geojson(again) == text));
}

BOOST_AUTO_TEST_CASE(the_same_map_at_the_origin_and_far_north_is_the_same_on_the_grid) {
  // A saw of twelve decimals, more than a double holds at 9 000 000: once near zero, once in the north.
  std::mt19937_64 generator(3);
  std::string near, far, near_end, far_end;
  for (int i = 0; i <= 400; ++i) {
    const int x = i < 200 ? 10 * i : 10 * (400 - i) - 5, y = i < 200 ? 100 + i % 2 : -100;
    const std::string dx = fmt::format("{:012}", generator() % 1'000'000'000'000),
                      dy = fmt::format("{:012}", generator() % 1'000'000'000'000);
    const int shifted = y < 0 ? y + 8000 : y;  // whole parts of both signs would need other decimals
    near += fmt::format("{}.{} {}.{}, ", x + 5, dx, shifted, dy);
    far += fmt::format("{}.{} {}.{}, ", 500005 + x, dx, 9000000 + shifted, dy);
  }
  near_end = near.substr(0, near.find(','));
  far_end = far.substr(0, far.find(','));
  const Map here = read_map("POLYGON ((" + near + near_end + "))", Origin{}).value();
  const Map there = read_map("POLYGON ((" + far + far_end + "))", origin("500000,9000000")).value();
  BOOST_TEST((here.features == there.features));
  BOOST_TEST(here.features.front().polygon.outline.size() == 401u);
  BOOST_TEST((read_map(map_to_geojson(there)).value().features == here.features));
}

BOOST_AUTO_TEST_CASE(without_an_origin_the_middle_of_the_data_is_taken_where_zero_is_too_far) {
  const Map near = read_map("POLYGON ((0 0, 8000 0, 8000 9, 0 0))").value();
  BOOST_TEST((near.origin == Origin{}));
  const Map far = read_map("POLYGON ((500123 7000000, 500223 7000000, 500223 7000100, 500123 7000000))").value();
  BOOST_TEST(to_string(far.origin) == "500200,7000100");
  BOOST_TEST((far.features.front().polygon.outline.front() == snap({-77, -100})));
  // So wide that hundreds of metres leave no room.
  const Map wide = read_map("POLYGON ((100033 0, 116417 0, 116417 9, 100033 0))").value();
  BOOST_TEST(to_string(wide.origin) == "108225,0");
  const auto wider = read_map("POLYGON ((100000 0, 116390 0, 116390 9, 100000 0))");
  BOOST_TEST(wider.error().what == "line 1, column 10: (100000, 0) is beyond +-8192 m of the origin (108195,0)");
}

BOOST_AUTO_TEST_CASE(the_origin_of_the_file_yields_to_the_given_one) {
  const std::string text =
      R"({"type":"Polygon","origin":[500000,7e6],"coordinates":[[[500000,7000000],[500001,7000000],[500001,7000001],[500000,7000000]]]})";
  BOOST_TEST(to_string(read_map(text).value().origin) == "500000,7000000");
  // ogr2ogr keeps the member of a file that it projects anew.
  const std::string stale = std::string(text).replace(text.find("500000,7e6"), 10, "900000,7e6");
  BOOST_TEST(to_string(read_map(stale).value().origin) == "500000,7000000");
  const Map other = read_map(text, origin("499999.5,7000000")).value();
  BOOST_TEST((other.features.front().polygon.outline.front() == snap({0.5, 0})));
  BOOST_TEST(read_map(R"({"type":"Polygon","origin":[1],"coordinates":[]})").error().what ==
             "line 1, column 1: \"origin\" is not an array of two numbers below 10^15 m");
}

BOOST_AUTO_TEST_CASE(degrees_are_refused_where_the_file_names_them_and_suspected_where_it_does_not) {
  const auto with_crs = [](const char* name) {
    return fmt::format(
        R"({{"type":"FeatureCollection","crs":{{"type":"name","properties":{{"name":"{}"}}}},"features":[]}})", name);
  };
  for (const char* name : {"urn:ogc:def:crs:OGC:1.3:CRS84", "urn:ogc:def:crs:EPSG::4326", "EPSG:4258"}) {
    const auto map = read_map(with_crs(name));
    BOOST_REQUIRE(!map.has_value());
    BOOST_TEST(map.error().what.find("ogr2ogr -t_srs") != std::string::npos);
    BOOST_TEST(!read_polygons(with_crs(name)).has_value());
  }
  // Zone 32N with its number in the easting has a code in the midst of the geographic ones.
  for (const char* name : {"urn:ogc:def:crs:EPSG::32633", "EPSG:4647", "local"}) {
    const std::string text = with_crs(name);
    BOOST_TEST(text.find(read_map(text).value().crs) != std::string::npos);
    BOOST_TEST(!read_map(text).value().crs.empty());
  }
  BOOST_TEST(read_map("POLYGON ((15.1 78.2, 15.2 78.2, 15.2 78.3, 15.1 78.2))").value().looks_like_degrees);
  BOOST_TEST(read_map("POLYGON ((15.1 -78.2, 15.2 -78.2, 15.2 -78.3, 15.1 -78.2))").value().looks_like_degrees);
  BOOST_TEST(!read_map("POLYGON ((0 -20, 40 -20, 40 20, 0 20, 0 -20))").value().looks_like_degrees);
  BOOST_TEST(!read_map("POLYGON ((15.1 78.2, 15.2 78.2, 15.2 78.3, 15.1 78.2))", Origin{}).value().looks_like_degrees);
}

BOOST_AUTO_TEST_CASE(lines_of_geojson_are_the_same_cracks_as_those_of_wkt) {
  const auto wkt = read_lines("LINESTRING (0 0, 1 2, 3 4) MULTILINESTRING ((5 5, 6 6), (7 7, 8 8))").value().cracks;
  const auto json = read_lines(
                        R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":null,"geometry":
{"type":"LineString","coordinates":[[0,0],[1,2],[3,4]]}},{"type":"Feature","properties":null,"geometry":
{"type":"MultiLineString","coordinates":[[[5,5],[6,6]],[[7,7],[8,8]]]}}]})")
                        .value()
                        .cracks;
  BOOST_REQUIRE(json.size() == wkt.size());
  for (std::size_t i = 0; i < wkt.size(); ++i) BOOST_TEST((json[i].from == wkt[i].from && json[i].to == wkt[i].to));
  BOOST_TEST(read_lines(R"({"type":"Polygon","coordinates":[]})").error().what ==
             "line 1, column 1: Polygon is not read: FeatureCollection, Feature, LineString, MultiLineString or "
             "GeometryCollection is expected");
  BOOST_TEST(read_lines(R"({"type":"LineString","coordinates":[[0,0]]})").error().what ==
             "line 1, column 36: a line needs at least 2 positions, this has 1");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
}  // namespace brash::geometry
