// SPDX-License-Identifier: GPL-3.0-or-later
#include "failure_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <iostream>
#include <sstream>
#include <string_view>
#include <vector>

#include "brash/core/byte_order_mark.hpp"
#include "brash/core/constants.hpp"
#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/text.hpp"
#include "brash/failure/response_model.hpp"
#include "brash/meta_model/network.hpp"
#include "brash/plate/plate.hpp"
#include "messages.hpp"

namespace brash::cli {

namespace {

constexpr const char* kHeader = "b_lc,c_lc,theta_deg,mu1,mu2";
constexpr const char* kThickness = ",lc_over_h";
constexpr std::size_t kColumns = 5;
constexpr std::array<const char*, kColumns + 1> kNames{"b_lc", "c_lc", "theta_deg", "mu1", "mu2", "lc_over_h"};
constexpr const char* kRemedy = "correct the line";
/// Of a bay, b / l_c: the solver meshes no deeper one.
constexpr double kDeepest = 5.0;

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
    throw InputError(Complaint{place, fmt::format("{} = `{}` is not a finite number", name, printable(text)),
                               "numbers with a decimal point", kRemedy});
  }
  return value;
}

void expect(bool allowed, const std::string& place, const char* name, double value, const char* what) {
  if (!allowed) throw InputError(Complaint{place, fmt::format("{} = {} is not allowed", name, value), what, kRemedy});
}

PredictedRow parse_row(const std::string& line, const std::string& place, std::size_t n_columns) {
  std::vector<std::string> fields;
  std::stringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  if (fields.size() != n_columns) {
    throw InputError(Complaint{place, fmt::format("has {} values", fields.size()),
                               fmt::format("{} values, as the first line says", n_columns), kRemedy});
  }
  std::array<double, kColumns + 1> v{};
  for (std::size_t i = 0; i < n_columns; ++i) v[i] = number(fields[i], place, kNames[i]);
  expect(v[0] >= -kDeepest, place, kNames[0], v[0],
         fmt::format("at least {}; a bay has a depth below 0", -kDeepest).c_str());
  expect(v[1] > 0.0, place, kNames[1], v[1], "above 0");
  expect(v[2] >= 0.0 && v[2] < 180.0, place, kNames[2], v[2], "from 0 to below 180 degrees");
  expect(v[3] > 0.0, place, kNames[3], v[3], "above 0");
  if (n_columns > kColumns)
    expect(v[5] >= 1.0, place, kNames[5], v[5], "at least 1: l_c / h of a plate, and not h / l_c, its inverse");
  return {line, {v[0], v[1], radians(v[2]), v[3], v[4]}, v[5]};
}

std::vector<PredictedRow> read_rows(std::istream& stream, const std::string& name, std::string& header) {
  std::string line;
  if (!std::getline(stream, line))
    throw InputError(Complaint{name, "is empty", fmt::format("a first line `{}[{}]`, then rows", kHeader, kThickness),
                               "check that it is the right file and whole"});
  header = without_line_end(std::string(without_byte_order_mark(line)));
  if (header != kHeader && header != std::string(kHeader) + kThickness) {
    throw InputError(Complaint{name + ":1", fmt::format("the first line is `{}`", printable(header)),
                               fmt::format("`{}` or `{}{}`", kHeader, kHeader, kThickness),
                               "write that line first, and the columns in its order"});
  }
  const std::size_t n_columns = header == kHeader ? kColumns : kColumns + 1;
  std::vector<PredictedRow> rows;
  for (int number = 2; std::getline(stream, line); ++number) {
    line = without_line_end(line);
    if (!line.empty()) rows.push_back(parse_row(line, fmt::format("{}:{}", name, number), n_columns));
  }
  return rows;
}

}  // namespace

std::vector<PredictedRow> read_predicted_rows(const std::string& path, std::string& header) {
  if (path.empty()) return read_rows(std::cin, "standard input", header);
  std::istringstream file(read_characters(path, "rows of inputs (CSV)", 64));
  return read_rows(file, path, header);
}

void predict_rows(const PredictOptions& options) {
  std::string header;
  const std::vector<PredictedRow> rows = read_predicted_rows(options.rows, header);
  const auto model = failure::make_response_model(options.model);
  std::vector<failure::ModelResponse> answers;
  for (const PredictedRow& row : rows)
    answers.push_back(model->respond(row.input, row.lc_over_h > 0.0 ? 1.0 / row.lc_over_h : 0.0));
  print("{},sigma_over_p,lbreak_over_lc,in_range\n", header);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    print("{},{:.6g},{:.6g},{}\n", rows[i].text, answers[i].sigma_over_p, answers[i].lbreak_over_lc,
          answers[i].in_range);
  }
}

}  // namespace brash::cli
