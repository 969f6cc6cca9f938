// SPDX-License-Identifier: GPL-3.0-or-later
#include "polygons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "brash/core/error.hpp"
#include "brash/geometry/ice_sheet.hpp"
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

/// The polygons that one value represents, or nothing when it represents none.
std::optional<std::vector<Polygon>> polygons_of(py::handle value, const char* name) {
  if (py::isinstance<Polygon>(value)) return std::vector{value.cast<Polygon>()};
  if (py::isinstance<py::str>(value)) return from_text(value.cast<std::string>(), name);
  if (py::hasattr(value, "__geo_interface__")) {
    const py::object text = py::module_::import("json").attr("dumps")(value.attr("__geo_interface__"));
    return from_text(text.cast<std::string>(), name);
  }
  if (py::isinstance<py::dict>(value))
    return from_text(py::module_::import("json").attr("dumps")(value).cast<std::string>(), name);
  const auto array = ensured<Array>(value);
  if (!array || array.ndim() != 2 || array.shape(1) != 2) return std::nullopt;
  return std::vector{Polygon{geometry::ring(points(value, name)), {}}};  // as it was given: masks and kinds are refused
}

}  // namespace

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
