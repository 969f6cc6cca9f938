// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry_commands.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>

#include "brash/core/constants.hpp"
#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/text.hpp"
#include "brash/core/write_file.hpp"
#include "brash/geometry/ledger.hpp"
#include "brash/geometry/text.hpp"
#include "brash/geometry/trapezoid.hpp"
#include "brash/io/results.hpp"
#include "crack_events.hpp"
#include "file_name.hpp"
#include "map_file.hpp"
#include "messages.hpp"

namespace brash::cli {
namespace {

using geometry::ExactArea;
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
  if (!sheet) refuse_polygons(path, sheet.error().what + " (sheet polygons count from 0)");
  return *std::move(sheet);
}

/// Polygons without holes, each valid by itself, whose overlap with the sheet is cut out.
std::vector<Polygon> read_cutters(const std::string& path, const Origin& origin) {
  const auto map = geometry::read_map(read_text_file(path, "cutters (WKT or GeoJSON)", kMostMebibytes), origin);
  if (!map)
    throw InputError(Complaint{path, map.error().what,
                               "POLYGON or MULTIPOLYGON (WKT) or their like in GeoJSON, in plan metres",
                               "correct the polygon; lines that split the ice go to --along"});
  std::vector<Polygon> polygons;
  for (const Feature& f : map->features) polygons.push_back(f.polygon);
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    const Polygon& cutter = polygons[i];
    const std::string name = fmt::format("cutter {}", i + 1);
    if (!cutter.holes.empty()) {
      throw InputError(
          Complaint{path, name + " has a hole", "polygons without holes", "give its parts as polygons without holes"});
    }
    if (const auto alone = IceSheet::from_polygons(std::span(&cutter, 1)); !alone) {
      refuse_polygons(path, fmt::format("{} is not simple: {}", name, alone.error().what));
    }
  }
  return polygons;
}

/// The rectangle around all ice of the sheet, which is not empty.
geometry::Ring box_around(const IceSheet& sheet) {
  geometry::Extent box;
  for (const Polygon& part : sheet.polygons()) box.add(geometry::extent(part));
  const std::array corners{box.lower, Vec2{box.upper.x, box.lower.y}, box.upper, Vec2{box.lower.x, box.upper.y}};
  return geometry::ring(corners);
}

/// A sheet that is cut again and again, its floes and its ledger.
class CrackRun {
 public:
  CrackRun(IceSheet sheet, const std::vector<Feature>& features) : sheet_(std::move(sheet)) {
    for (const Feature& f : features) {
      if (f.kind != "floe") continue;
      floes_.push_back(f);
      ledger_.floes += geometry::area(f.polygon);
      next_id_ = std::max(next_id_, f.id + 1);
    }
    ledger_.initial = sheet_.area() + ledger_.floes;
  }

  /// @return whether it cut ice, here and below.
  bool apply(const CrackEvent& event, int sides) {
    return book(event.angles ? geometry::cut_circumferential(sheet_, event.centre, event.radius, *event.angles, sides)
                             : geometry::cut_circumferential(sheet_, event.centre, event.radius, event.wedges, sides));
  }
  bool apply(const Polygon& cutter) { return book(sheet_.cut(cutter.outline)); }
  /// Splits all ice of the sheet along the cracks; every part becomes a floe.
  void apply(std::span<const geometry::Crack> cracks) {
    if (sheet_.n_vertices() > 0) book(sheet_.cut(box_around(sheet_), cracks));
  }
  void release() {
    for (Polygon& part : sheet_.release_detached()) add_floe(std::move(part));
  }

  geometry::Ledger ledger() const {
    geometry::Ledger result = ledger_;
    result.sheet = sheet_.area();
    return result;
  }
  std::size_t n_floes() const { return floes_.size(); }
  std::vector<Polygon> sheet() const { return sheet_.polygons(); }

  /// Sheet parts with ids from 0, then the floes in the order of their birth.
  std::vector<Feature> features() const {
    std::vector<Feature> result;
    for (Polygon& part : sheet_.polygons()) {
      result.push_back({std::move(part), "sheet", static_cast<std::int64_t>(result.size())});
    }
    result.insert(result.end(), floes_.begin(), floes_.end());
    return result;
  }

