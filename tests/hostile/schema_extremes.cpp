// SPDX-License-Identifier: GPL-3.0-or-later
// Every key of the schema of cases with extremes, and every pair of keys of one section at their borders, as
// `brash check` and the first step of `brash run` take them: a case, or an error in words. A broken contract, a signal
// or a hang (the test's time limit) is a finding.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "brash/advice/advice.hpp"
#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "brash/io/case.hpp"
#include "brash/simulation/simulation.hpp"

namespace {

using nlohmann::ordered_json;

constexpr const char* kBase = R"([ice]
thickness = 0.33
youngs_modulus = 3.5e8
flexural_strength = 5.39e5
[structure]
angle = 1.07
waterline_width = 13.6
height = 9.08
height_under_water = 5.68
speed = 1.202
start_distance = 7
[field]
length = 20
width = 30
[failure]
model = "wedge"
[time]
duration = 2
[output]
frames_per_second = 15
)";

const ordered_json& schema() {
  static const ordered_json read = ordered_json::parse(brash::io::case_schema()).at("properties");
  return read;
}

std::string type_of(const ordered_json& key) {
  const ordered_json& type = key.at("type");
  return type.is_array() ? type.front().get<std::string>() : type.get<std::string>();
}

/// A number as TOML.
std::string toml(double value) {
  std::string text = fmt::format("{}", value);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

/// Borders of a number: the last that is allowed and the first that is not, on both sides.
std::vector<std::string> borders(const ordered_json& key) {
  std::vector<std::string> values;
  const bool whole = type_of(key) == "integer";
  for (const char* const keyword : {"minimum", "exclusiveMinimum", "maximum", "exclusiveMaximum"}) {
    if (!key.contains(keyword)) continue;
    const double border = key.at(keyword).get<double>();
    for (const double side : {-1.0, 0.0, 1.0}) {
      if (whole)
        values.push_back(fmt::format("{:.0f}", border + side));
      else
        values.push_back(toml(side == 0.0 ? border : std::nextafter(border, side * 1e300)));
    }
  }
  return values;
}

const std::vector<std::string>& extremes() {
  static const std::vector<std::string> values = [] {
    std::vector<std::string> all{"nan",
                                 "inf",
                                 "-inf",
                                 "0",
                                 "0.0",
                                 "-0.0",
                                 "-1",
                                 "1",
                                 "1e-320",
                                 "-1e-320",
                                 "5e-324",
                                 "1e-300",
                                 "1e-30",
                                 "1e-9",
                                 "1e9",
                                 "1e30",
                                 "1e300",
                                 "1e308",
                                 "-1e308",
                                 "9223372036854775807",
                                 "-9223372036854775808",
                                 "2147483648",
                                 "true",
                                 "false",
                                 "\"\"",
                                 "\"text\"",
                                 "\"nan\"",
                                 "\"inf m\"",
                                 "\"1e308 Gm\"",
                                 "\"1e-320 m\"",
                                 "\"1 m^99\"",
                                 "\"1 km9\"",
                                 "\"-1 kPa\"",
                                 "\"1 furlong\"",
                                 "\"..\"",
                                 "\"/\"",
                                 "\"\\u202e\\u009b31m\"",
                                 "[]",
                                 "[nan, nan]",
                                 "[0, 0]",
                                 "[1e308, -1e308]",
                                 "[[1], [2]]",
                                 "[1, 2, 3]",
                                 "[\"1 m/s\", \"\"]",
                                 "{}",
                                 "{ a = 1 }",
                                 "2024-02-01T00:00:00Z",
                                 "12:00:00"};
    all.push_back('"' + std::string(5000, 'x') + '"');
    all.push_back("\"" + std::string(400, '9') + " m\"");
    return all;
  }();
  return values;
}

/// How the cases end.
struct Answers {
  int n_cases = 0;
  int n_accepted = 0;
  std::vector<std::string> findings;
};

enum class Depth { kCheck, kStep };

void add_finding(Answers& answers, const std::vector<std::string>& overrides, const std::string& what) {
  answers.findings.push_back(fmt::format("{}: {}", fmt::join(overrides, " "), what).substr(0, 400));
}

void try_case(const std::vector<std::string>& overrides, Depth depth, Answers& answers) {
  ++answers.n_cases;
  try {
    const brash::model::Case resolved = brash::io::parse_case(kBase, "hostile.toml", overrides);
    const brash::simulation::Setup setup(resolved);
    const brash::simulation::DerivedScales& scales = setup.scales;
    static_cast<void>(brash::advice::warnings_of(setup));
    if (!std::isfinite(scales.characteristic_length) || !std::isfinite(scales.collision_time))
      add_finding(answers, overrides, "a derived scale is not finite");
    ++answers.n_accepted;
    if (depth == Depth::kCheck) return;
    brash::simulation::Simulation simulation(resolved);
    for (int i = 0; i < 2; ++i) static_cast<void>(simulation.step());
  } catch (const brash::InputError& error) {
    const std::string what = error.what();
    if (what.find("remedy:") == std::string::npos) add_finding(answers, overrides, "no remedy: " + what);
    if (what.find("contract broken") != std::string::npos) add_finding(answers, overrides, what);
  } catch (const std::exception& error) {
    add_finding(answers, overrides, error.what());
  }
}

void report(const char* name, const Answers& answers) {
  BOOST_TEST_MESSAGE(fmt::format("{}: {} cases, {} accepted", name, answers.n_cases, answers.n_accepted));
  for (const std::string& finding : answers.findings) BOOST_ERROR(finding);
}

BOOST_AUTO_TEST_CASE(every_key_with_extremes_is_a_case_or_an_error_in_words) {
  Answers answers;
  for (const auto& [section, content] : schema().items()) {
    for (const auto& [key, key_schema] : content.at("properties").items()) {
      std::vector<std::string> values = extremes();
      for (std::string& border : borders(key_schema)) values.push_back(std::move(border));
      if (key_schema.contains("enum"))
        for (const auto& name : key_schema.at("enum")) values.push_back(name.dump());
      for (const std::string& value : values)
        try_case({fmt::format("{}.{}={}", section, key, value)}, Depth::kStep, answers);
    }
  }
  report("keys", answers);
  BOOST_TEST(answers.n_cases > 3000);
  BOOST_TEST(answers.n_accepted > 100);
}

/// A few values at the borders that the schema allows, and usual values.
std::vector<std::string> inner_borders(const ordered_json& key) {
  if (key.contains("enum")) {
    std::vector<std::string> names;
    for (const auto& name : key.at("enum")) names.push_back(name.dump());
    return names;
  }
  const std::string type = type_of(key);
  if (type == "boolean") return {"true", "false"};
  if (type == "integer" || type == "number") {
    std::vector<std::string> values;
    const auto add = [&](double value) {
      values.push_back(type == "integer" ? fmt::format("{:.0f}", value) : toml(value));
    };
    constexpr double kSmallest = 5e-324;
    if (key.contains("minimum")) add(key.at("minimum").get<double>());
    if (key.contains("exclusiveMinimum")) add(key.at("exclusiveMinimum").get<double>() + kSmallest);
    if (key.contains("maximum")) add(key.at("maximum").get<double>());
    if (key.contains("exclusiveMaximum")) add(std::nextafter(key.at("exclusiveMaximum").get<double>(), 0.0));
    if (type == "number") {
      for (const double usual : {1e-12, 0.05, 0.4}) add(usual);
    }
    for (const double usual : {1.0, 20.0}) add(usual);
    return values;
  }
  if (type == "array") return {"[1, 16]", "[16, 1]", "[0, 0]", "[-10, 10]"};
  return {"\"\"", "\"a\""};
}

BOOST_AUTO_TEST_CASE(every_pair_of_keys_of_a_section_at_their_borders_is_a_case_or_an_error_in_words) {
  Answers answers;
  for (const auto& [section, content] : schema().items()) {
    const ordered_json& keys = content.at("properties");
    for (auto a = keys.begin(); a != keys.end(); ++a)
      for (auto b = std::next(a); b != keys.end(); ++b)
        for (const std::string& of_a : inner_borders(a.value()))
          for (const std::string& of_b : inner_borders(b.value()))
            try_case({fmt::format("{}.{}={}", section, a.key(), of_a), fmt::format("{}.{}={}", section, b.key(), of_b)},
                     Depth::kCheck, answers);
  }
  report("pairs", answers);
  BOOST_TEST(answers.n_cases > 3000);
  BOOST_TEST(answers.n_accepted > 100);
}

}  // namespace
