// SPDX-License-Identifier: GPL-3.0-or-later
// Maps in projected coordinates, and the sizes of pieces.
#include <fmt/format.h>

#include "brash/analysis/pieces.hpp"
#include "brash/geometry/repair.hpp"
#include "brash/geometry/text.hpp"
#include "brash/report/pictures.hpp"
#include "convert.hpp"
#include "notes.hpp"
#include "polygons.hpp"
#include "rooms.hpp"
#include "signals.hpp"

namespace brash::python {
namespace {

using geometry::Map;
using geometry::Polygon;

std::string written(py::handle number) { return py::str(number).cast<std::string>(); }

/// Two whole numbers, texts or decimal.Decimal: a float far from zero no longer holds the grid, and is as it is
/// printed.
geometry::Origin origin_from(const py::object& value) {
  if (py::isinstance<py::str>(value) || !py::isinstance<py::sequence>(value) || py::len(value) != 2)
    throw InputError("origin: two numbers are expected");
  const auto origin = geometry::origin_from_text(written(value[py::int_(0)]) + ',' + written(value[py::int_(1)]));
  if (!origin) throw InputError("origin: two numbers of metres below 10^15 are expected");
  return *origin;
}

Map read(const std::string& text, const py::object& origin) {
  const auto given = origin.is_none() ? std::nullopt : std::optional(origin_from(origin));
  auto map = geometry::read_map(text, given);
  if (!map) throw InputError("text: " + map.error().what);
  warn_of_left_out("text", map->left_out);
  if (const auto faults = geometry::own_faults_of(geometry::polygons_of(map->features)); !faults.empty())
    throw InputError("text: " + geometry::text_of(faults));
  return *std::move(map);
}

py::tuple origin_of(const Map& map) {
  const py::object decimal = py::module_::import("decimal").attr("Decimal");
  return py::make_tuple(decimal(map.origin.x.to_string()), decimal(map.origin.y.to_string()));
}

std::vector<Polygon> of_kind(const Map& map, const std::string& kind) {
  std::vector<Polygon> polygons;
  for (const geometry::Feature& f : map.features)
    if (f.kind == kind) polygons.push_back(f.polygon);
  return polygons;
}

Map with_polygons(const Map& map, const py::object& sheet, const py::object& floes) {
  Map changed = map;
  changed.features.clear();
  std::int64_t id = 0;
  const auto add = [&](const py::object& polygons, const char* kind, const char* name) {
    for (Polygon& p : to_polygons(polygons, name)) changed.features.push_back({std::move(p), kind, id++});
  };
  add(sheet, "sheet", "sheet");
  add(floes, "floe", "floes");
  return changed;
}

template <typename T>
std::vector<T> members(const Map& map, T geometry::Feature::*member) {
  std::vector<T> all;
  for (const geometry::Feature& f : map.features) all.push_back(f.*member);
  return all;
}

py::object sizes_of(const py::object& pieces, bool born, bool picture) {
  const bool is_path = py::isinstance<py::str>(pieces) || py::hasattr(pieces, "__fspath__");
  const auto read = [&] {
    const auto path = py::module_::import("os").attr("fspath")(pieces).cast<std::string>();
    return unlocked([&] { return analysis::read_piece_sizes(path, born, say_note); });
  };
  const analysis::PieceSizes sizes =
      is_path ? read() : analysis::piece_sizes_of(to_polygons(pieces, "pieces"), "polygons");
  if (sizes.areas.empty()) throw InputError("pieces: there are none");
  const analysis::PieceAnalysis analysis = unlocked([&] { return analysis::analyse_pieces(sizes); });
  py::object out = from_json(analysis::pieces_json(sizes, analysis).dump());
  if (picture) out[py::str("picture")] = report::pieces_picture(sizes, analysis);
  return out;
}

}  // namespace

void add_maps(py::module_& m) {
  py::class_<Map>(m, "Map", "Polygons with their place on the earth. Their coordinates are metres from `origin`.")
      .def_property_readonly(
          "polygons", [](const Map& map) { return members(map, &geometry::Feature::polygon); }, "In the file's order.")
      .def_property_readonly(
          "kinds", [](const Map& map) { return members(map, &geometry::Feature::kind); }, "'sheet' or 'floe' of each.")
      .def_property_readonly(
          "ids", [](const Map& map) { return members(map, &geometry::Feature::id); }, "Number of each.")
      .def_property_readonly("origin", &origin_of, "Zero of the grid in the coordinates of the file: two Decimals [m].")
      .def_property_readonly(
          "crs", [](const Map& map) { return map.crs.empty() ? py::none() : from_json(map.crs); },
          "The member `crs` of the file, or None.")
      .def_readonly("looks_like_degrees", &Map::looks_like_degrees,
                    "Nothing says what the coordinates are, and all could be longitudes and latitudes.")
      .def_property_readonly(
          "sheet", [](const Map& map) { return of_kind(map, "sheet"); }, "The polygons of the kind 'sheet'.")
      .def_property_readonly(
          "floes", [](const Map& map) { return of_kind(map, "floe"); }, "The polygons of the kind 'floe'.")
      .def("with_polygons", &with_polygons, py::arg("sheet"), py::arg("floes"),
           "A map at the same place with other polygons, their ids from 0.")
      .def("to_geojson", &geometry::map_to_geojson, "read_map() gives back the same map.")
      .def("__repr__", [](const Map& map) {
        return fmt::format("<brash.Map of {} polygons, origin {}>", map.features.size(), to_string(map.origin));
      });
  m.def(
      "read_map", &read, py::arg("text"), py::arg("origin") = py::none(),
      "Reads WKT or GeoJSON in projected metres onto the grid around an origin: two whole numbers, texts or Decimals. "
      "Without one it is the file's own, 0, or the middle of the data.");
  m.def("pieces", &sizes_of, py::arg("pieces"), py::arg("born") = false, py::arg("picture") = false,
        "Size distribution of pieces: quantiles, moments, fits with intervals and tests.\n\n"
        "pieces: the path of a map or a run, or polygons. born: of a run, every floe that was born. picture: adds the "
        "drawing (SVG) as 'picture'.");
}

}  // namespace brash::python
