// SPDX-License-Identifier: GPL-3.0-or-later
#include "long_history.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace brash::report {
namespace {

/// Rows of a history that is drawn as it is.
constexpr std::size_t kMostRows = 20000;
/// Of a longer history: more than a wide screen has pixels for its chart.
constexpr std::size_t kSpans = 1500;

constexpr std::array<Wrench model::LoadRow::*, 4> kDrawnLoads{
    &model::LoadRow::total, &model::LoadRow::crushing, &model::LoadRow::floe_normal, &model::LoadRow::floe_friction};
constexpr std::array<Vec3 Wrench::*, 2> kParts{&Wrench::force, &Wrench::moment};
constexpr std::array<double Vec3::*, 3> kAxes{&Vec3::x, &Vec3::y, &Vec3::z};

/// Calls `visit` with a reader of each of the six components of `load`.
template <typename Visit>
void visit_components(Wrench model::LoadRow::*load, Visit&& visit) {
  for (const auto part : kParts)
    for (const auto axis : kAxes) visit([=](const model::LoadRow& row) { return row.*load.*part.*axis; });
}

}  // namespace

void LongHistory::take(std::vector<model::LoadRow>&& rows, std::size_t n_all) {
  span_ = n_all <= kMostRows ? 1 : (n_all + kSpans - 1) / kSpans;
  for (const model::LoadRow& row : rows) {
    samples_.times.push_back(row.time);
    std::size_t i = 0;
    visit_components(&model::LoadRow::total, [&](auto value) { samples_.loads[i++].push_back(value(row)); });
  }
  if (!rows.empty()) last_ = rows.back();
  if (span_ == 1) {
    std::ranges::move(rows, std::back_inserter(drawn_));
    return;
  }
  for (const model::LoadRow& row : rows) {
    waiting_.push_back(row);
    if (waiting_.size() == span_) choose();
  }
}

void LongHistory::choose() {
  std::set<std::size_t> chosen;
  for (const auto load : kDrawnLoads)
    visit_components(load, [&](auto value) {
      const auto [least, largest] = std::ranges::minmax_element(waiting_, {}, value);
      chosen.insert(static_cast<std::size_t>(least - waiting_.begin()));
      chosen.insert(static_cast<std::size_t>(largest - waiting_.begin()));
    });
  for (const std::size_t i : chosen) drawn_.push_back(waiting_[i]);
  waiting_.clear();
}

std::vector<model::LoadRow> LongHistory::drawn() {
  if (!waiting_.empty()) choose();
  if (span_ > 1 && drawn_.back().time != last_.time) drawn_.push_back(last_);
  return std::move(drawn_);
}

}  // namespace brash::report
