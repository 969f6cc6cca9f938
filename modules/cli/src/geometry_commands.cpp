// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry_commands.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "brash/core/constants.hpp"
#include "brash/core/error.hpp"
#include "brash/geometry/ledger.hpp"
#include "brash/geometry/text.hpp"
#include "brash/geometry/trapezoid.hpp"
#include "brash/io/results.hpp"
#include "crack_events.hpp"

namespace brash::cli {
namespace {

using geometry::ExactArea;
using geometry::Feature;
using geometry::IceSheet;
using geometry::Polygon;

std::string read_text(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  // A folder opens, and is bad when it is read; an empty file inserts nothing, which `<<` would count as a failure.
  if (stream && stream.peek() == std::ifstream::traits_type::eof()) {
    if (!stream.bad()) return {};
  } else if (stream && text << stream.rdbuf()) {
    return text.str();
  }
  throw InputError(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
}

/// The features of a GeoJSON text, or the polygons of a WKT text as sheet.
std::vector<Feature> read_features(const std::string& path) {
  const std::string text = read_text(path);
  const std::size_t first = text.find_first_not_of(" \t\r\n\xef\xbb\xbf");
  if (first != std::string::npos && text[first] == '{') {
    auto features = geometry::from_geojson(text);
    if (!features) throw InputError(fmt::format("{}, {}", path, features.error().what));
    return *std::move(features);
  }
  auto polygons = geometry::from_wkt(text);
  if (!polygons) throw InputError(fmt::format("{}, {}", path, polygons.error().what));
  std::vector<Feature> features;
  for (Polygon& p : *polygons) {
    features.push_back({std::move(p), "sheet", static_cast<std::int64_t>(features.size())});
  }
  return features;
}

IceSheet sheet_of(const std::string& path, const std::vector<Feature>& features) {
  std::vector<Polygon> ice;
  for (const Feature& f : features) {
    if (f.kind == "sheet") ice.push_back(f.polygon);
  }
  auto sheet = IceSheet::from_polygons(ice);
  if (!sheet) throw InputError(fmt::format("{}: {} (sheet polygons count from 0)", path, sheet.error().what));
  return *std::move(sheet);
}

/// Polygons without holes, each valid by itself, whose overlap with the sheet is cut out.
std::vector<Polygon> read_cutters(const std::string& path) {
  auto polygons = geometry::from_wkt(read_text(path));
  if (!polygons) throw InputError(fmt::format("{}, {}", path, polygons.error().what));
  for (std::size_t i = 0; i < polygons->size(); ++i) {
    const Polygon& cutter = (*polygons)[i];
    const std::string name = fmt::format("{}: cutter {}", path, i + 1);
    if (!cutter.holes.empty()) throw InputError(name + " has a hole; give its parts as polygons without holes");
    if (const auto alone = IceSheet::from_polygons(std::span(&cutter, 1)); !alone) {
      throw InputError(fmt::format("{} is not simple: {}", name, alone.error().what));
    }
  }
  return *std::move(polygons);
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

  void apply(const CrackEvent& event, int sides) {
    book(event.angles ? geometry::cut_circumferential(sheet_, event.centre, event.radius, *event.angles, sides)
                      : geometry::cut_circumferential(sheet_, event.centre, event.radius, event.wedges, sides));
  }
  void apply(const Polygon& cutter) { book(sheet_.cut(cutter.outline)); }
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
  void book(geometry::Cut cut) {
    ledger_.snap += cut.snap;
    ledger_.n_rounded += cut.n_rounded;
    for (Polygon& piece : cut.pieces) add_floe(std::move(piece));
  }

  IceSheet sheet_;
  std::vector<Feature> floes_;
  geometry::Ledger ledger_;
  std::int64_t next_id_ = 0;
};

std::string ledger_text(const CrackRun& run) {
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
  return json.dump(2);
}

struct CrackOptions {
  std::string sheet, events, cutters, output;
  int sides = 16;
  bool release_detached = false;
};

void crack(const CrackOptions& options) {
  if (options.events.empty() == options.cutters.empty()) {
    throw InputError("crack: give either --events FILE.csv or --cutters FILE.wkt");
  }
  const std::vector<Feature> features = read_features(options.sheet);
  CrackRun run(sheet_of(options.sheet, features), features);
  if (!options.events.empty()) {
    for (const CrackEvent& event : read_crack_events(options.events, read_text(options.events))) {
      run.apply(event, options.sides);
      if (options.release_detached) run.release();
    }
  } else {
    for (const Polygon& cutter : read_cutters(options.cutters)) {
      run.apply(cutter);
      if (options.release_detached) run.release();
    }
  }
  if (!options.output.empty()) io::write_file(options.output, geometry::to_geojson(run.features()));
  fmt::print("{}\n", ledger_text(run));
  if (!run.ledger().closes()) {
    throw RunError(fmt::format("crack: the ledger misses {} m2", run.ledger().missing().to_string()));
  }
}

struct FitOptions {
  std::string sheet, at, towards;
  double contact_length = 0.0;
  double reach = 3.0;
};

/// Reads "X,Y".
Vec2 to_vector(const std::string& option, const std::string& text) {
  Vec2 result;
  const char* const end = text.data() + text.size();
  const auto [comma, first] = std::from_chars(text.data(), end, result.x);
  if (first == std::errc{} && comma != end && *comma == ',') {
    const auto [stop, second] = std::from_chars(comma + 1, end, result.y);
    if (second == std::errc{} && stop == end && std::abs(result.x) <= geometry::kMaxCoordinate &&
        std::abs(result.y) <= geometry::kMaxCoordinate) {
      return result;
    }
  }
  throw InputError(fmt::format("fit: {} = '{}': X,Y within +-{} is expected", option, text, geometry::kMaxCoordinate));
}

void fit(const FitOptions& options) {
  if (!(options.reach > 0.0 && options.reach <= geometry::kMaxCoordinate)) {
    throw InputError(fmt::format("fit: --reach = {}: metres above 0 are expected", options.reach));
  }
  if (!(options.contact_length >= 0.0 && std::isfinite(options.contact_length))) {
    throw InputError(
        fmt::format("fit: --contact-length = {}: metres, at least 0, are expected", options.contact_length));
  }
  const Vec2 at = to_vector("--at", options.at), towards = to_vector("--towards", options.towards);
  if (!(norm(towards) > 0.0)) throw InputError("fit: --towards = 0,0: a direction is expected");
  for (const double way : {at.x, at.y}) {
    if (std::abs(way) + 2.0 * options.reach > geometry::kMaxCoordinate) {
      throw InputError(fmt::format("fit: --at = '{}' with --reach {}: the window must stay within +-{} m", options.at,
                                   options.reach, geometry::kMaxCoordinate));
    }
  }

  const IceSheet sheet = sheet_of(options.sheet, read_features(options.sheet));
  if (sheet.free_edge(at, options.reach).empty()) {
    throw InputError(fmt::format("fit: --at = '{}': no free edge within {} m of it", options.at, options.reach));
  }
  const geometry::Trapezoid found = geometry::fit_trapezoid(
      sheet,
      {.at = at, .towards = normalized(towards), .contact_length = options.contact_length, .reach = options.reach});

  const nlohmann::ordered_json json{{"b", found.depth},      {"c", found.contact_length},
                                    {"theta", found.angle},  {"theta_deg", degrees(found.angle)},
                                    {"error", found.error},  {"reidentified", found.reidentified},
                                    {"reach", options.reach}};
  fmt::print("{}\n", json.dump(2));
}

}  // namespace

void add_crack_command(CLI::App& app) {
  auto options = std::make_shared<CrackOptions>();
  CLI::App* command = app.add_subcommand("crack", "Crack a sheet: the geometry kernel alone");
  command->add_option("--sheet", options->sheet, "sheet (GeoJSON or WKT); floes in it are passed on")->required();
  command->add_option("--events", options->events, "crack events: CSV x,y,radius,wedges[,angles] in m and rad");
  command->add_option("--cutters", options->cutters, "polygons (WKT), each takes its overlap out of the sheet");
  command->add_option("-o,--output", options->output, "sheet and floes to write (GeoJSON)");
  command->add_option("--sides", options->sides, "chords of a full circle")
      ->capture_default_str()
      ->check(CLI::Range(3, 100000));
  command->add_flag("--release", options->release_detached,
                    "make every part but the largest a floe after each cut; else parts stay in the sheet");
  command->footer(
      "Prints the ledger as JSON, areas in m2 as exact text.\n"
      "Example: brash crack --sheet sheet.wkt --events events.csv -o pieces.geojson");
  command->callback([options] { crack(*options); });
}

void add_fit_command(CLI::App& app) {
  auto options = std::make_shared<FitOptions>();
  CLI::App* command = app.add_subcommand("fit", "Fit the trapezoid (b, c, theta) of the free edge at a point");
  command->add_option("--sheet", options->sheet, "sheet (GeoJSON or WKT)")->required();
  command->add_option("--at", options->at, "X,Y: collision point B on the free edge [m]")->required();
  command->add_option("--towards", options->towards, "X,Y: direction from B into the ice, of any length")->required();
  command->add_option("--contact-length", options->contact_length, "contact length c [m]; 0: find it")
      ->capture_default_str();
  command->add_option("--reach", options->reach, "half the width of the window [m], about a characteristic length")
      ->capture_default_str();
  command->footer(
      "Prints b and c in m, theta in rad and deg, and the error, as JSON.\n"
      "Example: brash fit --sheet sheet.wkt --at 0,0.5 --towards 1,0");
  command->callback([options] { fit(*options); });
}

}  // namespace brash::cli
