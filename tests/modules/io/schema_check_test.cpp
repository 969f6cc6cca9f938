// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>
#include <string>

#include "brash/core/contract.hpp"
#include "schema.hpp"

using brash::io::allows;
using nlohmann::json;

namespace {

/// Whether a schema, as text, allows a value, as text.
bool allowed(const char* schema, const char* value) {
  return allows(brash::io::OrderedJson::parse(schema), json::parse(value));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(schema_check)

BOOST_AUTO_TEST_CASE(a_value_has_one_of_the_listed_types) {
  const char* const quantity = R"({"type": ["number", "string"]})";
  BOOST_TEST(allowed(quantity, "0.33"));
  BOOST_TEST(allowed(quantity, "3"));
  BOOST_TEST(allowed(quantity, R"("0.33 m")"));
  BOOST_TEST(!allowed(quantity, "true"));
  BOOST_TEST(!allowed(quantity, "[0.33]"));
  BOOST_TEST(!allowed(R"({"type": "integer"})", "3.0"));
  BOOST_TEST(!allowed(R"({"type": "number"})", R"("3")"));
}

BOOST_AUTO_TEST_CASE(a_number_lies_within_the_limits_which_belong_to_the_range_unless_they_are_exclusive) {
  const char* const closed = R"({"minimum": 0, "maximum": 2.5})";
  for (const char* const inside : {"0", "2.5", "1"}) BOOST_TEST(allowed(closed, inside));
  for (const char* const outside : {"-1e-9", "2.6", "-3"}) BOOST_TEST(!allowed(closed, outside));
  const char* const open = R"({"exclusiveMinimum": 0, "exclusiveMaximum": 1})";
  BOOST_TEST(allowed(open, "0.5"));
  for (const char* const outside : {"0", "1", "1.5"}) BOOST_TEST(!allowed(open, outside));
  BOOST_TEST(allowed(closed, R"("9 m")"));  // a quantity in text is checked once its unit is converted
}

BOOST_AUTO_TEST_CASE(a_choice_is_one_of_the_listed_names) {
  const char* const kinds = R"({"type": "string", "enum": ["cone", "ship"]})";
  BOOST_TEST(allowed(kinds, R"("ship")"));
  BOOST_TEST(!allowed(kinds, R"("Ship")"));
}

BOOST_AUTO_TEST_CASE(an_array_has_as_many_items_as_allowed_and_each_is_allowed) {
  const char* const pairs = R"({"type": "array", "minItems": 1, "maxItems": 2,
    "items": {"type": "array", "minItems": 2, "maxItems": 2, "items": {"type": "number", "maximum": 9}}})";
  BOOST_TEST(allowed(pairs, "[[1, 2], [3, 4]]"));
  for (const char* const wrong : {"[]", "[[1, 2], [3, 4], [5, 6]]", "[[1]]", "[[1, 10]]", "[1, 2]"})
    BOOST_TEST(!allowed(pairs, wrong));
}

BOOST_AUTO_TEST_CASE(a_text_is_measured_in_characters) {
  const char* const two = R"({"maxLength": 2})";
  BOOST_TEST(allowed(two, R"("µm")"));
  BOOST_TEST(!allowed(two, R"("abc")"));
}

BOOST_AUTO_TEST_CASE(a_keyword_that_is_not_checked_breaks_the_contract) {
  BOOST_CHECK_THROW(allowed(R"({"pattern": "a*"})", R"("b")"), brash::ContractViolation);
  BOOST_TEST(allowed(R"({"description": "", "default": 1, "examples": [], "x-unit": "m"})", "2"));
}

BOOST_AUTO_TEST_SUITE_END()