 private:
  void add_floe(Polygon polygon) {
    ledger_.floes += geometry::area(polygon);
    floes_.push_back({std::move(polygon), "floe", next_id_++});
  }
  bool book(geometry::Cut cut) {
    ledger_.snap += cut.snap;
    ledger_.n_rounded += cut.n_rounded;
    for (Polygon& piece : cut.pieces) add_floe(std::move(piece));
    return !cut.pieces.empty();
  }

  IceSheet sheet_;
  std::vector<Feature> floes_;
  geometry::Ledger ledger_;
  std::int64_t next_id_ = 0;
};

std::string ledger_text(const CrackRun& run, const Origin& origin) {
  const geometry::Ledger ledger = run.ledger();
  nlohmann::ordered_json json;
  const auto put = [&](const char* name, ExactArea area) { json[name] = area.to_string(); };
  put("initial", ledger.initial);
  put("sheet", ledger.sheet);
  put("floes", ledger.floes);
  put("crushed", ledger.crushed);
  put("deleted", ledger.deleted);
  put("brash", ledger.brash);
  put("snap", ledger.snap);
  put("missing", ledger.missing());
  json["closes"] = ledger.closes();
  json["n_rounded"] = ledger.n_rounded;
  json["n_sheet_parts"] = run.sheet().size();
  json["n_floes"] = run.n_floes();
  if (origin != Origin{}) json["origin"] = {origin.x.to_string(), origin.y.to_string()};
  return json.dump(2);
}

struct CrackOptions {
  std::string sheet, events, cutters, lines, output, origin;
  int sides = 16;
  bool release_detached = false;
};

/// The vertices of a circle of `sides` chords must not fall together on the grid.
void refuse_small_circle(const std::string& path, double radius, int sides) {
  const double least = geometry::kGridUnit * std::max(8, sides);
  if (radius >= least) return;
  throw InputError(Complaint{path, fmt::format("radius = {} m is too small for --sides {}", radius, sides),
                             fmt::format("at least {:.3g} m", least), "enlarge the radius, or take fewer sides"});
}

void refuse_other_than_one_cut(const CrackOptions& options) {
  const auto n_given = !options.events.empty() + !options.cutters.empty() + !options.lines.empty();
  if (n_given == 1) return;
  throw InputError(Complaint{"crack", n_given == 0 ? "nothing to cut with" : "two things to cut with",
                             "one of --events FILE.csv, --cutters FILE.wkt and --along LINES.wkt",
                             "give one of the three"});
}

/// Counts the cuts of a file that meet no ice.
class MissedCuts {
 public:
  void count(bool has_cut, const std::string& name) {
    ++n_;
    if (!has_cut && n_missed_++ == 0) first_ = name;
  }
  void say_of(const std::string& file, const char* cuts) const {
    if (n_missed_ > 0) say("note: {}: {} of {} {} met no ice, the first is {}\n", file, n_missed_, n_, cuts, first_);
  }

 private:
  std::size_t n_ = 0, n_missed_ = 0;
  std::string first_;
};

void apply_cuts(const CrackOptions& options, const Origin& origin, CrackRun& run) {
  if (!options.lines.empty()) return run.apply(read_lines_file(options.lines, origin));
  MissedCuts missed;
  if (!options.cutters.empty()) {
    int number = 0;
    for (const Polygon& cutter : read_cutters(options.cutters, origin)) {
      missed.count(run.apply(cutter), fmt::format("cutter {}", ++number));
      if (options.release_detached) run.release();
    }
    return missed.say_of(options.cutters, "cutters");
  }
  const std::string text = read_text_file(options.events, "crack events (CSV)", kMostMebibytes);
  for (const CrackEvent& event : read_crack_events(options.events, text, origin)) {
    refuse_small_circle(options.events, event.radius, options.sides);
    missed.count(run.apply(event, options.sides), fmt::format("in line {}", event.line));
    if (options.release_detached) run.release();
  }
  missed.say_of(options.events, "events");
}

