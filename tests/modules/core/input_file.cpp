// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/core/input_file.hpp"

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "brash/core/error.hpp"
#include "brash/core/text.hpp"

namespace brash {
namespace {

struct File {
  std::filesystem::path path = std::filesystem::temp_directory_path() / "brash-input-file-test";
  explicit File(const std::string& text) { std::ofstream(path, std::ios::binary) << text; }
  ~File() { std::filesystem::remove(path); }
};

bool says(const InputError& error, const std::string& words) {
  return std::string(error.what()).find(words) != std::string::npos;
}

BOOST_AUTO_TEST_CASE(a_complaint_has_four_parts_and_steers_no_terminal) {
  const InputError error(Complaint{"a.csv:3", "x = '\x1b[2J\n\xff'", "numbers", "correct it"});
  BOOST_TEST(error.what() == "a.csv:3: x = '\\x1b[2J\\x0a\\xff'\n  allowed: numbers\n  remedy:  correct it");
}

BOOST_AUTO_TEST_CASE(long_text_is_cut_between_characters) {
  BOOST_TEST(printable(std::string(80, 'a')) == std::string(80, 'a'));
  BOOST_TEST(printable(std::string(79, 'a') + "\xc3\xa4" + "b") == std::string(79, 'a') + "...");
}

BOOST_AUTO_TEST_CASE(a_file_is_read_up_to_its_limit_and_not_beyond) {
  const std::string mebibyte(std::size_t{1} << 20, 'a');
  BOOST_TEST(read_text_file(File(mebibyte).path, "a text", 1) == mebibyte);
  BOOST_TEST(read_text_file(File("").path, "a text", 1).empty());
  const File larger(mebibyte + "a");
  BOOST_CHECK_EXCEPTION(read_text_file(larger.path, "a text", 1), InputError,
                        [](const InputError& e) { return says(e, "is larger than 1 MiB\n  allowed: a text"); });
  // A device has no size to look at first.
  BOOST_CHECK_EXCEPTION(read_text_file("/dev/zero", "a text", 1), InputError,
                        [](const InputError& e) { return says(e, "/dev/zero: is larger than 1 MiB"); });
  BOOST_CHECK_EXCEPTION(read_text_file("/", "a text", 1), InputError,
                        [](const InputError& e) { return says(e, "/: is a folder"); });
}

BOOST_AUTO_TEST_CASE(a_file_is_read_line_by_line_across_its_blocks) {
  // Lines that end before, at and after the ends of blocks of 64 KiB; the last one has no end.
  std::vector<std::string> expected{"", "a\r", std::string(65'531, 'b'), "c", std::string(200'000, 'd'), "", "e"};
  std::string text;
  for (const std::string& line : expected) text += line + "\n";
  text.pop_back();
  std::vector<std::string> lines;
  for_each_line(File(text).path, "a text", [&](std::string_view line) { lines.emplace_back(line); });
  BOOST_TEST(lines == expected, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(json_is_measured_in_depth_outside_of_its_strings) {
  const std::string deep(64, '['), strings = R"(["[[[[", "\"[[", "\\"])";
  BOOST_TEST(read_json_text(File(deep).path, "JSON") == deep);
  BOOST_TEST(read_json_text(File(strings + deep).path, "JSON").size() == strings.size() + deep.size());
  const File deeper("[]" + deep + "{");
  BOOST_CHECK_EXCEPTION(read_json_text(deeper.path, "JSON"), InputError,
                        [](const InputError& e) { return says(e, "byte 67: is nested too deeply"); });
}

BOOST_AUTO_TEST_CASE(no_file_makes_room_for_more_than_its_bytes_can_hold) {
  BOOST_TEST(most_values_in(0) == 0u);
  BOOST_TEST(most_values_in(10) == 10320u);
  BOOST_TEST(most_values_in(std::uintmax_t{1} << 62) == std::size_t{1} << 27);
}

}  // namespace
}  // namespace brash
