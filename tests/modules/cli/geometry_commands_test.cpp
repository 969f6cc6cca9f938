// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <boost/test/unit_test.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "brash/core/error.hpp"
#include "brash/geometry/text.hpp"
#include "commands.hpp"

namespace brash::cli {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test, removed afterwards.
struct Folder {
  fs::path path = fs::temp_directory_path() / ("brash_geometry_commands_" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path / name, std::ios::binary) << text;
    return (path / name).string();
  }
  std::string read(const std::string& name) const {
    std::ifstream stream(path / name);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  }
};

/// Runs `brash ARGUMENTS` without the program around it; exceptions come through.
void run(std::vector<std::string> arguments) {
  CLI::App app;
  add_crack_command(app);
  add_fit_command(app);
  add_pieces_command(app);
  std::reverse(arguments.begin(), arguments.end());
  app.parse(arguments);
}

/// The text that `run` writes to a stream, whose number is `descriptor`.
std::string text_of(const Folder& folder, const std::vector<std::string>& arguments, std::FILE* stream,
                    int descriptor) {
  const std::string file = (folder.path / "stream").string();
  std::fflush(stream);
  const int saved = ::dup(descriptor);
  BOOST_REQUIRE(std::freopen(file.c_str(), "w", stream) != nullptr);
  run(arguments);
  std::fflush(stream);
  ::dup2(saved, descriptor);
  ::close(saved);
  return folder.read("stream");
}

/// The output of `run`, as JSON.
nlohmann::json output_of(const Folder& folder, const std::vector<std::string>& arguments) {
  return nlohmann::json::parse(text_of(folder, arguments, stdout, 1));
}

bool names(const InputError& error, const std::string& what) {
  BOOST_TEST_INFO(error.what());
  return std::string(error.what()).find(what) != std::string::npos;
}

constexpr const char* kSheet = "POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))";

BOOST_FIXTURE_TEST_SUITE(geometry_commands, Folder)

BOOST_AUTO_TEST_CASE(events_are_cut_out_as_wedges_and_the_ledger_closes) {
  const std::string sheet = write("sheet.wkt", kSheet);
  const std::string events = write("events.csv", "x,y,radius,wedges\n# the left edge\n0,5,2,3\n\n0,2,1,,0.3;-0.3\n");
  const std::string pieces = (path / "pieces.geojson").string();
  const auto ledger = output_of(*this, {"crack", "--sheet", sheet, "--events", events, "-o", pieces});
  BOOST_TEST(ledger["initial"] == "100");
  BOOST_TEST(ledger["missing"] == "0");
  BOOST_TEST(ledger["closes"] == true);
  BOOST_TEST(ledger["n_floes"] == 6);
  const auto features = geometry::read_polygons(read("pieces.geojson")).value().features;
  geometry::ExactArea floes;
  for (const auto& f : features) {
    if (f.kind == "floe") floes += geometry::area(f.polygon);
  }
  BOOST_TEST(ledger["floes"] == floes.to_string());
  // Three wedges of half a 16-gon of radius 2: area 2^2 * 8 sin(2 pi/16) / 2, off by the grid.
  const double expected = (4.0 + 1.0) * 4.0 * std::sin(std::acos(-1.0) / 8);
  // The second disc has vertices of its own at the cracks' ends: its area is between half a 16-gon and pi/2.
  BOOST_TEST(floes.square_metres() > expected);
  BOOST_TEST(floes.square_metres() < expected + std::acos(-1.0) / 2 - 4.0 * std::sin(std::acos(-1.0) / 8));
}

BOOST_AUTO_TEST_CASE(the_output_of_one_run_is_the_input_of_the_next) {
  const std::string sheet = write("sheet.wkt", kSheet), first = (path / "first.geojson").string();
  const std::string one = write("one.csv", "0,5,2,3\n"), two = write("two.csv", "10,5,2,4\n");
  const std::string both = write("both.csv", "0,5,2,3\n10,5,2,4\n");
  output_of(*this, {"crack", "--sheet", sheet, "--events", one, "-o", first});
  output_of(*this, {"crack", "--sheet", first, "--events", two, "-o", (path / "second.geojson").string()});
  output_of(*this, {"crack", "--sheet", sheet, "--events", both, "-o", (path / "both.geojson").string()});
  BOOST_TEST(read("second.geojson") == read("both.geojson"));
}

