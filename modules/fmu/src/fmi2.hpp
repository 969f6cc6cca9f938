// SPDX-License-Identifier: GPL-3.0-or-later
// The C interface of a co-simulation unit under FMI 2.0.4: names, types and status codes follow the standard
// (Modelica Association, Functional Mock-up Interface 2.0.4, 2022, Sec. 2.1 and 4.2).
#pragma once

#include <cstddef>

// The only names that a host sees.
#pragma GCC visibility push(default)
extern "C" {

using fmi2Component = void*;
using fmi2ComponentEnvironment = void*;
using fmi2FMUstate = void*;
using fmi2ValueReference = unsigned int;
using fmi2Real = double;
using fmi2Integer = int;
using fmi2Boolean = int;
using fmi2Char = char;
using fmi2String = const fmi2Char*;
using fmi2Byte = char;

enum fmi2Status { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending };
enum fmi2Type { fmi2ModelExchange, fmi2CoSimulation };
enum fmi2StatusKind { fmi2DoStepStatus, fmi2PendingStatus, fmi2LastSuccessfulTime, fmi2Terminated };

using fmi2CallbackLogger = void (*)(fmi2ComponentEnvironment, fmi2String name, fmi2Status, fmi2String category,
                                    fmi2String format, ...);
using fmi2CallbackAllocateMemory = void* (*)(std::size_t n, std::size_t size);
using fmi2CallbackFreeMemory = void (*)(void*);
using fmi2StepFinished = void (*)(fmi2ComponentEnvironment, fmi2Status);

struct fmi2CallbackFunctions {
  fmi2CallbackLogger logger;
  fmi2CallbackAllocateMemory allocateMemory;
  fmi2CallbackFreeMemory freeMemory;
  fmi2StepFinished stepFinished;
  fmi2ComponentEnvironment componentEnvironment;
};

const char* fmi2GetTypesPlatform();
const char* fmi2GetVersion();
fmi2Status fmi2SetDebugLogging(fmi2Component, fmi2Boolean on, std::size_t n, const fmi2String categories[]);

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type, fmi2String guid, fmi2String resources,
                              const fmi2CallbackFunctions*, fmi2Boolean visible, fmi2Boolean logging_on);
void fmi2FreeInstance(fmi2Component);
fmi2Status fmi2SetupExperiment(fmi2Component, fmi2Boolean has_tolerance, fmi2Real tolerance, fmi2Real start,
                               fmi2Boolean has_stop, fmi2Real stop);
fmi2Status fmi2EnterInitializationMode(fmi2Component);
fmi2Status fmi2ExitInitializationMode(fmi2Component);
fmi2Status fmi2Terminate(fmi2Component);
fmi2Status fmi2Reset(fmi2Component);

fmi2Status fmi2GetReal(fmi2Component, const fmi2ValueReference[], std::size_t n, fmi2Real values[]);
fmi2Status fmi2GetInteger(fmi2Component, const fmi2ValueReference[], std::size_t n, fmi2Integer values[]);
fmi2Status fmi2GetBoolean(fmi2Component, const fmi2ValueReference[], std::size_t n, fmi2Boolean values[]);
fmi2Status fmi2GetString(fmi2Component, const fmi2ValueReference[], std::size_t n, fmi2String values[]);
fmi2Status fmi2SetReal(fmi2Component, const fmi2ValueReference[], std::size_t n, const fmi2Real values[]);
fmi2Status fmi2SetInteger(fmi2Component, const fmi2ValueReference[], std::size_t n, const fmi2Integer values[]);
fmi2Status fmi2SetBoolean(fmi2Component, const fmi2ValueReference[], std::size_t n, const fmi2Boolean values[]);
fmi2Status fmi2SetString(fmi2Component, const fmi2ValueReference[], std::size_t n, const fmi2String values[]);

fmi2Status fmi2GetFMUstate(fmi2Component, fmi2FMUstate*);
fmi2Status fmi2SetFMUstate(fmi2Component, fmi2FMUstate);
fmi2Status fmi2FreeFMUstate(fmi2Component, fmi2FMUstate*);
fmi2Status fmi2SerializedFMUstateSize(fmi2Component, fmi2FMUstate, std::size_t* size);
fmi2Status fmi2SerializeFMUstate(fmi2Component, fmi2FMUstate, fmi2Byte bytes[], std::size_t size);
fmi2Status fmi2DeSerializeFMUstate(fmi2Component, const fmi2Byte bytes[], std::size_t size, fmi2FMUstate*);

fmi2Status fmi2GetDirectionalDerivative(fmi2Component, const fmi2ValueReference unknown[], std::size_t n_unknown,
                                        const fmi2ValueReference known[], std::size_t n_known, const fmi2Real seed[],
                                        fmi2Real derivatives[]);
fmi2Status fmi2SetRealInputDerivatives(fmi2Component, const fmi2ValueReference[], std::size_t n,
                                       const fmi2Integer order[], const fmi2Real values[]);
fmi2Status fmi2GetRealOutputDerivatives(fmi2Component, const fmi2ValueReference[], std::size_t n,
                                        const fmi2Integer order[], fmi2Real values[]);

fmi2Status fmi2DoStep(fmi2Component, fmi2Real from, fmi2Real size, fmi2Boolean never_back);
fmi2Status fmi2CancelStep(fmi2Component);
fmi2Status fmi2GetStatus(fmi2Component, fmi2StatusKind, fmi2Status*);
fmi2Status fmi2GetRealStatus(fmi2Component, fmi2StatusKind, fmi2Real*);
fmi2Status fmi2GetIntegerStatus(fmi2Component, fmi2StatusKind, fmi2Integer*);
fmi2Status fmi2GetBooleanStatus(fmi2Component, fmi2StatusKind, fmi2Boolean*);
fmi2Status fmi2GetStringStatus(fmi2Component, fmi2StatusKind, fmi2String*);

}  // extern "C"
#pragma GCC visibility pop
