// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "brash/analysis/resistance.hpp"
#include "brash/analysis/tables.hpp"
#include "brash/core/error.hpp"
#include "brash/core/text.hpp"

namespace brash::analysis {
namespace {

constexpr const char* kTable = "a table (CSV) of net thrust: `speed` [m/s], rising from row to row, and `thrust` [N]";

double number(const TextTable& table, std::size_t row, std::size_t column) {
  const std::string& cell = table.rows[row][column];
  if (const auto value = number_in(cell); value && *value >= 0.0) return *value;
  throw InputError(Complaint{fmt::format("{}:{}", table.path, row + 2),
                             fmt::format("{} '{}'", table.names[column], printable(cell)), "a number of SI, at least 0",
                             "correct the number"});
}

}  // namespace

NetThrust NetThrust::from_bollard_pull(double bollard, double open_water) {
  NetThrust thrust;
  thrust.bollard_ = bollard;
  thrust.open_water_ = open_water;
  thrust.loss_ = model::thrust_loss(bollard, open_water);
  return thrust;
}

NetThrust NetThrust::from_table(const std::string& path) {
  const TextTable table = read_text_table(path, kTable, "write a line of names, then one line a speed");
  const std::size_t speed = table.column("speed"), thrust = table.column("thrust");
  NetThrust found;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    found.speeds_.push_back(number(table, row, speed));
    found.thrusts_.push_back(number(table, row, thrust));
    if (row > 0 && !(found.speeds_[row] > found.speeds_[row - 1]))
      throw InputError(Complaint{fmt::format("{}:{}", path, row + 2),
                                 fmt::format("speed {:g} after {:g}", found.speeds_[row], found.speeds_[row - 1]),
                                 "speeds that rise from row to row", "sort the rows, and keep one of each speed"});
  }
  if (found.speeds_.size() < 2)
    throw InputError(
        Complaint{path, fmt::format("has {} rows", found.speeds_.size()), kTable, "give two rows at least"});
  return found;
}

std::optional<double> NetThrust::at(double speed) const {
  if (speeds_.empty()) return std::max(0.0, bollard_ - loss_.linear * speed - loss_.quadratic * speed * speed);
  if (speed < speeds_.front() || speed > speeds_.back()) return std::nullopt;
  const auto next = std::max<std::ptrdiff_t>(1, std::ranges::lower_bound(speeds_, speed) - speeds_.begin());
  const auto i = static_cast<std::size_t>(next);
  return std::lerp(thrusts_[i - 1], thrusts_[i], (speed - speeds_[i - 1]) / (speeds_[i] - speeds_[i - 1]));
}

nlohmann::ordered_json NetThrust::json() const {
  if (speeds_.empty()) return {{"bollard_pull", bollard_}, {"open_water_speed", open_water_}};
  return {{"speed", speeds_}, {"thrust", thrusts_}};
}

}  // namespace brash::analysis
