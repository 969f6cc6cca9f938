// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <stdexcept>

namespace brash::python {

/// Lets Python see Ctrl-C during a long call that has released the GIL.
class SignalPoll {
 public:
  /// Whether a signal handler has raised; asks Python at most ten times a second. The Python error stays pending.
  bool raised() {
    const auto now = std::chrono::steady_clock::now();
    if (now - asked_ < std::chrono::milliseconds(100)) return false;
    asked_ = now;
    const pybind11::gil_scoped_acquire gil;
    return PyErr_CheckSignals() != 0;
  }

 private:
  std::chrono::steady_clock::time_point asked_ = std::chrono::steady_clock::now();
};

/// Calls `piece(i)` for i in [0, n) without the GIL; raises what a signal handler raised between two pieces.
template <typename Piece>
void without_gil(std::size_t n, Piece piece) {
  bool raised = false;
  {
    const pybind11::gil_scoped_release release;
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
