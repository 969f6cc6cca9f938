// SPDX-License-Identifier: GPL-3.0-or-later
// The C interface of a unit under FMI 3.0.2: names, types and status codes follow the standard (Modelica
// Association, Functional Mock-up Interface 3.0.2, 2024, Sec. 2.2, 2.3 and 4.2). A unit exports every function, also
// for kinds and abilities that it does not have (Sec. 2.5).
#pragma once

#include <cstddef>
#include <cstdint>

// The only names that a host sees.
#pragma GCC visibility push(default)
extern "C" {

using fmi3Instance = void*;
using fmi3InstanceEnvironment = void*;
using fmi3FMUState = void*;
using fmi3ValueReference = std::uint32_t;
using fmi3Float32 = float;
using fmi3Float64 = double;
using fmi3Int8 = std::int8_t;
using fmi3UInt8 = std::uint8_t;
using fmi3Int16 = std::int16_t;
using fmi3UInt16 = std::uint16_t;
using fmi3Int32 = std::int32_t;
using fmi3UInt32 = std::uint32_t;
using fmi3Int64 = std::int64_t;
using fmi3UInt64 = std::uint64_t;
using fmi3Boolean = bool;
using fmi3Clock = bool;
using fmi3String = const char*;
using fmi3Byte = std::uint8_t;
using fmi3Binary = const fmi3Byte*;

enum fmi3Status { fmi3OK, fmi3Warning, fmi3Discard, fmi3Error, fmi3Fatal };
enum fmi3DependencyKind { fmi3Independent, fmi3Constant, fmi3Fixed, fmi3Tunable, fmi3Discrete, fmi3Dependent };
enum fmi3IntervalQualifier { fmi3IntervalNotYetKnown, fmi3IntervalUnchanged, fmi3IntervalChanged };

using fmi3LogMessageCallback = void (*)(fmi3InstanceEnvironment, fmi3Status, fmi3String category, fmi3String message);
using fmi3ClockUpdateCallback = void (*)(fmi3InstanceEnvironment);
using fmi3LockPreemptionCallback = void (*)();
using fmi3UnlockPreemptionCallback = void (*)();
using fmi3IntermediateUpdateCallback = void (*)(fmi3InstanceEnvironment, fmi3Float64 time, fmi3Boolean set_requested,
                                                fmi3Boolean get_allowed, fmi3Boolean step_finished,
                                                fmi3Boolean can_return_early, fmi3Boolean* early_return_requested,
                                                fmi3Float64* early_return_time);

const char* fmi3GetVersion();
fmi3Status fmi3SetDebugLogging(fmi3Instance, fmi3Boolean on, std::size_t n, const fmi3String categories[]);

fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                         fmi3Boolean logging_on, fmi3Boolean event_mode_used,
                                         fmi3Boolean early_return_allowed, const fmi3ValueReference required[],
                                         std::size_t n_required, fmi3InstanceEnvironment, fmi3LogMessageCallback,
                                         fmi3IntermediateUpdateCallback);
fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                          fmi3Boolean logging_on, fmi3InstanceEnvironment, fmi3LogMessageCallback);
fmi3Instance fmi3InstantiateScheduledExecution(fmi3String name, fmi3String token, fmi3String resources,
                                               fmi3Boolean visible, fmi3Boolean logging_on, fmi3InstanceEnvironment,
                                               fmi3LogMessageCallback, fmi3ClockUpdateCallback,
                                               fmi3LockPreemptionCallback, fmi3UnlockPreemptionCallback);
void fmi3FreeInstance(fmi3Instance);
fmi3Status fmi3EnterInitializationMode(fmi3Instance, fmi3Boolean has_tolerance, fmi3Float64 tolerance,
                                       fmi3Float64 start, fmi3Boolean has_stop, fmi3Float64 stop);
fmi3Status fmi3ExitInitializationMode(fmi3Instance);
fmi3Status fmi3EnterEventMode(fmi3Instance);
fmi3Status fmi3EnterStepMode(fmi3Instance);
fmi3Status fmi3Terminate(fmi3Instance);
fmi3Status fmi3Reset(fmi3Instance);

/// The functions that read and set values of one type.
#define BRASH_FMI3_VALUES(Type)                                                                                \
  fmi3Status fmi3Get##Type(fmi3Instance, const fmi3ValueReference[], std::size_t n, fmi3##Type values[],       \
                           std::size_t n_values);                                                              \
  fmi3Status fmi3Set##Type(fmi3Instance, const fmi3ValueReference[], std::size_t n, const fmi3##Type values[], \
                           std::size_t n_values)
BRASH_FMI3_VALUES(Float32);
BRASH_FMI3_VALUES(Float64);
BRASH_FMI3_VALUES(Int8);
BRASH_FMI3_VALUES(UInt8);
BRASH_FMI3_VALUES(Int16);
BRASH_FMI3_VALUES(UInt16);
BRASH_FMI3_VALUES(Int32);
BRASH_FMI3_VALUES(UInt32);
BRASH_FMI3_VALUES(Int64);
BRASH_FMI3_VALUES(UInt64);
BRASH_FMI3_VALUES(Boolean);
BRASH_FMI3_VALUES(String);
#undef BRASH_FMI3_VALUES
fmi3Status fmi3GetBinary(fmi3Instance, const fmi3ValueReference[], std::size_t n, std::size_t sizes[],
                         fmi3Binary values[], std::size_t n_values);
fmi3Status fmi3SetBinary(fmi3Instance, const fmi3ValueReference[], std::size_t n, const std::size_t sizes[],
                         const fmi3Binary values[], std::size_t n_values);
