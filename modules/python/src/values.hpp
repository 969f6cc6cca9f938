// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <utility>

namespace brash::python {

/// Adds a plain value as a class with read-only members, given as pairs of name and pointer to member.
template <typename Value, typename... Member>
pybind11::class_<Value> add_value(pybind11::module_& m, const char* name, const char* doc, const Member&... members) {
  namespace py = pybind11;
  py::class_<Value> type(m, name, doc);
  (type.def_readonly(members.first, members.second), ...);
  type.def("__repr__", [name, members...](const Value& value) {
    std::string text = std::string("<brash.") + name;
    ((text += std::string(" ") + members.first + "=" + std::string(py::repr(py::cast(value.*(members.second))))), ...);
    return text + ">";
  });
  return type;
}

}  // namespace brash::python
