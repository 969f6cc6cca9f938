// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "brash/model/case.hpp"

namespace brash::python {

/// How many runs of a case go on. A copy of the case begins without any.
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

}  // namespace brash::python