BOOST_AUTO_TEST_CASE(cutters_take_their_overlap) {
  const std::string sheet = write("sheet.wkt", kSheet);
  const std::string cutters =
      write("cutters.wkt", "POLYGON ((-1 -1, 2 -1, 2 2, -1 2, -1 -1))\nPOLYGON ((4 -1, 6 -1, 6 11, 4 11, 4 -1))\n");
  const auto kept = output_of(*this, {"crack", "--sheet", sheet, "--cutters", cutters});
  BOOST_TEST(kept["sheet"] == "76");
  BOOST_TEST(kept["floes"] == "24");
  BOOST_TEST(kept["n_sheet_parts"] == 2);
  const auto released = output_of(*this, {"crack", "--sheet", sheet, "--cutters", cutters, "--release"});
  BOOST_TEST(released["sheet"] == "40");
  BOOST_TEST(released["n_floes"] == 3);
}

BOOST_AUTO_TEST_CASE(cracks_split_a_map_of_floes_and_lose_nothing) {
  // Two floes, one with a hole, and a bent crack through both that begins outside and ends inside the second one.
  const std::string sheet = write("floes.wkt",
                                  "POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))\n"
                                  "POLYGON ((20 0, 30 0, 30 10, 20 10, 20 0), (24 7, 26 7, 26 9, 24 9, 24 7))");
  const std::string cracks = write("cracks.wkt",
                                   "LINESTRING (-1 4, 5 4, 12 6, 25 5)\n"
                                   "MULTILINESTRING ((25 5, 31 5), (1 1, 2 2))");
  const std::string pieces = (path / "pieces.geojson").string();
  const auto ledger = output_of(*this, {"crack", "--sheet", sheet, "--cracks", cracks, "-o", pieces});
  BOOST_TEST(ledger["initial"] == "196");
  BOOST_TEST(ledger["sheet"] == "0");
  BOOST_TEST(ledger["n_floes"] == 4);  // the crack from (1, 1) to (2, 2) splits nothing
  BOOST_TEST(ledger["missing"] == "0");
  std::size_t n_holes = 0;
  const geometry::Map written = geometry::read_polygons(read("pieces.geojson")).value();
  for (const geometry::Feature& feature : written.features) n_holes += feature.polygon.holes.size();
  BOOST_TEST(n_holes == 1);
  const auto none = output_of(*this, {"crack", "--sheet", write("none.wkt", "POLYGON EMPTY"), "--cracks", cracks});
  BOOST_TEST(none["n_floes"] == 0);
}

geometry::Polygon polygon_in(std::string_view text) {
  return geometry::read_polygons(text).value().features.front().polygon;
}

BOOST_FIXTURE_TEST_CASE(a_union_prints_its_ledger_and_keeps_the_kinds_apart, Folder) {
  const std::string map = write("map.geojson", geometry::to_geojson(std::vector<geometry::Feature>{
                                                   {polygon_in("POLYGON ((0 0, 4 0, 4 2, 0 2, 0 0))"), "sheet", 0},
                                                   {polygon_in("POLYGON ((1 -1, 2 -1, 2 5, 1 5, 1 -1))"), "sheet", 1},
                                                   {polygon_in("POLYGON ((3 0, 6 0, 6 2, 3 2, 3 0))"), "floe", 2},
                                                   {polygon_in("POLYGON ((6 0, 7 0, 7 2, 6 2, 6 0))"), "floe", 3}}));
  const auto ledger = output_of(*this, {"crack", "--sheet", map, "--union", "-o", (path / "united.geojson").string()});
  BOOST_TEST(ledger["given"] == "22");
  BOOST_TEST(ledger["united"] == "20");
  BOOST_TEST(ledger["overlap"] == "2");
  BOOST_TEST(ledger["missing"] == "0");
  BOOST_TEST(ledger["n_polygons"] == 2);
  const geometry::Map united = geometry::read_polygons(read("united.geojson")).value();
  BOOST_REQUIRE(united.features.size() == 2u);
  BOOST_TEST(united.features[0].kind == "sheet");
  BOOST_TEST(geometry::area(united.features[1].polygon).to_string() == "8");
  BOOST_CHECK_EXCEPTION(run({"crack", "--sheet", map, "--union", "--along", map}), InputError,
                        [](const InputError& e) { return names(e, "--union"); });
  const std::string bow = write("bow.wkt", "POLYGON ((0 0, 3 2, 3 0, 0 1, 0 0))");
  BOOST_CHECK_EXCEPTION(run({"crack", "--sheet", bow, "--union"}), InputError,
                        [](const InputError& e) { return names(e, "polygon 0 crosses itself"); });
}

