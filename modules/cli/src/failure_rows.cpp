// SPDX-License-Identifier: GPL-3.0-or-later
#include "failure_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <functional>
#include <iostream>
#include <sstream>
#include <vector>

#include "brash/core/constants.hpp"
#include "brash/core/error.hpp"
#include "brash/failure/unit_profiles.hpp"
#include "brash/meta_model/network.hpp"
#include "brash/plate/plate.hpp"

namespace brash::cli {

namespace {

constexpr const char* kHeader = "b_lc,c_lc,theta_deg,mu1,mu2";
constexpr const char* kThickness = ",lc_over_h";
constexpr std::size_t kColumns = 5;
constexpr std::array<const char*, kColumns + 1> kNames{"b_lc", "c_lc", "theta_deg", "mu1", "mu2", "lc_over_h"};
/// h / l_c of rows that do not state it: that of the paper's validation case, rounded.
constexpr double kUsualThickness = 0.1;

struct PredictedRow {
  std::string text;  ///< as it was read
  meta_model::Input input;
  double lc_over_h = 0.0;  ///< 0: not stated
};

struct Answer {
  meta_model::Output output;
  bool in_range = true;
};

std::string without_line_end(std::string line) {
  while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
  return line;
}

double number(const std::string& text, const std::string& place, const char* name) {
  double value = 0.0;
  const auto first = text.find_first_not_of(' ');
  const char* begin = text.data() + std::min(first, text.size());
  const auto [end, code] = std::from_chars(begin, text.data() + text.size(), value);
  const bool rest = text.find_first_not_of(' ', static_cast<std::size_t>(end - text.data())) != std::string::npos;
  if (code != std::errc() || rest || !std::isfinite(value)) {
    throw InputError(fmt::format("{}: {} = `{}` is not a finite number", place, name, text));
  }
  return value;
}

void expect(bool allowed, const std::string& place, const char* name, double value, const char* what) {
  if (!allowed) throw InputError(fmt::format("{}: {} = {} is not allowed; {}", place, name, value, what));
}

PredictedRow parse_row(const std::string& line, const std::string& place, std::size_t n_columns) {
  std::vector<std::string> fields;
  std::stringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  if (fields.size() != n_columns) {
    throw InputError(fmt::format("{}: has {} values, must have {}", place, fields.size(), n_columns));
  }
  std::array<double, kColumns + 1> v{};
  for (std::size_t i = 0; i < n_columns; ++i) v[i] = number(fields[i], place, kNames[i]);
  expect(v[0] >= 0.0, place, kNames[0], v[0], "must be >= 0");
  expect(v[1] > 0.0, place, kNames[1], v[1], "must be > 0");
  expect(v[2] >= 0.0 && v[2] < 180.0, place, kNames[2], v[2], "must be in [0, 180) degrees");
  expect(v[3] > 0.0, place, kNames[3], v[3], "must be > 0");
  if (n_columns > kColumns) expect(v[5] > 0.0, place, kNames[5], v[5], "must be > 0");
  return {line, {v[0], v[1], radians(v[2]), v[3], v[4]}, v[5]};
}

std::vector<PredictedRow> read_rows(std::istream& stream, const std::string& name, std::string& header) {
  std::string line;
  if (!std::getline(stream, line))
    throw InputError(fmt::format("{}: is empty; first line: {}[{}]", name, kHeader, kThickness));
  header = without_line_end(line);
  if (header != kHeader && header != std::string(kHeader) + kThickness) {
    throw InputError(fmt::format("{}:1: the first line is `{}`, must be `{}` or `{}{}`", name, header, kHeader, kHeader,
                                 kThickness));
  }
  const std::size_t n_columns = header == kHeader ? kColumns : kColumns + 1;
  std::vector<PredictedRow> rows;
  for (int number = 2; std::getline(stream, line); ++number) {
    line = without_line_end(line);
    if (!line.empty()) rows.push_back(parse_row(line, fmt::format("{}:{}", name, number), n_columns));
  }
  return rows;
}

/// The plate itself; every row is in range that the plate theory can hold.
std::vector<Answer> solve_rows(const std::vector<PredictedRow>& rows) {
  std::vector<Answer> answers;
  for (const PredictedRow& row : rows) {
    const double thickness = row.lc_over_h > 0.0 ? 1.0 / row.lc_over_h : kUsualThickness;
    const auto profiles = plate::solve(
        {.depth = row.input.b_lc, .contact_length = row.input.c_lc, .angle = row.input.theta, .thickness = thickness});
    if (!profiles) throw RunError(fmt::format("row `{}`: {}", row.text, profiles.error().what));
    const plate::Response r = plate::respond(*profiles, thickness, row.input.mu1, row.input.mu2);
    answers.push_back({{r.sigma_over_p, r.lbreak_over_lc}, true});
  }
  return answers;
}

/// The network, inputs moved into its range, the stress scaled by Eq. 19 where the row states l_c / h.
std::vector<Answer> infer_rows(const meta_model::Network& network, const std::vector<PredictedRow>& rows) {
  std::vector<meta_model::Input> inputs;
  for (const PredictedRow& row : rows) inputs.push_back(network.clamp(row.input));
  std::vector<meta_model::Output> outputs(rows.size());
  network.predict(inputs, outputs);
  std::vector<Answer> answers;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].lc_over_h > 0.0) outputs[i].sigma_over_p *= rows[i].lc_over_h * network.thickness_over_lc();
    answers.push_back({outputs[i], network.check(rows[i].input).inside()});
  }
  return answers;
}

