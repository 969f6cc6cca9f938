// SPDX-License-Identifier: GPL-3.0-or-later
#include "fmi3.hpp"

#include "component.hpp"

using brash::fmu::attempt;
using brash::fmu::Component;

namespace {

fmi3Status code(brash::fmu::Status status) { return static_cast<fmi3Status>(status); }

brash::fmu::Log log_to(fmi3LogMessageCallback host, fmi3InstanceEnvironment environment, bool on) {
  if (host == nullptr) return {{}, on};
  return {[host, environment](brash::fmu::Status status, const char* category, const char* message) {
            host(environment, code(status), category, message);
          },
          on};
}

/// `each(instance, i)` for every value of an array; all variables are scalars.
template <typename Each>
fmi3Status for_values(fmi3Instance instance, const fmi3ValueReference references[], std::size_t n, const void* values,
                      std::size_t n_values, Each&& each) {
  return code(attempt(instance, [&](Component& c) {
    if (n_values != n) throw std::runtime_error("every variable has one value");
    brash::fmu::expect_array(references, n);
    brash::fmu::expect_array(values, n);
    for (std::size_t i = 0; i < n; ++i) each(c.instance, i);
  }));
}

/// Sets values, which are numbers of this kind.
template <typename Kind, typename Value>
fmi3Status set_values(fmi3Instance instance, const fmi3ValueReference references[], std::size_t n, const Value values[],
                      std::size_t n_values) {
  return code(attempt(instance, [&](Component& c) {
    if (n_values != n) throw std::runtime_error("every variable has one value");
    c.instance.set(brash::fmu::settings_of<Kind>(references, values, n));
  }));
}

/// A call that needs an ability that the unit does not have, or nothing where there is nothing to do.
fmi3Status without(fmi3Instance instance, const char* ability, std::size_t n = 1) {
  return code(attempt(instance, [&](Component&) {
    if (n > 0) throw std::runtime_error(std::string("the unit has no ") + ability);
  }));
}

/// A kind of instance that the unit is not made for.
Component* refuse(fmi3LogMessageCallback host, fmi3InstanceEnvironment environment, const char* why) noexcept {
  return brash::fmu::made_by([&]() -> Component* {
    log_to(host, environment, true).error(why);
    return nullptr;
  });
}

}  // namespace

extern "C" {

const char* fmi3GetVersion() { return "3.0"; }

fmi3Status fmi3SetDebugLogging(fmi3Instance instance, fmi3Boolean on, std::size_t n, const fmi3String categories[]) {
  return code(attempt(instance, [&](Component& c) { c.log.select(on, categories, n); }));
}

fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources,
                                         fmi3Boolean /*visible*/, fmi3Boolean logging_on, fmi3Boolean event_mode_used,
                                         fmi3Boolean /*early_return_allowed*/, const fmi3ValueReference[],
                                         std::size_t n_required, fmi3InstanceEnvironment environment,
                                         fmi3LogMessageCallback host, fmi3IntermediateUpdateCallback) {
  return brash::fmu::made_by([&] {
    const std::string shown = name != nullptr ? name : "";
    if (shown.find_first_not_of(" \t\n") == std::string::npos || token == nullptr || resources == nullptr)
      return refuse(host, environment, "an instance needs a name, a token and the place of its resources");
    if (event_mode_used) return refuse(host, environment, "the unit has no event mode");
    if (n_required > 0) return refuse(host, environment, "the unit has no values between its steps");
    return brash::fmu::make_component(resources, token, log_to(host, environment, logging_on));
  });
}
fmi3Instance fmi3InstantiateModelExchange(fmi3String, fmi3String, fmi3String, fmi3Boolean, fmi3Boolean,
                                          fmi3InstanceEnvironment environment, fmi3LogMessageCallback host) {
  return refuse(host, environment, "the unit is for co-simulation only");
}
fmi3Instance fmi3InstantiateScheduledExecution(fmi3String, fmi3String, fmi3String, fmi3Boolean, fmi3Boolean,
                                               fmi3InstanceEnvironment environment, fmi3LogMessageCallback host,
                                               fmi3ClockUpdateCallback, fmi3LockPreemptionCallback,
                                               fmi3UnlockPreemptionCallback) {
  return refuse(host, environment, "the unit is for co-simulation only");
}
void fmi3FreeInstance(fmi3Instance instance) { delete static_cast<Component*>(instance); }