BOOST_FIXTURE_TEST_CASE(a_repair_lists_faults_and_changes_and_keeps_kinds_and_ice, Folder) {
  const std::string bow = "POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))";  // of two lobes whose areas cancel
  std::vector<geometry::Feature> drawn{{polygon_in("POLYGON ((5 0, 9 0, 9 2, 5 2, 5 0))"), "sheet", 4},
                                       {polygon_in("POLYGON ((8 1, 11 1, 11 3, 8 3, 8 1))"), "floe", 2, 0.3, 5e5},
                                       {polygon_in(bow), "floe", 7, 0.4},
                                       {polygon_in("POLYGON ((6 0, 7 0, 7 1, 6 1, 6 0))"), "floe", 1}};
  const std::string map = write("drawn.geojson", geometry::to_geojson(drawn)),
                    sound = (path / "sound.geojson").string();
  const auto ledger = output_of(*this, {"crack", "--sheet", map, "--repair", "-o", sound});
  BOOST_TEST(ledger["given"] == "15");
  BOOST_TEST(ledger["kept"] == "15");
  BOOST_TEST(ledger["overlap"] == "2");
  BOOST_TEST(ledger["folded"] == "-2");
  BOOST_TEST(ledger["snap"] == "0");
  BOOST_TEST(ledger["closes"] == true);
  BOOST_TEST(ledger["n_gone"] == 1);
  BOOST_TEST((ledger["changed"] == nlohmann::json{1, 2, 3}));
  BOOST_TEST(ledger["faults"].size() == 3u);
  const geometry::Map repaired = geometry::read_map(read("sound.geojson")).value();
  BOOST_REQUIRE(repaired.features.size() == 4u);
  BOOST_TEST((repaired.features[0] == drawn[0]));
  BOOST_TEST(repaired.features[1].flexural_strength.value() == 5e5);
  BOOST_TEST(repaired.features[2].id == 7);
  BOOST_TEST(repaired.features[3].id == 8);
  for (const int lobe : {2, 3}) BOOST_TEST(repaired.features[lobe].thickness.value() == 0.4);
  // A sound map stays as it is, and a repaired one is sound.
  output_of(*this, {"crack", "--sheet", sound, "--repair", "-o", (path / "again.geojson").string()});
  BOOST_TEST(read("again.geojson") == read("sound.geojson"));
  run({"pieces", sound});
  BOOST_CHECK_EXCEPTION(run({"pieces", write("bow.wkt", bow)}), InputError,
                        [](const InputError& e) { return names(e, "polygon 0 crosses itself at (1, 1)"); });
}

BOOST_FIXTURE_TEST_CASE(pieces_reads_a_map_that_is_wider_than_a_grid, Folder) {
  const std::string wide = write("wide.wkt",
                                 "POLYGON ((0 0, 20 0, 20 20, 0 20, 0 0)) POLYGON ((90000 0, 90010 0, 90010 10, 90000 "
                                 "10, 90000 0)) POLYGON ((0 50000, 5 50000, 5 50005, 0 50005, 0 50000))");
  const auto found = output_of(*this, {"pieces", wide, "--json"});
  BOOST_TEST(found["n"] == 3);
  BOOST_TEST(found["area"] == 525.0);
}

