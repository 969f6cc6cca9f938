// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace brash {

/// A message to the user about bad input. Each part may contain text from a file: it is shown escaped.
struct Complaint {
  std::string where;    ///< file and place in it: "events.csv, line 3"
  std::string what;     ///< the value and the error in it
  std::string allowed;  ///< the values that may be there instead
  std::string remedy;   ///< the action that helps
};

/// Bad input or environment. The message names file, key, value, allowed values and remedy. Exit code 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  explicit InputError(const Complaint& complaint);
};

/// A run that cannot continue although its input was good. Exit code 1.
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file that the system would not write: the run itself is not at fault.
class StorageError : public RunError {
 public:
  using RunError::RunError;
};

}  // namespace brash
