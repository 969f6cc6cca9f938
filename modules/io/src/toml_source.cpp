// SPDX-License-Identifier: GPL-3.0-or-later
#include "toml_source.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "brash/core/nesting.hpp"
#include "brash/core/text.hpp"
#include "schema.hpp"

namespace brash::io {
namespace {

constexpr const char* kTomlAllowed =
    "TOML 1.0: lines `key = value` under a line `[section]`, each key and section once";

}  // namespace

std::string read_text(const std::string& path, const std::string& kind) {
  constexpr std::streamsize kLargest = 1 << 20;
  const auto refuse_file = [&](std::string what, std::string remedy) {
    refuse({{{path, 1, 1, ""},
             kind,
             "",
             std::move(what),
             "a readable TOML file of at most 1 MiB",
             "",
             std::move(remedy)}});
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) refuse_file("is a folder", fmt::format("name the {} in it", kind));
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    const std::error_code reason(errno, std::generic_category());
    refuse_file("cannot be opened: " + reason.message(), "check the path and its permissions");
  }
  std::string text(static_cast<std::size_t>(kLargest) + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) refuse_file("cannot be read", "check the file");
  if (stream.gcount() > kLargest) refuse_file("is larger than 1 MiB", fmt::format("check that it is a {}", kind));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

namespace {

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

/// Line `number` (from 1) of `text`, and the header of the section that it is in.
struct Line {
  std::string text;
  std::string section;
};
Line line_at(const std::string& text, std::uint32_t number) {
  std::istringstream stream(text);
  Line line;
  for (std::uint32_t i = 1; i <= number && std::getline(stream, line.text); ++i) {
    line.text = trimmed(line.text);
    if (i < number && line.text.starts_with('['))
      line.section = trimmed(line.text.substr(1, std::min(line.text.find(']'), line.text.size()) - 1));
  }
  return line;
}

/// A syntax error of toml++ with the key and the text of its line.
Problem syntax_problem(const std::string& file, const std::string& text, const toml::parse_error& error) {
  const toml::source_position at = error.source().begin;
  const Line line = line_at(text, at.line);
  Problem problem;
  problem.place = {file, static_cast<int>(at.line), static_cast<int>(at.column), ""};
  const std::size_t equals = line.text.find('=');
  if (equals != std::string::npos) {
    const std::string key = trimmed(line.text.substr(0, equals));
    problem.key = line.section.empty() ? key : line.section + "." + key;
    problem.value = trimmed(line.text.substr(equals + 1));
  } else {
    problem.key = line.text.empty() ? "end of the file" : "line `" + printable(line.text) + "`";
  }
  problem.what = std::string(error.description());
  problem.allowed = kTomlAllowed;
  const bool twice =
      problem.what.find("redefin") != std::string::npos || problem.what.find("duplicate") != std::string::npos;
  problem.remedy =
      twice ? "remove one of the two" : "correct the line; text needs quotes, so does a number with a unit";
  if (at.line == 1 && text.starts_with('{'))
    problem.remedy = "name a TOML file; `brash rerun MANIFEST.json` repeats a run from its manifest";
  return problem;
}

toml::table parse(const std::string& file, const std::string& text) {
  if (const auto deep = find_deep_nesting(text)) {
    Problem problem{{file, deep->line, deep->column, ""},
                    "line",
                    "",
                    "brackets or dotted keys are nested too deeply",
                    fmt::format("at most {} levels", kDeepestNesting),
                    "",
                    "write sections and plain keys"};
    refuse({problem});
  }
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    refuse({syntax_problem(file, text, error)});
  }
}

bool is_subsection(const std::string& name) {
  return name.find('.') != std::string::npos && schema_of_cases().sections().contains(name);
}

/// The value of an override: TOML, else the text itself.
toml::table parse_override_value(const std::string& text) {
  if (text.find('\n') == std::string::npos && !find_deep_nesting(text)) {
    try {
      toml::table parsed = toml::parse("value = " + text);
      if (parsed.size() == 1) return parsed;
    } catch (const toml::parse_error&) {
      // Not TOML: a word or a quantity without its quotes.
    }
  }
  toml::table plain;
  plain.insert("value", text);
  return plain;
}

Place place_in(const std::string& file, const toml::source_region& region) {
  const bool known = region.begin.line > 0;
  return {file, known ? static_cast<int>(region.begin.line) : 1, known ? static_cast<int>(region.begin.column) : 1, ""};
}

Place place_in(const CaseSource& source, const std::string& name, const toml::source_region& region) {
  const auto found = source.overridden.find(name);
  return found != source.overridden.end() ? found->second : place_in(source.file, region);
}

}  // namespace

