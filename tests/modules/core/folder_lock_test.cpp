// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/core/folder_lock.hpp"

#include <boost/test/unit_test.hpp>

#include "brash/core/error.hpp"
#include "scratch.hpp"

using namespace brash;

BOOST_AUTO_TEST_SUITE(locked_folders)

BOOST_AUTO_TEST_CASE(one_at_a_time_holds_a_folder_and_leaves_nothing_in_it) {
  const Scratch scratch;
  {
    const FolderLock lock = FolderLock::take_or_refuse(scratch.path("a/b"), "lock");
    BOOST_TEST(!FolderLock::take(scratch.path("a/b/lock")).has_value());
    BOOST_CHECK_EXCEPTION(FolderLock::take_or_refuse(scratch.path("a/b"), "lock"), InputError,
                          [](const InputError& error) {
                            const std::string said = error.what();
                            return said.find("a/b: is in use by process ") != std::string::npos &&
                                   said.find("remedy:") != std::string::npos;
                          });
  }
  BOOST_TEST(std::filesystem::is_empty(scratch.folder()));
  {
    const FolderLock lock = FolderLock::take_or_refuse(scratch.path("a/b"), "lock");
    scratch.write("a/result", "");
  }
  BOOST_TEST(std::filesystem::exists(scratch.path("a/result")));
  BOOST_TEST(!std::filesystem::exists(scratch.path("a/b")));
}

BOOST_AUTO_TEST_CASE(a_lock_file_that_was_left_behind_locks_nobody_out) {
  const Scratch scratch;
  scratch.write("lock", "process 1 on a machine that is gone\n");
  BOOST_TEST(FolderLock::take(scratch.path("lock")).has_value());
}

BOOST_AUTO_TEST_CASE(a_lock_in_a_folder_that_got_another_name_leaves_the_new_one_of_the_old_name_alone) {
  const Scratch scratch;
  std::optional<FolderLock> first = FolderLock::take_or_refuse(scratch.path("part"), "lock");
  std::filesystem::rename(scratch.path("part"), scratch.path("whole"));
  const FolderLock second = FolderLock::take_or_refuse(scratch.path("part"), "lock");
  first.reset();
  BOOST_TEST(std::filesystem::exists(scratch.path("part/lock")));
  BOOST_TEST(!FolderLock::take(scratch.path("part/lock")).has_value());
}

BOOST_AUTO_TEST_CASE(a_link_or_a_file_of_something_else_is_neither_taken_nor_changed) {
  const Scratch scratch;
  scratch.write("diary", "dear diary");
  std::filesystem::create_symlink(scratch.path("diary"), scratch.path("link"));
  std::filesystem::create_symlink(scratch.path("nowhere"), scratch.path("dangling"));
  std::filesystem::create_hard_link(scratch.path("diary"), scratch.path("second"));
  std::filesystem::create_directory(scratch.path("folder"));
  for (const char* const name : {"link", "dangling", "second", "diary", "folder"}) {
    BOOST_CHECK_THROW(FolderLock::take(scratch.path(name)), InputError);
    FolderLock::remove_stale(scratch.path(name));
    BOOST_TEST(std::filesystem::exists(std::filesystem::symlink_status(scratch.path(name))), name);
  }
  BOOST_TEST(read_bytes(scratch.path("diary")) == "dear diary");
  BOOST_TEST(!std::filesystem::exists(scratch.path("nowhere")));
}

BOOST_AUTO_TEST_CASE(a_lock_that_nobody_holds_is_removed_and_one_that_is_held_stays) {
  const Scratch scratch;
  scratch.write("lock", "process 1 on a machine that is gone\n");
  FolderLock::remove_stale(scratch.path("lock"));
  BOOST_TEST(!std::filesystem::exists(scratch.path("lock")));
  const std::optional<FolderLock> held = FolderLock::take(scratch.path("lock"));
  FolderLock::remove_stale(scratch.path("lock"));
  BOOST_TEST(std::filesystem::exists(scratch.path("lock")));
}

BOOST_AUTO_TEST_CASE(a_folder_that_cannot_be_made_is_named) {
  const Scratch scratch;
  scratch.write("file", "");
  BOOST_CHECK_THROW(FolderLock::take_or_refuse(scratch.path("file/a"), "lock"), InputError);
  BOOST_TEST(!FolderLock::take(scratch.path("missing/lock")).has_value());
}

BOOST_AUTO_TEST_SUITE_END()