/// The lines of `text` that begin with a position, moved by whole metres: digits after the point stay as they are.
std::string moved(const std::string& text, int x, int y) {
  static const std::regex position(R"((\d+)(\.\d+)? (\d+)(\.\d+)?)");
  std::string result;
  auto last = text.begin();
  for (std::sregex_iterator m(text.begin(), text.end(), position), end; m != end; ++m) {
    result.append(last, text.begin() + m->position());
    result += std::to_string(std::stoi((*m)[1]) + x) + (*m)[2].str() + ' ' + std::to_string(std::stoi((*m)[3]) + y) +
              (*m)[4].str();
    last = text.begin() + m->position() + m->length();
  }
  return result.append(last, text.end());
}

BOOST_FIXTURE_TEST_CASE(edges_that_are_led_to_the_ends_of_a_line_are_counted_as_rounded, Folder) {
  // Both ends are drawn on an edge, to nine digits.
  const std::string sheet = write("sheet.wkt", "POLYGON ((0 0, 7 1, 6 5, 1 4, 0 0))"),
                    line = write("line.wkt", "LINESTRING (3 0.428571428, 2.5 4.3)");
  const auto ledger = output_of(*this, {"crack", "--sheet", sheet, "--along", line});
  BOOST_TEST(ledger["n_floes"] == 2);
  BOOST_TEST(ledger["snap"] != "0");
  BOOST_TEST(ledger["n_rounded"] == 2);
}

BOOST_AUTO_TEST_CASE(the_same_case_at_northing_9_000_000_gives_the_same_pieces) {
  // Ten decimals and more, which a double no longer holds there.
  const std::string sheet = "POLYGON ((0.1234567891 0.3, 100.0000000007 1.1, 110.5 60.7777777777, 0.1234567891 0.3))";
  const std::string lines = "LINESTRING (5.0000000003 70, 60.123456789123 0.1, 70.7 1.00000000001, 100 60)";
  const auto ledger_at = [&](int x, int y, const std::string& pieces, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"crack",
                                       "--sheet",
                                       write("sheet.wkt", moved(sheet, x, y)),
                                       "--along",
                                       write("lines.wkt", moved(lines, x, y)),
                                       "-o",
                                       (path / pieces).string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return output_of(*this, arguments);
  };
  const auto here = ledger_at(0, 0, "here.geojson", {});
  auto there = ledger_at(500000, 9000000, "there.geojson", {"--origin", "500000,9000000"});
  BOOST_TEST(there["origin"].dump() == R"(["500000","9000000"])");
  there.erase("origin");
  BOOST_TEST(here == there);
  BOOST_TEST(here["n_floes"] == 3);
  const geometry::Map near = geometry::read_map(read("here.geojson")).value();
  const geometry::Map far = geometry::read_map(read("there.geojson")).value();
  BOOST_TEST((near.features == far.features));
  BOOST_TEST(to_string(far.origin) == "500000,9000000");
  // Events and cutters too.
  for (const auto& [option, file] : {std::pair{"--events", "40.0000000003,20.5,7.1,3\n"},
                                     {"--cutters", "POLYGON ((40 5, 60.0000000001 5, 60 30, 40 5))"}}) {
    std::string far_file = moved(file, 500000, 9000000);
    if (std::string(option) == "--events") far_file = "500040.0000000003,9000020.5,7.1,3\n";
    output_of(*this, {"crack", "--sheet", write("a.wkt", sheet), option, write("a", file), "-o",
                      (path / "a.geojson").string()});
    output_of(*this, {"crack", "--sheet", write("b.wkt", moved(sheet, 500000, 9000000)), option, write("b", far_file),
                      "--origin", "500000,9000000", "-o", (path / "b.geojson").string()});
    BOOST_TEST((geometry::read_map(read("a.geojson"))->features == geometry::read_map(read("b.geojson"))->features));
  }
}

