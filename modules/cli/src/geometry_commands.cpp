// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "brash/analysis/crack_run.hpp"
#include "brash/core/constants.hpp"
#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/text.hpp"
#include "brash/core/write_file.hpp"
#include "brash/formats/maps.hpp"
#include "brash/geometry/lines.hpp"
#include "brash/geometry/repair.hpp"
#include "brash/geometry/text.hpp"
#include "brash/geometry/trapezoid.hpp"
#include "brash/io/file_names.hpp"
#include "brash/io/results.hpp"
#include "commands.hpp"
#include "files.hpp"
#include "messages.hpp"

namespace brash::cli {
namespace {

using analysis::CrackRun;
using geometry::Feature;
using geometry::IceSheet;
using geometry::Origin;
using geometry::Polygon;

IceSheet sheet_of(const std::string& path, const std::vector<Feature>& features) {
  std::vector<Polygon> ice;
  for (const Feature& f : features) {
    if (f.kind == "sheet") ice.push_back(f.polygon);
  }
  auto sheet = IceSheet::from_polygons(ice);
  if (!sheet) formats::refuse_polygons(path, sheet.error().what + " (sheet polygons count from 0)");
  return *std::move(sheet);
}

/// Floes may overlap each other and the sheet, but not themselves.
void refuse_crossed_floes(const std::string& path, const std::vector<Feature>& features) {
  std::vector<Polygon> floes;
  for (const Feature& f : features)
    if (f.kind == "floe") floes.push_back(f.polygon);
  if (const auto faults = geometry::own_faults_of(floes); !faults.empty())
    formats::refuse_polygons(path, geometry::text_of(faults) + " (floes count from 0)");
}

/// A map and the file that it comes from.
struct SheetFile {
  std::string path;
  geometry::Map map;
};

/// Lines and cutters lie on the ice of the sheet only if both count from one place.
void refuse_other_crs(const std::string& path, const std::string& crs, const SheetFile& sheet) {
  const std::string own = geometry::name_of_crs(crs), name = geometry::name_of_crs(sheet.map.crs);
  if (own.empty() || name.empty() || geometry::are_same_crs(own, name)) return;
  throw InputError(Complaint{path, fmt::format("has the crs {}, and {} has {}", own, sheet.path, name),
                             "one coordinate reference system for all files of a command",
                             "project one of the files (ogr2ogr -t_srs EPSG:CODE), or correct its crs"});
}

/// Polygons without holes, each valid on its own, whose overlap with the sheet is cut out.
std::vector<Polygon> read_cutters(const std::string& path, const SheetFile& sheet) {
  const auto map =
      geometry::read_map(read_characters(path, "cutters (WKT or GeoJSON)", formats::kMostMebibytes), sheet.map.origin);
  if (!map)
    throw InputError(Complaint{path, map.error().what,
                               "POLYGON or MULTIPOLYGON (WKT) or their like in GeoJSON, in plan metres",
                               "correct the polygon; lines that split the ice go to --along"});
  say_left_out(path, map->left_out);
  refuse_other_crs(path, map->crs, sheet);
  std::vector<Polygon> polygons = geometry::polygons_of(map->features);
  for (std::size_t i = 0; i < polygons.size(); ++i)
    if (!polygons[i].holes.empty())
      throw InputError(Complaint{path, fmt::format("cutter {} has a hole", i + 1), "polygons without holes",
                                 "give its parts as polygons without holes"});
  if (const auto faults = geometry::own_faults_of(polygons); !faults.empty())
    formats::refuse_polygons(path, geometry::text_of(faults) + " (cutters count from 0)");
  return polygons;
}

geometry::Lines read_lines(const std::string& path, const SheetFile& sheet) {
  auto lines =
      geometry::read_lines(read_characters(path, "lines (WKT or GeoJSON)", formats::kMostMebibytes), sheet.map.origin);
  if (!lines)
    throw InputError(Complaint{path, lines.error().what,
                               "LINESTRING or MULTILINESTRING (WKT) or their like in GeoJSON, in plan metres",
                               "correct the line; areas to take out are polygons and go to --cutters"});
  say_left_out(path, lines->left_out);
  refuse_other_crs(path, lines->crs, sheet);
  lines->cracks = geometry::beyond_free_ends(std::move(lines->cracks));
  return *std::move(lines);
}

struct CrackOptions {
  std::string sheet, events, cutters, lines, output, origin;
  int sides = 16;
  bool release_detached = false, unites = false, repairs = false;
};

/// The vertices of a circle of `sides` chords must not fall together on the grid.
void refuse_small_circle(const std::string& path, double radius, int sides) {
  const double least = geometry::kGridUnit * std::max(8, sides);
  if (radius >= least) return;
  throw InputError(Complaint{path, fmt::format("radius = {} m is too small for --sides {}", radius, sides),
                             fmt::format("at least {:.3g} m", least), "enlarge the radius, or take fewer sides"});
}

void refuse_other_than_one_cut(const CrackOptions& options) {
  const auto n_given =
      !options.events.empty() + !options.cutters.empty() + !options.lines.empty() + options.unites + options.repairs;
  if (n_given == 1) return;
  throw InputError(Complaint{"crack", n_given == 0 ? "nothing to do" : "two things to do",
                             "one of --events FILE.csv, --cutters FILE.wkt, --along LINES.wkt, --union and --repair",
                             "give one of the five"});
}

/// Counts the cuts of a file that miss their aim.
class MissedCuts {
 public:
  void count(bool has_cut, const std::string& name) {
    ++n_;
    if (!has_cut && n_missed_++ == 0) first_ = name;
  }
  void say_of(const std::string& file, const char* cuts, const char* fate = "met no ice") const {
    if (n_missed_ > 0) say("note: {}: {} of {} {} {}, the first is {}\n", file, n_missed_, n_, cuts, fate, first_);
  }

