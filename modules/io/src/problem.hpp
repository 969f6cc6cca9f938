// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace brash::io {

/// Where a value was written: "cone.toml:3:11", or "cone.toml, --set ice.thickness=-1".
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
  std::string override_text;  ///< not empty: the value came from --set

  std::string text() const;
};

/// One thing that is wrong with a case file.
struct Problem {
  Place place;
  std::string key;      ///< "ice.thickness"
  std::string value;    ///< as written; empty when there is none
  std::string what;     ///< the fault
  std::string allowed;  ///< the allowed values
  std::string nearest;  ///< nearest known name; empty when there is none
  std::string remedy;   ///< the user's next action
};

/// Throws one InputError that lists `problems` in the order of the file.
[[noreturn]] void refuse(std::vector<Problem> problems);

}  // namespace brash::io
