// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/io/campaign_plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "brash/core/error.hpp"
#include "brash/core/sha256.hpp"
#include "brash/core/text.hpp"
#include "brash/model/case_keys.hpp"
#include "plan_settings.hpp"
#include "resolve.hpp"
#include "schema.hpp"

namespace brash::io {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

constexpr std::size_t kMostSettings = 10'000;

/// The seed of a setting, so that settings draw independently: 48 bits of a hash of its name and the plan's seed. A
/// double holds them exactly, as in JSON.
std::uint64_t seed_of(const std::string& setting, std::uint64_t seed) {
  return std::stoull(sha256(fmt::format("{} {}", seed, setting)).substr(0, 12), nullptr, 16);
}

SettingValue value_of(double value) { return {fmt::format("{}", value), value}; }
SettingValue value_of(bool value) { return {value ? "1" : "0", value ? 1.0 : 0.0}; }
SettingValue value_of(int value) { return {std::to_string(value), value}; }
SettingValue value_of(std::uint64_t value) { return {std::to_string(value), static_cast<double>(value)}; }
SettingValue value_of(const std::string& value) { return {value, {}}; }
template <model::Choice Choice>
SettingValue value_of(Choice value) {
  return {std::string(model::name_of(value)), {}};
}
SettingValue value_of(const Vec2& value) { return {fmt::format("{} {}", value.x, value.y), {}}; }
SettingValue value_of(const std::array<int, 2>& value) { return {fmt::format("{} {}", value[0], value[1]), {}}; }
SettingValue value_of(const Vec3& value) { return {fmt::format("{} {} {}", value.x, value.y, value.z), {}}; }
template <typename Value>
SettingValue value_of(const std::optional<Value>& value) {
  return value ? value_of(*value) : SettingValue{};
}
template <std::size_t n>
SettingValue value_of(const std::array<double, n>& row) {
  return {fmt::format("{}", fmt::join(row, " ")), {}};
}
SettingValue value_of(const model::Waypoint& row) { return value_of(model::detail::numbers_of(row)); }
SettingValue value_of(const model::MooringLine& row) { return value_of(model::detail::numbers_of(row)); }
SettingValue value_of(const std::vector<double>& values) { return {fmt::format("{}", fmt::join(values, " ")), {}}; }
/// Places of legs, and other tables.
template <typename Row>
SettingValue value_of(const std::vector<Row>& rows) {
  std::string text;
  for (const Row& row : rows) text += (text.empty() ? "" : "; ") + value_of(row).text;
  return {text, {}};
}

SettingValue value_in(const model::Case& resolved, const std::string& name) {
  const std::string known = name == model::kLongSpeed ? model::kSpeed : name;
  SettingValue found;
  model::visit_keys(resolved, [&](const std::string& section, const std::string& key, const auto& value) {
    if (section + "." + key == known) found = value_of(value);
  });
  return found;
}

/// Reads a plan: its own sections first, then each of its settings.
class PlanReader {
 public:
  PlanReader(const std::string& path, const PlanOptions& options)
      : path_(path), options_(options), source_(parse_source(text_of(path, "plan"), path, {})) {}

  CampaignPlan read() {
    const Json document = validated(source_, schema_of_plans());
    check_quick();
    read_own(document);
    set_ = read_assignments(path_, "set", source_.tree.get("set"), problems_);
    axes_ = read_axes(path_, source_.tree.get("grid"), problems_);
    if (options_.quick) {
      quick_set_ = read_assignments(path_, "quick.set", source_.tree["quick"]["set"].node(), problems_);
      if (const Json& quick = document.value("quick", Json::object()); quick.contains("points"))
        for (Axis& axis : axes_)
          if (!axis.points.empty()) thin_out(axis, quick.at("points").get<int>());
    }
    check_base();
    check_keys();
    if (!problems_.empty()) refuse(std::move(problems_));
    add_settings();
    plan_.quick = options_.quick;
    plan_.replicates_in_place = options_.replicates;
    plan_.overrides = options_.overrides;
    return std::move(plan_);
  }

 private:
  void report(const Place& place, std::string key, std::string value, std::string what, std::string allowed,
              std::string nearest, std::string remedy) {
    problems_.push_back({place, std::move(key), std::move(value), std::move(what), std::move(allowed),
                         std::move(nearest), std::move(remedy)});
  }

  void check_quick() const {
    if (!options_.quick || source_.tree.contains("quick")) return;
    refuse({{place_of(source_, "quick"), "[quick]", "", "is missing, and --quick asks for it",
             "a section [quick] in the plan", "", "add it, or leave --quick out"}});
  }

