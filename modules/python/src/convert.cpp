// SPDX-License-Identifier: GPL-3.0-or-later
#include "convert.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "brash/core/error.hpp"

namespace brash::python {
namespace {

py::array_t<double> rows_of(std::size_t n, py::ssize_t columns) {
  return py::array_t<double>({static_cast<py::ssize_t>(n), columns});
}

void expect_on_the_grid(Vec2 v, const char* name, const std::string& place) {
  // A NaN fails the comparison.
  if (std::abs(v.x) <= geometry::kMaxCoordinate && std::abs(v.y) <= geometry::kMaxCoordinate) return;
  throw InputError(
      fmt::format("{}{} = ({}, {}): metres within +-{} are expected", name, place, v.x, v.y, geometry::kMaxCoordinate));
}

/// Throws for values that NumPy would cast to numbers with a loss, or without their unit.
void expect_real(const py::array& array, const char* name) {
  const auto refuse = [name](const char* found, const char* remedy) {
    throw InputError(fmt::format("{}: an array of numbers is expected, not of {}; {}", name, found, remedy));
  };
  const char kind = array.dtype().kind();
  if (kind == 'c') refuse("complex numbers", "take their real or their imaginary part");
  if (kind == 'M') refuse("dates", "subtract the first and divide by numpy.timedelta64(1, 's')");
  if (kind == 'm') refuse("durations", "divide them by numpy.timedelta64(1, 's')");
  if (kind == 'U' || kind == 'S') refuse("texts", "convert them with numpy.asarray(..., dtype=float)");
}

/// The coordinates of a point, several points or a line with __geo_interface__, such as shapely's; else the value.
py::object coordinates_of(py::handle value) {
  if (py::hasattr(value, "__geo_interface__")) {
    const py::dict geometry = value.attr("__geo_interface__");
    const std::string type = geometry.contains("type") ? std::string(py::str(geometry["type"])) : "";
    if (type == "Point" || type == "MultiPoint" || type == "LineString") return geometry["coordinates"];
  }
  return py::reinterpret_borrow<py::object>(value);
}

}  // namespace

std::string shape_text(const py::array& array) { return py::str(array.attr("shape")); }

void expect_no_mask(py::handle value, const char* name) {
  if (!py::hasattr(value, "mask")) return;
  if (!py::module_::import("numpy.ma").attr("is_masked")(value).cast<bool>()) return;
  throw InputError(fmt::format(
      "{0}: an array without masked values is expected; leave them out with {0}.compressed(), and the times of a "
      "history the same, or fill them with {0}.filled(...)",
      name));
}

Array numbers(py::handle value, const char* name) {
  expect_no_mask(value, name);
  const auto as_given = ensured<py::array>(value);
  if (as_given) expect_real(as_given, name);
  auto array = ensured<Array>(value);
  if (!array)
    throw InputError(fmt::format("{}: an array of numbers is expected, not {}", name,
                                 std::string(py::str(py::type::handle_of(value).attr("__name__")))));
  return array;
}

Array samples(py::handle value, const char* name) {
  Array array = numbers(value, name);
  if (array.ndim() != 1)
    throw InputError(fmt::format("{}: has shape {}, must have shape (n,)", name, shape_text(array)));
  return array;
}

std::span<const double> span_of(const Array& array) { return {array.data(), static_cast<std::size_t>(array.size())}; }

std::vector<Vec2> points(py::handle value, const char* name) {
  const Array array = numbers(coordinates_of(value), name);
  if (array.ndim() != 2 || array.shape(1) != 2)
    throw InputError(fmt::format("{}: has shape {}, must have shape (n, 2)", name, shape_text(array)));
  std::vector<Vec2> result;
  for (py::ssize_t i = 0; i < array.shape(0); ++i) {
    result.push_back({array.at(i, 0), array.at(i, 1)});
    expect_on_the_grid(result.back(), name, fmt::format("[{}]", i));
  }
  return result;
}

Vec2 point(py::handle value, const char* name) {
  const Array array = numbers(coordinates_of(value), name);
  if (array.ndim() != 1 || array.shape(0) != 2)
    throw InputError(fmt::format("{}: has shape {}, must have shape (2,)", name, shape_text(array)));
  const Vec2 result{array.at(0), array.at(1)};
  expect_on_the_grid(result, name, "");
  return result;
}

py::array_t<double> to_array(std::span<const double> values) {
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

py::array_t<double> to_array(std::span<const Vec2> vertices) {
  py::array_t<double> array = rows_of(vertices.size(), 2);
  auto view = array.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < array.shape(0); ++i) {
    view(i, 0) = vertices[static_cast<std::size_t>(i)].x;
    view(i, 1) = vertices[static_cast<std::size_t>(i)].y;
  }
  return array;
}

py::array_t<double> to_array(std::span<const geometry::Point> ring) {
  std::vector<Vec2> vertices;
  for (const geometry::Point p : ring) vertices.push_back(geometry::metres(p));
  return to_array(vertices);
}

py::array_t<double> to_array(const Vec3& v) {
  const double values[]{v.x, v.y, v.z};
  return to_array(values);
}

py::array_t<double> to_array(const Quaternion& q) {
  const double values[]{q.w, q.x, q.y, q.z};
  return to_array(values);
}

py::object fraction(geometry::ExactArea area) {
  return py::module_::import("fractions").attr("Fraction")(area.to_string());
}

py::object from_json(const std::string& text) { return py::module_::import("json").attr("loads")(text); }

}  // namespace brash::python
