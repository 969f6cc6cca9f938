// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "brash/core/interruption.hpp"

namespace brash::python {

/// Outside the range of a closed form, or data that a distribution does not fit: brash.NotApplicable.
class NotApplicable : public InputError {
 public:
  using InputError::InputError;
};

// Each adds one part of the module.
void add_case(pybind11::module_& m);
void add_simulation(pybind11::module_& m);
void add_results(pybind11::module_& m);
void add_campaign(pybind11::module_& m);
void add_geometry(pybind11::module_& m);
void add_maps(pybind11::module_& m);
void add_failure(pybind11::module_& m);
void add_statistics(pybind11::module_& m);
void add_load_histories(pybind11::module_& m);
void add_standards(pybind11::module_& m);

/// Lets Python see Ctrl-C, with the GIL held. @throws pybind11::error_already_set the exception of its handler.
inline void raise_signals() {
  if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
}

/// Calls a function all of whose contracts are about its arguments: a broken contract is the fault of the caller's
/// input. Ctrl-C ends it.
template <typename Call>
auto with_arguments_of(const char* function, Call call) {
  const CheckedForInterruption checked(&raise_signals);
  try {
    return call();
  } catch (const ContractViolation& broken) {
    const std::string text = broken.what();
    const std::size_t condition = text.find("contract broken: ");
    throw InputError(std::string(function) +
                     ": must hold: " + (condition == std::string::npos ? text : text.substr(condition + 17)));
  }
}

}  // namespace brash::python