fmi3Status fmi3GetClock(fmi3Instance, const fmi3ValueReference[], std::size_t n, fmi3Clock values[]);
fmi3Status fmi3SetClock(fmi3Instance, const fmi3ValueReference[], std::size_t n, const fmi3Clock values[]);

fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance, fmi3ValueReference, std::size_t* n);
fmi3Status fmi3GetVariableDependencies(fmi3Instance, fmi3ValueReference dependent, std::size_t elements[],
                                       fmi3ValueReference independents[], std::size_t independent_elements[],
                                       fmi3DependencyKind kinds[], std::size_t n);

fmi3Status fmi3GetFMUState(fmi3Instance, fmi3FMUState*);
fmi3Status fmi3SetFMUState(fmi3Instance, fmi3FMUState);
fmi3Status fmi3FreeFMUState(fmi3Instance, fmi3FMUState*);
fmi3Status fmi3SerializedFMUStateSize(fmi3Instance, fmi3FMUState, std::size_t* size);
fmi3Status fmi3SerializeFMUState(fmi3Instance, fmi3FMUState, fmi3Byte bytes[], std::size_t size);
fmi3Status fmi3DeserializeFMUState(fmi3Instance, const fmi3Byte bytes[], std::size_t size, fmi3FMUState*);

fmi3Status fmi3GetDirectionalDerivative(fmi3Instance, const fmi3ValueReference unknowns[], std::size_t n_unknowns,
                                        const fmi3ValueReference knowns[], std::size_t n_knowns,
                                        const fmi3Float64 seed[], std::size_t n_seed, fmi3Float64 sensitivity[],
                                        std::size_t n_sensitivity);
fmi3Status fmi3GetAdjointDerivative(fmi3Instance, const fmi3ValueReference unknowns[], std::size_t n_unknowns,
                                    const fmi3ValueReference knowns[], std::size_t n_knowns, const fmi3Float64 seed[],
                                    std::size_t n_seed, fmi3Float64 sensitivity[], std::size_t n_sensitivity);
fmi3Status fmi3EnterConfigurationMode(fmi3Instance);
fmi3Status fmi3ExitConfigurationMode(fmi3Instance);

fmi3Status fmi3GetIntervalDecimal(fmi3Instance, const fmi3ValueReference[], std::size_t n, fmi3Float64 intervals[],
                                  fmi3IntervalQualifier[]);
fmi3Status fmi3GetIntervalFraction(fmi3Instance, const fmi3ValueReference[], std::size_t n, fmi3UInt64 counters[],
                                   fmi3UInt64 resolutions[], fmi3IntervalQualifier[]);
fmi3Status fmi3GetShiftDecimal(fmi3Instance, const fmi3ValueReference[], std::size_t n, fmi3Float64 shifts[]);
fmi3Status fmi3GetShiftFraction(fmi3Instance, const fmi3ValueReference[], std::size_t n, fmi3UInt64 counters[],
                                fmi3UInt64 resolutions[]);
fmi3Status fmi3SetIntervalDecimal(fmi3Instance, const fmi3ValueReference[], std::size_t n,
                                  const fmi3Float64 intervals[]);
fmi3Status fmi3SetIntervalFraction(fmi3Instance, const fmi3ValueReference[], std::size_t n, const fmi3UInt64 counters[],
                                   const fmi3UInt64 resolutions[]);
fmi3Status fmi3SetShiftDecimal(fmi3Instance, const fmi3ValueReference[], std::size_t n, const fmi3Float64 shifts[]);
fmi3Status fmi3SetShiftFraction(fmi3Instance, const fmi3ValueReference[], std::size_t n, const fmi3UInt64 counters[],
                                const fmi3UInt64 resolutions[]);
fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance);
fmi3Status fmi3UpdateDiscreteStates(fmi3Instance, fmi3Boolean* update_again, fmi3Boolean* terminate,
                                    fmi3Boolean* nominals_changed, fmi3Boolean* values_changed,
                                    fmi3Boolean* next_time_defined, fmi3Float64* next_time);

fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance);
fmi3Status fmi3CompletedIntegratorStep(fmi3Instance, fmi3Boolean never_back, fmi3Boolean* enter_event_mode,
                                       fmi3Boolean* terminate);
fmi3Status fmi3SetTime(fmi3Instance, fmi3Float64 time);
fmi3Status fmi3SetContinuousStates(fmi3Instance, const fmi3Float64 states[], std::size_t n);
fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance, fmi3Float64 derivatives[], std::size_t n);
fmi3Status fmi3GetEventIndicators(fmi3Instance, fmi3Float64 indicators[], std::size_t n);
fmi3Status fmi3GetContinuousStates(fmi3Instance, fmi3Float64 states[], std::size_t n);
fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance, fmi3Float64 nominals[], std::size_t n);
fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance, std::size_t* n);
fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance, std::size_t* n);

fmi3Status fmi3GetOutputDerivatives(fmi3Instance, const fmi3ValueReference[], std::size_t n, const fmi3Int32 orders[],
                                    fmi3Float64 values[], std::size_t n_values);
fmi3Status fmi3DoStep(fmi3Instance, fmi3Float64 from, fmi3Float64 size, fmi3Boolean never_back,
                      fmi3Boolean* event_handling_needed, fmi3Boolean* terminate, fmi3Boolean* early_return,
                      fmi3Float64* last_successful_time);
fmi3Status fmi3ActivateModelPartition(fmi3Instance, fmi3ValueReference clock, fmi3Float64 time);

}  // extern "C"
#pragma GCC visibility pop