fmi3Status fmi3EnterInitializationMode(fmi3Instance instance, fmi3Boolean /*has_tolerance*/, fmi3Float64 /*tolerance*/,
                                       fmi3Float64 start, fmi3Boolean has_stop, fmi3Float64 stop) {
  return code(attempt(instance, [&](Component& c) {
    c.instance.set_up(start, has_stop ? std::optional(stop) : std::nullopt);
    c.instance.enter_initialization();
  }));
}
fmi3Status fmi3ExitInitializationMode(fmi3Instance instance) {
  return code(attempt(instance, [](Component& c) { c.instance.exit_initialization(); }));
}
fmi3Status fmi3EnterEventMode(fmi3Instance instance) { return without(instance, "event mode"); }
fmi3Status fmi3EnterStepMode(fmi3Instance instance) { return without(instance, "event mode"); }
fmi3Status fmi3Terminate(fmi3Instance instance) {
  return code(attempt(instance, [](Component& c) { c.instance.terminate(); }));
}
fmi3Status fmi3Reset(fmi3Instance instance) {
  return code(attempt(instance, [](Component& c) { c.instance.reset(); }));
}

fmi3Status fmi3GetFloat64(fmi3Instance instance, const fmi3ValueReference references[], std::size_t n,
                          fmi3Float64 values[], std::size_t n_values) {
  return for_values(instance, references, n, values, n_values,
                    [&](auto& of, std::size_t i) { values[i] = of.number(references[i]); });
}
fmi3Status fmi3SetFloat64(fmi3Instance instance, const fmi3ValueReference references[], std::size_t n,
                          const fmi3Float64 values[], std::size_t n_values) {
  return set_values<double>(instance, references, n, values, n_values);
}
fmi3Status fmi3GetInt64(fmi3Instance instance, const fmi3ValueReference references[], std::size_t n, fmi3Int64 values[],
                        std::size_t n_values) {
  return for_values(instance, references, n, values, n_values,
                    [&](auto& of, std::size_t i) { values[i] = of.whole_number(references[i]); });
}
fmi3Status fmi3SetInt64(fmi3Instance instance, const fmi3ValueReference references[], std::size_t n,
                        const fmi3Int64 values[], std::size_t n_values) {
  return set_values<std::int64_t>(instance, references, n, values, n_values);
}

