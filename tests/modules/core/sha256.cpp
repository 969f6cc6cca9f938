// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/core/sha256.hpp"

#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>

#include "brash/core/error.hpp"

namespace {

using namespace brash;

/// The SHA-256 of "abc" as in FIPS 180-4's examples.
constexpr const char* kDigestOfAbc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

BOOST_AUTO_TEST_CASE(the_digest_of_abc_is_the_published_one_whole_in_pieces_and_from_a_file) {
  BOOST_TEST(sha256("abc") == kDigestOfAbc);
  Sha256 pieces;
  pieces.add("a");
  pieces.add("bc");
  BOOST_TEST(hexadecimal(pieces.digest()) == kDigestOfAbc);
  const auto file = std::filesystem::temp_directory_path() / ("brash_sha256_" + std::to_string(::getpid()));
  std::ofstream(file) << "abc";
  BOOST_TEST(sha256_of_file(file) == kDigestOfAbc);
  std::filesystem::remove(file);
}

BOOST_AUTO_TEST_CASE(a_file_that_is_not_there_has_no_digest) {
  BOOST_CHECK_THROW(sha256_of_file("/nonexistent"), RunError);
}

}  // namespace