void lift_subsections(toml::table& tree) {
  std::vector<std::pair<std::string, std::string>> found;
  for (const auto& [section, node] : tree)
    if (const toml::table* const keys = node.as_table())
      for (const auto& [key, value] : *keys) found.emplace_back(section.str(), key.str());
  for (const auto& [section, key] : found) {
    const std::string whole = section + "." + key;
    if (!is_subsection(whole)) continue;
    toml::table& keys = *tree[section].as_table();
    keys.get(key)->visit([&](auto& typed) { tree.insert_or_assign(whole, std::move(typed)); });
    keys.erase(key);
  }
}

CaseSource parse_source(const std::string& text, const std::string& path, const std::vector<std::string>& overrides) {
  CaseSource source{path, parse(path, text), {}};
  lift_subsections(source.tree);
  for (const std::string& change : overrides) apply_override(source, change);
  return source;
}

void apply_override(CaseSource& source, const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::string name = trimmed(text.substr(0, equals));
  const std::size_t dot = name.rfind('.');
  const Place place{source.file, 0, 0, text};
  const bool has_name = dot != std::string::npos && dot > 0 && dot + 1 < name.size();
  const std::string section = has_name ? name.substr(0, dot) : "";
  const bool is_section = section.find('.') == std::string::npos || is_subsection(section);
  if (equals == std::string::npos || !has_name || !is_section)
    refuse({{place, name, "", "is not an override", "section.key=value", "",
             "write it as --set ice.thickness=0.4 or --set 'ice.thickness=40 cm'"}});
  const toml::table value = parse_override_value(trimmed(text.substr(equals + 1)));
  replace_value(source, section, name.substr(dot + 1), *value.get("value"), place);
}

void replace_value(CaseSource& source, const std::string& section, const std::string& key, const toml::node& value,
                   const Place& place) {
  if (!source.tree.contains(section)) {
    source.tree.insert(section, toml::table{});
    source.overridden[section] = place;
  }
  toml::table* const table = source.tree[section].as_table();
  if (table == nullptr) return;  // validation says that it should be a section
  value.visit([&](const auto& typed) { table->insert_or_assign(key, typed); });
  source.overridden[section + "." + key] = place;
}

Place place_of(const std::string& file, const toml::node& node) { return place_in(file, node.source()); }

Place place_of(const CaseSource& source, const std::string& section) {
  const toml::node* const node = source.tree.get(section);
  return place_in(source, section, node == nullptr ? toml::source_region{} : node->source());
}

Place place_of(const CaseSource& source, const std::string& section, const std::string& key) {
  const toml::node* const node = source.tree[section][key].node();
  if (node == nullptr) return place_of(source, section);
  return place_in(source, section + "." + key, node->source());
}

std::string value_text(const toml::node& node) {
  if (const auto* number = node.as_floating_point()) return toml_number(number->get());
  if (const auto* text = node.as_string()) return toml_string(text->get());
  if (const auto* array = node.as_array()) {
    std::string items;
    for (const toml::node& item : *array) items += (items.empty() ? "" : ", ") + value_text(item);
    return "[" + items + "]";
  }
  std::ostringstream text;
  node.visit([&](const auto& value) { text << value; });
  return text.str();
}

std::string value_text(const CaseSource& source, const std::string& section, const std::string& key) {
  const toml::node* const node = source.tree[section][key].node();
  return node == nullptr ? "" : value_text(*node);
}

}  // namespace brash::io
