// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/ice/floe_file.hpp"

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>

#include "brash/core/error.hpp"

namespace {

using namespace brash;
using namespace brash::ice;

struct InFolder {
  std::filesystem::path folder = std::filesystem::temp_directory_path() / "brash_floe_file";
  model::FieldSection field;

  InFolder() {
    std::filesystem::create_directories(folder);
    field.kind = model::FieldKind::kFloes;
    field.length = field.width = 20.0;
  }
  ~InFolder() { std::filesystem::remove_all(folder); }

  std::string write(const std::string& text) const {
    const std::string path = (folder / "floes").string();
    std::ofstream(path) << text;
    return path;
  }
  std::vector<GivenFloe> read(const std::string& text) const { return read_floes(write(text), field); }
  void refuses(const std::string& text, const std::string& word) const {
    BOOST_CHECK_EXCEPTION((void)read(text), InputError, [&](const InputError& error) {
      BOOST_TEST_MESSAGE(error.what());
      return std::string(error.what()).find(word) != std::string::npos;
    });
  }
};

const std::string kSquare = "[[[0,0],[4,0],[4,4],[0,4],[0,0]]]", kOther = "[[[5,0],[9,0],[9,4],[5,4],[5,0]]]";

std::string feature(const std::string& type, const std::string& coordinates, const std::string& properties) {
  return R"({"type":"Feature","properties":)" + properties + R"(,"geometry":{"type":")" + type + R"(","coordinates":)" +
         coordinates + "}}";
}
std::string collection(const std::string& features) {
  return R"({"type":"FeatureCollection","features":[)" + features + "]}";
}

BOOST_FIXTURE_TEST_SUITE(floe_files, InFolder)

BOOST_AUTO_TEST_CASE(wkt_gives_outlines_in_their_order) {
  const auto floes = read("POLYGON((0 0, 4 0, 4 4, 0 4, 0 0))\nPOLYGON((4 0, 8 0, 8 4, 4 4, 4 0))");  // they touch
  BOOST_REQUIRE(floes.size() == 2u);
  BOOST_TEST(geometry::area(floes[1].outline).square_metres() == 16.0);
  BOOST_TEST(!floes[0].thickness.has_value());
}

BOOST_AUTO_TEST_CASE(geojson_gives_each_floe_its_ice) {
  const auto floes = read(
      collection(feature("MultiPolygon", "[" + kSquare + "," + kOther + "]", R"({"thickness":0.5})") + "," +
                 feature("Polygon", "[[[0,5],[4,5],[4,9],[0,5]]]", R"({"flexural_strength":4e5,"thickness":null})")));
  BOOST_REQUIRE(floes.size() == 3u);
  BOOST_TEST(floes[0].thickness.value() == 0.5);
  BOOST_TEST(floes[1].thickness.value() == 0.5);
  BOOST_TEST(!floes[2].thickness.has_value());
  BOOST_TEST(floes[2].flexural_strength.value() == 4e5);
}

BOOST_AUTO_TEST_CASE(features_without_geometry_keep_the_ice_of_the_others_at_its_place) {
  const std::string text =
      collection(R"({"type":"Feature","properties":{"thickness":0.9},"geometry":null},)" +
                 feature("Polygon", "[[[0,5,1],[4,5,1],[4,9,1],[0,5,1]]]", R"({"thickness":0.5})"));
  const auto floes = read(text);
  BOOST_REQUIRE(floes.size() == 1u);
  BOOST_TEST(floes[0].thickness.value() == 0.5);
  BOOST_TEST(left_out_of(write(text), {}, false) == "heights (4), features without geometry (1)");
  BOOST_TEST(left_out_of(write("LINESTRING Z (0 0 1, 1 1 1)"), {}, true) == "heights (2)");
}

BOOST_AUTO_TEST_CASE(a_property_in_other_letters_beside_the_known_one_is_left_alone) {
  const auto floes = read(collection(feature("Polygon", kSquare, R"({"thickness":0.5,"THICKNESS":"50 cm"})")));
  BOOST_TEST(floes.front().thickness.value() == 0.5);
}

BOOST_AUTO_TEST_CASE(an_origin_is_taken_from_the_coordinates_of_a_map_exactly) {
  const auto local = read("POLYGON((0.25 -3.1, 4.2 -3, 4 4, 0.25 -3.1))");
  field.origin = {499999.75, 9000003.0};
  // A double no longer holds 2^-30 m there; the text does.
  const auto of_map = read("POLYGON((500000.0 8999999.9, 500003.95 9000000, 500003.75 9000007, 500000.0 8999999.9))");
  BOOST_TEST((of_map.front().outline == local.front().outline));
}

BOOST_AUTO_TEST_CASE(coordinates_of_a_map_are_refused_with_the_origin_to_write) {
  refuses("POLYGON((500000.5 8999999.9, 500003.95 9000000, 500003.75 9000007, 500000.5 8999999.9))",
          "write field.origin = [500000, 9000003]");
  field.origin = {500000.0, 9000003.0};
  BOOST_TEST(read("POLYGON((500000.5 8999999.9, 500003.95 9000000, 500003.75 9000007, 500000.5 8999999.9))").size() ==
             1u);
}

BOOST_AUTO_TEST_CASE(faults_are_refused_with_their_place) {
  refuses("POLYGON((0 0, 4 0, 4 4, 0 4, 0 0)) POLYGON((2 0, 8 0, 8 4, 2 4, 2 0))",
          "polygon 0 overlaps polygon 1 at (2, 0)");
  refuses("POLYGON((0 0, 4 0, 4 4, 0 4, 0 0)) POLYGON((2 1, 8 1, 8 3, 2 3, 2 1))",
          "polygon 0 crosses polygon 1 at (4,");
  refuses("POLYGON((0 0, 8 0, 8 8, 0 8, 0 0)) POLYGON((2 2, 4 2, 4 4, 2 4, 2 2))",
          "polygon 0 overlaps polygon 1 at (2, 2)");  // one in the other
  refuses("POLYGON((0 0, 30 0, 30 4, 0 4, 0 0))", "field.length = 20");
  refuses(collection(feature("Polygon", kSquare, R"({"thickness":"thick"})")), "feature 0");
  refuses(collection(feature("Polygon", kSquare, R"({"thickness":-1})")), "has the thickness -1");
  refuses("POLYGON((0 0, 4 0", "line 1");
  refuses(collection(feature("Polygon", kSquare, R"({"Thickness":0.5})")), "has the property Thickness");
  refuses(collection(feature("Polygon", kSquare, R"({"FLEXURAL_STRENGTH":4e5})")), "write flexural_strength");
  refuses("POLYGON EMPTY", "holds no polygon");
  refuses("POLYGON((0 0, 8 0, 8 8, 0 8, 0 0)) POLYGON((9 0, 15 0, 15 8, 9 8, 9 0), (2 2, 4 2, 4 4, 2 4, 2 2))",
          "polygon 1: there is no ice for a hole at (2, 2)");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
