// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "brash/core/error.hpp"
#include "brash/statistics/random.hpp"
#include "commands.hpp"
#include "history_file.hpp"

namespace {

using namespace brash;
using namespace brash::cli;
using analysis::contains;
using analysis::TemporaryFile;
using boost::test_tools::tolerance;

/// A sawtooth of cycles of 1 s whose peaks are exponential above 100.
std::vector<double> sawtooth(int cycles) {
  std::vector<double> samples;
  statistics::RandomStream stream(1, "stats", 0, "peaks");
  for (int c = 0; c < cycles; ++c) {
    const double peak = 100.0 - 40.0 * std::log(1.0 - stream.uniform());
    for (int i = 1; i <= 20; ++i) samples.push_back(20.0 + (peak - 20.0) * i / 20);
  }
  return samples;
}

/// What `brash stats` refuses, or "" when it refuses nothing.
std::string refusal_of(const std::string& arguments) {
  CLI::App app;
  add_stats_command(app);
  try {
    app.parse("stats " + arguments);
  } catch (const InputError& error) {
    return error.what();
  } catch (const CLI::ParseError& error) {
    return error.what();
  }
  return "";
}

/// The text that `brash stats` prints, by way of a file.
std::string printed(const std::string& arguments, const std::filesystem::path& folder) {
  const std::string out = folder / "printed.txt";
  std::fflush(stdout);
  const int screen = ::dup(STDOUT_FILENO), file = ::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  ::dup2(file, STDOUT_FILENO);
  CLI::App app;
  add_stats_command(app);
  app.parse("stats " + arguments);
  std::fflush(stdout);
  ::dup2(screen, STDOUT_FILENO);
  ::close(screen);
  ::close(file);
  std::ifstream stream(out);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(stats_command)

BOOST_AUTO_TEST_CASE(several_histories_and_tables_are_written_at_once) {
  std::string text = "time [s],Fx,Fz\n";
  const auto load = sawtooth(100);
  for (std::size_t i = 0; i < load.size(); ++i)
    text += std::to_string(0.05 * static_cast<double>(i)) + "," + std::to_string(load[i]) + "," +
            std::to_string(-load[i]) + "\n";
  const TemporaryFile file(text);
  const auto lines_of = [&](const std::string& arguments, const std::string& table) {
    const std::string out = file.path() + (table == "--picture" ? ".svg" : ".table.csv");
    CLI::App app;
    add_stats_command(app);
    app.parse("stats " + file.path() + " --json " + arguments + " " + table + " " + out);
    std::ifstream stream(out);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
  };
  const auto events = lines_of("--column Fx", "--events");
  BOOST_TEST(events.front() == "start,end,peak_time,peak,impulse,rise,fall,cause,crack_time,crack_x,crack_y");
  BOOST_TEST(std::abs(static_cast<int>(events.size()) - 100) <= 2);
  const auto both = lines_of("--column Fx --column Fz --to 50", "--exceedance");
  BOOST_TEST(both.size() == 101U);
  BOOST_TEST(both.front() == "file,column,level,time_above,share,events_above");
  BOOST_TEST(lines_of("--column Fx", "--cycles").size() > 99U);
  BOOST_CHECK_THROW(lines_of("--column Fx --column Fz", "--picture"), InputError);
  BOOST_TEST(contains(lines_of("--column Fx", "--picture").front(), "<svg"));
}

BOOST_AUTO_TEST_CASE(tables_replace_no_result_of_a_run_and_not_each_other) {
  const TemporaryFile file("time,Fx\n0,1\n1,2\n2,1\n3,2\n");
  const std::filesystem::path folder = std::filesystem::path(file.path()).parent_path();
  const std::string history = file.path(), in_folder = folder.string() + "/";
  const std::string events = "time,x,y,event\n1,4,5,break\n";
  const auto text_of = [&](const char* name) {
    std::ifstream stream(folder / name);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  std::ofstream(folder / "events.csv") << events;
  std::ofstream(folder / "summary.json") << "{}";
  BOOST_TEST(contains(refusal_of(history + " --events " + in_folder + "events.csv"), "which is an input"));
  BOOST_TEST(
      contains(refusal_of(history + " --cycles " + in_folder + "../" + folder.filename().string() + "/events.csv"),
               "which is an input"));
  std::ofstream(folder / "manifest.json") << R"({"outputs": [{"path": "events.csv"}, {"path": "summary.json"}]})";
  for (const char* name : {"summary.json", "manifest.json"})
    BOOST_TEST(contains(refusal_of(history + " --exceedance " + in_folder + name), "is not a result of a run"));
  BOOST_TEST(text_of("events.csv") == events);
  BOOST_TEST(text_of("summary.json") == "{}");

  const std::string out = in_folder + "o.csv";
  BOOST_TEST(contains(refusal_of(history + " --exceedance " + out + " --cycles " + in_folder + "./o.csv"),
                      "is the name of two files to write"));
  BOOST_TEST(
      contains(refusal_of(history + " --column Fx --column time --cycles " + out + " --picture " + in_folder + "o.svg"),
               "--picture of 2 histories"));
  BOOST_TEST(!std::filesystem::exists(out));
}

BOOST_AUTO_TEST_CASE(the_history_of_a_run_begins_as_its_summary) {
  std::string text = "time [s],Fx [N]\n";
  for (int i = 0; i < 400; ++i) text += fmt::format("{},{}\n", 0.1 * i, i <= 100 ? 0.0 : i % 2 == 0 ? 90.0 : 110.0);
  const TemporaryFile file(text);
  const std::filesystem::path folder = std::filesystem::path(file.path()).parent_path();
  const auto found = [&](const std::string& more) {
    return nlohmann::json::parse(printed(file.path() + " --json " + more, folder));
  };
  BOOST_TEST(found("")["from"] == 0.0);
  for (const char* const summary : {"{}", R"({"statistics_from": null})"}) {
    std::ofstream(folder / "summary.json") << summary;
    BOOST_TEST(found("")["from"] == 0.0);
  }
  std::ofstream(folder / "summary.json") << R"({"statistics_from": 10.0})";
  // Without the sample at the start, as the summary.
  BOOST_TEST(found("")["n"] == 299);
  BOOST_TEST(found("")["mean"].get<double>() == 100.0, tolerance(1e-3));
  BOOST_TEST(found("")["statistics_from"] == 10.0);
  BOOST_TEST(contains(printed(file.path(), folder), "begins               at statistics_from = 10 s of summary.json"));
  BOOST_TEST(found("--from 10")["n"] == 299);
  BOOST_TEST(found("--from 0")["n"] == 399);  // the samples of a run are ends of steps, which none has at 0
  BOOST_TEST(contains(refusal_of(file.path() + " --from 50"), "--from 50 leaves fewer than two values"));
  BOOST_TEST(!found("--from 0").contains("statistics_from"));
  std::ofstream(folder / "summary.json") << R"({"statistics_from": 50.0})";
  BOOST_TEST(contains(refusal_of(file.path()), "statistics_from = 50 of the summary leaves fewer than two values"));
  // A table of something else has no summary.
  std::ofstream(folder / "measured.csv") << text;
  BOOST_TEST(nlohmann::json::parse(printed((folder / "measured.csv").string() + " --json", folder))["n"] == 400);
}

BOOST_AUTO_TEST_CASE(options_without_effect_are_refused) {
  const TemporaryFile file("time,Fx\n0,1\n1,2\n2,1\n3,2\n");
  BOOST_TEST(contains(refusal_of(file.path() + " --phase causal"), "--phase requires --low-pass"));
  BOOST_TEST(contains(refusal_of(file.path() + " --frequency 2"), "--frequency requires --exponent"));
}

BOOST_AUTO_TEST_CASE(a_threshold_that_is_no_number_is_refused) {
  const TemporaryFile file("0,1\n1,2\n2,3\n");
  BOOST_TEST(contains(refusal_of(file.path() + " --threshold nan"), "--threshold nan is not a load"));
}

BOOST_AUTO_TEST_SUITE_END()
