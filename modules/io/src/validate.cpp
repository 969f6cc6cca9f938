// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "brash/core/text.hpp"
#include "resolve.hpp"
#include "schema.hpp"
#include "toml_value.hpp"

namespace brash::io {
namespace {

using Json = nlohmann::json;

/// More than this is noise, and comparing names costs time.
constexpr std::size_t kMostProblems = 100;

std::vector<std::string> names(const OrderedJson& object) {
  std::vector<std::string> keys;
  for (const auto& [name, value] : object.items()) keys.push_back(name);
  return keys;
}

std::string list(const std::vector<std::string>& items) { return fmt::format("{}", fmt::join(items, ", ")); }

/// Reads a tree section by section and collects the problems.
class Reader {
 public:
  Reader(const CaseSource& source, const Schema& schema) : source_(source), schema_(schema) {}

  Json read() {
    refuse_other_kind();
    for (const auto& [key, node] : source_.tree) {
      if (problems_.size() >= kMostProblems) break;
      read_section(std::string(key.str()), node);
    }
    add_missing();
    if (problems_.size() < kMostProblems) check_schema();
    if (problems_.empty()) check_names_of_kinds();
    if (!problems_.empty()) refuse(std::move(problems_));
    shorten();
    add_defaults();
    return std::move(document_);
  }

 private:
  /// A file of another kind has one fault, and not one for each of its keys.
  void refuse_other_kind() const {
    const auto has = [&](const char* section) {
      return source_.tree.contains(section) && place_of(source_, section).override_text.empty();
    };
    const auto refuse_as = [&](const char* kind, const std::string& remedy) {
      refuse({{{source_.file, 1, 1, ""},
               schema_.kind(),
               "",
               fmt::format("is {}", kind),
               "a " + schema_.kind(),
               "",
               remedy}});
    };
    const bool of_case = schema_.kind() == "case";
    const std::string file = printable(source_.file);
    if (has("design") && has("range"))
      refuse_as("the plan of a failure database",
                fmt::format("compute it with `brash failure database {} -o DATABASE.nc`", file));
    if (of_case && (has("campaign") || has("grid")))
      refuse_as("the plan of a campaign", fmt::format("run it with `brash campaign {} -o DIR`", file));
    if (!of_case && has("ice") && has("structure"))
      refuse_as("a case",
                fmt::format("run it with `brash run {} -o DIR`, or name it in a plan as campaign.case", file));
  }

  void read_section(const std::string& section, const toml::node& node) {
    const std::vector<std::string> sections = names(schema_.sections());
    if (!schema_.sections().contains(section) && !node.is_table() && !node.is_array_of_tables()) {
      problems_.push_back(key_outside(section, node));
      return;
    }
    if (!schema_.sections().contains(section)) {
      const std::string nearest = nearest_name(section, sections);
      problems_.push_back({place_of(source_, section), "[" + section + "]", "", "is not a known section",
                           "sections " + list(sections), nearest.empty() ? "" : "[" + nearest + "]",
                           nearest.empty() ? "remove it, or name a known section" : "rename it, or remove it"});
      return;
    }
    if (Schema::is_free(schema_.sections().at(section))) return;
    if (!node.is_table()) {
      problems_.push_back({place_of(source_, section), section, value_text(node), "must be a section",
                           fmt::format("a line `[{}]`, then lines `key = value`", section), "",
                           fmt::format("write the keys of {} under `[{}]`", section, section)});
      return;
    }
    document_[section] = Json::object();
    for (const auto& [key, value] : *node.as_table()) {
      if (problems_.size() >= kMostProblems) return;
      read_key(section, std::string(key.str()), key, value);
    }
  }

  void read_key(const std::string& section, const std::string& name, const toml::key& key, const toml::node& node) {
    if (!schema_.keys(section).contains(name)) {
      if (!changes_nothing(section, name, node)) problems_.push_back(unknown_key(section, name, key, node));
      return;
    }
    const OrderedJson& key_schema = schema_.keys(section).at(name);
    if (Schema::is_free(key_schema)) return;
    const tl::expected<Json, ValueError> value = json_value(node, key_schema);
    if (value)
      document_[section][name] = *value;
    else
      problems_.push_back({place_of(source_, section, name), section + "." + name, value_text(node), value.error().what,
                           allowed_values(key_schema), "", value.error().remedy});
  }

  /// Whether a key of earlier versions has the value that every case has without it. The cases in results of earlier
  /// versions hold all their keys.
  bool changes_nothing(const std::string& section, const std::string& name, const toml::node& node) const {
    if (const std::string fixed = schema_.fixed_value(section, name); !fixed.empty()) return value_text(node) == fixed;
    const std::string successor = schema_.successor(section, name);
    if (!schema_.keys(section).contains(successor)) return false;
    const OrderedJson& key_schema = schema_.keys(section).at(successor);
    const tl::expected<Json, ValueError> value = json_value(node, key_schema);
    return value && key_schema.contains("default") && *value == Json(key_schema.at("default"));
  }

