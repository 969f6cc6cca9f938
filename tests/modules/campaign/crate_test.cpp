// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "brash/core/sha256.hpp"
#include "collect.hpp"
#include "scratch.hpp"

using namespace brash;
using namespace brash::campaign;

namespace {

/// A folder with the files that a campaign of `n_cases` cases leaves.
void lay_out(const Scratch& scratch, int n_cases) {
  for (const char* const name : {"campaign.csv", "campaign.nc", "summary.json", "manifest.json"})
    scratch.write(name, name);
  std::filesystem::create_directories(scratch.folder() / "settings");
  scratch.write("settings/a.toml", "x = 1\n");
  for (int i = 0; i < n_cases; ++i) {
    const std::string folder = "cases/a-r000" + std::to_string(i);
    std::filesystem::create_directories(scratch.folder() / folder);
    scratch.write(folder + "/manifest.json",
                  R"({"volatile": {"started_at": "2026-11-2)" + std::to_string(i) + R"(T10:00:00Z"}})");
  }
}

nlohmann::json entity(const Scratch& scratch, const std::string& id) {
  const auto crate = nlohmann::json::parse(read_bytes(scratch.path(kCrateFile)));
  for (const auto& found : crate["@graph"])
    if (found["@id"] == id) return found;
  return {};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(crate)

BOOST_AUTO_TEST_CASE(a_crate_lists_every_file_with_the_size_and_hash_that_it_has) {
  const Scratch scratch;
  lay_out(scratch, 3);
  write_crate(scratch.folder().string());
  const auto root = entity(scratch, "./");
  BOOST_TEST(root["hasPart"].size() == 8u);
  for (const auto& part : root["hasPart"]) {
    const auto file = entity(scratch, part["@id"].get<std::string>());
    const std::string bytes = read_bytes(scratch.path(part["@id"].get<std::string>()));
    BOOST_TEST(file["sha256"] == sha256(bytes));
    BOOST_TEST(file["contentSize"] == std::to_string(bytes.size()));
  }
  BOOST_TEST(root["datePublished"] == "2026-11-22T10:00:00Z");
}

BOOST_AUTO_TEST_CASE(the_licence_that_a_user_gave_the_results_outlives_a_campaign_that_grows) {
  const Scratch scratch;
  lay_out(scratch, 1);
  scratch.write(kCrateFile, R"({"@graph": [{"@id": "./", "license": {"@id": "by"}, "name": "mine"}]})");
  lay_out(scratch, 2);
  write_crate(scratch.folder().string());
  BOOST_TEST(entity(scratch, "./")["license"]["@id"] == "by");
  BOOST_TEST(entity(scratch, "./")["hasPart"].size() == 7u);
}

BOOST_AUTO_TEST_CASE(the_people_and_the_licence_to_which_the_users_words_lead_are_kept_once) {
  const Scratch scratch;
  lay_out(scratch, 1);
  scratch.write(kCrateFile, R"({"@graph": [
    {"@id": "./", "license": {"@id": "by"}, "author": [{"@id": "#ada"}, {"@id": "#gone"}, {"@id": "#ben"}]},
    {"@id": "by", "@type": "CreativeWork", "name": "CC BY 4.0"},
    {"@id": "#ada", "@type": "Person", "affiliation": {"@id": "#lab"}, "knows": {"@id": "#ben"}},
    {"@id": "#ben", "@type": "Person", "knows": [{"@id": "#ada"}, {"@id": "campaign.csv"}]},
    {"@id": "#lab", "@type": "Organization"}, {"@id": "#other", "@type": "Person"},
    {"@id": "campaign.csv", "@type": "File", "sha256": "old"}, 7]})");
  for (int round = 0; round < 2; ++round) {
    write_crate(scratch.folder().string());
    const auto crate = nlohmann::json::parse(read_bytes(scratch.path(kCrateFile)));
    for (const char* const id : {"by", "#ada", "#ben", "#lab", "campaign.csv", "./"})
      BOOST_TEST(std::ranges::count_if(crate["@graph"], [&](const auto& e) { return e["@id"] == id; }) == 1, id);
    BOOST_TEST(entity(scratch, "by")["name"] == "CC BY 4.0");
    BOOST_TEST(entity(scratch, "#other").is_null());
    BOOST_TEST(entity(scratch, "campaign.csv")["sha256"] == sha256("campaign.csv"));
  }
}

BOOST_AUTO_TEST_CASE(a_crate_that_is_no_json_is_written_again) {
  const Scratch scratch;
  lay_out(scratch, 1);
  scratch.write(kCrateFile, "{\"@graph\": [3");
  write_crate(scratch.folder().string());
  BOOST_TEST(entity(scratch, "./")["hasPart"].size() == 6u);
}

BOOST_AUTO_TEST_SUITE_END()
