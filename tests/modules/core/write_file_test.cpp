// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/core/write_file.hpp"

#include <sys/resource.h>

#include <boost/test/unit_test.hpp>
#include <csignal>

#include "brash/core/error.hpp"
#include "scratch.hpp"

using namespace brash;

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

BOOST_AUTO_TEST_CASE(a_link_under_the_name_of_a_part_is_not_followed) {
  const Scratch scratch;
  scratch.write("diary", "dear diary");
  std::filesystem::create_symlink(scratch.path("diary"), part_of(scratch.path("a.txt")));
  write_file(scratch.path("a.txt"), "text");
  BOOST_TEST(read_bytes(scratch.path("diary")) == "dear diary");
  BOOST_TEST(read_bytes(scratch.path("a.txt")) == "text");
  BOOST_TEST(std::filesystem::is_regular_file(std::filesystem::symlink_status(scratch.path("a.txt"))));
  BOOST_TEST(n_files(scratch.folder()) == 2u);
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

BOOST_AUTO_TEST_CASE(what_killed_processes_left_of_files_is_removed_and_nothing_else) {
  const Scratch scratch;
  for (const char* name : {"a.txt.123.part", "b.4.part", "a.txt", "c.part", "d.12x.part", "5.part", "e..part"})
    scratch.write(name, "x");
  std::filesystem::create_directory(scratch.path("case-1.part"));
  remove_parts(scratch.folder());
  BOOST_TEST(n_files(scratch.folder()) == 6u);
  BOOST_TEST(!std::filesystem::exists(scratch.path("a.txt.123.part")));
  BOOST_TEST(!std::filesystem::exists(scratch.path("b.4.part")));
  BOOST_CHECK_NO_THROW(remove_parts(scratch.path("missing")));
}

BOOST_AUTO_TEST_SUITE_END()