BOOST_AUTO_TEST_CASE(lines_that_end_touch_cross_and_overlap_split_and_lose_nothing) {
  const std::string sheet = write("sheet.wkt", kSheet);
  const std::pair<const char*, int> cases[] = {
      {"LINESTRING (2 5, 8 5)", 1},                                                // ends inside: splits nothing
      {"LINESTRING (-1 5, 5 5) LINESTRING (5 5, 11 5)", 2},                        // touch end to end
      {"LINESTRING (-1 5, 11 5) LINESTRING (5 5, 5 11)", 3},                       // ends on another
      {"LINESTRING (-1 5, 11 5) LINESTRING (5 -1, 5 11)", 4},                      // cross
      {"LINESTRING (-1 5, 7 5) LINESTRING (3 5, 11 5)", 2},                        // overlap
      {"LINESTRING (-1 5, 11 5) LINESTRING (-1 5, 11 5)", 2},                      // twice the same
      {"LINESTRING (0 0, 10 10) LINESTRING (0 10, 10 0)", 4},                      // through corners
      {"LINESTRING (0 0, 10 0)", 1},                                               // along an edge
      {"LINESTRING (-1 3, 5 3, 5 7, 11 7) LINESTRING (-1 7, 5 7)", 3},             // branch at a corner
      {"LINESTRING (3 3, 7 3, 7 7, 3 7, 3 3)", 2},                                 // a closed one
      {"LINESTRING (-1 1, 11 9, 11 1, -1 9)", 4},                                  // crosses itself
      {"LINESTRING (-1 3.333333333333, 11 6.1) LINESTRING (-1 7.7, 11 2.2)", 4}};  // a rounded crossing
  for (const auto& [lines, n] : cases) {
    const auto ledger = output_of(*this, {"crack", "--sheet", sheet, "--along", write("lines.wkt", lines)});
    BOOST_TEST(ledger["n_floes"] == n, lines);
    BOOST_TEST(ledger["missing"] == "0", lines);
    BOOST_TEST(ledger["closes"] == true, lines);
  }
  const std::string json =
      R"({"type":"Feature","properties":null,"geometry":{"type":"LineString","coordinates":[[-1,5],[11,5]]}})";
  const auto ledger = output_of(*this, {"crack", "--sheet", sheet, "--along", write("lines.geojson", json)});
  BOOST_TEST(ledger["n_floes"] == 2);
}

BOOST_AUTO_TEST_CASE(the_name_of_the_output_decides_its_format) {
  const std::string sheet = write("sheet.wkt", kSheet), lines = write("lines.wkt", "LINESTRING (-1 5, 11 5)");
  output_of(*this, {"crack", "--sheet", sheet, "--along", lines, "-o", (path / "p.wkt").string()});
  BOOST_TEST(read("p.wkt") == "POLYGON ((0 0, 10 0, 10 5, 0 5, 0 0))\nPOLYGON ((0 5, 10 5, 10 10, 0 10, 0 5))\n");
  const auto refused = [&](const std::string& name) {
    BOOST_CHECK_EXCEPTION(run({"crack", "--sheet", sheet, "--along", lines, "-o", (path / name).string()}), InputError,
                          [&](const InputError& e) { return names(e, "is not a format that is written"); });
    BOOST_TEST(!fs::exists(path / name));
  };
  refused("p.shp");
  refused("p.gpkg");
  const std::string degrees = write("degrees.geojson", R"({"type":"FeatureCollection","crs":{"type":"name","properties":
{"name":"urn:ogc:def:crs:OGC:1.3:CRS84"}},"features":[]})");
  BOOST_CHECK_EXCEPTION(run({"crack", "--sheet", degrees, "--along", lines}), InputError,
                        [](const InputError& e) { return names(e, "ogr2ogr -t_srs"); });
  BOOST_CHECK_EXCEPTION(run({"crack", "--sheet", sheet, "--along", lines, "--origin", "1"}), InputError,
                        [](const InputError& e) { return names(e, "--origin = '1' is not a place"); });
}

