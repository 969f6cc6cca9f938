// SPDX-License-Identifier: GPL-3.0-or-later
#include "schedule.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "brash/statistics/intervals.hpp"
#include "brash/statistics/moments.hpp"
#include "case_results.hpp"

namespace brash::campaign {

bool is_narrow(const io::StopRule& rule, std::span<const double> values) {
  if (values.size() < 2) return false;
  const statistics::Interval interval = statistics::mean_interval(values, rule.confidence);
  const double mean = statistics::moments(values).mean;
  return 0.5 * (interval.upper - interval.lower) <= rule.half_width * std::abs(mean);
}

Schedule::Schedule(const io::CampaignPlan& plan, const Folder& folder)
    : plan_(plan), folder_(folder), settings_(plan.settings.size()) {
  for (std::size_t setting = 0; setting < settings_.size(); ++setting) {
    add_replicates(setting, plan.replicates);
    extend(setting);
  }
}

void Schedule::add_replicates(std::size_t setting, int n) {
  std::vector<Replicate>& replicates = settings_[setting];
  const int first = static_cast<int>(replicates.size());
  replicates.resize(replicates.size() + static_cast<std::size_t>(n));
  for (int i = first; i < first + n; ++i) look_at(setting, i);
  first_open_ = std::min(first_open_, setting);
}

void Schedule::look_at(std::size_t setting, int replicate) {
  const CaseKey key{setting, replicate};
  Replicate& seen = settings_[setting][static_cast<std::size_t>(replicate)];
  seen.state = folder_.state(key);
  if (!plan_.stop || seen.state != CaseState::kDone) return;
  const std::map<std::string, double> numbers = folder_.numbers(key);
  if (const auto found = numbers.find(plan_.stop->statistic); found != numbers.end()) seen.value = found->second;
  seen.fingerprint = fingerprint(numbers);
}

void Schedule::look_at(const CaseKey& key) {
  look_at(key.setting, key.replicate);
  extend(key.setting);
}

bool Schedule::is_narrow_enough(std::size_t setting) const {
  std::vector<double> values;
  std::set<std::string> seen;
  for (const Replicate& replicate : settings_[setting])
    if (replicate.value && seen.insert(replicate.fingerprint).second) values.push_back(*replicate.value);
  return plan_.stop && is_narrow(*plan_.stop, values);
}

bool Schedule::has_statistic(std::size_t setting) const {
  return std::ranges::any_of(settings_[setting], [](const Replicate& r) { return r.value.has_value(); });
}

bool Schedule::is_missing_cases(std::size_t setting) const {
  return std::ranges::any_of(settings_[setting], [](const Replicate& r) { return r.state == CaseState::kMissing; });
}

void Schedule::extend(std::size_t setting) {
  if (!plan_.stop) return;
  // The replicates that a stopped campaign left behind may fulfil several batches at once.
  while (!is_missing_cases(setting) && !is_narrow_enough(setting) && has_statistic(setting)) {
    const int left = plan_.stop->most_replicates - static_cast<int>(settings_[setting].size());
    if (left <= 0) return;
    add_replicates(setting, std::min(left, plan_.stop->batch));
  }
}

std::optional<CaseKey> Schedule::next() {
  for (; first_open_ < settings_.size(); ++first_open_) {
    std::vector<Replicate>& replicates = settings_[first_open_];
    const auto open = std::ranges::find_if(
        replicates, [](const Replicate& r) { return r.state == CaseState::kMissing && !r.handed_out; });
    if (open == replicates.end()) continue;
    open->handed_out = true;
    return CaseKey{first_open_, static_cast<int>(open - replicates.begin())};
  }
  return {};
}

Counts Schedule::counts() const {
  Counts counts;
  for (const auto& [key, state] : cases()) {
    ++counts.n_cases;
    counts.n_done += state == CaseState::kDone ? 1 : 0;
    counts.n_failed += state == CaseState::kFailed ? 1 : 0;
  }
  return counts;
}

std::vector<std::pair<CaseKey, CaseState>> Schedule::cases() const {
  std::vector<std::pair<CaseKey, CaseState>> all;
  for (std::size_t setting = 0; setting < settings_.size(); ++setting)
    for (std::size_t i = 0; i < settings_[setting].size(); ++i)
      all.emplace_back(CaseKey{setting, static_cast<int>(i)}, settings_[setting][i].state);
  return all;
}

Counts count(const io::CampaignPlan& plan, const std::string& directory) {
  const Folder folder(plan, directory);
  return Schedule(plan, folder).counts();
}

int count_beyond(const io::CampaignPlan& plan, const std::string& directory) {
  namespace fs = std::filesystem;
  const Folder folder(plan, directory);
  std::set<std::string> planned;
  for (const auto& [key, state] : Schedule(plan, folder).cases()) planned.insert(folder.id(key));
  int n = 0;
  std::error_code is_not_there;
  for (const auto& entry : fs::directory_iterator(directory + "/cases", is_not_there)) {
    const bool is_done = entry.path().extension() != ".part" && fs::exists(entry.path() / "summary.json");
    n += is_done && !planned.contains(entry.path().filename().string()) ? 1 : 0;
  }
  return n;
}

}  // namespace brash::campaign
