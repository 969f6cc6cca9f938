// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fnmatch.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "brash/core/error.hpp"
#include "brash/core/text.hpp"
#include "brash/statistics/hypothesis.hpp"
#include "brash/statistics/intervals.hpp"
#include "messages.hpp"
#include "stats_commands.hpp"
#include "text_table.hpp"

namespace brash::cli {
namespace {

using nlohmann::ordered_json;
/// Values of the replicates at each setting, in rising order of the setting.
using Groups = std::map<double, std::vector<double>>;

TextTable read_cases(const std::string& given) {
  return read_text_table(std::filesystem::is_directory(given) ? given + "/campaign.csv" : given,
                         "the campaign.csv of a campaign that is done",
                         "run the campaign with `--resume`, which writes the table again");
}

/// Rows without a number in either column, such as failed cases, are left out.
Groups groups_of(const TextTable& table, const std::string& along, const std::string& of, const std::string& where) {
  const std::size_t x = table.column(along), y = table.column(of);
  const std::size_t setting = where.empty() ? 0 : table.column("setting");
  Groups groups;
  for (const TextTable::Row& row : table.rows) {
    if (!where.empty() && fnmatch(where.c_str(), row[setting].c_str(), 0) != 0) continue;
    const auto at = number_in(row[x]), value = number_in(row[y]);
    if (at && value) groups[*at].push_back(*value);
  }
  const bool repeated = std::ranges::all_of(groups, [](const auto& group) { return group.second.size() >= 2; });
  if (groups.size() < 2 || !repeated)
    throw InputError(Complaint{table.path,
                               fmt::format("'{}' has {} settings{}", printable(along), groups.size(),
                                           repeated ? "" : ", some with a single replicate"),
                               "2 settings at least with 2 numbers of '" + of + "' each",
                               "run more settings and replicates, or choose another --along, --of or --where"});
  return groups;
}

ordered_json trend_of(const Groups& groups, const std::string& of) {
  ordered_json settings = ordered_json::array();
  std::vector<std::vector<double>> values;
  std::vector<double> x, y;
  for (const auto& [at, group] : groups) {
    const statistics::Interval interval = statistics::mean_interval(group);
    settings.push_back({{"at", at},
                        {"n", group.size()},
                        {"mean", 0.5 * (interval.lower + interval.upper)},
                        {"mean_95", {interval.lower, interval.upper}}});
    values.push_back(group);
    x.insert(x.end(), group.size(), at);
    y.insert(y.end(), group.begin(), group.end());
  }
  const statistics::TestResult trend = statistics::jonckheere_terpstra(values), tau = statistics::kendall(x, y);
  const statistics::MeanComparison ends = statistics::compare_means(values.back(), values.front());
  return {{"of", of},
          {"settings", settings},
          {"jonckheere_terpstra", {{"z", trend.statistic}, {"p", trend.p_value}}},
          {"kendall", {{"tau", tau.statistic}, {"p", tau.p_value}}},
          {"last_less_first",
           {{"difference", ends.difference}, {"interval_95", {ends.interval.lower, ends.interval.upper}}}}};
}

/// Adds Holm's adjustment of all trends and their verdicts at 5 %.
void adjust(ordered_json& trends) {
  std::vector<double> p;
  for (const ordered_json& trend : trends) p.push_back(trend["jonckheere_terpstra"]["p"].get<double>());
  const std::vector<double> adjusted = statistics::holm(p);
  for (std::size_t i = 0; i < adjusted.size(); ++i) {
    ordered_json& trend = trends[i];
    const double z = trend["jonckheere_terpstra"]["z"].get<double>();
    trend["p_adjusted"] = adjusted[i];
    trend["trend"] = adjusted[i] >= 0.05 ? "undecided" : z > 0.0 ? "rises" : "falls";
  }
}

std::string trend_text(const ordered_json& out) {
  std::string text;
  for (const ordered_json& trend : out["trends"]) {
    text += fmt::format("{} along {}\n", trend["of"].get<std::string>(), out["along"].get<std::string>());
    for (const ordered_json& s : trend["settings"])
      text += fmt::format("  {:<12.6g} {:>3} replicates  {:.6g}  [{:.6g}, {:.6g}]\n", s["at"].get<double>(),
                          s["n"].get<std::size_t>(), s["mean"].get<double>(), s["mean_95"][0].get<double>(),
                          s["mean_95"][1].get<double>());
    const ordered_json &test = trend["jonckheere_terpstra"], &ends = trend["last_less_first"];
    text +=
        fmt::format("  {}: Jonckheere-Terpstra z = {:.3f}, p = {:.3g} ({:.3g} after Holm), Kendall's tau = {:.3f}\n",
                    trend["trend"].get<std::string>(), test["z"].get<double>(), test["p"].get<double>(),
                    trend["p_adjusted"].get<double>(), trend["kendall"]["tau"].get<double>());
    text += fmt::format("  last less first: {:.6g}  [{:.6g}, {:.6g}]\n", ends["difference"].get<double>(),
                        ends["interval_95"][0].get<double>(), ends["interval_95"][1].get<double>());
  }
  return text;
}

}  // namespace

void add_trend_command(CLI::App& app) {
  struct Options {
    std::string campaign, along, where;
    std::vector<std::string> of{"horizontal.mean"};
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("trend", "Tests whether a result rises or falls along a campaign's grid");
  command->add_option("campaign", options->campaign, "folder of a campaign, or its campaign.csv")->required();
  command->add_option("--along", options->along, "key of the grid, such as structure.angle")->required();
  command->add_option("--of", options->of, "columns; their p-values are adjusted for their number")
      ->take_all()
      ->allow_extra_args(false)
      ->capture_default_str();
  command->add_option("--where", options->where, "only settings whose name matches, such as 'angle-50deg_*'");
  command->add_flag("--json", options->json, "as JSON");
  command->footer("Example: brash trend results/angle_velocity --along structure.angle --where '*_speed-2.0'");
  command->callback([options] {
    const TextTable table = read_cases(options->campaign);
    ordered_json trends = ordered_json::array();
    for (const std::string& of : options->of)
      trends.push_back(trend_of(groups_of(table, options->along, of, options->where), of));
    adjust(trends);
    const ordered_json out{{"along", options->along}, {"where", options->where}, {"trends", trends}};
    print_data(options->json ? out.dump(2) + "\n" : escaped_lines(trend_text(out)));
  });
}

}  // namespace brash::cli