  /// `name` with the first section that has such a key; empty if none has.
  std::string with_section(const std::string& name) const {
    for (const std::string& section : names(schema_.sections()))
      if (has_keys(section) && schema_.keys(section).contains(name)) return section + "." + name;
    return "";
  }

  /// A key before the first section, where no key belongs.
  Problem key_outside(const std::string& name, const toml::node& node) const {
    const std::string nearest = with_section(name);
    return {place_of(source_, name),
            name,
            value_text(node),
            "stands outside the sections",
            "keys below a line `[section]`",
            nearest,
            nearest.empty() ? "remove it, or write it below the line of its section"
                            : fmt::format("write it below the line `[{}]`", nearest.substr(0, nearest.rfind('.')))};
  }

  Problem unknown_key(const std::string& section, const std::string& name, const toml::key& key,
                      const toml::node& node) {
    const std::vector<std::string> keys = names(schema_.keys(section));
    // The same name in another section is nearer than a similar name in this one.
    std::string nearest = with_section(name);
    if (nearest.empty() && !nearest_name(name, keys).empty()) nearest = section + "." + nearest_name(name, keys);

    Problem problem{place_of(source_, section, name),
                    section + "." + name,
                    value_text(node),
                    "is not a known key",
                    fmt::format("keys of [{}]: {}", section, list(keys)),
                    nearest,
                    nearest.empty() ? fmt::format("remove it; `brash schema{}` lists the keys",
                                                  schema_.kind() == "plan" ? " --plan" : "")
                                    : "rename it, or remove it"};
    if (const std::string successor = schema_.successor(section, name); !successor.empty()) {
      problem.what = "is no longer a key";
      problem.nearest = "";
      problem.remedy = fmt::format("write {} in its place, or remove it", successor);
    }
    if (const std::string value = schema_.fixed_value(section, name); !value.empty()) {
      problem.what = "is no longer a key";
      problem.nearest = "";
      problem.remedy = fmt::format("remove it: the program has {} in all cases", value);
    }
    if (problem.place.override_text.empty() && key.source().begin.line > 0) {
      problem.place.line = static_cast<int>(key.source().begin.line);
      problem.place.column = static_cast<int>(key.source().begin.column);
    }
    return problem;
  }

  /// Reports required keys that nobody wrote, and keys that another kind of the section has.
  void add_missing() {
    for (const std::string& section : names(schema_.sections())) {
      if (!has_keys(section) || (source_.tree.contains(section) && !source_.tree[section].is_table())) continue;
      if (!source_.tree.contains(section) && !schema_.requires_section(section)) continue;
      for (const auto& [key, key_schema] : schema_.keys(section).items()) {
        const bool written = source_.tree[section][key].node() != nullptr;
        if (written && !has_key(section, key))
          problems_.push_back(of_another_kind(section, key));
        else if (const std::string other = written_instead(section, key); written && !other.empty())
          problems_.push_back(stands_beside(section, key, other));
        else if (written && is_written(long_form(key_schema)))
          problems_.push_back(written_twice(section, key, long_form(key_schema)));
        else if (!written && is_missing(section, key))
          problems_.push_back(missing(section, key));
      }
    }
  }

  /// The value of the key `kind` of a section, its default where it is not a known one; "" where there is no such key.
  std::string kind_of(const std::string& section) const {
    if (!schema_.keys(section).contains("kind")) return "";
    const OrderedJson& kind = schema_.keys(section).at("kind");
    const auto written = source_.tree[section]["kind"].value<std::string>();
    const bool known =
        written && std::find(kind.at("enum").begin(), kind.at("enum").end(), *written) != kind.at("enum").end();
    return known ? *written : kind.at("default").get<std::string>();
  }

  /// Section and key of the key that another one is short for.
  static std::pair<std::string, std::string> long_form(const OrderedJson& key_schema) {
    const std::string name = key_schema.value("x-short-for", "");
    const std::size_t dot = name.rfind('.');
    return dot == std::string::npos ? std::pair<std::string, std::string>()
                                    : std::pair(name.substr(0, dot), name.substr(dot + 1));
  }

  bool is_written(const std::pair<std::string, std::string>& key) const {
    return source_.tree[key.first][key.second].node() != nullptr;
  }

  bool is_missing(const std::string& section, const std::string& key) const {
    return schema_.requires_key(section, key, kind_of(section)) && has_key(section, key) &&
           !is_written(long_form(schema_.keys(section).at(key))) && written_instead(section, key).empty();
  }

  /// The key that is written in place of another one, or "".
  std::string written_instead(const std::string& section, const std::string& key) const {
    for (const std::string& other : schema_.in_place_of(section, key)) {
      const std::size_t dot = other.rfind('.');
      if (is_written({other.substr(0, dot), other.substr(dot + 1)})) return other;
    }
    return "";
  }

