// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/io/campaign_plan.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <set>

#include "brash/core/error.hpp"
#include "scratch.hpp"

using namespace brash;
using namespace brash::io;
using namespace brash::model;

namespace {

const std::vector<std::string> kColumns{"horizontal.mean", "vertical.mean"};

/// Reads `text` as a plan beside a least case named cone.toml.
CampaignPlan read(const std::string& text, bool quick = false, std::vector<std::string> overrides = {}) {
  const Scratch scratch;
  scratch.write("cone.toml", kLeastCase);
  return read_campaign_plan(scratch.write("plan.toml", text), {quick, {}, std::move(overrides), kColumns, kColumns});
}

const std::string kBase = "[campaign]\ncase = \"cone.toml\"\n";

std::string message_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    read(text, false, overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void check_has(const std::string& message, const std::vector<std::string>& parts) {
  for (const std::string& part : parts)
    BOOST_TEST(message.find(part) != std::string::npos, "\"" << part << "\" is not in:\n" << message);
}

/// A case as the sections of a plan.
std::string in_plan(std::string rest) {
  std::string inside;
  while (!rest.empty()) {
    const std::string line = rest.substr(0, rest.find('\n'));
    rest.erase(0, line.size() + 1);
    inside += (line.starts_with('[') ? "[case." + line.substr(1) : line) + "\n";
  }
  return inside;
}

std::vector<std::string> names(const CampaignPlan& plan) {
  std::vector<std::string> all;
  for (const Setting& setting : plan.settings) all.push_back(setting.name);
  return all;
}

const std::string kGrid = kBase + R"([set]
time.duration = 30
[[grid]]
structure.angle = ["55 deg", "61.4 deg", "65 deg"]
[[grid]]
structure.speed = [0.5, 1.2]
output.statistics_from = [16, 8]
)";

}  // namespace

BOOST_AUTO_TEST_SUITE(campaign_plan)

BOOST_AUTO_TEST_CASE(a_plan_without_a_grid_has_one_setting_with_the_name_of_its_case) {
  const CampaignPlan plan = read(kBase);
  BOOST_TEST(plan.replicates == 1);
  BOOST_TEST(plan.keep == "summary");
  BOOST_TEST(plan.columns == kColumns, boost::test_tools::per_element());
  BOOST_REQUIRE(plan.settings.size() == 1u);
  BOOST_TEST(plan.settings[0].name == "base");
  BOOST_TEST(plan.settings[0].resolved.name == "cone");
  BOOST_TEST(model::speed(plan.settings[0].resolved.structure.motion) == 1.202);
}

BOOST_AUTO_TEST_CASE(the_settings_are_all_combinations_the_last_axis_fastest) {
  const CampaignPlan plan = read(kGrid);
  const std::vector<std::string> expected{"angle-55deg_speed-0.5",   "angle-55deg_speed-1.2", "angle-61.4deg_speed-0.5",
                                          "angle-61.4deg_speed-1.2", "angle-65deg_speed-0.5", "angle-65deg_speed-1.2"};
  BOOST_TEST(names(plan) == expected, boost::test_tools::per_element());
  const Setting& setting = plan.settings[3];
  BOOST_TEST(setting.resolved.name == "cone_angle-61.4deg_speed-1.2");
  BOOST_TEST(model::speed(setting.resolved.structure.motion) == 1.2);
  BOOST_TEST(setting.resolved.time.duration == 30.0);
  BOOST_TEST(*setting.resolved.output.statistics_from == 8.0);
  // The keys in the order of the file, the values from the resolved case: an angle in rad.
  BOOST_REQUIRE(plan.keys.size() == 3u);
  BOOST_TEST(plan.keys[0].name == "structure.angle");
  BOOST_TEST(plan.keys[0].unit == "rad");
  BOOST_TEST(plan.keys[1].name == "structure.speed");
  BOOST_TEST(*setting.values[0].number == std::get<model::Cone>(setting.resolved.structure.shape).angle);
  BOOST_TEST(setting.values[2].text == "8");
}