  /// [campaign], [stop], [output] and their replacements in [quick].
  void read_own(const Json& document) {
    const Json quick = options_.quick ? document.value("quick", Json::object()) : Json::object();
    plan_.replicates =
        options_.replicates.value_or(quick.value("replicates", document.at("campaign").at("replicates").get<int>()));
    plan_.keep = document.at("output").at("keep").get<std::string>();
    plan_.columns = document.at("output").value("columns", options_.default_columns);
    for (const std::string& column : plan_.columns) check_column("output", "columns", column);
    for (auto at = plan_.columns.begin(); at != plan_.columns.end(); ++at)
      if (std::find(plan_.columns.begin(), at, *at) != at)
        report(place_of(source_, "output", "columns"), "output.columns", toml_string(*at), "is named twice",
               "each column once", "", "name it once");
    if (!source_.tree.contains("stop")) return;
    const Json& stop = document.at("stop");
    const StopRule rule{stop.at("statistic"), stop.at("half_width"), stop.at("confidence"), stop.at("most_replicates"),
                        stop.at("batch")};
    check_column("stop", "statistic", rule.statistic);
    if (options_.quick || options_.replicates) return;  // in place of the stop rule
    const int least = document.at("campaign").at("replicates");
    if (least < 2 || least > rule.most_replicates)
      report(place_of(source_, "campaign", "replicates"), "campaign.replicates", std::to_string(least),
             "is not a least number of replicates for [stop]",
             fmt::format("from 2 to stop.most_replicates = {}", rule.most_replicates), "", "change one of the two");
    plan_.stop = rule;
  }

  void check_column(const char* section, const char* key, const std::string& column) {
    if (std::ranges::find(options_.known_columns, column) != options_.known_columns.end()) return;
    report(place_of(source_, section, key), fmt::format("{}.{}", section, key), toml_string(column), "is not a column",
           "a number of a run's summary.json, the names of its keys joined by dots",
           nearest_name(column, options_.known_columns),
           "correct the name; docs/reference/plan.md says how they are made");
  }

  void check_base() {
    const bool named = source_.tree["campaign"]["case"].is_string();
    const bool inside = source_.tree.contains("case");
    if (inside && !source_.tree["case"].is_table()) {
      report(place_of(source_, "case"), "case", value_text(*source_.tree.get("case")), "must be a section",
             "`[case.ice]`, `[case.structure]` and so on, or campaign.case = \"FILE\"", "",
             "write the sections of the case under those, or name a case file under [campaign]");
    } else if (named == inside) {
      report(place_of(source_, "campaign", "case"), "campaign.case", "",
             named ? "cannot be combined with a case in the plan itself" : "is missing",
             "either campaign.case = \"FILE\" or the sections [case.ice], [case.structure], ...", "",
             named ? "remove one of the two" : "add `case = \"cone.toml\"` or the like under `[campaign]`");
    }
  }

  /// Every key is set in one place, and the replicates are the campaign's own.
  void check_keys() {
    std::set<std::string> taken;
    const auto take = [&](const Assignment& assignment) {
      const std::string name = assignment.name();
      if (name == "random.replicate") refuse_replicate(assignment.place);
      if (!taken.insert(name).second)
        report(assignment.place, name, value_text(*assignment.value), "is set twice",
               "each key in one axis of the grid, or in [set]", "", "remove one of the two");
    };
    for (const Assignment& assignment : set_) take(assignment);
    for (const Axis& axis : axes_)
      if (!axis.points.empty())
        for (const Assignment& assignment : axis.points.front().assignments) take(assignment);
    for (const Assignment& assignment : quick_set_)
      if (assignment.name() == "random.replicate") refuse_replicate(assignment.place);
    for (const std::string& text : options_.overrides) refuse_key_of_grid(text);
    std::size_t n = 1;
    for (const Axis& axis : axes_) n = std::min(n * std::max<std::size_t>(axis.points.size(), 1), kMostSettings + 1);
    if (n > kMostSettings)
      report(place_of(source_, "grid"), "grid", "", "has too many combinations",
             fmt::format("at most {}", kMostSettings), "", "divide the plan");
  }

  /// The names of the settings would not be true any more.
  void refuse_key_of_grid(const std::string& override_text) {
    CaseSource alone{path_, {}, {}};
    apply_override(alone, override_text);
    for (const auto& [name, place] : alone.overridden)
      for (const Axis& axis : axes_)
        if (std::ranges::find(axis.names, name) != axis.names.end())
          report(place, name, "", "is a key of the grid, which names the settings by its values",
                 "a key that no axis of the grid has", "", "change the values in [[grid]], or leave the override out");
  }

  void refuse_replicate(const Place& place) {
    report(place, "random.replicate", "", "is counted by the campaign", "any other key of the case file", "",
           "remove it; campaign.replicates says how many there are");
  }

  /// The text of a file, read once, so that a later hash belongs to the same bytes that were read.
  const std::string& text_of(const std::string& path, const std::string& kind) {
    const auto known = std::ranges::find(plan_.sources, path, &SourceText::path);
    if (known != plan_.sources.end()) return known->text;
    plan_.sources.push_back({path, read_text(path, kind)});
    return plan_.sources.back().text;
  }