void crack(const CrackOptions& options) {
  refuse_other_than_one_cut(options);
  refuse_overwriting(options.output, {options.sheet, options.events, options.cutters, options.lines});
  refuse_replacing_results(options.output);
  if (!options.output.empty()) check_map_name(options.output);
  geometry::Map map = read_map_file(options.sheet, origin_option("crack", options.origin));
  CrackRun run(sheet_of(options.sheet, map.features), map.features);
  apply_cuts(options, map.origin, run);
  map.features = run.features();
  if (!options.output.empty()) write_map_file(options.output, map);
  print_data(ledger_text(run, map.origin) + "\n");
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
  refuse_option(option, text, "is no place", fmt::format("X,Y within +-{} m{}", geometry::kMaxCoordinate, centre));
}

/// The point of the polylines that is nearest to `at`; there is one at least.
Vec2 nearest_point(const std::vector<std::vector<Vec2>>& lines, Vec2 at) {
  Vec2 nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<Vec2>& line : lines) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Vec2 along = line[i] - line[i - 1];
      const double length = dot(along, along);
      const double share = length > 0.0 ? std::clamp(dot(at - line[i - 1], along) / length, 0.0, 1.0) : 0.0;
      const Vec2 point = line[i - 1] + share * along;
      if (norm(point - at) < least) nearest = point, least = norm(point - at);
    }
  }
  return nearest;
}

/// Refuses a direction out of the ice. From a place on the edge the ice begins at once; from one beside it, somewhere
/// within the reach.
void refuse_way_out(const IceSheet& sheet, const FitOptions& options, Vec2 at, Vec2 towards) {
  constexpr double kBesideEdge = 0.01, kAtOnce = 0.1;  // of the reach
  constexpr int kSteps = 100;
  const Vec2 edge = nearest_point(sheet.free_edge(at, options.reach), at);
  const bool on_edge = norm(edge - at) <= kBesideEdge * options.reach;
  const double way = (on_edge ? kAtOnce : 1.0) * options.reach;
  for (int i = 1; i <= kSteps; ++i)
    if (sheet.contains((on_edge ? edge : at) + (way * i / kSteps) * towards)) return;
  refuse_option("--towards", options.towards, "leads out of the ice", "X,Y from --at into the ice");
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
  if (!(norm(towards) > 0.0)) refuse_option("--towards", options.towards, "is no direction", "X,Y other than 0,0");
  for (const double way : {at.x, at.y}) {
    if (std::abs(way) + 2.0 * options.reach > geometry::kMaxCoordinate) {
      refuse_option("--at", options.at, fmt::format("is too far out for --reach {}", options.reach),
                    fmt::format("a window within +-{} m", geometry::kMaxCoordinate));
    }
  }

  const IceSheet sheet = sheet_of(options.sheet, map.features);
  if (sheet.free_edge(at, options.reach).empty()) {
    refuse_option("--at", options.at, fmt::format("has no free edge within {} m of it", options.reach),
                  "a place at an edge of the sheet");
  }
  refuse_way_out(sheet, options, at, normalized(towards));
  const geometry::Trapezoid found = geometry::fit_trapezoid(
      sheet,
      {.at = at, .towards = normalized(towards), .contact_length = options.contact_length, .reach = options.reach});

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
  command->add_option("--sheet", options->sheet, "sheet (GeoJSON or WKT); floes in it are passed on")->required();
  auto* const events =
      command->add_option("--events", options->events, "crack events: CSV x,y,radius,wedges[,angles] in m and rad");
  command->add_option("--cutters", options->cutters,
                      "polygons (WKT or GeoJSON), the sheet loses the ice inside each, as a floe");
  auto* const along = command->add_option("--along,--cracks", options->lines,
                                          "lines (WKT or GeoJSON) that split the sheet; every part becomes a floe");
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
      "         brash crack --sheet floes.geojson --along lines.wkt -o pieces.geojson");
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
