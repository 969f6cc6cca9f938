// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "brash/core/interruption.hpp"

namespace brash::python {

/// Releases the GIL while it lives. An interpreter that ends waits for every live Released (see wait_for_calls()): a
/// thread that asks an ended one for the GIL would end the process.
class Released {
 public:
  Released() = default;
  Released(const Released&) = delete;
  Released& operator=(const Released&) = delete;

  /// Whether the interpreter is about to end.
  static bool is_closing() { return closing; }
  /// Ends the calling thread of an interpreter that is about to end. It says nothing: a traceback on a stderr that is
  /// being closed would abort the process (Python 3.13).
  static void raise_end() { PyErr_SetString(PyExc_SystemExit, "the interpreter is about to end"); }
  /// Has all calls end soon, and waits for them, a minute at most. For atexit; holds the GIL.
  static void wait_for_calls() {
    closing = true;
    const pybind11::gil_scoped_release release;
    for (int i = 0; i < 6000 && n_calls > 0; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }

 private:
  struct Count {
    Count() {
      if (closing) {
        raise_end();
        throw pybind11::error_already_set();
      }
      ++n_calls;
    }
    Count(const Count&) = delete;
    Count& operator=(const Count&) = delete;
    ~Count() { --n_calls; }
  };
  static inline std::atomic<bool> closing = false;
  static inline std::atomic<int> n_calls = 0;

  Count count_;
  pybind11::gil_scoped_release release_;  ///< goes first
};

/// Lets Python see Ctrl-C during a long call that has released the GIL.
class SignalPoll {
 public:
  /// Whether a signal handler has raised; asks Python at most ten times a second. The Python error stays pending.
  bool raised() {
    const auto now = std::chrono::steady_clock::now();
    if (now - asked_ < std::chrono::milliseconds(100)) return false;
    asked_ = now;
    const pybind11::gil_scoped_acquire gil;
    if (Released::is_closing()) {
      Released::raise_end();
      return true;
    }
    return PyErr_CheckSignals() != 0;
  }

 private:
  std::chrono::steady_clock::time_point asked_ = std::chrono::steady_clock::now();
};

/// Lets Python see Ctrl-C in a computation without the GIL. @throws pybind11::error_already_set, as its handler says.
inline void raise_signals_without_gil() {
  static thread_local SignalPoll poll;
  if (!poll.raised()) return;
  const pybind11::gil_scoped_acquire gil;
  throw pybind11::error_already_set();
}

/// Calls a computation that touches nothing of Python, without the GIL. Ctrl-C ends it where it looks for that.
template <typename Call>
auto unlocked(Call call) {
  const Released release;
  const CheckedForInterruption checked(&raise_signals_without_gil);
  return call();
}

/// Calls `piece(i)` for i in [0, n) without the GIL; raises the exception of a signal handler between two pieces.
template <typename Piece>
void without_gil(std::size_t n, Piece piece) {
  bool raised = false;
  {
    const Released release;
    SignalPoll poll;
    for (std::size_t i = 0; i < n && !raised; ++i) {
      piece(i);
      raised = poll.raised();
    }
  }
  if (raised) throw pybind11::error_already_set();
}

/// Holds a service for one call: its state may not be touched by a second thread while the first is inside.
class Busy {
 public:
  Busy(bool& flag, const char* what) : flag_(flag) {
    if (flag_) throw std::runtime_error(std::string(what) + " is in use by another thread");
    flag_ = true;
  }
  Busy(const Busy&) = delete;
  Busy& operator=(const Busy&) = delete;
  ~Busy() { flag_ = false; }

 private:
  bool& flag_;
};

}  // namespace brash::python
