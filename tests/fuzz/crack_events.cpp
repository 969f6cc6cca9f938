// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer: any text is a list of crack events that a sheet can be given, or an InputError.
#include <cmath>
#include <cstdlib>

#include "brash/analysis/crack_run.hpp"
#include "brash/core/error.hpp"
#include "scratch_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    for (const brash::analysis::CrackEvent& event :
         brash::analysis::read_crack_events("fuzz.csv", std::string(text_of(data, size))))
      if (!std::isfinite(event.centre.x) || !std::isfinite(event.centre.y) || !(event.radius > 0.0) || event.wedges < 1)
        std::abort();
  } catch (const brash::InputError&) {
  }
  return 0;
}
