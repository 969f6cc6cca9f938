// SPDX-License-Identifier: GPL-3.0-or-later
#include "case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <stdexcept>
#include <string_view>

#include "brash/advice/advice.hpp"
#include "brash/core/error.hpp"
#include "brash/io/case.hpp"
#include "brash/io/new_case.hpp"
#include "brash/io/origin.hpp"
#include "brash/model/case_keys.hpp"
#include "brash/structure/hull.hpp"
#include "convert.hpp"
#include "rooms.hpp"

namespace brash::python {
namespace {

Case read(std::string text, std::string path, bool has_file, std::vector<std::string> overrides) {
  model::Case resolved = io::parse_case(text, path, overrides);
  return {std::move(text), std::move(path), has_file, std::move(overrides), std::move(resolved)};
}

/// A Python value as TOML: true, 0.4, "40 cm", [3, 5]. A list that holds itself has no end, and is refused.
std::string toml_value(py::handle value, int depth = 0) {
  constexpr int kDeepest = 8;
  if (depth > kDeepest) throw InputError(fmt::format("a list is nested deeper than {}, or holds itself", kDeepest));
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>() ? "true" : "false";
  if (py::isinstance<py::str>(value))
    return py::str(py::module_::import("json").attr("dumps")(value, py::arg("ensure_ascii") = false));
  // NumPy's float64 is a float whose text is not a number.
  if (py::hasattr(value, "tolist")) return toml_value(value.attr("tolist")(), depth + 1);
  if (py::isinstance<py::int_>(value) || py::isinstance<py::float_>(value)) return py::repr(value);
  if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) {
    std::string items;
    for (const py::handle item : value) items += (items.empty() ? "" : ", ") + toml_value(item, depth + 1);
    return "[" + items + "]";
  }
  throw py::type_error("a case takes bool, int, float, str and lists, not " +
                       std::string(py::str(py::type::handle_of(value).attr("__name__"))));
}

/// Whether a key names a file.
bool names_file(std::string_view key) {
  constexpr std::array<std::string_view, 7> kFiles{"failure.file", "structure.file", "structure.motion.path",
                                                   "field.file",   "field.openings", "field.cracks",
                                                   "field.shore"};
  return std::ranges::find(kFiles, key) != kFiles.end();
}

/// The name of a file as it is found from any folder.
std::string absolute(const std::string& name) { return std::filesystem::absolute(name).string(); }

std::string key_of(const std::string& text) { return text.substr(0, text.find('=')); }

/// `overrides` with the entries of `changes`, a dict, in place of older overrides of the same key. Names of files are
/// of the current folder, and stay so.
std::vector<std::string> changed(std::vector<std::string> overrides, const py::dict& changes) {
  for (const auto& [key, value] : changes) {
    if (!py::isinstance<py::str>(key))
      throw py::type_error(fmt::format("changes: {} is not a key; a key is a text such as \"ice.thickness\"",
                                       py::repr(key).cast<std::string>()));
    const auto name = key.attr("encode")().cast<std::string>();
    std::erase_if(overrides, [&](const std::string& old) { return key_of(old) == name; });
    py::object given = py::reinterpret_borrow<py::object>(value);
    if (names_file(name) && py::isinstance<py::str>(value) && py::len(value) > 0)
      given = py::str(absolute(value.cast<std::string>()));
    overrides.push_back(name + "=" + toml_value(given));
  }
  return overrides;
}

py::dict to_dict(const Case& c) { return py::module_::import("tomllib").attr("loads")(io::to_toml(c.resolved)); }

py::object value_of(const Case& c, const std::string& name) {
  if (name.find('.') == std::string::npos) throw py::key_error(name);  // a section is not a value
  // The text of a case leaves the kind out where the structure is towed.
  if (name == "structure.motion.kind")
    return py::str(std::string(model::name_of(model::kind_of(c.resolved.structure.motion))));
  py::object found = to_dict(c);
  const std::string known = name == model::kLongSpeed ? model::kSpeed : name;
  for (const py::handle part : py::str(known).attr("split")(".")) {
    if (!py::isinstance<py::dict>(found) || !found.contains(part)) throw py::key_error(name);
    found = found[part];
  }
  return found;
}

py::dict derived(const Case& c) {
  const simulation::Setup setup(c.resolved);
  const simulation::DerivedScales& s = setup.scales;
  py::dict out;
  out["characteristic_length"] = s.characteristic_length;
  out["thickness_over_lc"] = s.thickness_over_lc;
  out["mu1"] = s.mu1;
  out["freeboard"] = s.freeboard;
  out["draft"] = s.draft;
  out["correlation_length"] = s.correlation_length;
  out["collision_time"] = s.collision_time;
  out["initial_crack_radius"] = s.initial_crack_radius;
  py::list warnings;
  for (const model::Warning& warning : advice::warnings_of(setup)) warnings.append(warning.text);
  out["warnings"] = warnings;
  return out;
}

py::tuple mesh(const Case& c) {
  const auto hull = structure::make_hull(c.resolved.structure);
  const auto& [vertices, triangles] = hull->mesh();
  py::array_t<double> places({static_cast<py::ssize_t>(vertices.size()), py::ssize_t{3}});
  py::array_t<int> corners({static_cast<py::ssize_t>(triangles.size()), py::ssize_t{3}});
  auto place = places.mutable_unchecked<2>();
  auto corner = corners.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < place.shape(0); ++i) {
    const Vec3& v = vertices[static_cast<std::size_t>(i)];
    place(i, 0) = v.x, place(i, 1) = v.y, place(i, 2) = v.z;
  }
  for (py::ssize_t i = 0; i < corner.shape(0); ++i)
    for (py::ssize_t k = 0; k < 3; ++k)
      corner(i, k) = triangles[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
  return py::make_tuple(std::move(places), std::move(corners));
}

void update(Case& c, const py::dict& changes) {
  if (c.runs.n > 0) throw std::runtime_error("this case is running: change a copy of it, case.copy()");
  c = with_changes(c, changes);
}

void add_class(py::module_& m) {
  py::class_<Case>(m, "Case", R"(A case: what is simulated. Keys are those of a case file, values are SI and radians.

>>> case = brash.Case.from_file("cone.toml")
>>> case["ice.thickness"] = "40 cm"
>>> case["ice.thickness"]
0.4)")
      .def_static(
          "from_file",
          [](const py::object& path, const py::dict& changes) {
            const auto name = py::module_::import("os").attr("fspath")(path).cast<std::string>();
            Case c = read(io::read_case_text(name), name, true, changed({}, changes));
            c.path = absolute(name);  // a later change may come from another folder
            return c;
          },
          py::arg("path"), py::arg("changes") = py::dict(),
          "Reads a case file. `changes` maps \"section.key\" to values, as --set does. Names of files in it, and in "
          "later changes, are relative to the current folder.\n\n"
          "Raises InputError with file, line, key, value, what is allowed and the remedy.")
      .def_static(
          "from_text",
          [](const std::string& text, const std::string& name, const py::dict& changes) {
            return read(text, name, false, changed({}, changes));
          },
          py::arg("text"), py::arg("name") = "case", py::arg("changes") = py::dict(),
          "Reads the text of a case file (TOML). `name` takes the place of the file's name: in messages, and in the "
          "key of the "
          "random numbers. Names of files in the text are relative to the current folder, also when the case is "
          "changed.")
      .def("update", &update, py::arg("changes"), "Changes several keys at once; on InputError nothing is changed.")
      .def("__setitem__",
           [](Case& c, const std::string& key, const py::object& value) {
             py::dict change;
             change[py::str(key)] = value;
             update(c, change);
           })
      .def("__getitem__", &value_of)
      .def("to_dict", &to_dict, "All keys with their values, section by section.")
      .def(
          "to_toml", [](const Case& c) { return io::to_toml(c.resolved); }, "The resolved case as a case file.")
      .def("mesh", &mesh,
           "The structure as a closed mesh: vertices [m], shape=(n, 3), z upwards from the waterplane, and triangles,\n"
           "shape=(m, 3), counter-clockwise from outside.")
      .def("derived", &derived, "Lengths [m] and times [s] that follow from the case, and warnings, as `brash check`.")
      .def(
          "copy", [](const Case& c) { return c; }, "An independent case with the same keys.")
      .def("__copy__", [](const Case& c) { return c; })
      .def("__deepcopy__", [](const Case& c, const py::dict&) { return c; })
      .def(py::pickle([](const Case& c) { return py::make_tuple(c.text, c.path, c.has_file, c.overrides); },
                      [](const py::tuple& state) {
                        return read(state[0].cast<std::string>(), state[1].cast<std::string>(), state[2].cast<bool>(),
                                    state[3].cast<std::vector<std::string>>());
                      }))
      .def(
          "__eq__", [](const Case& a, const Case& b) { return a.resolved == b.resolved; }, py::is_operator())
      .def_property_readonly(
          "name", [](const Case& c) { return c.resolved.name; }, "The stem of the file's name.")
      .def_property_readonly(
          "origin", [](const Case& c) { return io::origin_line(io::origin_of(c.resolved)); },
          "Preset and program, as every table of the command names them: \"preset: paper (1 key changed); program: "
          "brash 0.2.0\".")
      .def("__repr__", [](const Case& c) { return "<brash.Case " + c.resolved.name + ">"; });
}

void add_templates(py::module_& m) {
  m.def("schema", &io::case_schema, "The JSON Schema of a case file as text.");
  m.def("template", &io::case_template, py::arg("ice") = "basin",
        "A commented case file with every key. ice: one of site_ice(), whose values have their sources beside them.");
  m.def("new_case", &io::new_case, py::arg("kind") = "cone", py::arg("ice") = "basin",
        "A short case file to begin with, for a structure of this kind, as `brash new`. ice: as for template().");
  m.def(
      "site_ice", &io::site_ice,
      "The names of the ice that templates offer: basin, the model ice of the validation case, and the ice of sites.");
}

}  // namespace

Case with_changes(const Case& c, const py::dict& changes) {
  return read(c.text, c.path, c.has_file, changed(c.overrides, changes));
}

void add_case(py::module_& m) {
  add_class(m);
  add_templates(m);
}

}  // namespace brash::python