BOOST_AUTO_TEST_CASE(pieces_are_the_floes_of_a_map_or_all_its_polygons) {
  std::string map;
  for (int i = 1; i <= 60; ++i) {
    const int x = 200 * i, side = i;
    map += fmt::format("POLYGON (({0} 0, {1} 0, {1} {2}, {0} {2}, {0} 0))\n", x - 6000, x - 6000 + side, side);
  }
  const std::string picture = (path / "sizes.svg").string();
  const auto all = output_of(*this, {"pieces", write("map.wkt", map), "--json", "-o", picture});
  BOOST_TEST(all["n"] == 60);
  BOOST_TEST(all["area"] == 73810.0);  // 60 61 121/6
  BOOST_TEST(all["largest"].get<double>() == 240.0 / std::acos(-1.0), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(all["quantiles_by_number"]["0.5"].get<double>() == 122.0 / std::acos(-1.0),
             boost::test_tools::tolerance(1e-12));
  // Squares up to 47 m hold 35 720 m2, up to 48 m 38 024 m2, up to 58 m 66 729 m2 and up to 59 m 70 210 m2.
  BOOST_TEST(all["quantiles_by_area"]["0.5"].get<double>() == 192.0 / std::acos(-1.0),
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(all["quantiles_by_area"]["0.95"].get<double>() == 236.0 / std::acos(-1.0),
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(all["fits"].size() == 3u);
  BOOST_TEST(read("sizes.svg").starts_with("<svg"));
  const std::string mixed = write(
      "mixed.geojson",
      geometry::to_geojson(std::vector<geometry::Feature>{
          {polygon_in(kSheet), "sheet", 0}, {polygon_in("POLYGON ((20 0, 22 0, 22 2, 20 2, 20 0))"), "floe", 1}}));
  const auto floes = output_of(*this, {"pieces", mixed, "--json"});
  BOOST_TEST(floes["n"] == 1);
  BOOST_TEST(floes["n_left_out"] == 1);
  BOOST_TEST(floes["area"] == 4.0);
  BOOST_TEST(floes["not_fitted"].size() == 3u);
  BOOST_CHECK_EXCEPTION(run({"pieces", write("none.wkt", "POLYGON EMPTY")}), InputError,
                        [](const InputError& e) { return names(e, "has no pieces"); });
}

BOOST_AUTO_TEST_CASE(the_fit_finds_the_trapezoid_of_a_sheet) {
  // A protrusion of depth 1, tip 0.5 and 90 deg on the left edge of a sheet.
  const std::string sheet =
      write("sheet.wkt", "POLYGON ((1 -20, 40 -20, 40 20, 1 20, 1 1.25, 0 0.25, 0 -0.25, 1 -1.25, 1 -20))");
  const auto fit = output_of(*this, {"fit", "--sheet", sheet, "--at", "0,0", "--towards", "2,0"});
  // As exact as the search, see the trapezoid's own tests.
  BOOST_TEST(std::abs(fit["b"].get<double>() - 1.0) < 0.01);
  BOOST_TEST(std::abs(fit["c"].get<double>() - 0.5) < 0.05);
  BOOST_TEST(std::abs(fit["theta_deg"].get<double>() - 90.0) < 2.0);
  BOOST_TEST(fit["error"].get<double>() < 1e-3);
  BOOST_TEST(fit["reidentified"] == false);
  const auto known =
      output_of(*this, {"fit", "--sheet", sheet, "--at", "0,0", "--towards", "1,0", "--contact-length", "0.5"});
  BOOST_TEST(known["c"] == 0.5);
  // The free edge on the other side of the sheet is straight; a negative number is a value, no option.
  const auto straight = output_of(*this, {"fit", "--sheet", sheet, "--at", "40,0", "--towards", "-1,0"});
  BOOST_TEST(straight["b"] == 0.0);
}

BOOST_AUTO_TEST_CASE(bad_input_is_refused_with_its_place) {
  const std::string sheet = write("sheet.wkt", kSheet), bad = write("bad.wkt", "POLYGON ((0 0,\n1 x))");
  const std::string crossed = write("crossed.wkt", "POLYGON ((0 0, 3 2, 3 0, 0 1, 0 0))");
  const std::string events = write("events.csv", "0,5,2,3\n");
  const auto refused = [&](std::vector<std::string> arguments, const std::string& what) {
    BOOST_CHECK_EXCEPTION(run(arguments), InputError, [&](const InputError& e) { return names(e, what); });
  };
  refused({"crack", "--sheet", (path / "none").string(), "--events", events}, "none: cannot be opened: No such file");
  refused({"crack", "--sheet", path.string(), "--events", events}, "is a folder");
  refused({"crack", "--sheet", write("empty", ""), "--events", events}, "line 1, column 1: there is no geometry");
  refused({"crack", "--sheet", bad, "--events", events}, "bad.wkt: line 2, column 3");
  refused({"crack", "--sheet", crossed, "--events", events}, "crossed.wkt: polygon 0 crosses itself");
  refused({"crack", "--sheet", sheet, "--cutters", crossed},
          "crosses itself at (1, 0.66666666697710752) (cutters count from 0)");
  refused({"crack", "--sheet", sheet}, "--events");
  refused({"fit", "--sheet", sheet, "--at", "5,5", "--towards", "1,0"}, "no free edge within 3 m");
  refused({"fit", "--sheet", sheet, "--at", "5", "--towards", "1,0"}, "--at = '5'");
  refused({"fit", "--sheet", sheet, "--at", "0,5", "--towards", "0,0"}, "--towards");
}

BOOST_AUTO_TEST_CASE(an_option_of_crack_that_would_have_no_effect_is_refused) {
  const std::string sheet = write("sheet.wkt", kSheet), lines = write("lines.wkt", "LINESTRING (-1 5, 11 5)");
  BOOST_CHECK_THROW(run({"crack", "--sheet", sheet, "--along", lines, "--sides", "8"}), CLI::RequiresError);
  BOOST_CHECK_THROW(run({"crack", "--sheet", sheet, "--along", lines, "--release"}), CLI::ExcludesError);
}

BOOST_AUTO_TEST_CASE(an_input_is_not_written_over) {
  const std::string sheet = write("sheet.wkt", kSheet), events = write("events.csv", "0,5,2,3\n");
  const std::string cutters = write("cutters.wkt", "POLYGON ((4 -1, 6 -1, 6 11, 4 11, 4 -1))");
  const std::string other_name = (path / "link.wkt").string();
  fs::create_symlink(sheet, other_name);
  const auto refused = [&](const std::vector<std::string>& arguments) {
    BOOST_CHECK_EXCEPTION(run(arguments), InputError, [&](const InputError& e) { return names(e, "is an input"); });
  };
  refused({"crack", "--sheet", sheet, "--events", events, "-o", sheet});
  refused({"crack", "--sheet", sheet, "--events", events, "-o", other_name});
  refused({"crack", "--sheet", sheet, "--events", events, "-o", events});
  refused({"crack", "--sheet", sheet, "--cutters", cutters, "-o", cutters});
  BOOST_TEST(read("sheet.wkt") == kSheet);
}

BOOST_AUTO_TEST_CASE(a_cut_that_meets_no_ice_is_told) {
  const std::string sheet = write("sheet.wkt", kSheet);
  const auto notes = [&](const std::string& option, const std::string& file) {
    return text_of(*this, {"crack", "--sheet", sheet, option, file}, stderr, 2);
  };
  const std::string events = write("events.csv", "x,y,radius,wedges\n0,5,2,3\n100,500,2,3\n90,5,2,3\n");
  BOOST_TEST(notes("--events", events) == "note: " + events + ": 2 of 3 events met no ice, the first is in line 3\n");
  const std::string cutters = write("cutters.wkt", "POLYGON ((20 0, 30 0, 30 9, 20 0))");
  BOOST_TEST(notes("--cutters", cutters) ==
             "note: " + cutters + ": 1 of 1 cutters met no ice, the first is cutter 1\n");
  BOOST_TEST(notes("--events", write("one.csv", "0,5,2,3\n")) == "");
}

BOOST_AUTO_TEST_CASE(a_hole_in_another_polygon_is_refused_whatever_cuts) {
  const std::string sheet = write("sheet.wkt",
                                  "MULTIPOLYGON (((0 0,10 0,10 10,0 10,0 0)),"
                                  "((20 0,30 0,30 10,20 10,20 0),(2 2,4 2,4 4,2 4,2 2)))");
  const std::string line = write("line.wkt", "LINESTRING (5 -1, 5 11)"), events = write("events.csv", "0,5,2,3\n"),
                    cutter = write("cutter.wkt", "POLYGON ((4 4, 6 4, 6 6, 4 4))");
  const auto refused = [&](const std::vector<std::string>& arguments, const std::string& what) {
    BOOST_CHECK_EXCEPTION(run(arguments), InputError, [&](const InputError& e) { return names(e, what); });
  };
  for (const auto& [option, file] : {std::pair{"--along", line}, {"--events", events}, {"--cutters", cutter}})
    refused({"crack", "--sheet", sheet, option, file}, "polygon 1: there is no ice for a hole at (2, 2)");
  refused({"pieces", sheet}, "there is no ice for a hole");
}

BOOST_AUTO_TEST_CASE(lines_split_floes_which_keep_what_is_theirs) {
  const auto square = [](const std::string& properties, int x) {
    return fmt::format(R"({{"type":"Feature","properties":{0},"geometry":{{"type":"Polygon","coordinates":)"
                       R"([[[{1},0],[{2},0],[{2},10],[{1},10],[{1},0]]]}}}})",
                       properties, x, x + 10);
  };
  // The second floe lies on the first one, and the last one beside the line.
  const std::string map =
      write("map.geojson", R"({"type":"FeatureCollection","features":[)" +
                               square(R"({"kind":"floe","id":7,"thickness":0.5})", 0) + "," +
                               square(R"({"kind":"floe","id":8})", 5) + "," + square("{}", 20) + "," +
                               square(R"({"kind":"floe","id":3,"flexural_strength":4e5})", 40) + "]}");
  const std::string lines = write("lines.wkt", "LINESTRING (-1 5, 35 5)");
  const auto ledger =
      output_of(*this, {"crack", "--sheet", map, "--along", lines, "-o", (path / "parts.geojson").string()});
  BOOST_TEST(ledger["initial"] == "400");
  BOOST_TEST(ledger["floes"] == "400");
  BOOST_TEST(ledger["closes"] == true);
  const auto floes = geometry::read_polygons(read("parts.geojson")).value().features;
  BOOST_REQUIRE(floes.size() == 7u);
  for (const std::size_t i : {0u, 1u}) BOOST_TEST(floes[i].thickness.value() == 0.5);
  BOOST_TEST(!floes[2].thickness.has_value());
  BOOST_TEST(floes[4].id == 3);
  BOOST_TEST(floes[4].flexural_strength.value() == 4e5);
  std::set<std::int64_t> ids;
  for (const auto& floe : floes) ids.insert(floe.id);
  BOOST_TEST(ids.size() == 7u);
  BOOST_TEST(
      text_of(*this,
              {"crack", "--sheet", (path / "parts.geojson").string(), "--events", write("events.csv", "0,5,2,3\n")},
              stderr, 2)
          .starts_with("note: " + (path / "parts.geojson").string() +
                       ": holds floes only, and --events cuts the sheet"));
}

BOOST_AUTO_TEST_CASE(a_direction_out_of_the_ice_is_not_fitted) {
  const std::string sheet = write("tongue.wkt", "POLYGON ((0 0, 20 0, 20 20, 0 20, 0 13, -3 11, -3 9, 0 7, 0 0))");
  const auto fit = [&](const std::string& at, const std::string& towards) {
    return output_of(*this, {"fit", "--sheet", sheet, "--at=" + at, "--towards=" + towards});
  };
  const auto refused = [&](const std::string& at, const std::string& towards) {
    BOOST_CHECK_EXCEPTION(fit(at, towards), InputError,
                          [](const InputError& e) { return names(e, "leads out of the ice"); });
  };
  refused("-3,10", "-1,0");
  refused("-2.99,10", "-1,0");
  refused("-3.5,10", "-1,0");
  refused("20,10", "1,0.2");
  BOOST_TEST(fit("-3,10", "1,0")["b"].get<double>() > 1.0);
  fit("-3.5,10", "1,0");  // a place beside the edge
  fit("-2.5,10", "1,0");
  fit("-3,9", "1,0.1");  // a corner
  fit("20,10", "-1,0");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
}  // namespace brash::cli
