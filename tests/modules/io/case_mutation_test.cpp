// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever a file holds, reading it gives a case or an InputError: thousands of damaged copies of the validation case.
#include <boost/test/unit_test.hpp>
#include <random>

#include "brash/core/error.hpp"
#include "brash/io/case.hpp"
#include "scratch.hpp"

namespace {

constexpr int kMutations = 3000;

/// One to four damages: a byte replaced, removed or inserted, a stretch doubled or removed.
std::string damaged(std::string text, std::mt19937_64& random) {
  const std::string spice = "[]{}\"'=.,#\n\\-+_eE09 \t\0\xff\xc3nif";
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % std::max<std::size_t>(n, 1)); };
  for (std::size_t n = 1 + below(4); n > 0; --n) {
    const std::size_t at = below(text.size());
    const std::size_t length = below(std::min<std::size_t>(40, text.size() - at));
    switch (below(5)) {
      case 0:
        text[at] = spice[below(spice.size())];
        break;
      case 1:
        text.erase(at, 1);
        break;
      case 2:
        text.insert(at, 1, spice[below(spice.size())]);
        break;
      case 3:
        text.insert(below(text.size()), text.substr(at, length));
        break;
      default:
        text.erase(at, length);
    }
  }
  return text;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(case_mutations)

BOOST_AUTO_TEST_CASE(a_damaged_case_is_read_or_refused_and_nothing_else) {
  // The generator's sequence is fixed by the C++ standard.
  std::mt19937_64 random(20240229);
  const std::string whole = read_bytes(BRASH_SOURCE_DIR "/experiments/validation/cone.toml");
  const Scratch scratch;
  std::filesystem::create_directory(scratch.folder() / "again");
  int n_refused = 0;
  for (int i = 0; i < kMutations; ++i) {
    const std::string text = damaged(whole, random);
    // A new file each time: some file systems wait for the disk when a file is written over.
    const std::string path = scratch.write(std::to_string(i) + ".toml", text);
    try {
      const brash::model::Case read = brash::io::read_case(path);
      // The text of a case that was read gives the same case again.
      const brash::model::Case again =
          brash::io::read_case(scratch.write("again/" + std::to_string(i) + ".toml", brash::io::to_toml(read)));
      BOOST_REQUIRE_MESSAGE(again == read, text);
    } catch (const brash::InputError& error) {
      ++n_refused;
      const std::string message = error.what();
      BOOST_REQUIRE_MESSAGE(message.find("  allowed: ") != std::string::npos, message);
      BOOST_REQUIRE_MESSAGE(message.find("  remedy:  ") != std::string::npos, message);
    }
  }
  BOOST_TEST(n_refused > kMutations / 2);
  BOOST_TEST(n_refused < kMutations);
}

BOOST_AUTO_TEST_SUITE_END()
