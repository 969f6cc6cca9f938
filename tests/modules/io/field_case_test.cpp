// SPDX-License-Identifier: GPL-3.0-or-later
// The keys of a field of floes: read, written, and refused where they do not go together.
#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "brash/core/error.hpp"
#include "brash/io/case.hpp"
#include "scratch.hpp"

using namespace brash;
using namespace brash::io;
using namespace brash::model;

namespace {

/// The least case with a field of floes; `more` are its further lines.
std::string field_of_floes(const std::string& more) {
  std::string text = kLeastCase;
  const std::size_t at = text.find("[field]\n") + 8;
  return text.insert(at, "kind = \"floes\"\n") + more;
}

const std::string kSizes = "[field.size]\nleast = 2\nlargest = \"600 cm\"\n";

Case read(const std::string& text, const std::vector<std::string>& overrides = {"field.concentration=0.7"}) {
  const Scratch scratch;
  return read_case(scratch.write("floes.toml", text), overrides);
}

void refuses(const std::string& text, const std::vector<std::string>& overrides, const std::string& part) {
  BOOST_CHECK_EXCEPTION((void)read(text, overrides), InputError, [&](const InputError& error) {
    const bool has = std::string(error.what()).find(part) != std::string::npos;
    BOOST_TEST(has, "\"" << part << "\" is not in:\n" << error.what());
    return has;
  });
}

}  // namespace

BOOST_AUTO_TEST_SUITE(field_cases)