  /// The base case as it was written; parsed again for each setting, so that messages can say where.
  CaseSource base() {
    if (const auto named = source_.tree["campaign"]["case"].value<std::string>()) {
      const std::string path = (fs::path(path_).parent_path() / *named).string();
      return parse_source(text_of(path, "case file"), path, {});
    }
    CaseSource whole = parse_source(text_of(path_, "plan"), path_, {});
    toml::table inside = std::move(*whole.tree["case"].as_table());
    lift_subsections(inside);
    return {path_, std::move(inside), {}};
  }

  std::string base_name() const {
    const auto named = source_.tree["campaign"]["case"].value<std::string>();
    return fs::path(named.value_or(path_)).stem().string();
  }

  /// All combinations of the axes' points, the last axis fastest.
  void add_settings() {
    std::set<std::string> names;
    std::vector<std::size_t> at(axes_.size(), 0);
    for (bool more = true; more;) {
      add_setting(at, names);
      more = false;
      for (std::size_t i = axes_.size(); i-- > 0 && !more;) {
        more = ++at[i] < axes_[i].points.size();
        if (!more) at[i] = 0;
      }
    }
    for (const Axis& axis : axes_)
      for (const std::string& name : axis.names) plan_.keys.push_back({name, unit_of(name)});
  }

  void add_setting(const std::vector<std::size_t>& at, std::set<std::string>& names) {
    Setting setting;
    for (std::size_t i = 0; i < at.size(); ++i) setting.name += (i == 0 ? "" : "_") + axes_[i].points[at[i]].label;
    if (axes_.empty()) setting.name = "base";
    constexpr std::size_t kLongestName = 120;
    const bool is_new = names.insert(setting.name).second;
    if (!is_new || setting.name.size() > kLongestName)
      refuse({{place_of(source_, "grid"), "grid", "",
               fmt::format("{} settings {} {}", is_new ? "the name of the" : "two",
                           is_new ? "is too long:" : "have the name", setting.name),
               fmt::format("one name for each setting, of at most {} letters", kLongestName), "",
               "remove a repeated value, or add short `labels` to the axes"}});
    const std::string case_name = axes_.empty() ? base_name() : base_name() + "_" + setting.name;
    try {
      setting.resolved = resolve(source_of(at), case_name);
    } catch (const InputError& error) {
      throw InputError(axes_.empty() ? error.what() : fmt::format("setting {}:\n{}", setting.name, error.what()));
    }
    setting.resolved.random.replicate = 0;
    refuse_equal(setting);
    for (const Axis& axis : axes_)
      for (const std::string& name : axis.names) setting.values.push_back(value_in(setting.resolved, name));
    if (!axes_.empty() && !varies("random.seed"))
      setting.resolved.random.seed = seed_of(setting.name, setting.resolved.random.seed);
    plan_.settings.push_back(std::move(setting));
  }

  bool varies(std::string_view key) const {
    return std::ranges::any_of(
        axes_, [&](const Axis& axis) { return std::ranges::find(axis.names, key) != axis.names.end(); });
  }

  /// Two spellings of one value would be computed twice, and no table could show which is which.
  void refuse_equal(const Setting& setting) {
    const auto [first, is_new] = name_of_case_.emplace(to_toml(setting.resolved), setting.name);
    if (!is_new)
      refuse({{place_of(source_, "grid"), "grid", "",
               fmt::format("the settings {} and {} have equal values", first->second, setting.name),
               "other values in each setting", "", "remove a repeated value"}});
  }

  CaseSource source_of(const std::vector<std::size_t>& at) {
    CaseSource source = base();
    const auto assign = [&](const std::vector<Assignment>& assignments) {
      for (const Assignment& a : assignments) replace_value(source, a.section, a.key, *a.value, a.place);
    };
    assign(set_);
    for (std::size_t i = 0; i < at.size(); ++i) assign(axes_[i].points[at[i]].assignments);
    assign(quick_set_);
    for (const std::string& text : options_.overrides) apply_override(source, text);
    if (const auto replicate = source.overridden.find("random.replicate"); replicate != source.overridden.end()) {
      refuse_replicate(replicate->second);
      refuse(std::move(problems_));
    }
    return source;
  }

  static std::string unit_of(const std::string& name) {
    const std::size_t dot = name.rfind('.');
    return schema_of_cases().keys(name.substr(0, dot)).at(name.substr(dot + 1)).value("x-unit", "1");
  }

  const std::string path_;
  const PlanOptions& options_;
  CampaignPlan plan_;
  const CaseSource source_;
  std::vector<Assignment> set_;
  std::vector<Axis> axes_;
  std::vector<Assignment> quick_set_;
  std::vector<Problem> problems_;
  std::map<std::string, std::string> name_of_case_;  ///< of each setting, by its case as it is written
};

}  // namespace

CampaignPlan read_campaign_plan(const std::string& path, const PlanOptions& options) {
  return PlanReader(path, options).read();
}

}  // namespace brash::io