/// Interpolated unit profiles, superposed; h / l_c as for the plate.
std::vector<Answer> superpose_rows(const meta_model::ProfileModel& model, const std::vector<PredictedRow>& rows) {
  std::vector<Answer> answers;
  for (const PredictedRow& row : rows) {
    const double thickness = row.lc_over_h > 0.0 ? 1.0 / row.lc_over_h : kUsualThickness;
    const meta_model::Geometry wanted{row.input.b_lc, row.input.c_lc, row.input.theta, thickness};
    const plate::Response r = plate::respond(failure::to_unit_profiles(model.predict(model.clamp(wanted))), thickness,
                                             row.input.mu1, row.input.mu2);
    answers.push_back({{r.sigma_over_p, r.lbreak_over_lc}, model.check(wanted).inside()});
  }
  return answers;
}

std::vector<Answer> answer(const std::string& model, const std::vector<PredictedRow>& rows) {
  if (model == "fem") return solve_rows(rows);
  if (meta_model::model_format(model) == meta_model::kProfileFormat) {
    return superpose_rows(meta_model::ProfileModel::read(model), rows);
  }
  return infer_rows(meta_model::Network::read(model), rows);
}

}  // namespace

meta_model::ProfileSample to_profile_sample(const database::Record& record) {
  const plate::UnitProfiles& unit = record.profiles;
  const plate::WedgePlate& g = record.plate;
  meta_model::ProfileSample sample{{g.depth, g.contact_length, g.angle, g.thickness}, {}};
  meta_model::Profiles& p = sample.profiles;
  p.station = unit.station;
  for (std::size_t i = 0; i < unit.station.size(); ++i) {
    p.bending_xx.push_back(unit.bending[i].xx);
    p.bending_yy.push_back(unit.bending[i].yy);
    p.normal_xx.push_back(unit.normal[i].xx);
    p.normal_yy.push_back(unit.normal[i].yy);
    p.tangential_xy.push_back(unit.tangential[i].xy);
  }
  return sample;
}

void predict_rows(const PredictOptions& options) {
  std::string header;
  std::vector<PredictedRow> rows;
  if (options.rows.empty()) {
    rows = read_rows(std::cin, "standard input", header);
  } else {
    std::ifstream file(options.rows);
    if (!file) throw InputError(fmt::format("{}: cannot be read; give a CSV file that exists", options.rows));
    rows = read_rows(file, options.rows, header);
  }
  const std::vector<Answer> answers = answer(options.model, rows);
  fmt::print("{},sigma_over_p,lbreak_over_lc,in_range\n", header);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    fmt::print("{},{:.6g},{:.6g},{}\n", rows[i].text, answers[i].output.sigma_over_p, answers[i].output.lbreak_over_lc,
               answers[i].in_range);
  }
}

}  // namespace brash::cli
