// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace brash {

/// Thrown by a check that wants a computation to end. It is not a std::exception, so that nothing takes it for a
/// failure.
struct Interruption {};

/// A check that long computations of this thread call now and then; it throws when whoever waits wants them to end.
using InterruptionCheck = void (*)();
inline thread_local InterruptionCheck interruption_check = nullptr;

/// One look, for the outer loops of computations that may take seconds.
inline void look_for_interruption() {
  if (interruption_check != nullptr) interruption_check();
}

/// Sets the check of this thread for as long as it lives.
class CheckedForInterruption {
 public:
  explicit CheckedForInterruption(InterruptionCheck check) : before_(interruption_check) { interruption_check = check; }
  CheckedForInterruption(const CheckedForInterruption&) = delete;
  CheckedForInterruption& operator=(const CheckedForInterruption&) = delete;
  ~CheckedForInterruption() { interruption_check = before_; }

 private:
  InterruptionCheck before_;
};

}  // namespace brash
