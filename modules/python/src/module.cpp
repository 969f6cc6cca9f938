// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>

#include <new>

#include "brash/core/thread_variables.hpp"
#include "brash/core/version.hpp"
#include "brash/geometry/memory.hpp"
#include "rooms.hpp"
#include "signals.hpp"

namespace {

/// Refuses objects whose __init__ never ran: made by T.__new__(T), they have no value behind them.
void* refuse_half_made(std::size_t) {
  throw pybind11::type_error("this object was not made: call its class, not __new__");
}

void refuse_half_made_objects(const pybind11::module_& m) {
  namespace py = pybind11;
  for (const auto& [name, value] : m.attr("__dict__").cast<py::dict>()) {
    if (!py::isinstance<py::type>(value)) continue;
    auto* const info = py::detail::get_type_info(reinterpret_cast<PyTypeObject*>(value.ptr()));
    // pybind11 asks for memory, and leaves it empty, where a value is missing when it is used.
    if (info != nullptr) info->operator_new = &refuse_half_made;
  }
}

/// A call of any function: pybind11 has one for all of them.
class Call : public pybind11::cpp_function {
 public:
  /// Has the calls of `object` make the variables of their thread first: a function, a property, or a class with all
  /// that it has. Without memory for the variables they raise MemoryError.
  static void guard(pybind11::handle object) {
    namespace py = pybind11;
    if (PyType_Check(object.ptr()) != 0) {
      if (py::detail::get_type_info(reinterpret_cast<PyTypeObject*>(object.ptr())) == nullptr) return;
      for (const auto& [name, member] : py::dict(object.attr("__dict__"))) guard(member);
    } else if (PyObject_TypeCheck(object.ptr(), &PyProperty_Type) != 0) {
      for (const char* const way : {"fget", "fset"}) guard(object.attr(way));
    } else if (PyObject_TypeCheck(object.ptr(), &PyStaticMethod_Type) != 0) {
      guard(object.attr("__func__"));
    } else if (const py::handle function = py::detail::get_function(object); PyCFunction_Check(function.ptr()) != 0) {
      PyMethodDef& definition = *reinterpret_cast<PyCFunctionObject*>(function.ptr())->m_ml;
      if (definition.ml_meth == method(&dispatcher)) definition.ml_meth = method(&guarded);
    }
  }

 private:
  static PyObject* guarded(PyObject* self, PyObject* arguments, PyObject* keywords) {
    return brash::make_thread_variables() ? dispatcher(self, arguments, keywords) : PyErr_NoMemory();
  }
  static PyCFunction method(PyCFunctionWithKeywords function) {
    return reinterpret_cast<PyCFunction>(reinterpret_cast<void (*)()>(function));
  }
};

}  // namespace

PYBIND11_MODULE(_brash, m) {
  using namespace brash::python;
  namespace py = pybind11;
  if (!brash::make_thread_variables()) throw std::bad_alloc();
  brash::geometry::throw_where_memory_is_short();
  m.doc() = "How a structure breaks level ice. SI units and radians throughout; x along the structure's track.";
  m.attr("__version__") = brash::kVersion;
  // Later registrations are tried first.
  py::register_exception<brash::ContractViolation>(m, "ContractViolation", PyExc_AssertionError).doc() =
      "A bug in the program: a broken contract, with its values.";
  py::register_exception<brash::RunError>(m, "RunError", PyExc_RuntimeError).doc() =
      "A run that cannot continue although its input was good.";
  auto& input_error = py::register_exception<brash::InputError>(m, "InputError", PyExc_ValueError);
  input_error.doc() = "Bad input: the message names the place, the value, what is allowed and the remedy.";
  py::register_exception<NotApplicable>(m, "NotApplicable", input_error.ptr()).doc() =
      "Outside the range of a closed form, or data that a distribution does not fit.";
  add_case(m);
  add_results(m);
  add_simulation(m);
  add_campaign(m);
  add_geometry(m);
  brash::python::add_maps(m);
  add_failure(m);
  add_statistics(m);
  add_load_histories(m);
  add_standards(m);
  refuse_half_made_objects(m);
  for (const auto& [name, value] : m.attr("__dict__").cast<py::dict>()) Call::guard(value);
  py::module_::import("atexit").attr("register")(py::cpp_function(&Released::wait_for_calls));
}
