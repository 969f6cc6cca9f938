// SPDX-License-Identifier: GPL-3.0-or-later
// The rooms' arrows, read from the includes: a room may include itself and the rooms in its row, nothing else.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

struct Room {
  std::string folder;
  Names may_include;         ///< rooms, by the folder under include/brash/
  Names libraries;           ///< third-party libraries its sources may include
  Names public_libraries{};  ///< the ones of them that its public headers may include too
};

const std::map<std::string, Room> kRooms{
    {"core", {"modules/core", {}, {"nettle"}}},
    {"netcdf", {"modules/netcdf", {"core"}, {"netcdf", "hdf5"}}},
    {"geometry", {"geometry", {"core"}, {"CGAL", "GMP", "json"}}},
    {"plate", {"failure/plate", {"core"}, {"CGAL", "Eigen"}}},
    {"meta_model", {"failure/meta_model", {"core", "plate"}, {"Eigen", "json"}}},
    {"failure", {"failure/criterion", {"core", "model", "plate", "meta_model"}, {}}},
    // Makes models; the rooms of a run do without it.
    {"training",
     {"failure/training",
      {"core", "failure", "meta_model", "model", "netcdf", "plate"},
      {"gsl", "Eigen", "netcdf", "toml"}}},
    {"model", {"modules/model", {"core", "geometry"}, {}}},
    {"structure", {"modules/structure", {"core", "model", "hydrodynamics"}, {"CGAL", "Eigen", "clipper"}}},
    {"hydrodynamics", {"modules/hydrodynamics", {"core", "model"}, {}}},
    {"rigid_body", {"modules/rigid_body", {"core"}, {"Bullet", "CGAL"}}},
    {"statistics", {"modules/statistics", {"core"}, {"gsl"}}},
    {"standards", {"modules/standards", {"core"}, {"gsl"}}},
    {"ice", {"modules/ice", {"core", "geometry", "failure", "model", "statistics"}, {"CGAL", "Eigen", "json"}}},
    {"io",
     {"modules/io",
      {"core", "geometry", "model", "netcdf", "standards", "structure"},
      {"toml", "netcdf", "udunits", "json"}}},
    {"formats", {"modules/formats", {"core", "geometry", "model", "io", "structure"}, {"json", "minizip", "zlib"}}},
    // Its results are JSON documents.
    {"analysis",
     {"modules/analysis",
      {"core", "formats", "geometry", "io", "model", "simulation", "standards", "statistics", "structure"},
      {"json"},
      {"json"}}},
    {"report",
     {"modules/report",
      {"analysis", "core", "io", "model", "recording", "simulation", "statistics", "structure"},
      {"json", "zlib"}}},
    {"live", {"modules/live", {"core"}, {"beast"}}},
    {"floes",
     {"modules/floes", {"core", "geometry", "hydrodynamics", "ice", "model", "rigid_body", "structure"}, {"Eigen"}}},
    {"edge", {"modules/edge", {"core", "failure", "floes", "geometry", "ice", "model", "rigid_body", "structure"}, {}}},
    {"simulation",
     {"modules/simulation",
      {"core", "edge", "failure", "floes", "geometry", "hydrodynamics", "ice", "model", "rigid_body", "statistics",
       "structure"},
      {"json"}}},
    // Warnings. It makes the run's summary whole.
    {"advice", {"modules/advice", {"core", "failure", "geometry", "ice", "model", "simulation", "structure"}, {}}},
    {"simulator",
     {"modules/simulator",
      {"advice", "core", "failure", "model", "geometry", "io", "report", "simulation", "structure"},
      {"json"}}},
    {"fmu", {"modules/fmu", {"core", "failure", "model", "simulation", "structure"}, {"json"}}},
    {"recording", {"modules/recording", {"core", "model", "io", "simulation", "failure"}, {"json"}}},
    {"campaign",
     {"modules/campaign", {"advice", "core", "model", "io", "recording", "simulation", "statistics"}, {"json"}}},
    // Skins: nothing includes them.
    {"simulator/web", {"modules/simulator/web", {"analysis", "core", "io", "simulator"}, {"json"}}},
    {"python",
     {"modules/python",
      {"advice", "analysis", "campaign", "core", "failure", "formats", "geometry", "io", "model", "recording", "report",
       "simulation", "standards", "statistics", "structure"},
      {"pybind11"}}},
    {"cli",
     {"modules/cli",
      {"advice", "analysis", "campaign", "core", "failure", "fmu", "formats", "geometry", "io", "live", "meta_model",
       "model", "plate", "recording", "report", "simulation", "simulator", "structure", "training"},
      {"CLI11", "json"}}},
};

/// The one public header that may include a third-party library: it converts to and from CGAL's polygons.
const std::string kConversions = "geometry/include/brash/geometry/cgal.hpp";

