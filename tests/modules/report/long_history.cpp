// SPDX-License-Identifier: GPL-3.0-or-later
#include "long_history.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>
#include <span>

#include "brash/statistics/random.hpp"

using namespace brash;
using namespace brash::report;

namespace {

/// Loads that jump, with a rare peak of crushing alone.
std::vector<model::LoadRow> history(std::size_t n) {
  statistics::RandomStream stream(1, "history", 0, "loads");
  std::vector<model::LoadRow> rows(n);
  for (std::size_t i = 0; i < n; ++i) {
    model::LoadRow& row = rows[i];
    row.time = 0.01 * static_cast<double>(i + 1);
    for (double Vec3::*const axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
      row.crushing.force.*axis = i % 997 == 500 ? 1e3 * stream.uniform() : 0.0;
      row.floe_normal.force.*axis = 1e2 * (stream.uniform() - 0.3);
      row.total.force.*axis = row.crushing.force.*axis + row.floe_normal.force.*axis;
    }
  }
  return rows;
}

/// Takes `rows` in uneven pieces.
LongHistory taken(const std::vector<model::LoadRow>& rows) {
  LongHistory history;
  for (std::size_t first = 0, size = 1; first < rows.size(); first += size, size = size * 3 + 1) {
    const auto begin = rows.begin() + static_cast<std::ptrdiff_t>(first);
    history.take({begin, begin + static_cast<std::ptrdiff_t>(std::min(size, rows.size() - first))}, rows.size());
  }
  return history;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_row_of_a_short_history_is_drawn) {
  const std::vector<model::LoadRow> rows = history(20000);
  LongHistory history = taken(rows);
  BOOST_TEST(history.span() == 1U);
  BOOST_TEST((history.drawn() == rows));
}

BOOST_AUTO_TEST_CASE(a_long_history_is_drawn_by_rows_of_its_own_that_keep_its_outline) {
  for (const std::size_t n : {20001U, 90000U, 100003U}) {
    const std::vector<model::LoadRow> rows = history(n);
    LongHistory history = taken(rows);
    const std::size_t span = history.span();
    const std::vector<model::LoadRow> drawn = history.drawn();
    BOOST_TEST(drawn.size() < n);
    BOOST_TEST(drawn.back().time == rows.back().time);
    // Each is a row of the history, in order.
    BOOST_TEST(std::ranges::includes(rows, drawn, {}, &model::LoadRow::time, &model::LoadRow::time));
    const auto same = [&](const model::LoadRow& row) {
      return row == *std::ranges::lower_bound(rows, row.time, {}, &model::LoadRow::time);
    };
    BOOST_TEST(std::ranges::all_of(drawn, same));
    // In each span, each cause has the extremes that it has in all rows.
    for (Wrench model::LoadRow::*const load : {&model::LoadRow::total, &model::LoadRow::crushing}) {
      const auto value = [load](const model::LoadRow& row) { return (row.*load).force.y; };
      auto next = drawn.begin();
      for (std::size_t first = 0; first < n; first += span) {
        const std::size_t end = std::min(first + span, n);
        const auto all = std::ranges::minmax(std::span(rows).subspan(first, end - first), {}, value);
        const auto last =
            std::find_if(next, drawn.end(), [&](const auto& row) { return row.time > rows[end - 1].time; });
        const auto some = std::ranges::minmax(std::span(next, last), {}, value);
        BOOST_REQUIRE(value(some.min) == value(all.min));
        BOOST_REQUIRE(value(some.max) == value(all.max));
        next = last;
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(charts_of_a_long_history_keep_the_extremes_of_every_sample_and_line) {
  for (const std::size_t n : {1000U, 100003U}) {
    const std::vector<model::LoadRow> rows = history(n);
    LongHistory history = taken(rows);
    const std::size_t n_lines = n / 16 + 1;
    std::vector<double> frequency(n_lines), density(n_lines, 1.0);
    for (std::size_t i = 0; i < n_lines; ++i) frequency[i] = static_cast<double>(i);
    density[n_lines / 3] = 9.0;
    density[n_lines / 2] = 0.5;
    nlohmann::ordered_json all;
    for (const char* const name : kLoadNames)
      all[name] = {{"spectrum", {{"frequency", frequency}, {"density", density}}}, {"lower_end", false}};
    Blocks blocks;
    const nlohmann::ordered_json drawn = drawn_statistics(all, history.samples(), 0.0, 1e9, blocks);
    const nlohmann::ordered_json& spectrum = drawn["Fx"]["spectrum"];
    BOOST_TEST(spectrum["n_lines"] == n_lines);
    BOOST_TEST(spectrum["density"].size() == spectrum["frequency"].size());
    BOOST_TEST((spectrum["density"].size() == n_lines) == (n == 1000));
    const auto kept = spectrum["density"].get<std::vector<double>>();
    const auto highest = std::ranges::find(kept, 9.0), lowest = std::ranges::find(kept, 0.5);
    BOOST_REQUIRE((highest != kept.end() && lowest != kept.end()));
    BOOST_TEST(spectrum["frequency"][static_cast<std::size_t>(highest - kept.begin())] == frequency[n_lines / 3]);
    // All ranks of a short history; of a long one the first, the last and some between.
    const auto block = std::ranges::find(blocks.directory(), "exceedance.Fx.rank",
                                         [](const auto& entry) { return entry["name"].template get<std::string>(); });
    BOOST_REQUIRE((block != blocks.directory().end()));
    const std::size_t n_ranks = (*block)["count"];
    BOOST_TEST((n == 1000 ? n_ranks == n : n_ranks > 1000 && n_ranks <= 2001));
  }
}

BOOST_AUTO_TEST_CASE(a_history_without_statistics_has_no_charts_of_them) {
  Blocks blocks;
  BOOST_TEST(drawn_statistics(nullptr, LoadSamples{}, 0.0, 1.0, blocks).is_null());
}
