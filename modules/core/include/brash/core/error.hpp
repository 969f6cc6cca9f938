// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace brash {

/// Bad input or environment. The message names file, key, value, what is allowed and the remedy. Exit code 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A run that cannot go on although its input was good. Exit code 1.
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
