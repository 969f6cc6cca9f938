// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "brash/campaign/campaign.hpp"
#include "brash/core/error.hpp"
#include "case_results.hpp"

using namespace brash;
using namespace brash::campaign;

BOOST_AUTO_TEST_SUITE(columns)

BOOST_AUTO_TEST_CASE(a_column_is_named_by_the_way_to_its_number) {
  const auto columns = columns_of("summary.json", R"({
    "text": "none", "n": 3, "ok": true, "bad": null,
    "horizontal": {"mean": 1.5, "mean_95": [1, 2], "mean_by_cause": {"crushing": 0.5}},
    "piece_area_quantiles": [1, 2, 3, 4, 5], "quantile_levels": [0.05, 0.25, 0.5, 0.75, 0.95], "pair": [7, 8]})");
  const std::map<std::string, double> expected{{"n", 3},
                                               {"ok", 1},
                                               {"horizontal.mean", 1.5},
                                               {"horizontal.mean_95.lower", 1},
                                               {"horizontal.mean_95.upper", 2},
                                               {"horizontal.mean_by_cause.crushing", 0.5},
                                               {"piece_area_quantiles.05", 1},
                                               {"piece_area_quantiles.25", 2},
                                               {"piece_area_quantiles.50", 3},
                                               {"piece_area_quantiles.75", 4},
                                               {"piece_area_quantiles.95", 5},
                                               {"pair.0", 7},
                                               {"pair.1", 8}};
  BOOST_CHECK(columns == expected);
}

BOOST_AUTO_TEST_CASE(the_columns_that_the_manual_names_are_known) {
  for (const char* const name :
       {"horizontal.mean", "horizontal.standard_deviation", "horizontal.maximum", "horizontal.quantile_99",
        "horizontal.mean_by_cause.crushing", "horizontal.mean_95.lower", "mean_whole_history.horizontal", "n_breaks",
        "breaking_frequency", "energy.work", "breaking_length_quantiles.05", "piece_area_quantiles.95"})
    BOOST_TEST(std::ranges::count(known_columns(), name) == 1, name);
}

BOOST_AUTO_TEST_CASE(numbers_of_ships_and_fields_are_known_and_wait_to_be_named) {
  for (const char* const name :
       {"mean_by_region.bow.total.Fx", "mean_by_region.shoulders.crushing.Fz", "mean_by_region.leg_4.total.Fx",
        "initial_floes.n", "initial_floes.size_quantiles.50", "fastest_floe"}) {
    BOOST_TEST(std::ranges::count(known_columns(), name) == 1, name);
    BOOST_TEST(std::ranges::count(default_columns(), name) == 0, name);
  }
  for (const std::string& name : default_columns()) BOOST_TEST(std::ranges::count(known_columns(), name) == 1, name);
}

BOOST_AUTO_TEST_CASE(each_known_column_has_its_unit) {
  const std::map<std::string, std::string> expected{{"horizontal.mean", "N"},
                                                    {"horizontal.mean_95.lower", "N"},
                                                    {"horizontal.autocorrelation_time", "s"},
                                                    {"vertical.skewness", "1"},
                                                    {"mean_whole_history.vertical", "N"},
                                                    {"mean_by_region.leg_4.total.Fx", "N"},
                                                    {"statistics_from", "s"},
                                                    {"breaking_frequency", "s-1"},
                                                    {"breaking_length_quantiles.05", "m"},
                                                    {"piece_area_quantiles.95", "m2"},
                                                    {"initial_floes.size_quantiles.50", "m"},
                                                    {"contact_iterations.mean_last_change", "m s-1"},
                                                    {"fastest_floe", "m s-1"},
                                                    {"verdicts.latest", "s"},
                                                    {"energy.losses.bending", "J"}};
  for (const auto& [name, unit] : expected) {
    BOOST_TEST(unit_of(name) == unit, name);
    BOOST_TEST(std::ranges::count(known_columns(), name) == 1, name);
  }
  // The others are counts, ratios, and yes or no.
  for (const std::string& name : known_columns()) {
    const std::string last = name.substr(name.rfind('.') + 1);
    const bool has_none = last == "n" || last.starts_with("n_") || name.starts_with("breaks_decided.") ||
                          name.starts_with("sheets.") || (name.starts_with("verdicts.") && last != "latest") ||
                          name.starts_with("overload_") || name.starts_with("stress_over_strength_") ||
                          last == "skewness" || last == "effective_sample_size" || last == "long_enough" ||
                          last == "concentration" || name == "ledger.closes";
    BOOST_TEST((unit_of(name) == "1") == has_none, name);
  }
}

BOOST_AUTO_TEST_CASE(a_summary_that_is_cut_short_is_refused_by_name) {
  BOOST_CHECK_EXCEPTION(columns_of("cases/a/summary.json", "{\"n\": "), InputError, [](const InputError& error) {
    return std::string(error.what()).starts_with("cases/a/summary.json: cannot be read");
  });
}

BOOST_AUTO_TEST_SUITE_END()
