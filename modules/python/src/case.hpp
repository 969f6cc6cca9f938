// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "brash/model/case.hpp"

namespace brash::python {

/// How many runs of a case are in progress. A copy of the case begins without any.
struct RunsNow {
  int n = 0;

  RunsNow() = default;
  RunsNow(const RunsNow&) {}
  RunsNow& operator=(const RunsNow&) { return *this; }
};

/// A case with its source, so that a change is checked as the command line checks it.
struct Case {
  std::string text;  ///< of the case file
  std::string path;  ///< of the file; where there is none, its name in messages
  bool has_file = false;
  std::vector<std::string> overrides;
  model::Case resolved;
  mutable RunsNow runs{};  ///< the GIL guards it
};

/// The case read again with `changes`, a dict of "section.key" and values. @throws InputError as the command line does.
Case with_changes(const Case& c, const pybind11::dict& changes);

}  // namespace brash::python
