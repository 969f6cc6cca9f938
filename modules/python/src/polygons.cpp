// SPDX-License-Identifier: GPL-3.0-or-later
#include "polygons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "brash/core/error.hpp"
#include "brash/geometry/lines.hpp"
#include "brash/geometry/text.hpp"
#include "convert.hpp"

namespace brash::python {
namespace {

using geometry::Polygon;

/// Polygons of a text. Where a map names sheet and floes, the floes are not part of the sheet, and read_map() gives
/// them.
std::vector<Polygon> from_text(const std::string& text, const char* name) {
  auto map = geometry::read_polygons(text);
  if (!map) {
    const bool is_far = map.error().what.find("is beyond") != std::string::npos;
    throw InputError(fmt::format("{}: {}{}", name, map.error().what,
                                 is_far ? "; read_map() reads projected maps from an origin" : ""));
  }
  warn_of_left_out(name, map->left_out);
  std::vector<geometry::Feature>& features = map->features;
  const bool is_mixed = std::ranges::any_of(features, [](const auto& f) { return f.kind == "floe"; }) &&
                        std::ranges::any_of(features, [](const auto& f) { return f.kind == "sheet"; });
  std::vector<Polygon> polygons;
  for (geometry::Feature& feature : features)
    if (!is_mixed || feature.kind == "sheet") polygons.push_back(std::move(feature.polygon));
  return polygons;
}

/// A single polygon is accepted when it neither crosses itself nor is empty.
Polygon checked(Polygon polygon, const char* name) {
  if (const auto alone = geometry::IceSheet::from_polygons(std::span(&polygon, 1)); !alone)
    throw InputError(fmt::format("{}: {}", name, alone.error().what));
  return polygon;
}

/// WKT or GeoJSON of a text, of a dictionary or of an object with __geo_interface__; nothing for other values.
std::optional<std::string> text_of_geometry(py::handle value) {
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  const bool has_interface = py::hasattr(value, "__geo_interface__");
  if (!has_interface && !py::isinstance<py::dict>(value)) return std::nullopt;
  const py::object json = has_interface ? value.attr("__geo_interface__") : py::reinterpret_borrow<py::object>(value);
  return py::module_::import("json").attr("dumps")(json).cast<std::string>();
}

/// The polygons that one value represents, or nothing when it represents none.
std::optional<std::vector<Polygon>> polygons_of(py::handle value, const char* name) {
  if (py::isinstance<Polygon>(value)) return std::vector{value.cast<Polygon>()};
  if (const auto text = text_of_geometry(value)) return from_text(*text, name);
  const auto array = ensured<Array>(value);
  if (!array || array.ndim() != 2 || array.shape(1) != 2) return std::nullopt;
  return std::vector{Polygon{geometry::ring(points(value, name)), {}}};  // as it was given: masks and kinds are refused
}

std::vector<geometry::Crack> lines_from_text(const std::string& text, const std::string& name) {
  auto lines = geometry::read_lines(text);
  if (!lines) throw InputError(fmt::format("{}: {}", name, lines.error().what));
  warn_of_left_out(name, lines->left_out);
  if (lines->n_cracks.empty()) throw InputError(fmt::format("{}: holds no line", name));
  return std::move(lines->cracks);
}

std::vector<geometry::Crack> line_through(const std::vector<Vec2>& vertices, const std::string& name) {
  if (vertices.size() < 2) throw InputError(fmt::format("{}: two points at least make a line", name));
  std::vector<geometry::Crack> cracks;
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    const geometry::Crack crack{geometry::snap(vertices[i - 1]), geometry::snap(vertices[i])};
    if (crack.from != crack.to) cracks.push_back(crack);
  }
  return cracks;
}

/// The lines of one value, or nothing when it is none.
std::optional<std::vector<geometry::Crack>> lines_of(py::handle value, const std::string& name) {
  if (const auto text = text_of_geometry(value)) return lines_from_text(*text, name);
  const auto array = ensured<Array>(value);
  if (!array || array.ndim() != 2 || array.shape(1) != 2) return std::nullopt;
  return line_through(points(value, name.c_str()), name);
}

/// Whether a list has geometries or texts, which NumPy may take for arrays.
bool lists_geometries(py::handle value) {
  if (!py::isinstance<py::list>(value) && !py::isinstance<py::tuple>(value)) return false;
  for (const py::handle item : value)
    if (py::isinstance<py::str>(item) || py::isinstance<py::dict>(item) || py::hasattr(item, "__geo_interface__"))
      return true;
  return false;
}

}  // namespace