  Problem missing(const std::string& section, const std::string& key) const {
    const OrderedJson& key_schema = schema_.keys(section).at(key);
    const std::string example = toml_text(key_schema.at("examples").front());
    return {place_of(source_, section),
            section + "." + key,
            "",
            "is missing",
            allowed_values(key_schema),
            "",
            fmt::format("add `{} = {}` or the like under `[{}]`", key, example, section)};
  }

  /// The section whose kind decides about a key: a part that only some kinds of the section around it have is theirs.
  std::string decides(const std::string& section) const {
    const std::string around = section.substr(0, section.rfind('.'));
    if (around == section || !schema_.sections().at(section).contains("x-kinds")) return section;
    return schema_.has_section(section, kind_of(around)) ? section : around;
  }

  bool has_key(const std::string& section, const std::string& key) const {
    return decides(section) == section && schema_.has_key(section, key, kind_of(section));
  }

  Problem of_another_kind(const std::string& section, const std::string& key) const {
    const std::string owner = decides(section);
    std::vector<std::string> keys;
    for (const std::string& name : names(schema_.keys(owner)))
      if (has_key(owner, name)) keys.push_back(name);
    const std::string kind = fmt::format("{}.kind = {}", owner, toml_string(kind_of(owner)));
    return {place_of(source_, section, key),         section + "." + key,
            value_text(source_, section, key),       "is not a key of " + kind,
            fmt::format("its keys: {}", list(keys)), "",
            "remove it, or change the kind"};
  }

  Problem stands_beside(const std::string& section, const std::string& key, const std::string& other) const {
    return {place_of(source_, section, key),
            section + "." + key,
            value_text(source_, section, key),
            fmt::format("cannot be combined with {}, which takes its place", other),
            "one of the two",
            "",
            "remove one of the two"};
  }

  Problem written_twice(const std::string& section, const std::string& key,
                        const std::pair<std::string, std::string>& other) const {
    return {place_of(source_, section, key),
            section + "." + key,
            value_text(source_, section, key),
            fmt::format("is the short form of {}.{}, which is written too", other.first, other.second),
            "one of the two",
            "",
            "remove one of the two"};
  }

  /// Checks types and ranges.
  void check_schema() {
    for (const auto& [section, keys] : document_.items())
      for (const auto& [key, value] : keys.items())
        if (const OrderedJson& key_schema = schema_.keys(section).at(key); !allows(key_schema, value))
          problems_.push_back(wrong_value(source_, section, key, key_schema, value));
  }

  /// Reports names that only another kind of the section takes.
  void check_names_of_kinds() {
    for (const std::string& section : names(schema_.sections())) {
      if (!has_keys(section) || !document_.contains(section)) continue;
      for (const auto& [key, key_schema] : schema_.keys(section).items()) {
        if (!key_schema.contains("x-of-kinds") || !document_[section].contains(key)) continue;
        const OrderedJson of_kind = Schema::of_kind(key_schema, kind_of(section));
        const OrderedJson& known = of_kind.at("enum");
        if (std::find(known.begin(), known.end(), document_[section][key].get<std::string>()) != known.end()) continue;
        problems_.push_back({place_of(source_, section, key), section + "." + key, value_text(source_, section, key),
                             fmt::format("is not a choice of {}.kind = {}", section, toml_string(kind_of(section))),
                             allowed_values(of_kind), "", "change the value, or the kind"});
      }
    }
  }

  /// Moves values from the long form of a key to its short form.
  void shorten() {
    for (const std::string& section : names(schema_.sections())) {
      if (!has_keys(section)) continue;
      for (const auto& [key, key_schema] : schema_.keys(section).items()) {
        const auto [long_section, long_key] = long_form(key_schema);
        if (long_key.empty() || !document_[long_section].contains(long_key)) continue;
        document_[section][key] = document_[long_section][long_key];
        document_[long_section].erase(long_key);
      }
    }
  }

  /// Fills in the defaults, which depend on the preset of the case.
  void add_defaults() {
    const std::string preset = schema_.preset_of(document_);
    for (const std::string& section : names(schema_.sections())) {
      if (!has_keys(section)) continue;
      for (const auto& [key, key_schema] : schema_.keys(section).items())
        if (has_key(section, key) && !document_[section].contains(key) && Schema::has_default(key_schema, preset))
          document_[section][key] =
              Json::parse(Schema::default_in(Schema::of_kind(key_schema, kind_of(section)), preset).dump());
    }
  }

  bool has_keys(const std::string& section) const { return !Schema::is_free(schema_.sections().at(section)); }

  const CaseSource& source_;
  const Schema& schema_;
  Json document_ = Json::object();
  std::vector<Problem> problems_;
};

}  // namespace

nlohmann::json validated(const CaseSource& source, const Schema& schema) { return Reader(source, schema).read(); }

}  // namespace brash::io
