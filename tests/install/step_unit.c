// SPDX-License-Identifier: GPL-3.0-or-later
// Loads the library of a unit under FMI 2.0 and steps it; needs the C library alone.
// step_unit LIBRARY RESOURCES GUID REFERENCE STEP N: prints the output with this value reference after each step.
#include <dlfcn.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

typedef void* Component;
typedef struct {
  void (*log)(void*, const char*, int, const char*, const char*, ...);
  void* (*allocate)(size_t, size_t);
  void (*free)(void*);
  void (*step_finished)(void*, int);
  void* environment;
} Callbacks;

static void log_message(void* environment, const char* instance, int status, const char* category, const char* text,
                        ...) {
  va_list arguments;
  (void)environment;
  va_start(arguments, text);
  fprintf(stderr, "%s: status %d, %s: ", instance, status, category);
  vfprintf(stderr, text, arguments);
  fputc('\n', stderr);
  va_end(arguments);
}

static void* function(void* library, const char* name) {
  void* found = dlsym(library, name);
  if (!found) fprintf(stderr, "%s\n", dlerror()), exit(1);
  return found;
}

static void expect(int status, const char* what) {
  if (status > 1) fprintf(stderr, "%s: status %d\n", what, status), exit(1);  // 0 ok, 1 warning
}

int main(int n_arguments, char** arguments) {
  if (n_arguments != 7) return 2;
  void* const library = dlopen(arguments[1], RTLD_NOW | RTLD_LOCAL);
  if (!library) return fprintf(stderr, "%s\n", dlerror()), 1;
  Component (*instantiate)(const char*, int, const char*, const char*, const Callbacks*, int, int) =
      function(library, "fmi2Instantiate");
  int (*set_up)(Component, int, double, double, int, double) = function(library, "fmi2SetupExperiment");
  int (*enter)(Component) = function(library, "fmi2EnterInitializationMode");
  int (*leave)(Component) = function(library, "fmi2ExitInitializationMode");
  int (*do_step)(Component, double, double, int) = function(library, "fmi2DoStep");
  int (*get_real)(Component, const unsigned*, size_t, double*) = function(library, "fmi2GetReal");
  void (*free_instance)(Component) = function(library, "fmi2FreeInstance");

  const Callbacks callbacks = {log_message, calloc, free, NULL, NULL};
  const Component unit = instantiate("ice", 1, arguments[3], arguments[2], &callbacks, 0, 0);
  if (!unit) return fprintf(stderr, "no instance\n"), 1;
  const unsigned reference = (unsigned)strtoul(arguments[4], NULL, 10);
  const double step = strtod(arguments[5], NULL);
  const long n = strtol(arguments[6], NULL, 10);
  expect(set_up(unit, 0, 0.0, 0.0, 0, 0.0), "set-up");
  expect(enter(unit), "initialization");
  expect(leave(unit), "initialization");
  for (long i = 0; i < n; ++i) {
    double value = 0.0;
    expect(do_step(unit, (double)i * step, step, 1), "step");
    expect(get_real(unit, &reference, 1, &value), "output");
    printf("%.17g\n", value);
  }
  free_instance(unit);
  return 0;
}
