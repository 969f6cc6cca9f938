// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/analysis/trend.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>

#include "brash/analysis/campaign_histories.hpp"
#include "brash/analysis/tables.hpp"
#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/text.hpp"
#include "brash/statistics/hypothesis.hpp"
#include "brash/statistics/intervals.hpp"

namespace brash::analysis {
namespace {

using nlohmann::ordered_json;
/// Values of the replicates at each setting, in rising order of the setting.
using Groups = std::map<double, std::vector<double>>;
/// The same for each combination of the other axes, by its name; of one axis alone, "".
using Strata = std::map<std::string, Groups>;

TextTable read_cases(const std::filesystem::path& table) {
  return read_text_table(table.string(), "the campaign.csv of a campaign that is done",
                         "run the campaign with `--resume`, which writes the table again");
}

/// The varied keys of a campaign, as the summary.json beside its table names them; none for a table alone.
std::vector<std::string> varied_keys(const std::filesystem::path& table) {
  std::vector<std::string> keys;
  const std::string path = (table.parent_path() / "summary.json").string();
  if (!std::filesystem::exists(path)) return keys;
  const auto json = ordered_json::parse(read_json_text(path, "the summary.json of a campaign"), nullptr, false);
  if (!json.is_object() || !json.contains("settings") || !json["settings"].is_array()) return keys;
  for (const ordered_json& setting : json["settings"]) {
    if (!setting.is_object() || !setting.contains("values")) continue;
    for (const auto& [key, value] : setting["values"].items())
      if (std::ranges::find(keys, key) == keys.end()) keys.push_back(key);
  }
  return keys;
}

/// The rows of the settings that `where` leaves; empty: all. Replicates that coincide count once.
std::vector<const TextTable::Row*> chosen(const TextTable& table, const std::string& where) {
  const std::size_t setting = table.column("setting");
  std::vector<const TextTable::Row*> rows;
  for (const TextTable::Row& row : table.rows)
    if (!is_repeated(table, row) && (where.empty() || fnmatch(where.c_str(), row[setting].c_str(), 0) == 0))
      rows.push_back(&row);
  return rows;
}

/// Columns of the keys of other axes: the ones that vary at one value of `along`.
std::vector<std::size_t> other_axes(const TextTable& table, const std::string& along,
                                    const std::vector<std::string>& keys) {
  const std::size_t x = table.column(along);
  std::vector<std::size_t> others;
  for (const std::string& key : keys) {
    if (key == along || std::ranges::find(table.names, key) == table.names.end()) continue;
    const std::size_t column = table.column(key);
    std::map<std::string, std::string> seen;
    const bool varies = std::ranges::any_of(table.rows, [&](const TextTable::Row& row) {
      return seen.try_emplace(row[x], row[column]).first->second != row[column];
    });
    if (varies) others.push_back(column);
  }
  return others;
}

std::string stratum_of(const TextTable& table, const TextTable::Row& row, const std::vector<std::size_t>& others) {
  std::string name;
  for (const std::size_t column : others)
    name += (name.empty() ? "" : ", ") + table.names[column] + " = " + row[column];
  return name;
}

/// Two settings at one value of `along` in one stratum: another key varies, and nothing names it.
[[noreturn]] void refuse_unnamed_axis(const TextTable& table, const std::string& first, const std::string& second,
                                      const std::string& along) {
  throw InputError(Complaint{
      table.path,
      fmt::format("'{}' and '{}' have one value of '{}'", printable(first), printable(second), printable(along)),
      "one setting at each value, or the campaign's summary.json beside its table",
      "name the folder of the campaign, or choose settings with --where"});
}

/// Rows without a number in either column, such as failed cases, are left out; so are strata without a trend to see.
Strata strata_of(const TextTable& table, const std::vector<std::string>& keys, const std::string& along,
                 const std::string& of, const std::string& where) {
  const std::size_t x = table.column(along), y = table.column(of);
  const std::size_t setting = table.column("setting");
  const std::vector<std::size_t> others = other_axes(table, along, keys);
  Strata strata;
  std::map<std::string, std::map<double, std::string>> names;  // of the settings, by stratum and value of `along`
  for (const TextTable::Row* const row : chosen(table, where)) {
    const auto at = number_in((*row)[x]), value = number_in((*row)[y]);
    if (!at || !value) continue;
    const std::string stratum = stratum_of(table, *row, others);
    const std::string& first = names[stratum].try_emplace(*at, (*row)[setting]).first->second;
    if (first != (*row)[setting]) refuse_unnamed_axis(table, first, (*row)[setting], along);
    strata[stratum][*at].push_back(*value);
  }
  std::size_t most = 0;
  bool repeated = true;
  for (const auto& [name, groups] : strata) {
    most = std::max(most, groups.size());
    if (groups.size() >= 2)
      repeated = repeated && std::ranges::all_of(groups, [](const auto& group) { return group.second.size() >= 2; });
  }
  std::erase_if(strata, [](const auto& stratum) { return stratum.second.size() < 2; });
  if (strata.empty() || !repeated)
    throw InputError(Complaint{
        table.path,
        fmt::format("'{}' has {} settings{}", printable(along), most, repeated ? "" : ", some with a single replicate"),
        "2 settings at least with 2 numbers of '" + of + "' each",
        "run more settings and replicates, or choose another --along, --of or --where"});
  return strata;
}

ordered_json settings_json(const Groups& groups) {
  ordered_json settings = ordered_json::array();
  for (const auto& [at, group] : groups) {
    const statistics::Interval interval = statistics::mean_interval(group);
    settings.push_back({{"at", at},
                        {"n", group.size()},
                        {"mean", 0.5 * (interval.lower + interval.upper)},
                        {"mean_95", {interval.lower, interval.upper}}});
  }
  return settings;
}

/// The groups at the last and the first setting of all, in each stratum that has both.
std::vector<statistics::PairOfGroups> ends_of(const Strata& strata) {
  double first = INFINITY, last = -INFINITY;
  for (const auto& [name, groups] : strata) {
    first = std::min(first, groups.begin()->first);
    last = std::max(last, groups.rbegin()->first);
  }
  std::vector<statistics::PairOfGroups> ends;
  for (const auto& [name, groups] : strata)
    if (groups.contains(first) && groups.contains(last)) ends.push_back({groups.at(last), groups.at(first)});
  return ends;
}

/// The difference of the ends with its interval; nulls if no stratum has both ends.
ordered_json last_less_first(const Strata& strata, double confidence) {
  const std::vector<statistics::PairOfGroups> ends = ends_of(strata);
  ordered_json out{{"difference", nullptr}, {"interval_95", {nullptr, nullptr}}, {"confidence", confidence}};
  if (strata.size() > 1) out["strata"] = ends.size();
  if (ends.empty()) return out;
  const statistics::MeanComparison found = statistics::compare_means(ends, confidence);
  out["difference"] = found.difference;
  out["interval_95"] = {found.interval.lower, found.interval.upper};
  return out;
}

/// @param confidence  of the interval of the last less the first.
ordered_json trend_of(const Strata& strata, const std::string& of, double confidence) {
  std::vector<std::vector<std::vector<double>>> values;
  ordered_json settings = ordered_json::array(), by_stratum = ordered_json::array();
  for (const auto& [name, groups] : strata) {
    settings = settings_json(groups);
    by_stratum.push_back({{"stratum", name}, {"settings", settings}});
    values.emplace_back();
    for (const auto& [at, group] : groups) values.back().push_back(group);
  }
  const statistics::TestResult trend = statistics::jonckheere_terpstra(values);
  ordered_json out{{"of", of}};
  if (strata.size() == 1)
    out["settings"] = settings;
  else
    out["strata"] = by_stratum;
  out["jonckheere_terpstra"] = {{"z", trend.statistic}, {"p", trend.p_value}};
  out["kendall"] = {{"tau", statistics::kendall_tau(values)}};
  out["last_less_first"] = last_less_first(strata, confidence);
  return out;
}

/// The verdict at 5 %: the test of the trend, else the interval of the ends where it excludes zero.
std::string verdict(double p_adjusted, double z, const ordered_json& ends) {
  if (p_adjusted < 0.05) return z > 0.0 ? "rises" : "falls";
  if (ends["difference"].is_null()) return "undecided";
  if (ends["interval_95"][0].get<double>() > 0.0) return "last above first";
  if (ends["interval_95"][1].get<double>() < 0.0) return "last below first";
  return "undecided";
}

/// Adds Holm's adjustment of all trends and their verdicts at 5 %.
void adjust(ordered_json& trends) {
  std::vector<double> p;
  for (const ordered_json& trend : trends) p.push_back(trend["jonckheere_terpstra"]["p"].get<double>());
  const std::vector<double> adjusted = statistics::holm(p);
  for (std::size_t i = 0; i < adjusted.size(); ++i) {
    ordered_json& trend = trends[i];
    trend["p_adjusted"] = adjusted[i];
    trend["trend"] = verdict(adjusted[i], trend["jonckheere_terpstra"]["z"].get<double>(), trend["last_less_first"]);
  }
}

/// How many of the chosen cases have each warning.
std::map<std::string, std::size_t> count_warnings(const TextTable& table, const std::string& where) {
  std::map<std::string, std::size_t> counts;
  if (std::ranges::find(table.names, "warnings") == table.names.end()) return counts;
  const std::size_t warnings = table.column("warnings");
  for (const TextTable::Row* const row : chosen(table, where)) {
    std::istringstream ids((*row)[warnings]);
    for (std::string id; ids >> id;) ++counts[id];
  }
  return counts;
}

/// The origin of the chosen cases; empty in tables of earlier versions, which do not name it.
model::Origin origin_in(const TextTable& table, const std::string& where) {
  const auto has = [&](const char* column) { return std::ranges::find(table.names, column) != table.names.end(); };
  if (!has("preset") || !has("program")) return {};
  model::Origin origin;
  const std::size_t status = table.column("status"), preset = table.column("preset"), program = table.column("program");
  for (const TextTable::Row* const row : chosen(table, where))
    if ((*row)[status] == "done") model::add(origin, {{printable((*row)[preset])}, {printable((*row)[program])}});
  return origin;
}

std::string settings_text(const ordered_json& settings) {
  std::string text;
  for (const ordered_json& s : settings)
    text += fmt::format("  {:<12.6g} {:>3} replicates  {:.6g}  [{:.6g}, {:.6g}]\n", s["at"].get<double>(),
                        s["n"].get<std::size_t>(), s["mean"].get<double>(), s["mean_95"][0].get<double>(),
                        s["mean_95"][1].get<double>());
  return text;
}

std::string difference_text(const ordered_json& trend) {
  const ordered_json& ends = trend["last_less_first"];
  if (ends["difference"].is_null()) return "  last less first: no stratum has both ends\n";
  const double lower = ends["interval_95"][0].get<double>(), upper = ends["interval_95"][1].get<double>();
  std::string text =
      fmt::format("  last less first: {:.6g}  [{:.6g}, {:.6g}]", ends["difference"].get<double>(), lower, upper);
  // Of several columns each interval is wider, so that all together hold with 95 %.
  const double confidence = ends["confidence"].get<double>();
  if (confidence > 0.95) text += fmt::format(" at {:.4g} %", 100.0 * confidence);
  const std::size_t n = trend.contains("strata") ? trend["strata"].size() : 1;
  if (const std::size_t used = ends.value("strata", n); used < n)
    text += fmt::format(", in the {} of {} strata with both ends", used, n);
  text += "\n";
  const auto verdict = trend["trend"].get<std::string>();
  if (verdict.starts_with("last"))
    text += "  the ends differ at 5 %, but the values between them do not rise or fall steadily\n";
  if (verdict == "undecided")
    text += fmt::format("  a change of up to {:.6g} could hide\n", std::max({0.0, -lower, upper}));
  return text;
}

}  // namespace

ordered_json trends_of(const std::string& table_file, const TrendSettings& asked) {
  const TextTable table = read_cases(table_file);
  const std::vector<std::string> keys = varied_keys(table_file);
  // The intervals of all columns together hold with 95 %.
  const double confidence = 1.0 - 0.05 / static_cast<double>(asked.of.size());
  ordered_json trends = ordered_json::array();
  for (const std::string& of : asked.of)
    trends.push_back(trend_of(strata_of(table, keys, asked.along, of, asked.where), of, confidence));
  adjust(trends);
  ordered_json out{{"along", asked.along},
                   {"where", asked.where},
                   {"trends", trends},
                   {"warnings", count_warnings(table, asked.where)}};
  add_origin(origin_in(table, asked.where), out);
  return out;
}

std::string trend_text(const ordered_json& out) {
  std::string text = origin_text(out);
  for (const ordered_json& trend : out["trends"]) {
    text += fmt::format("{} along {}\n", trend["of"].get<std::string>(), out["along"].get<std::string>());
    if (trend.contains("settings")) text += settings_text(trend["settings"]);
    if (trend.contains("strata"))
      for (const ordered_json& stratum : trend["strata"])
        text += fmt::format(" {}\n", stratum["stratum"].get<std::string>()) + settings_text(stratum["settings"]);
    const ordered_json& test = trend["jonckheere_terpstra"];
    text +=
        fmt::format("  {}: Jonckheere-Terpstra z = {:.3f}, p = {:.3g} ({:.3g} after Holm), Kendall's tau = {:.3f}\n",
                    trend["trend"].get<std::string>(), test["z"].get<double>(), test["p"].get<double>(),
                    trend["p_adjusted"].get<double>(), trend["kendall"]["tau"].get<double>());
    text += difference_text(trend);
  }
  for (const auto& [id, n] : out["warnings"].items())
    text += fmt::format("warning: {} of the cases {} '{}' (docs/reference/warnings.md)\n", n.get<std::size_t>(),
                        n == 1 ? "has" : "have", id);
  return text;
}

}  // namespace brash::analysis
