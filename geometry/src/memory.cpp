// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/geometry/memory.hpp"

#include <gmp.h>

#include <cstdlib>
#include <new>

extern "C" void* __gmp_default_allocate(std::size_t size);  // NOLINT: GMP's own name

namespace brash::geometry {
namespace {

void* checked(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

// GMP has its memory from the C library too, so that numbers made before are grown and freed alike. It grows a number
// before it changes it, and is compiled with tables to unwind, as all of Debian is.
void* allocate(std::size_t size) { return checked(std::malloc(size)); }
void* reallocate(void* old, std::size_t, std::size_t size) { return checked(std::realloc(old, size)); }

}  // namespace

void throw_where_memory_is_short() {
  void* (*now)(std::size_t) = nullptr;
  mp_get_memory_functions(&now, nullptr, nullptr);
  if (now == &__gmp_default_allocate) mp_set_memory_functions(&allocate, &reallocate, nullptr);
}

}  // namespace brash::geometry
