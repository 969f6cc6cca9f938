// SPDX-License-Identifier: GPL-3.0-or-later
#include "closed_form.hpp"

namespace brash::python {

py::object add_named_tuple(py::module_& m, const char* name, const std::vector<std::string>& fields, const char* doc) {
  py::object type = py::module_::import("collections").attr("namedtuple")(name, py::cast(fields));
  type.attr("__doc__") = doc;
  type.attr("__module__") = m.attr("__name__");
  m.attr(name) = type;
  return type;
}

std::string shown_unit(const std::string& unit) {
  if (unit == "1") return "-";
  if (unit == "kg m-3") return "kg/m3";
  if (unit == "m s-1") return "m/s";
  return unit == "m s-2" ? "m/s2" : unit;
}

std::string remedy_for(const std::string& unit) {
  if (unit == "rad") return "Give angles in radians: numpy.radians(45) for 45 degrees.";
  if (unit == "Pa") return "Give it in Pa: 5e5 for 500 kPa.";
  if (unit == "kg m-3") return "Give it in kg/m3: 900 for sea ice, 1025 for sea water.";
  if (unit == "m s-1") return "Give it in m/s, and positive.";
  if (unit == "1") return "Give it as a number, 0.1 for 10 %.";
  return fmt::format("Give it in {}.", shown_unit(unit));
}

std::string range_text(const standards::Range& range) {
  const std::string least = fmt::format("{} {:.5g}", range.open_least ? "above" : "at least", range.least);
  if (range.most == standards::kNoLimit) return least + " and finite";
  return fmt::format("{} and {} {:.5g}", least, range.open_most ? "below" : "at most", range.most);
}

std::string index_text(const std::vector<py::ssize_t>& shape, std::size_t i) {
  if (shape.empty()) return "";
  std::vector<std::size_t> index(shape.size());
  for (std::size_t axis = shape.size(); axis-- > 0; i /= static_cast<std::size_t>(shape[axis]))
    index[axis] = i % static_cast<std::size_t>(shape[axis]);
  return fmt::format("[{}]", fmt::join(index, ", "));
}

std::vector<py::ssize_t> common_shape(const std::vector<std::string>& names, const std::vector<Array>& arrays) {
  std::vector<py::ssize_t> shape;
  for (const Array& array : arrays) {
    const auto n_axes = static_cast<std::size_t>(array.ndim());
    if (n_axes > shape.size()) shape.insert(shape.begin(), n_axes - shape.size(), 1);
    for (std::size_t axis = 0; axis < n_axes; ++axis) {
      py::ssize_t& common = shape[shape.size() - n_axes + axis];
      const py::ssize_t own = array.shape(static_cast<py::ssize_t>(axis));
      if (common == 1) common = own;
      if (own == 1 || own == common) continue;
      std::string text;
      for (std::size_t i = 0; i < arrays.size(); ++i)
        if (arrays[i].ndim() > 0)
          text += fmt::format("{}{} {}", text.empty() ? "" : ", ", names[i], shape_text(arrays[i]));
      throw InputError("the shapes cannot be broadcast together: " + text);
    }
  }
  return shape;
}

Array broadcast_to(const Array& array, const std::vector<py::ssize_t>& shape) {
  return ensured<Array>(py::module_::import("numpy").attr("broadcast_to")(array, py::cast(shape)));
}

void warn_of_gaps(const char* form, std::size_t n_gaps, std::size_t n_all, const std::string& first,
                  const std::string& why) {
  const std::string text = fmt::format("{}: {} of {} elements are nan, outside the formula's range; the first, {}: {}",
                                       form, n_gaps, n_all, first, why);
  if (PyErr_WarnEx(PyExc_UserWarning, text.c_str(), 1) != 0) throw py::error_already_set();
}

}  // namespace brash::python