/// Types that no variable has.
#define BRASH_FMI3_NO_VALUES(Type)                                                                               \
  fmi3Status fmi3Get##Type(fmi3Instance instance, const fmi3ValueReference[], std::size_t n, fmi3##Type[],       \
                           std::size_t) {                                                                        \
    return without(instance, "variables of type " #Type, n);                                                     \
  }                                                                                                              \
  fmi3Status fmi3Set##Type(fmi3Instance instance, const fmi3ValueReference[], std::size_t n, const fmi3##Type[], \
                           std::size_t) {                                                                        \
    return without(instance, "variables of type " #Type, n);                                                     \
  }
BRASH_FMI3_NO_VALUES(Float32)
BRASH_FMI3_NO_VALUES(Int8)
BRASH_FMI3_NO_VALUES(UInt8)
BRASH_FMI3_NO_VALUES(Int16)
BRASH_FMI3_NO_VALUES(UInt16)
BRASH_FMI3_NO_VALUES(Int32)
BRASH_FMI3_NO_VALUES(UInt32)
BRASH_FMI3_NO_VALUES(UInt64)
BRASH_FMI3_NO_VALUES(Boolean)
BRASH_FMI3_NO_VALUES(String)
#undef BRASH_FMI3_NO_VALUES
fmi3Status fmi3GetBinary(fmi3Instance instance, const fmi3ValueReference[], std::size_t n, std::size_t[], fmi3Binary[],
                         std::size_t) {
  return without(instance, "variables of type Binary", n);
}
fmi3Status fmi3SetBinary(fmi3Instance instance, const fmi3ValueReference[], std::size_t n, const std::size_t[],
                         const fmi3Binary[], std::size_t) {
  return without(instance, "variables of type Binary", n);
}
fmi3Status fmi3GetClock(fmi3Instance instance, const fmi3ValueReference[], std::size_t n, fmi3Clock[]) {
  return without(instance, "clocks", n);
}
fmi3Status fmi3SetClock(fmi3Instance instance, const fmi3ValueReference[], std::size_t n, const fmi3Clock[]) {
  return without(instance, "clocks", n);
}

fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance instance, fmi3ValueReference, std::size_t*) {
  return without(instance, "dependencies of elements");
}
fmi3Status fmi3GetVariableDependencies(fmi3Instance instance, fmi3ValueReference, std::size_t[], fmi3ValueReference[],
                                       std::size_t[], fmi3DependencyKind[], std::size_t) {
  return without(instance, "dependencies of elements");
}

fmi3Status fmi3GetFMUState(fmi3Instance instance, fmi3FMUState* state) {
  return code(brash::fmu::keep_state(instance, state));
}
fmi3Status fmi3SetFMUState(fmi3Instance instance, fmi3FMUState state) {
  return code(brash::fmu::restore_state(instance, state));
}
fmi3Status fmi3FreeFMUState(fmi3Instance instance, fmi3FMUState* state) {
  return code(brash::fmu::free_state(instance, state));
}
fmi3Status fmi3SerializedFMUStateSize(fmi3Instance instance, fmi3FMUState state, std::size_t* size) {
  return code(brash::fmu::size_of_state(instance, state, size));
}
fmi3Status fmi3SerializeFMUState(fmi3Instance instance, fmi3FMUState state, fmi3Byte bytes[], std::size_t size) {
  return code(brash::fmu::serialise_state(instance, state, bytes, size));
}
fmi3Status fmi3DeserializeFMUState(fmi3Instance instance, const fmi3Byte bytes[], std::size_t size,
                                   fmi3FMUState* state) {
  return code(brash::fmu::deserialise_state(instance, bytes, size, state));
}

fmi3Status fmi3GetDirectionalDerivative(fmi3Instance instance, const fmi3ValueReference[], std::size_t,
                                        const fmi3ValueReference[], std::size_t, const fmi3Float64[], std::size_t,
                                        fmi3Float64[], std::size_t) {
  return without(instance, "directional derivatives");
}
fmi3Status fmi3GetAdjointDerivative(fmi3Instance instance, const fmi3ValueReference[], std::size_t,
                                    const fmi3ValueReference[], std::size_t, const fmi3Float64[], std::size_t,
                                    fmi3Float64[], std::size_t) {
  return without(instance, "adjoint derivatives");
}
fmi3Status fmi3EnterConfigurationMode(fmi3Instance instance) { return without(instance, "structural parameters"); }
fmi3Status fmi3ExitConfigurationMode(fmi3Instance instance) { return without(instance, "structural parameters"); }