/// How the include line of each third-party library begins.
const std::map<std::string, std::regex> kLibraries{
    {"CGAL", std::regex("^CGAL/")},
    {"GMP", std::regex("^gmp")},
    {"Eigen", std::regex("^Eigen/")},
    {"gsl", std::regex("^gsl/")},
    {"Bullet", std::regex("^(bt[A-Z]|Bullet|LinearMath)")},
    {"netcdf", std::regex("^netcdf")},
    {"hdf5", std::regex("^hdf5")},
    {"toml", std::regex("^toml")},
    {"udunits", std::regex("^udunits2")},
    {"json", std::regex("^nlohmann/")},
    {"nettle", std::regex("^nettle/")},
    {"zlib", std::regex("^zlib\\.h")},
    {"minizip", std::regex("^zip\\.h")},
    {"CLI11", std::regex("^CLI/")},
    {"pybind11", std::regex("^pybind11/")},
    {"clipper", std::regex("^polyclipping/")},
    {"beast", std::regex("^boost/(asio|beast)")},
};

std::vector<std::string> includes_of(const fs::path& file) {
  static const std::regex include("^\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"]");
  std::vector<std::string> names;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);)
    if (std::smatch match; std::regex_search(line, match, include)) names.push_back(match[1]);
  return names;
}

const fs::path kRoot = BRASH_SOURCE_DIR;

/// Calls `visit` with every file of a room; a folder in it that is a room has its own files.
template <typename Visit>
void for_each_file(const fs::path& folder, Visit visit) {
  for (auto at = fs::recursive_directory_iterator(folder); at != fs::recursive_directory_iterator(); ++at) {
    const auto is_here = [&](const auto& row) { return kRoot / row.second.folder == at->path(); };
    if (at->is_directory() && std::any_of(kRooms.begin(), kRooms.end(), is_here))
      at.disable_recursion_pending();
    else if (at->is_regular_file())
      visit(at->path());
  }
}

template <typename Visit>
void for_each_source(const fs::path& folder, Visit visit) {
  for_each_file(folder, [&](const fs::path& file) {
    const std::string extension = file.extension();
    if (extension == ".hpp" || extension == ".cpp") visit(file);
  });
}

BOOST_AUTO_TEST_CASE(no_room_includes_a_room_that_is_not_in_its_row) {
  static const std::regex brash_include("^brash/([a-z_]+)/");
  int n_arrows = 0;
  for (const auto& [name, room] : kRooms) {
    for_each_source(kRoot / room.folder, [&, &name = name, &room = room](const fs::path& file) {
      for (const std::string& include : includes_of(file)) {
        std::smatch match;
        if (!std::regex_search(include, match, brash_include) || match[1] == name) continue;
        ++n_arrows;
        BOOST_TEST(room.may_include.contains(match[1]), file.string() << " includes " << include);
      }
    });
  }
  BOOST_TEST(n_arrows > 0);
}

BOOST_AUTO_TEST_CASE(no_room_includes_a_path_that_leads_out_of_it) {
  for (const auto& [name, room] : kRooms)
    for_each_source(kRoot / room.folder, [](const fs::path& file) {
      for (const std::string& include : includes_of(file))
        BOOST_TEST(!include.starts_with(".."), file.string() << " includes " << include);
    });
}

BOOST_AUTO_TEST_CASE(no_room_compiles_or_links_the_command) {
  int n_files = 0;
  for (const auto& [name, room] : kRooms) {
    if (name == "cli") continue;
    for_each_file(kRoot / room.folder, [&](const fs::path& file) {
      if (file.filename() != "CMakeLists.txt") return;
      ++n_files;
      std::ifstream stream(file);
      const std::string text(std::istreambuf_iterator<char>(stream), {});
      for (const char* const word : {"brash_commands", "/cli/"})
        BOOST_TEST(text.find(word) == std::string::npos, file.string() << " names " << word);
    });
  }
  BOOST_TEST(n_files > 20);
}

BOOST_AUTO_TEST_CASE(the_rows_have_no_cycle) {
  std::map<std::string, Names> left;
  for (const auto& [name, room] : kRooms) left[name] = room.may_include;
  while (!left.empty()) {
    const auto leaf = std::find_if(left.begin(), left.end(), [&](const auto& row) {
      return std::none_of(row.second.begin(), row.second.end(), [&](const auto& r) { return left.contains(r); });
    });
    BOOST_REQUIRE(leaf != left.end());
    left.erase(leaf);
  }
}

BOOST_AUTO_TEST_CASE(third_party_headers_stay_in_their_rooms_and_out_of_public_headers) {
  for (const auto& [name, room] : kRooms) {
    const fs::path folder = kRoot / room.folder;
    for_each_source(folder, [&, &room = room](const fs::path& file) {
      const bool is_public = fs::relative(file, folder).begin()->string() == "include";
      const bool is_conversions = fs::relative(file, kRoot) == kConversions;
      for (const std::string& include : includes_of(file))
        for (const auto& [library, pattern] : kLibraries)
          if (std::regex_search(include, pattern))
            BOOST_TEST((room.libraries.contains(library) &&
                        (!is_public || is_conversions || room.public_libraries.contains(library))),
                       file.string() << " includes " << include);
    });
  }
}

BOOST_AUTO_TEST_CASE(every_source_begins_with_its_licence) {
  for (const auto& [name, room] : kRooms)
    for_each_source(kRoot / room.folder, [](const fs::path& file) {
      std::ifstream stream(file);
      std::string line;
      std::getline(stream, line);
      BOOST_TEST(line == "// SPDX-License-Identifier: GPL-3.0-or-later", file.string());
    });
}

}  // namespace