std::vector<geometry::Crack> to_cracks(py::handle value, const char* name) {
  constexpr const char* kExpected =
      "lines as vertices with shape (n, 2), WKT, GeoJSON, a geometry or a sequence, or ends with shape (n, 2, 2)";
  const bool is_list = lists_geometries(value);
  if (auto line = is_list ? std::nullopt : lines_of(value, name)) return geometry::beyond_free_ends(*std::move(line));
  std::vector<geometry::Crack> cracks;
  const auto array = is_list ? py::reinterpret_steal<Array>(py::handle()) : ensured<Array>(value);
  const bool has_lines = array && array.ndim() == 3 && array.shape(1) > 2 && array.shape(2) == 2;
  if (array && array.size() > 0 && !has_lines) {
    if (array.ndim() != 3 || array.shape(1) != 2 || array.shape(2) != 2)
      throw InputError(fmt::format("{}: has shape {}; {} are expected", name, shape_text(array), kExpected));
    const std::vector<Vec2> ends = points(numbers(value, name).attr("reshape")(-1, 2), name);
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
      cracks.push_back({geometry::snap(ends[i]), geometry::snap(ends[i + 1])});
    return cracks;
  }
  if (!py::isinstance<py::iterable>(value)) throw InputError(fmt::format("{}: {} are expected", name, kExpected));
  std::size_t n = 0;
  for (const py::handle item : value) {
    const std::string place = fmt::format("{}[{}]", name, n++);
    auto line = lines_of(item, place);
    if (!line) throw InputError(fmt::format("{}: {} are expected", place, kExpected));
    cracks.insert(cracks.end(), line->begin(), line->end());
  }
  return geometry::beyond_free_ends(std::move(cracks));
}

void warn_of_left_out(const std::string& name, const std::string& left_out) {
  if (!left_out.empty()) py::module_::import("warnings").attr("warn")(fmt::format("{}: left out: {}", name, left_out));
}

std::vector<Polygon> to_polygons(py::handle value, const char* name) {
  if (auto known = polygons_of(value, name)) return *std::move(known);
  constexpr const char* kExpected = "vertices with shape (n, 2), WKT, GeoJSON, a geometry, or a sequence";
  if (py::isinstance<py::str>(value) || !py::isinstance<py::iterable>(value))
    throw InputError(fmt::format("{}: {} is expected", name, kExpected));
  std::vector<Polygon> polygons;
  for (const py::handle item : value) {
    auto some = polygons_of(item, name);
    if (!some) throw InputError(fmt::format("{}[{}]: {} is expected", name, polygons.size(), kExpected));
    std::ranges::move(*some, std::back_inserter(polygons));
  }
  return polygons;
}

Polygon to_polygon(py::handle value, const char* name) {
  if (py::isinstance<Polygon>(value)) return value.cast<Polygon>();
  std::vector<Polygon> polygons = to_polygons(value, name);
  if (polygons.size() != 1) throw InputError(fmt::format("{}: {} polygons; one is expected", name, polygons.size()));
  return checked(std::move(polygons.front()), name);
}

geometry::Ring to_ring(py::handle value, const char* name) {
  Polygon polygon = to_polygon(value, name);
  if (!polygon.holes.empty()) throw InputError(fmt::format("{}: has a hole; an outline alone is expected", name));
  return std::move(polygon.outline);
}

}  // namespace brash::python
