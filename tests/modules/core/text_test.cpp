// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/core/text.hpp"

#include <boost/test/unit_test.hpp>

using namespace brash;

BOOST_AUTO_TEST_SUITE(shown_text)

BOOST_AUTO_TEST_CASE(controls_of_terminals_and_of_the_direction_of_writing_are_escaped) {
  BOOST_TEST(escaped("a\x1b[2J") == "a\\x1b[2J");
  BOOST_TEST(escaped("\xc2\x9b"
                     "31m") == "\\xc2\\x9b31m");             // CSI of C1
  BOOST_TEST(escaped("\xe2\x80\xae") == "\\xe2\\x80\\xae");  // right-to-left override
  BOOST_TEST(escaped("\xe2\x81\xa6") == "\\xe2\\x81\\xa6");  // left-to-right isolate
  BOOST_TEST(escaped("\x7f\xff") == "\\x7f\\xff");
}

BOOST_AUTO_TEST_CASE(letters_of_all_alphabets_are_left) {
  const std::string text = "\xc3\xa4 \xe6\xb0\xb7 \xd7\x90 \xf0\x9f\xa7\x8a \xc2\xa0";
  BOOST_TEST(escaped(text) == text);
  BOOST_TEST(escaped_lines(text + "\n\t") == text + "\n\t");
  BOOST_TEST(escaped_lines("a\rb") == "a\\x0db");
}

BOOST_AUTO_TEST_CASE(data_get_escapes_that_mean_the_same) {
  BOOST_TEST(escaped_as_unicode("\"\xc2\x9b\xe2\x80\xae\"\n") == "\"\\u009b\\u202e\"\n");
}

BOOST_AUTO_TEST_SUITE_END()
