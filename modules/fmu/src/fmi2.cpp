// SPDX-License-Identifier: GPL-3.0-or-later
#include "fmi2.hpp"

#include <limits>

#include "component.hpp"
#include "resource_path.hpp"

using brash::fmu::attempt;
using brash::fmu::Component;

namespace {

fmi2Status code(brash::fmu::Status status) { return static_cast<fmi2Status>(status); }

/// The host's logger takes a format of printf.
brash::fmu::Log log_to(const fmi2CallbackFunctions* host, std::string name, bool on) {
  if (host == nullptr || host->logger == nullptr) return {{}, on};
  const auto write = [logger = host->logger, environment = host->componentEnvironment, name = std::move(name)](
                         brash::fmu::Status status, const char* category, const char* message) {
    logger(environment, name.c_str(), code(status), category, "%s", message);
  };
  return {write, on};
}

/// `each(instance, i)` for every value of an array.
template <typename Each>
fmi2Status for_values(fmi2Component component, const fmi2ValueReference references[], std::size_t n, const void* values,
                      Each&& each) {
  return code(attempt(component, [&](Component& c) {
    brash::fmu::expect_array(references, n);
    brash::fmu::expect_array(values, n);
    for (std::size_t i = 0; i < n; ++i) each(c.instance, i);
  }));
}

/// A call for values that no variable has.
fmi2Status none_of(fmi2Component component, std::size_t n, const char* kind) {
  return code(attempt(component, [&](Component&) {
    if (n > 0) throw std::runtime_error(std::string("the unit has no ") + kind);
  }));
}

fmi2Status no_status(fmi2Component component) {
  return code(attempt(component, [](Component&) { throw brash::fmu::Discarded("no step is pending"); }));
}

}  // namespace

extern "C" {

const char* fmi2GetTypesPlatform() { return "default"; }
const char* fmi2GetVersion() { return "2.0"; }

fmi2Status fmi2SetDebugLogging(fmi2Component component, fmi2Boolean on, std::size_t n, const fmi2String categories[]) {
  return code(attempt(component, [&](Component& c) { c.log.select(on != 0, categories, n); }));
}

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                              const fmi2CallbackFunctions* host, fmi2Boolean /*visible*/, fmi2Boolean logging_on) {
  return brash::fmu::made_by([&]() -> Component* {
    const std::string shown = name != nullptr ? name : "";
    const brash::fmu::Log log = log_to(host, shown, logging_on != 0);
    if (shown.find_first_not_of(" \t\n") == std::string::npos || guid == nullptr || resources == nullptr) {
      log.error("an instance needs a name, a GUID and the place of its resources");
      return nullptr;
    }
    if (type != fmi2CoSimulation) {
      log.error("the unit is for co-simulation only");
      return nullptr;
    }
    return brash::fmu::make_component(brash::fmu::path_of_uri(resources), guid, log);
  });
}

void fmi2FreeInstance(fmi2Component component) { delete static_cast<Component*>(component); }

fmi2Status fmi2SetupExperiment(fmi2Component component, fmi2Boolean /*has_tolerance*/, fmi2Real /*tolerance*/,
                               fmi2Real start, fmi2Boolean has_stop, fmi2Real stop) {
  return code(attempt(
      component, [&](Component& c) { c.instance.set_up(start, has_stop != 0 ? std::optional(stop) : std::nullopt); }));
}

fmi2Status fmi2EnterInitializationMode(fmi2Component component) {
  return code(attempt(component, [](Component& c) { c.instance.enter_initialization(); }));
}
fmi2Status fmi2ExitInitializationMode(fmi2Component component) {
  return code(attempt(component, [](Component& c) { c.instance.exit_initialization(); }));
}
fmi2Status fmi2Terminate(fmi2Component component) {
  return code(attempt(component, [](Component& c) { c.instance.terminate(); }));
}
fmi2Status fmi2Reset(fmi2Component component) {
  return code(attempt(component, [](Component& c) { c.instance.reset(); }));
}