BOOST_AUTO_TEST_CASE(each_setting_has_a_seed_of_its_own_that_follows_from_the_plans_seed) {
  BOOST_TEST(read(kBase).settings[0].resolved.random.seed == 1u);
  const auto seeds = [](const std::string& plan) {
    std::vector<std::uint64_t> all;
    for (const Setting& setting : read(plan).settings) all.push_back(setting.resolved.random.seed);
    return all;
  };
  const std::vector<std::uint64_t> all = seeds(kGrid);
  BOOST_TEST(std::set(all.begin(), all.end()).size() == all.size());
  BOOST_TEST(std::ranges::max(all) < (1ULL << 48));
  BOOST_TEST(seeds(kGrid) == all, boost::test_tools::per_element());
  const std::string grid = "[[grid]]\nstructure.speed = [0.5, 1.2]\n";
  const auto first = seeds(kBase + "[set]\nrandom.seed = 1\n" + grid),
             other = seeds(kBase + "[set]\nrandom.seed = 2\n" + grid);
  BOOST_TEST(first[0] != other[0]);
  BOOST_TEST(seeds(kBase + grid) == first, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_grid_over_seeds_keeps_them) {
  const CampaignPlan plan = read(kBase + "[[grid]]\nrandom.seed = [4, 5]\n[[grid]]\nstructure.speed = [0.5, 1.2]\n");
  BOOST_TEST(plan.settings[0].resolved.random.seed == 4u);
  BOOST_TEST(plan.settings[1].resolved.random.seed == 4u);
  BOOST_TEST(plan.settings[3].resolved.random.seed == 5u);
}

BOOST_AUTO_TEST_CASE(a_speed_by_its_long_name_has_its_value) {
  std::string without_speed = kLeastCase;
  const std::size_t at = without_speed.find("speed = ");
  without_speed.erase(at, without_speed.find('\n', at) + 1 - at);
  const CampaignPlan plan = read(in_plan(without_speed) + "[[grid]]\nstructure.motion.speed = [0.5, \"2 m/s\"]\n");
  BOOST_TEST(plan.keys.at(0).name == "structure.motion.speed");
  BOOST_TEST(*plan.settings.at(0).values.at(0).number == 0.5);
  BOOST_TEST(*plan.settings.at(1).values.at(0).number == 2.0);
}

BOOST_AUTO_TEST_CASE(the_base_case_may_stand_in_the_plan) {
  const CampaignPlan plan = read(in_plan(kLeastCase) + "[set]\nice.thickness = 0.4\n");
  BOOST_TEST(plan.settings[0].resolved.name == "plan");
  BOOST_TEST(plan.settings[0].resolved.ice.thickness == 0.4);
}

BOOST_AUTO_TEST_CASE(the_case_in_a_plan_has_sections_within_sections) {
  const CampaignPlan plan = read(in_plan(kLeastCase) + "[case.structure.motion]\nframe = \"ice-drifts\"\n");
  BOOST_TEST((plan.settings[0].resolved.structure.frame == model::MotionFrame::kIceDrifts));
}

BOOST_AUTO_TEST_CASE(keys_of_a_section_within_a_section_vary_and_are_set) {
  const CampaignPlan plan =
      read(kBase + "[set]\nice.variation.thickness = 0.1\n[[grid]]\nice.variation.correlation_length = [\"3 m\", 5]\n");
  BOOST_TEST(names(plan) == (std::vector<std::string>{"correlation_length-3m", "correlation_length-5"}),
             boost::test_tools::per_element());
  BOOST_TEST(plan.settings[1].resolved.ice.variation.thickness == 0.1);
  BOOST_TEST(plan.settings[0].resolved.ice.variation.correlation_length == 3.0);
  BOOST_TEST(plan.keys[0].name == "ice.variation.correlation_length");
}

BOOST_AUTO_TEST_CASE(labels_name_the_values) {
  const CampaignPlan plan = read(kBase + "[[grid]]\nlabels = [\"few\", \"many\"]\nfailure.wedges = [[3, 3], [3, 5]]\n");
  BOOST_TEST(names(plan) == (std::vector<std::string>{"few", "many"}), boost::test_tools::per_element());
  BOOST_TEST(plan.settings[0].values[0].text == "3 3");
  BOOST_TEST(!plan.settings[0].values[0].number);
}

BOOST_AUTO_TEST_CASE(legs_are_told_by_their_places) {
  const CampaignPlan plan = read(kBase +
                                 "[set]\nstructure.start_distance = 20\n[[grid]]\n"
                                 "structure.legs = [[[0, 0]], [[8, 10.5], [8, -10.5]]]\n");
  BOOST_TEST(plan.settings[0].values[0].text == "0 0");
  BOOST_TEST(plan.settings[1].values[0].text == "8 10.5; 8 -10.5");
}

BOOST_AUTO_TEST_CASE(tables_are_told_by_their_values) {
  const Scratch scratch;
  std::string moves = kLeastCase;
  for (const std::string line : {"speed = 1.202\n", "start_distance = 7\n"}) moves.erase(moves.find(line), line.size());
  scratch.write("cone.toml", moves);
  const std::string plan = scratch.write("plan.toml", kBase +
                                                          "[[grid]]\nlabels = [\"slow\", \"fast\"]\n"
                                                          "structure.motion.path = [[[0, -7, 0, 0], [90, 5, -1.5, 0]], "
                                                          "[[0, -7, 0, 0], [45, 5, 0, 0]]]\n");
  const CampaignPlan paths = read_campaign_plan(plan, {false, {}, {}, kColumns, kColumns});
  BOOST_TEST(paths.settings[0].values[0].text == "0 -7 0 0; 90 5 -1.5 0");
  BOOST_TEST(paths.settings[1].values[0].text == "0 -7 0 0; 45 5 0 0");
  const CampaignPlan sizes =
      read(kBase +
           "[set]\nfield.kind = \"floes\"\nfield.concentration = 0.5\nfield.size.kind = \"list\"\n"
           "[[grid]]\nfield.size.values = [[3, 5], [4.5]]\n");
  BOOST_TEST(sizes.settings[0].values[0].text == "3 5");
  BOOST_TEST(sizes.settings[1].values[0].text == "4.5");
}

BOOST_AUTO_TEST_CASE(the_quick_variant_takes_fewer_points_and_replicates_and_no_stop_rule) {
  const std::string text = kGrid + "[stop]\nhalf_width = 0.05\nmost_replicates = 20\n" +
                           "[quick]\nreplicates = 2\npoints = 2\nset.time.duration = 17\n";
  const std::string long_plan = "[campaign]\ncase = \"cone.toml\"\nreplicates = 5\n" + text.substr(kBase.size());
  const CampaignPlan quick = read(long_plan, true);
  BOOST_TEST(quick.replicates == 2);
  BOOST_TEST(!quick.stop);
  BOOST_TEST(names(quick) == (std::vector<std::string>{"angle-55deg_speed-0.5", "angle-55deg_speed-1.2",
                                                       "angle-65deg_speed-0.5", "angle-65deg_speed-1.2"}),
             boost::test_tools::per_element());
  BOOST_TEST(quick.settings[0].resolved.time.duration == 17.0);

  const CampaignPlan whole = read(long_plan);
  BOOST_TEST(whole.replicates == 5);
  BOOST_TEST(whole.settings.size() == 6u);
  BOOST_REQUIRE(whole.stop.has_value());
  BOOST_CHECK(*whole.stop == (StopRule{"horizontal.mean", 0.05, 0.95, 20, 1}));
}

BOOST_AUTO_TEST_CASE(a_plan_without_a_quick_variant_has_none) {
  BOOST_CHECK_EXCEPTION(read(kGrid, true), InputError, [](const InputError& error) {
    return std::string(error.what()).find("[quick]: is missing, and --quick asks for it") != std::string::npos;
  });
  BOOST_TEST(names(read(kGrid + "[quick]\n", true)).size() == 6u);
}

BOOST_AUTO_TEST_CASE(a_stop_rule_that_is_left_out_asks_for_no_least_number_of_replicates) {
  const std::string text = kBase + "replicates = 1\n[stop]\nhalf_width = 0.1\nmost_replicates = 9\n[quick]\n";
  BOOST_CHECK_THROW(read(text), InputError);
  const CampaignPlan quick = read(text, true);
  BOOST_TEST(!quick.stop);
  BOOST_TEST(quick.replicates == 1);
  const Scratch scratch;
  scratch.write("cone.toml", kLeastCase);
  const CampaignPlan four = read_campaign_plan(scratch.write("plan.toml", text), {false, 4, {}, kColumns, kColumns});
  BOOST_TEST(!four.stop);
  BOOST_TEST(four.replicates == 4);
}

BOOST_AUTO_TEST_CASE(a_setting_does_not_depend_on_what_else_the_grid_has) {
  const CampaignPlan many = read(kGrid);
  const CampaignPlan few = read(kBase + "[set]\ntime.duration = 30\n[[grid]]\nstructure.angle = [\"65 deg\"]\n" +
                                "[[grid]]\nstructure.speed = [1.2]\noutput.statistics_from = [8]\n");
  BOOST_CHECK(few.settings[0] == many.settings[5]);
}

BOOST_AUTO_TEST_CASE(the_command_line_comes_last) {
  BOOST_TEST(read(kGrid, false, {"time.duration=20"}).settings[0].resolved.time.duration == 20.0);
}

BOOST_AUTO_TEST_CASE(faults_are_named_with_place_value_what_is_allowed_and_the_remedy) {
  check_has(message_of(kBase + "replicate = 3\n"),
            {"plan.toml:3:1: campaign.replicate = 3: is not a known key", "nearest: campaign.replicates"});
  check_has(message_of(kBase + "replicates = 0\n"),
            {"plan.toml:3:14: campaign.replicates = 0: is out of range", ">= 1"});
  check_has(message_of("[campaign]\nreplicates = 2\n"), {"campaign.case: is missing", "add `case = \"cone.toml\"`"});
  check_has(message_of("[campaign]\ncase = \"none.toml\"\n"), {"none.toml:1:1: case file: cannot be opened"});
  check_has(message_of(kBase + "[set]\nspeed = 3\n"), {"plan.toml:4:9: set.speed = 3", "section.key = value"});
  check_has(message_of(kBase + "[set]\nstructure.sped = 3\n"),
            {"plan.toml:4:18: structure.sped = 3: is not a known key", "nearest: structure.speed"});
  check_has(message_of(kBase + "[[grid]]\nstructure.speed = 1\n"),
            {"plan.toml:4:19: grid.structure.speed = 1: is not an array of values"});
  check_has(message_of(kBase + "[[grid]]\nstructure.speed = [1, 2]\nice.thickness = [0.3]\n"),
            {"plan.toml:5:17", "has 1 values, but structure.speed has 2"});
  check_has(message_of(kBase + "[[grid]]\nstructure.speed = [1.0, -2.0]\n"),
            {"setting speed--2.0:", "plan.toml:4:25: structure.speed = -2.0: is out of range"});
  check_has(message_of(kBase + "[[grid]]\nstructure.speed = [1.0, 1.0]\n"), {"two settings have the name speed-1.0"});
  check_has(message_of(kBase + "[[grid]]\nice.thickness = [\"0.30 m\", \"30 cm\"]\n"),
            {"plan.toml:3:1: grid: the settings thickness-0.30m and thickness-30cm have equal values",
             "remove a repeated value"});
  check_has(message_of(kBase + "[set]\nstructure.speed = 1\n[[grid]]\nstructure.speed = [1, 2]\n"),
            {"plan.toml:6:20: structure.speed = 1: is set twice"});
  check_has(message_of(kBase + "[[grid]]\nrandom.replicate = [1, 2]\n"),
            {"random.replicate: is counted by the campaign"});
  check_has(message_of(kGrid, {"structure.speed = 2"}),
            {"structure.speed", "is a key of the grid", "change the values in [[grid]]"});
  check_has(message_of(kBase, {"random.replicate=3"}), {"random.replicate: is counted by the campaign"});
  check_has(message_of(kBase + "[output]\ncolumns = [\"horizontal.men\"]\n"),
            {"output.columns = \"horizontal.men\": is not a column", "nearest: horizontal.mean"});
  check_has(message_of(kBase + "[output]\ncolumns = [\"n_breaks\", \"n_breaks\"]\n"),
            {"output.columns = \"n_breaks\": is named twice"});
  check_has(message_of(kBase + "[stop]\nhalf_width = 0.1\nmost_replicates = 9\n"),
            {"campaign.replicates = 1: is not a least number of replicates for [stop]",
             "from 2 to stop.most_replicates = 9"});
  check_has(message_of(kBase + "[stop]\nhalf_width = 0.1\n"), {"stop.most_replicates: is missing"});
  check_has(message_of(kBase + "grid = 3\n"), {"campaign.grid = 3: is not a known key"});
  check_has(message_of("grid = 3\n" + kBase), {"plan.toml:1:8: grid = 3: is not a grid"});
}

BOOST_AUTO_TEST_SUITE_END()