 private:
  std::size_t n_ = 0, n_missed_ = 0;
  std::string first_;
};

void apply_lines(const std::string& path, const SheetFile& sheet, CrackRun& run) {
  const geometry::Lines lines = read_lines(path, sheet);
  if (lines.n_cracks.empty()) say("note: {}: holds no line\n", path);
  MissedCuts missed, tails;
  int number = 0;
  for (const bool has_cut : analysis::lines_inside(lines, sheet.map.features))
    missed.count(has_cut, fmt::format("line {}", ++number));
  run.apply(lines.cracks);
  number = 0;
  for (const bool has_tail : analysis::lines_inside(lines, run.features()))
    tails.count(!has_tail, fmt::format("line {}", ++number));
  missed.say_of(path, "lines");
  tails.say_of(path, "lines", "left a tail that ends inside the ice and splits nothing");
}

void apply_cuts(const CrackOptions& options, const SheetFile& sheet, CrackRun& run) {
  if (!options.lines.empty()) return apply_lines(options.lines, sheet, run);
  if (!run.has_sheet() && run.n_floes() > 0)
    say("note: {}: holds floes only, and {} cuts the sheet; --along splits floes too\n", sheet.path,
        options.cutters.empty() ? "--events" : "--cutters");
  MissedCuts missed;
  if (!options.cutters.empty()) {
    int number = 0;
    for (const Polygon& cutter : read_cutters(options.cutters, sheet)) {
      missed.count(run.apply(cutter), fmt::format("cutter {}", ++number));
      if (options.release_detached) run.release();
    }
    return missed.say_of(options.cutters, "cutters");
  }
  const std::string text = read_characters(options.events, "crack events (CSV)", formats::kMostMebibytes);
  for (const analysis::CrackEvent& event : analysis::read_crack_events(options.events, text, sheet.map.origin)) {
    refuse_small_circle(options.events, event.radius, options.sides);
    missed.count(run.apply(event, options.sides), fmt::format("in line {}", event.line));
    if (options.release_detached) run.release();
  }
  missed.say_of(options.events, "events");
}

void crack(const CrackOptions& options) {
  refuse_other_than_one_cut(options);
  refuse_overwriting(options.output, {options.sheet, options.events, options.cutters, options.lines});
  io::refuse_replacing_results(options.output);
  if (!options.output.empty()) formats::check_map_name(options.output);
  SheetFile sheet{options.sheet, read_map_file(options.sheet, origin_option("crack", options.origin))};
  geometry::Map& map = sheet.map;
  if (options.unites || options.repairs) {
    const std::string ledger =
        options.unites ? formats::unite_map(options.sheet, map, say_note) : formats::repair_map(options.sheet, map);
    if (!options.output.empty()) write_map_file(options.output, map);
    print_data(ledger + "\n");
    return say_place(options.sheet, map, !options.origin.empty());
  }
  refuse_crossed_floes(options.sheet, map.features);
  CrackRun run(sheet_of(options.sheet, map.features), map.features);
  apply_cuts(options, sheet, run);
  map.features = run.features();
  if (!options.output.empty()) write_map_file(options.output, map);
  print_data(formats::ledger_text(run.ledger(), run.sheet().size(), run.n_floes(), map.origin) + "\n");
  say_place(options.sheet, map, !options.origin.empty());
  if (!run.ledger().closes()) {
    throw RunError(fmt::format("crack: the ledger misses {} m2", run.ledger().missing().to_string()));
  }
}

struct FitOptions {
  std::string sheet, at, towards, origin;
  double contact_length = 0.0;
  double reach = 3.0;
};

[[noreturn]] void refuse_option(const std::string& option, const std::string& value, const std::string& what,
                                const std::string& allowed) {
  throw InputError(
      Complaint{"fit", fmt::format("{} = '{}' {}", option, printable(value), what), allowed, "change the option"});
}

/// Reads "X,Y" and takes the origin away.
Vec2 to_vector(const std::string& option, const std::string& text, const Origin& origin) {
  if (const auto place = geometry::origin_from_text(text)) {
    const Vec2 result{(place->x - origin.x).nearest_double(), (place->y - origin.y).nearest_double()};
    if (std::abs(result.x) <= geometry::kMaxCoordinate && std::abs(result.y) <= geometry::kMaxCoordinate) return result;
  }
  const std::string centre = origin == Origin{} ? "" : " of the origin " + to_string(origin);
  refuse_option(option, text, "is not a place", fmt::format("X,Y within +-{} m{}", geometry::kMaxCoordinate, centre));
}

void fit(const FitOptions& options) {
  constexpr double kLeastReach = 1e-6;  // [m], a thousand units of the grid
  if (!(options.reach >= kLeastReach && options.reach <= geometry::kMaxCoordinate)) {
    refuse_option("--reach", fmt::format("{}", options.reach), "is out of range",
                  fmt::format("metres from {} to {}", kLeastReach, geometry::kMaxCoordinate));
  }
  if (!(options.contact_length >= 0.0 && std::isfinite(options.contact_length))) {
    refuse_option("--contact-length", fmt::format("{}", options.contact_length), "is out of range",
                  "metres, at least 0");
  }
  const geometry::Map map = read_map_file(options.sheet, origin_option("fit", options.origin));
  const Vec2 at = to_vector("--at", options.at, map.origin), towards = to_vector("--towards", options.towards, {});
  if (!(norm(towards) > 0.0)) refuse_option("--towards", options.towards, "is not a direction", "X,Y other than 0,0");
  for (const double way : {at.x, at.y}) {
    if (std::abs(way) + 2.0 * options.reach > geometry::kMaxCoordinate) {
      refuse_option("--at", options.at, fmt::format("is too far out for --reach {}", options.reach),
                    fmt::format("a window within +-{} m", geometry::kMaxCoordinate));
    }
  }

  const IceSheet sheet = sheet_of(options.sheet, map.features);
  if (sheet.n_vertices() == 0)
    throw InputError(Complaint{options.sheet, map.features.empty() ? "holds no ice" : "holds floes only, and no sheet",
                               "a map with a polygon of the kind sheet, whose free edge is fitted",
                               "give the map of a sheet, or write \"kind\": \"sheet\" for the floe to fit"});
  if (sheet.free_edge(at, options.reach).empty()) {
    refuse_option("--at", options.at, fmt::format("has no free edge within {} m of it", options.reach),
                  "a place at an edge of the sheet");
  }
  const geometry::FitRequest request{
      .at = at, .towards = normalized(towards), .contact_length = options.contact_length, .reach = options.reach};
  if (!geometry::leads_into_ice(sheet, request))
    refuse_option("--towards", options.towards, "leads out of the ice", "X,Y from --at into the ice");
  const geometry::Trapezoid found = geometry::fit_trapezoid(sheet, request);

  const nlohmann::ordered_json json{{"b", found.depth},      {"c", found.contact_length},
                                    {"theta", found.angle},  {"theta_deg", degrees(found.angle)},
                                    {"error", found.error},  {"reidentified", found.reidentified},
                                    {"reach", options.reach}};
  print_data(json.dump(2) + "\n");
  say_place(options.sheet, map, !options.origin.empty());
}

}  // namespace

void add_crack_command(CLI::App& app) {
  auto options = std::make_shared<CrackOptions>();
  CLI::App* command = app.add_subcommand("crack", "Crack a sheet: the geometry kernel alone");
  command->add_option("--sheet", options->sheet, "sheet (GeoJSON or WKT); only --along cuts floes in it")->required();
  auto* const events =
      command->add_option("--events", options->events, "crack events: CSV x,y,radius,wedges[,angles] in m and rad");
  command->add_option("--cutters", options->cutters,
                      "polygons (WKT or GeoJSON), the sheet loses the ice inside each, as a floe");
  auto* const along =
      command->add_option("--along,--cracks", options->lines,
                          "lines (WKT or GeoJSON) that split sheet and floes; every part becomes a floe");
  command->add_flag("--union", options->unites, "unite the polygons of the sheet, and of the floes; cuts nothing");
  command->add_flag(
      "--repair", options->repairs,
      "remove crossings and overlaps of the sheet's polygons and floes, and say what changed; cuts nothing");
  command->add_option("-o,--output", options->output,
                      "sheet and floes to write (.geojson, or .wkt without their kinds)");
  command->add_option(
      "--origin", options->origin,
      "X,Y: zero of the grid in the coordinates of the file; else the file's own, or the middle of data "
      "that are far from 0,0");
  command->add_option("--sides", options->sides, "chords of a full circle of --events")
      ->capture_default_str()
      ->needs(events)
      ->check(CLI::Range(3, 100000));
  command
      ->add_flag("--release", options->release_detached,
                 "make every part but the largest a floe after each cut; else parts stay in the sheet")
      ->excludes(along);
  command->footer(
      "Prints the ledger as JSON, areas in m2 as exact text.\n"
      "Example: brash crack --sheet sheet.wkt --events events.csv -o pieces.geojson\n"
      "         brash crack --sheet floes.geojson --along lines.wkt -o pieces.geojson\n"
      "         brash crack --sheet scenes.geojson --union -o ice.geojson\n"
      "         brash crack --sheet drawn.geojson --repair -o sound.geojson");
  command->callback([options] { crack(*options); });
}

void add_fit_command(CLI::App& app) {
  auto options = std::make_shared<FitOptions>();
  CLI::App* command = app.add_subcommand("fit", "Fit the trapezoid (b, c, theta) of the free edge at a point");
  command->add_option("--sheet", options->sheet, "sheet (GeoJSON or WKT)")->required();
  command->add_option("--origin", options->origin, "X,Y: zero of the grid, as for brash crack");
  command->add_option("--at", options->at, "X,Y: collision point B on the free edge [m]")->required();
  command->add_option("--towards", options->towards, "X,Y: direction from B into the ice, of any length")->required();
  command->add_option("--contact-length", options->contact_length, "contact length c [m]; 0: find it")
      ->capture_default_str();
  command
      ->add_option("--reach", options->reach,
                   "half the width of the window [m], about a characteristic length; a run takes two")
      ->capture_default_str();
  command->footer(
      "Prints b and c in m, theta in rad and deg, and the error, as JSON.\n"
      "Example: brash fit --sheet sheet.wkt --at 0,0.5 --towards 1,0");
  command->callback([options] { fit(*options); });
}

}  // namespace brash::cli