fmi3Status fmi3GetIntervalDecimal(fmi3Instance instance, const fmi3ValueReference[], std::size_t, fmi3Float64[],
                                  fmi3IntervalQualifier[]) {
  return without(instance, "clocks");
}
fmi3Status fmi3GetIntervalFraction(fmi3Instance instance, const fmi3ValueReference[], std::size_t, fmi3UInt64[],
                                   fmi3UInt64[], fmi3IntervalQualifier[]) {
  return without(instance, "clocks");
}
fmi3Status fmi3GetShiftDecimal(fmi3Instance instance, const fmi3ValueReference[], std::size_t, fmi3Float64[]) {
  return without(instance, "clocks");
}
fmi3Status fmi3GetShiftFraction(fmi3Instance instance, const fmi3ValueReference[], std::size_t, fmi3UInt64[],
                                fmi3UInt64[]) {
  return without(instance, "clocks");
}
fmi3Status fmi3SetIntervalDecimal(fmi3Instance instance, const fmi3ValueReference[], std::size_t, const fmi3Float64[]) {
  return without(instance, "clocks");
}
fmi3Status fmi3SetIntervalFraction(fmi3Instance instance, const fmi3ValueReference[], std::size_t, const fmi3UInt64[],
                                   const fmi3UInt64[]) {
  return without(instance, "clocks");
}
fmi3Status fmi3SetShiftDecimal(fmi3Instance instance, const fmi3ValueReference[], std::size_t, const fmi3Float64[]) {
  return without(instance, "clocks");
}
fmi3Status fmi3SetShiftFraction(fmi3Instance instance, const fmi3ValueReference[], std::size_t, const fmi3UInt64[],
                                const fmi3UInt64[]) {
  return without(instance, "clocks");
}
fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance instance) { return without(instance, "event mode"); }
fmi3Status fmi3UpdateDiscreteStates(fmi3Instance instance, fmi3Boolean*, fmi3Boolean*, fmi3Boolean*, fmi3Boolean*,
                                    fmi3Boolean*, fmi3Float64*) {
  return without(instance, "event mode");
}

fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance instance) { return without(instance, "model exchange"); }
fmi3Status fmi3CompletedIntegratorStep(fmi3Instance instance, fmi3Boolean, fmi3Boolean*, fmi3Boolean*) {
  return without(instance, "model exchange");
}
fmi3Status fmi3SetTime(fmi3Instance instance, fmi3Float64) { return without(instance, "model exchange"); }
fmi3Status fmi3SetContinuousStates(fmi3Instance instance, const fmi3Float64[], std::size_t) {
  return without(instance, "model exchange");
}
fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance instance, fmi3Float64[], std::size_t) {
  return without(instance, "model exchange");
}
fmi3Status fmi3GetEventIndicators(fmi3Instance instance, fmi3Float64[], std::size_t) {
  return without(instance, "model exchange");
}
fmi3Status fmi3GetContinuousStates(fmi3Instance instance, fmi3Float64[], std::size_t) {
  return without(instance, "model exchange");
}
fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance instance, fmi3Float64[], std::size_t) {
  return without(instance, "model exchange");
}
fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance instance, std::size_t*) {
  return without(instance, "model exchange");
}
fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance instance, std::size_t*) {
  return without(instance, "model exchange");
}

fmi3Status fmi3GetOutputDerivatives(fmi3Instance instance, const fmi3ValueReference[], std::size_t, const fmi3Int32[],
                                    fmi3Float64[], std::size_t) {
  return without(instance, "derivatives of outputs");
}
fmi3Status fmi3DoStep(fmi3Instance instance, fmi3Float64 from, fmi3Float64 size, fmi3Boolean /*never_back*/,
                      fmi3Boolean* event_handling_needed, fmi3Boolean* terminate, fmi3Boolean* early_return,
                      fmi3Float64* last_successful_time) {
  return code(attempt(instance, [&](Component& c) {
    for (fmi3Boolean* const answer : {event_handling_needed, terminate, early_return})
      if (answer != nullptr) *answer = false;
    if (last_successful_time != nullptr) *last_successful_time = c.instance.time();
    c.instance.step(from, size);
    if (last_successful_time != nullptr) *last_successful_time = c.instance.time();
  }));
}
fmi3Status fmi3ActivateModelPartition(fmi3Instance instance, fmi3ValueReference, fmi3Float64) {
  return without(instance, "scheduled execution");
}

}  // extern "C"
