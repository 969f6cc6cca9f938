// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

namespace brash {

/// A broken contract: a bug in the program, never a user's error. Always on.
class ContractViolation : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

namespace detail {

template <typename... Values>
[[noreturn]] void contract_failed(const char* condition, const char* file, int line, const Values&... values) {
  std::ostringstream message;
  message << file << ':' << line << ": contract broken: " << condition;
  ((message << ", " << values), ...);
  throw ContractViolation(message.str());
}

}  // namespace detail
}  // namespace brash

/// Throws ContractViolation with the given values when `condition` does not hold.
#define BRASH_EXPECTS(condition, ...)                                                              \
  do {                                                                                             \
    if (!(condition))                                                                              \
      ::brash::detail::contract_failed(#condition, __FILE__, __LINE__ __VA_OPT__(, ) __VA_ARGS__); \
  } while (false)
