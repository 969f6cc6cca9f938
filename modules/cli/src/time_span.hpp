// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "brash/core/text.hpp"

namespace brash::cli {

/// Check of an option that is a span of time [s]: from a nanosecond to thirty years.
inline CLI::Validator time_span() {
  return {[](const std::string& text) -> std::string {
            double seconds = 0.0;
            if (CLI::detail::lexical_cast(text, seconds) && seconds >= 1e-9 && seconds <= 1e9) return {};
            return "'" + printable(text) + "' is not a span of time: seconds from 1e-9 to 1e9 are allowed";
          },
          "SECONDS"};
}

}  // namespace brash::cli