fmi2Status fmi2GetReal(fmi2Component component, const fmi2ValueReference references[], std::size_t n,
                       fmi2Real values[]) {
  return for_values(component, references, n, values,
                    [&](auto& instance, std::size_t i) { values[i] = instance.number(references[i]); });
}
fmi2Status fmi2GetInteger(fmi2Component component, const fmi2ValueReference references[], std::size_t n,
                          fmi2Integer values[]) {
  return for_values(component, references, n, values, [&](auto& instance, std::size_t i) {
    const std::int64_t value = instance.whole_number(references[i]);
    if (value > std::numeric_limits<fmi2Integer>::max()) throw std::runtime_error("a value exceeds FMI 2's integers");
    values[i] = static_cast<fmi2Integer>(value);
  });
}
fmi2Status fmi2GetBoolean(fmi2Component component, const fmi2ValueReference[], std::size_t n, fmi2Boolean[]) {
  return none_of(component, n, "boolean variables");
}
fmi2Status fmi2GetString(fmi2Component component, const fmi2ValueReference[], std::size_t n, fmi2String[]) {
  return none_of(component, n, "string variables");
}
fmi2Status fmi2SetReal(fmi2Component component, const fmi2ValueReference references[], std::size_t n,
                       const fmi2Real values[]) {
  return code(attempt(component,
                      [&](Component& c) { c.instance.set(brash::fmu::settings_of<double>(references, values, n)); }));
}
fmi2Status fmi2SetInteger(fmi2Component component, const fmi2ValueReference references[], std::size_t n,
                          const fmi2Integer values[]) {
  return code(attempt(
      component, [&](Component& c) { c.instance.set(brash::fmu::settings_of<std::int64_t>(references, values, n)); }));
}
fmi2Status fmi2SetBoolean(fmi2Component component, const fmi2ValueReference[], std::size_t n, const fmi2Boolean[]) {
  return none_of(component, n, "boolean variables");
}
fmi2Status fmi2SetString(fmi2Component component, const fmi2ValueReference[], std::size_t n, const fmi2String[]) {
  return none_of(component, n, "string variables");
}

fmi2Status fmi2GetFMUstate(fmi2Component component, fmi2FMUstate* state) {
  return code(brash::fmu::keep_state(component, state));
}
fmi2Status fmi2SetFMUstate(fmi2Component component, fmi2FMUstate state) {
  return code(brash::fmu::restore_state(component, state));
}
fmi2Status fmi2FreeFMUstate(fmi2Component component, fmi2FMUstate* state) {
  return code(brash::fmu::free_state(component, state));
}
fmi2Status fmi2SerializedFMUstateSize(fmi2Component component, fmi2FMUstate state, std::size_t* size) {
  return code(brash::fmu::size_of_state(component, state, size));
}
fmi2Status fmi2SerializeFMUstate(fmi2Component component, fmi2FMUstate state, fmi2Byte bytes[], std::size_t size) {
  return code(brash::fmu::serialise_state(component, state, bytes, size));
}
fmi2Status fmi2DeSerializeFMUstate(fmi2Component component, const fmi2Byte bytes[], std::size_t size,
                                   fmi2FMUstate* state) {
  return code(brash::fmu::deserialise_state(component, bytes, size, state));
}

fmi2Status fmi2GetDirectionalDerivative(fmi2Component component, const fmi2ValueReference[], std::size_t,
                                        const fmi2ValueReference[], std::size_t, const fmi2Real[], fmi2Real[]) {
  return none_of(component, 1, "directional derivatives");
}
fmi2Status fmi2SetRealInputDerivatives(fmi2Component component, const fmi2ValueReference[], std::size_t,
                                       const fmi2Integer[], const fmi2Real[]) {
  return none_of(component, 1, "use for derivatives of inputs");
}
fmi2Status fmi2GetRealOutputDerivatives(fmi2Component component, const fmi2ValueReference[], std::size_t,
                                        const fmi2Integer[], fmi2Real[]) {
  return none_of(component, 1, "derivatives of outputs");
}

fmi2Status fmi2DoStep(fmi2Component component, fmi2Real from, fmi2Real size, fmi2Boolean /*never_back*/) {
  return code(attempt(component, [&](Component& c) { c.instance.step(from, size); }));
}
fmi2Status fmi2CancelStep(fmi2Component component) {
  return code(attempt(component, [](Component&) { throw std::runtime_error("no step is pending"); }));
}
fmi2Status fmi2GetStatus(fmi2Component component, fmi2StatusKind, fmi2Status*) { return no_status(component); }
fmi2Status fmi2GetRealStatus(fmi2Component component, fmi2StatusKind kind, fmi2Real* value) {
  if (kind != fmi2LastSuccessfulTime) return no_status(component);
  return code(attempt(component, [&](Component& c) {
    brash::fmu::expect_array(value, 1);
    *value = c.instance.time();
  }));
}
fmi2Status fmi2GetIntegerStatus(fmi2Component component, fmi2StatusKind, fmi2Integer*) { return no_status(component); }
fmi2Status fmi2GetBooleanStatus(fmi2Component component, fmi2StatusKind kind, fmi2Boolean* value) {
  if (kind != fmi2Terminated) return no_status(component);
  return code(attempt(component, [&](Component&) {
    brash::fmu::expect_array(value, 1);
    *value = 0;  // the unit never ends a simulation on its own
  }));
}
fmi2Status fmi2GetStringStatus(fmi2Component component, fmi2StatusKind, fmi2String*) { return no_status(component); }

}  // extern "C"
