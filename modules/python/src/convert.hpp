// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "brash/core/vec.hpp"
#include "brash/geometry/polygon.hpp"
#include "brash/io/result_columns.hpp"

namespace brash::python {

namespace py = pybind11;

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// "(3, 2)".
std::string shape_text(const py::array& array);

/// @throws InputError naming the argument `name` when a value of a numpy.ma array is masked: its number means nothing.
void expect_no_mask(py::handle value, const char* name);

/// The value as such an array, copied or cast where needed; a null array when it is not one.
/// @throws py::error_already_set when there is no memory for it: `ensure()` hides that.
template <typename Any>
Any ensured(py::handle value) {
  try {
    return Any(py::reinterpret_borrow<py::object>(value));
  } catch (const py::error_already_set& error) {
    if (error.matches(PyExc_MemoryError) || !error.matches(PyExc_Exception)) throw;
    return py::reinterpret_steal<Any>(py::handle());
  }
}

/// Any array of real numbers without masked values, copied or cast where needed. Dates, durations and texts are none.
/// @throws InputError naming the argument `name`.
Array numbers(py::handle value, const char* name);
/// The same with shape=(n,).
Array samples(py::handle value, const char* name);
std::span<const double> span_of(const Array& array);

/// shape=(n, 2), finite and on the grid's range [m], or points or a line with __geo_interface__.
/// @throws InputError naming argument and row.
std::vector<Vec2> points(py::handle value, const char* name);
/// The same for shape=(2,), or a point.
Vec2 point(py::handle value, const char* name);

py::array_t<double> to_array(std::span<const double> values);
/// shape=(n, 2)
py::array_t<double> to_array(std::span<const Vec2> vertices);
/// shape=(n, 2) [m]
py::array_t<double> to_array(std::span<const geometry::Point> ring);
/// shape=(3,)
py::array_t<double> to_array(const Vec3& v);
/// shape=(4,): w, x, y, z
py::array_t<double> to_array(const Quaternion& q);

/// An exact area [m2] as a fractions.Fraction.
py::object fraction(geometry::ExactArea area);

/// Text as a Python value: json.loads.
py::object from_json(const std::string& text);

/// Rows as a structured array, its fields named as the columns of the files; shape=(n,).
template <typename Row>
py::array table(std::span<const Row> rows) {
  py::list names, formats, offsets;
  std::size_t size = 0;
  const auto stored = [](const auto& value) {
    if constexpr (std::is_enum_v<std::decay_t<decltype(value)>>)
      return static_cast<std::int32_t>(value);
    else
      return value;
  };
  io::Columns<Row>::visit([&](const std::string& name, const char*, const std::string&, auto member) {
    using Value = decltype(stored(member(std::declval<const Row&>())));
    names.append(name);
    formats.append(py::dtype::of<Value>());
    offsets.append(size);
    size += sizeof(Value);
  });
  py::array array(py::dtype(names, formats, offsets, static_cast<py::ssize_t>(size)),
                  std::vector<py::ssize_t>{static_cast<py::ssize_t>(rows.size())});
  auto* bytes = static_cast<char*>(array.mutable_data());
  for (const Row& row : rows) {
    io::Columns<Row>::visit([&](const std::string&, const char*, const std::string&, auto member) {
      const auto value = stored(member(row));
      std::memcpy(bytes, &value, sizeof(value));
      bytes += sizeof(value);
    });
  }
  return array;
}

}  // namespace brash::python
