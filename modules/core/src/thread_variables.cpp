// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/core/thread_variables.hpp"

#include <pthread.h>

#include <cstdlib>
#include <exception>

#include "brash/core/interruption.hpp"

namespace brash {
namespace {

/// Which threads have their variables. Unlike a variable of a thread, a key of the C library needs no memory in it.
class ReadyThreads {
 public:
  bool has_this() const { return works_ && pthread_getspecific(key_) != nullptr; }
  void add_this() const {
    if (works_) pthread_setspecific(key_, this);
  }

 private:
  pthread_key_t key_{};
  bool works_ = pthread_key_create(&key_, nullptr) == 0;
};

}  // namespace

bool make_thread_variables() noexcept {
  static const ReadyThreads ready;
  if (ready.has_this()) return true;
  // The variables take 33 kB, nearly all of them in CGAL. The room freed here is for them.
  constexpr std::size_t kRoom = std::size_t{96} << 10;
  void* volatile const room = std::malloc(kRoom);
  if (room == nullptr) return false;
  std::free(room);
  volatile InterruptionCheck mine = interruption_check;
  volatile int in_flight = std::uncaught_exceptions();
  static_cast<void>(mine);
  static_cast<void>(in_flight);
  ready.add_this();
  return true;
}

}  // namespace brash
