// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/core/thread_variables.hpp"

#include <cstdlib>
#include <exception>

#include "brash/core/interruption.hpp"

namespace brash {

bool make_thread_variables() noexcept {
  // The variables take 33 kB, nearly all of them in CGAL. The room freed here is for them.
  constexpr std::size_t kRoom = std::size_t{96} << 10;
  void* volatile const room = std::malloc(kRoom);
  if (room == nullptr) return false;
  std::free(room);
  volatile InterruptionCheck mine = interruption_check;
  volatile int in_flight = std::uncaught_exceptions();
  static_cast<void>(mine);
  static_cast<void>(in_flight);
  return true;
}

}  // namespace brash