BOOST_AUTO_TEST_CASE(a_field_of_floes_is_read_in_si_and_written_again) {
  const Case c = read(field_of_floes(kSizes + "[wind]\nvelocity = [\"10 km/h\", 0]\n"));
  BOOST_TEST((c.field.kind == FieldKind::kFloes));
  BOOST_TEST(c.field.floes.concentration.value() == 0.7);
  BOOST_TEST(c.field.floes.size.largest.value() == 6.0);
  BOOST_TEST(c.wind.velocity.x == 10.0 / 3.6, boost::test_tools::tolerance(1e-12));
  const std::string written = to_toml(c);
  const Case again = read(written, {});
  BOOST_TEST(to_toml(again) == written);
  BOOST_TEST(written.find("initial_crack") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(level_ice_has_no_keys_of_floes) {
  const std::string written = to_toml(read(kLeastCase, {}));
  BOOST_TEST(written.find("field.size") == std::string::npos);
  BOOST_TEST(written.find("concentration") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(each_law_of_sizes_has_its_own_keys) {
  BOOST_TEST((read(field_of_floes("[field.size]\nkind = \"log-normal\"\nmedian = 3\n")).field.floes.size.kind ==
              SizeLaw::kLogNormal));
  const Case listed = read(field_of_floes("[field.size]\nkind = \"list\"\nvalues = [2, \"3 m\"]\n"));
  BOOST_TEST(listed.field.floes.size.values == (std::vector<double>{2.0, 3.0}), boost::test_tools::per_element());
  const std::vector<std::string> filled{"field.concentration=0.7"};
  refuses(field_of_floes(""), filled, "field.size.least");
  refuses(field_of_floes("[field.size]\nkind = \"log-normal\"\nleast = 3\n"), filled,
          "is not a key of field.size.kind = \"log-normal\"");
  refuses(field_of_floes("[field.size]\nleast = 6\nlargest = 3\n"), filled, "not less than the largest");
  refuses(field_of_floes("[field.size]\nleast = 6\nlargest = 300\n"), filled, "do not fit in the field");
}

BOOST_AUTO_TEST_CASE(keys_of_the_other_kind_of_field_are_refused_with_a_remedy) {
  refuses(field_of_floes(kSizes), {"field.concentration=0.7", "field.initial_crack=true"},
          "is not a key of field.kind = \"floes\"");
  refuses(kLeastCase, {"field.concentration=0.7"}, "is not a key of field.kind = \"level-ice\"");
  refuses(std::string(kLeastCase) + kSizes, {}, "is not a key of field.kind = \"level-ice\"");
  refuses(field_of_floes(kSizes), {}, "floes are generated, or read from a file");
  refuses(field_of_floes(kSizes), {"field.file=no.wkt"}, "there is no file");
  refuses(field_of_floes(kSizes), {"field.file=no.wkt", "field.concentration=0.7"},
          "cannot be combined with field.file");
}

BOOST_AUTO_TEST_CASE(one_key_names_the_borders_of_each_kind_of_field) {
  const std::vector<std::string> filled{"field.concentration=0.7"};
  const auto more = [&](const std::string& key) { return std::vector<std::string>{"field.concentration=0.7", key}; };
  BOOST_TEST((read(field_of_floes(kSizes), filled).field.floes.border == FloeBorder::kFree));
  BOOST_TEST((read(field_of_floes(kSizes), more("field.border=walls")).field.floes.border == FloeBorder::kWalls));
  BOOST_TEST((read(kLeastCase, {}).field.border == Border::kFixed));
  BOOST_TEST((read(kLeastCase, {"field.border=free"}).field.border == Border::kFree));
  refuses(kLeastCase, {"field.border=walls"}, "is not a choice of field.kind = \"level-ice\"");
  refuses(field_of_floes(kSizes), more("field.border=fixed"), "is not a choice of field.kind = \"floes\"");
  refuses(field_of_floes(kSizes), more("field.border=open"), "is not a known name");
  // The key of an earlier version names its successor.
  refuses(field_of_floes(kSizes), more("field.walls=true"), "write border = \"walls\" in its place");
  refuses(kLeastCase, {"failure.max_substeps=4"}, "remove it: the program has 8 in all cases");
  refuses(kLeastCase, {"contact.stiffness=1e7"}, "write collision_stiffness in its place");
  // Results of earlier versions hold all keys: one with the value that it has anyway is read.
  const std::vector<std::string> usual{"failure.max_substeps=8", "failure.arc_sides=16", "contact.delete_crushed=true",
                                       "contact.stiffness=1e6"};
  BOOST_TEST((read(kLeastCase, usual) == read(kLeastCase, {})));
}

BOOST_AUTO_TEST_CASE(files_of_level_ice_leave_the_initial_crack_out) {
  const Scratch scratch;
  const std::string lead = scratch.write("lead.wkt", "POLYGON((1 -1, 2 -1, 2 1, 1 1, 1 -1))");
  const Case c = read(kLeastCase, {"field.openings=" + lead});
  BOOST_TEST(c.field.openings == lead);
  BOOST_TEST(!c.field.initial_crack);
  BOOST_TEST(has_ice_files(c.field));
  BOOST_TEST(!has_ice_files(read(kLeastCase, {}).field));
  refuses(kLeastCase, {"field.openings=" + lead, "field.initial_crack=true"},
          "cannot be combined with files of the ice");
  refuses(kLeastCase, {"field.cracks=no.wkt"}, "there is no file");
  refuses(field_of_floes(kSizes), {"field.concentration=0.7", "field.cracks=" + lead},
          "is not a key of field.kind = \"floes\"");
}

BOOST_AUTO_TEST_CASE(a_rough_first_edge_is_refused_where_it_cannot_be_drawn) {
  const Case c = read(kLeastCase, {"field.edge_roughness=20 cm", "field.edge_correlation_length=2"});
  BOOST_TEST(c.field.edge_roughness == 0.2);
  refuses(kLeastCase, {"field.edge_roughness=" + std::to_string(c.field.length)}, "more than a tenth of the sheet's");
  refuses(kLeastCase, {"field.edge_roughness=0.1", "field.edge_correlation_length=0.001"},
          "a thousandth of the sheet's");
  const Scratch scratch;
  scratch.write("ice.wkt", "POLYGON((0 -3, 30 -3, 30 3, 0 3, 0 -3))");
  const std::string file = scratch.write("case.toml", kLeastCase);
  BOOST_CHECK_EXCEPTION(
      (void)read_case(file, {"field.file=ice.wkt", "field.edge_roughness=0.1"}), InputError,
      [](const InputError& e) { return std::string(e.what()).find("their own edge") != std::string::npos; });
}

BOOST_AUTO_TEST_CASE(the_schema_names_the_choices_of_the_model) {
  const auto field = nlohmann::json::parse(case_schema())["properties"]["field"]["properties"];
  std::vector<std::string> shapes, laws, of_sheets, of_floes;
  for (const auto& entry : kNames<Border>) of_sheets.emplace_back(entry.name);
  for (const auto& entry : kNames<FloeBorder>) of_floes.emplace_back(entry.name);
  BOOST_TEST(field["border"]["x-of-kinds"]["level-ice"].get<std::vector<std::string>>() == of_sheets);
  BOOST_TEST(field["border"]["x-of-kinds"]["floes"].get<std::vector<std::string>>() == of_floes);
  for (const auto& entry : kNames<FloeShape>) shapes.emplace_back(entry.name);
  for (const auto& entry : kNames<SizeLaw>) laws.emplace_back(entry.name);
  BOOST_TEST(field["shape"]["enum"].get<std::vector<std::string>>() == shapes);
  BOOST_TEST(field["size"]["properties"]["kind"]["enum"].get<std::vector<std::string>>() == laws);
}

BOOST_AUTO_TEST_SUITE_END()
