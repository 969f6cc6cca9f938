// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace brash::simulation {

/// Books wall time to one stage at a time: a stage within another stops the outer one's clock.
class StageTimer {
 public:
  /// Books to `seconds` until it ends.
  class Scope {
   public:
    Scope(StageTimer& timer, double& seconds) : timer_(timer), outer_(timer.current_) { timer_.book_to(&seconds); }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;
    ~Scope() { timer_.book_to(outer_); }

   private:
    StageTimer& timer_;
    double* outer_;
  };

 private:
  using Clock = std::chrono::steady_clock;

  void book_to(double* next) {
    const Clock::time_point now = Clock::now();
    if (current_ != nullptr) *current_ += std::chrono::duration<double>(now - since_).count();
    current_ = next;
    since_ = now;
  }

  double* current_ = nullptr;
  Clock::time_point since_;
};

}  // namespace brash::simulation
