// SPDX-License-Identifier: GPL-3.0-or-later
// Warnings of a structure that misses its ice, and of ice that lies elsewhere or comes from a map.
#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>

#include "brash/simulation/warnings.hpp"
#include "warnings.hpp"

namespace {

using namespace brash;
using namespace brash::test;

BOOST_AUTO_TEST_CASE(a_path_whose_heading_points_away_from_its_course_is_warned_of) {
  const auto text = [](const std::string& path) {
    const std::string file = kSource + "/tests/modules/simulation/turning_path.toml";
    return text_of(advice::warnings_of(io::read_case(file, {"structure.motion.path=" + path})), "path-heading");
  };
  const auto backwards = text("[[0,-7,0,3],[20,13,0,3]]");  // 3 degrees were meant
  BOOST_TEST(says(backwards, "from 0 to 20 s its course is 0 rad and its heading 3 rad"), backwards);
  BOOST_TEST(says(backwards, "were degrees meant?"), backwards);
  BOOST_TEST(says(text("[[0,-7,0,20],[20,13,0,20]]"), "begins with a heading of 20 rad"));
  BOOST_TEST(says(text("[[0,-12,-7,3],[20,-12,13,5]]"), "its course is 1.571 rad and its heading 4 rad"));
  BOOST_TEST(text("[[0,-7,0,1.5],[20,13,0,1.5]]") == "");           // abeam at most
  BOOST_TEST(text("[[0,-7,0,6.2],[20,13,0,6.2]]") == "");           // a little to the right
  BOOST_TEST(text("[[0,-7,0,3.1],[20,-27,0,-3.1]]") == "");         // away from the ice
  BOOST_TEST(text("[[0,-10,0,3],[20,-10,0,3]]") == "");             // at rest
  BOOST_TEST(text("[[0,-7,0,0],[1,-7.1,0,0],[20,13,0,0]]") == "");  // drifts back a little at first
}

BOOST_AUTO_TEST_CASE(a_run_that_touches_no_ice_says_so_and_gets_no_interval) {
  const auto summary = [](std::vector<std::string> settings) {
    settings.insert(settings.end(), {"failure.model=wedge", "output.statistics_from=0.05"});
    return advice::run(validation(settings)).summary;
  };
  const simulation::RunSummary none = summary({"time.duration=0.1"});  // the cone is 0.18 m away
  const auto text = text_of(none.warnings, "no-load");
  BOOST_TEST(says(text, "no ice touched the structure in the whole run"), text);
  BOOST_TEST(!has(none.warnings, "no-breaks"));
  BOOST_TEST(!simulation::bears_interval(none, none.horizontal));
  const simulation::RunSummary some = summary({"time.duration=0.2"});
  BOOST_TEST(!has(some.warnings, "no-load"));
}

BOOST_AUTO_TEST_CASE(a_structure_beside_a_field_of_floes_or_before_it_does_not_reach_the_ice) {
  const std::string file = kSource + "/experiments/fields/cone.toml";
  const auto warnings = [&](const std::vector<std::string>& settings) {
    return advice::warnings_of(io::read_case(file, settings));
  };
  BOOST_TEST(warnings({}).empty());
  BOOST_TEST(has(warnings({"structure.start_distance=70"}), "no-contact"));
  BOOST_TEST(!has(warnings({"structure.start_distance=70", "water.current=[-2,0]"}), "no-contact"));
  const auto path = [](double y) { return fmt::format("structure.motion.path=[[0,-10,{},0],[30,20,{},0]]", y, y); };
  const std::string barge = kSource + "/tests/modules/simulation/turning_path.toml";
  const auto along = [&](double y) {
    return advice::warnings_of(
        io::read_case(barge, {path(y), "time.duration=30", "field.kind=floes", "field.concentration=0.3",
                              "field.border=walls", "field.size.least=4", "field.size.largest=12"}));
  };
  BOOST_TEST(says(text_of(along(60.0), "no-contact"), "beside or behind the field"));
  BOOST_TEST(!has(along(0.0), "no-contact"));
  BOOST_TEST(has(along(20.0), "leaves-field"));  // through a wall
  const auto behind = warnings({"structure.start_distance=-260"});
  BOOST_TEST(has(behind, "no-contact"));
  BOOST_TEST(!has(behind, "leaves-field"));
  const auto beside = advice::warnings_of(io::read_case(barge, {path(60.0), "time.duration=30"}));
  BOOST_TEST(has(beside, "no-contact"));  // of level ice
  BOOST_TEST(!has(beside, "leaves-field"));
  BOOST_TEST(!has(along(10.0), "leaves-field"));
  BOOST_TEST(has(warnings({"time.duration=300"}), "leaves-field"));  // through the wall at the end
  BOOST_TEST(!has(warnings({"time.duration=300", "field.border=free"}), "leaves-field"));
}

BOOST_AUTO_TEST_CASE(a_start_of_statistics_that_was_left_out_is_not_to_be_left_out) {
  const auto far = warnings_with({"structure.start_distance=100"});
  BOOST_TEST(has(far, "no-contact"));
  BOOST_TEST(!has(far, "early-statistics"));
}

BOOST_AUTO_TEST_CASE(a_structure_at_rest_in_drifting_ice_is_judged_by_the_speed_of_the_ice) {
  const std::string file = kSource + "/tests/modules/simulation/turning_path.toml";
  const auto at_rest = [&](std::vector<std::string> settings) {
    settings.insert(settings.end(),
                    {"structure.motion.path=[[0,-10,0,0],[20,-10,0,0]]", "field.kind=floes", "field.concentration=0.3",
                     "field.size.least=4", "field.size.largest=12", "reference.source='model ice'"});
    return advice::warnings_of(io::read_case(file, settings));
  };
  const auto drifting = at_rest({"water.current=[-0.5,0]"});
  BOOST_TEST(!has(drifting, "few-iterations"));
  const auto text = text_of(drifting, "no-statistics");
  BOOST_TEST(says(text, "it does not pass it in this run"), text);
  BOOST_TEST(says(text, "set output.statistics_from"), text);
  const auto later = at_rest({"water.current=[-0.5,0]", "output.statistics_from=2"});
  BOOST_TEST(later.empty(), (later.empty() ? "" : later.front().text));
  BOOST_TEST(has(at_rest({"water.current=[-0.5,0]", "output.statistics_from=19.9"}), "short-run"));
  BOOST_TEST(has(at_rest({"water.current=[-0.01,0]"}), "few-iterations"));
  BOOST_TEST(!has(at_rest({}), "few-iterations"));
}

/// A file of a test, gone with it.
struct Written {
  std::string path;
  Written(const std::string& name, const std::string& text)
      : path((std::filesystem::temp_directory_path() / ("brash_warnings_" + name)).string()) {
    std::ofstream(path) << text;
  }
  Written(const Written&) = delete;
  Written& operator=(const Written&) = delete;
  ~Written() { std::filesystem::remove(path); }
};

BOOST_AUTO_TEST_CASE(the_ice_of_a_map_of_floes_is_checked_as_the_ice_of_the_case_is) {
  const auto warnings = [](const std::string& properties) {
    const Written map(
        "floes.geojson",
        R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":)"
        R"({"type":"Polygon","coordinates":[[[20,0],[24,0],[24,4],[20,0]]]}},{"type":"Feature","properties":)" +
            properties + R"(,"geometry":{"type":"Polygon","coordinates":[[[1,0],[5,0],[5,4],[1,0]]]}}]})");
    const std::string file = kSource + "/tests/experiments/field-of-file.toml";
    return advice::warnings_of(io::read_case(file, {"field.file=" + map.path}));
  };
  const auto strength = text_of(warnings(R"({"flexural_strength": 400})"), "flexural-strength");
  BOOST_TEST(says(strength, "feature 1"), strength);
  BOOST_TEST(says(strength, "flexural_strength = 400 Pa is outside all measured ice"), strength);
  BOOST_TEST(says(strength, "was \"400 kPa\" meant?"), strength);
  const auto thickness = text_of(warnings(R"({"thickness": 6})"), "thickness");
  BOOST_TEST(says(thickness, "thickness = 6 m is outside all measured ice"), thickness);
  const auto good = warnings(R"({"thickness": 0.5, "flexural_strength": 4e5})");
  BOOST_TEST(!has(good, "thickness"));
  BOOST_TEST(!has(good, "flexural-strength"));
}

BOOST_AUTO_TEST_CASE(openings_and_cracks_off_the_ice_are_warned_of_with_both_places) {
  const auto text = [](const std::string& key, const std::string& wkt) {
    const Written file(key + ".wkt", wkt);
    return text_of(warnings_with({"field." + key + "=" + file.path, "field.initial_crack=false"}), "off-the-ice");
  };
  const auto far = text("openings", "POLYGON ((200 0, 210 0, 210 10, 200 10, 200 0))");
  BOOST_TEST(says(far, "field.openings takes no ice away"), far);
  BOOST_TEST(says(far, "from (200, 0) to (210, 10) m"), far);
  BOOST_TEST(says(far, "the ice from (0, -25) to (50, 25) m"), far);
  BOOST_TEST(says(far, "field.origin"), far);
  const auto kilometres = text("openings", "POLYGON ((0.01 -0.02, 0.013 -0.02, 0.013 0.02, 0.01 0.02, 0.01 -0.02))");
  BOOST_TEST(says(kilometres, "takes 0.00012 m2 of ice away"), kilometres);
  const auto lines = text("cracks", "LINESTRING (200 0, 300 0)");
  BOOST_TEST(says(lines, "field.cracks parts no ice"), lines);
  const auto land = text("shore", "POLYGON ((200 0, 210 0, 210 10, 200 10, 200 0))");
  BOOST_TEST(says(land, "field.shore takes no ice away"), land);
  BOOST_TEST(text("openings", "POLYGON ((40 0, 60 0, 60 10, 40 10, 40 0))") == "");
  BOOST_TEST(text("cracks", "LINESTRING (-1 10, 51 10)") == "");
  BOOST_TEST(text("shore", "POLYGON ((50 0, 60 0, 60 10, 50 10, 50 0))") == "");  // it holds the ice
}

}  // namespace
