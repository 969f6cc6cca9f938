// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

namespace brash::statistics {

/// Switches GSL's aborting error handler off, once per process. Every entry to GSL in this room calls it first.
void quiet_gsl();

/// Throws RunError naming `what` and GSL's reason when `status` is not success.
void check_gsl(int status, const char* what);

/// Owns a GSL object; throws RunError when GSL could not allocate it.
template <typename T, void (*Free)(T*)>
struct GslDeleter {
  void operator()(T* object) const { Free(object); }
};

template <typename T, void (*Free)(T*)>
using GslOwner = std::unique_ptr<T, GslDeleter<T, Free>>;

}  // namespace brash::statistics
