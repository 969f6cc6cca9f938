// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer: any bytes are a case, or an InputError. The text of a case that was read gives the same case again.
#include <cstdlib>

#include "brash/core/error.hpp"
#include "brash/io/case.hpp"
#include "scratch_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string text;
  try {
    text = brash::io::to_toml(brash::io::parse_case(std::string(text_of(data, size)), "fuzz.toml"));
  } catch (const brash::InputError&) {
    return 0;
  }
  if (brash::io::to_toml(brash::io::parse_case(text, "fuzz.toml")) != text) std::abort();
  return 0;
}
