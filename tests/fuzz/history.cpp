// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer: any text is a load history with a finite number of finite values, or an InputError.
#include <cmath>
#include <cstdlib>

#include "brash/analysis/load_history.hpp"
#include "brash/core/error.hpp"
#include "scratch_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ScratchFile file(".csv");
  const std::string& path = file.with(text_of(data, size));
  for (const double dt : {0.0, 0.1}) {
    try {
      brash::analysis::HistoryChoice choice;
      choice.dt = dt;
      const brash::analysis::LoadHistory read = brash::analysis::read_history(path, choice);
      for (const double value : read.history.values)
        if (!std::isfinite(value)) std::abort();
    } catch (const brash::InputError&) {
    }
  }
  return 0;
}
