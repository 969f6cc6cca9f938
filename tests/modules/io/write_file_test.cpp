// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/resource.h>

#include <boost/test/unit_test.hpp>
#include <csignal>

#include "brash/core/error.hpp"
#include "brash/io/results.hpp"
#include "scratch.hpp"

using namespace brash;
using namespace brash::io;

namespace {

std::size_t n_files(const std::filesystem::path& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(whole_files)

BOOST_AUTO_TEST_CASE(a_written_file_has_its_text_and_leaves_nothing_beside_it) {
  const Scratch scratch;
  const std::string text("one\0two\n", 8);
  write_file(scratch.path("a.txt"), text);
  BOOST_TEST(read_bytes(scratch.path("a.txt")) == text);
  write_file(scratch.path("a.txt"), "new");
  BOOST_TEST(read_bytes(scratch.path("a.txt")) == "new");
  BOOST_TEST(n_files(scratch.folder()) == 1u);
}

BOOST_AUTO_TEST_CASE(a_folder_that_is_missing_is_made) {
  const Scratch scratch;
  write_file(scratch.path("x/y/a.txt"), "text");
  BOOST_TEST(read_bytes(scratch.path("x/y/a.txt")) == "text");
}

BOOST_AUTO_TEST_CASE(a_full_disk_leaves_the_old_file_and_no_half_one) {
  const Scratch scratch;
  write_file(scratch.path("a.txt"), "old");

  // A limit on the size of files stands for a full disk.
  rlimit before{};
  BOOST_REQUIRE(::getrlimit(RLIMIT_FSIZE, &before) == 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{1000, before.rlim_max};
  BOOST_REQUIRE(::setrlimit(RLIMIT_FSIZE, &small) == 0);
  std::string message;
  try {
    write_file(scratch.path("a.txt"), std::string(5000, 'x'));
  } catch (const RunError& error) {
    message = error.what();
  }
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);

  BOOST_TEST(message.find("a.txt: cannot be written: File too large") != std::string::npos, message);
  BOOST_TEST(read_bytes(scratch.path("a.txt")) == "old");
  BOOST_TEST(n_files(scratch.folder()) == 1u);
}

BOOST_AUTO_TEST_CASE(a_place_that_cannot_be_written_is_named_with_the_reason) {
  const Scratch scratch;
  scratch.write("file", "");
  BOOST_CHECK_EXCEPTION(write_file(scratch.path("file/a.txt"), "x"), RunError, [](const RunError& error) {
    return std::string(error.what()).find("file/a.txt: cannot be written: ") != std::string::npos;
  });
}

BOOST_AUTO_TEST_SUITE_END()
