// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <toml++/toml.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "brash/core/error.hpp"
#include "brash/core/text.hpp"

namespace brash::training {

inline constexpr const char* kRemedy = "write it as in experiments/failure_database/plan.toml";

/// A value as a plan has it, for messages.
inline std::string shown(const toml::node& node) {
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  std::ostringstream text;
  node.visit([&](const auto& value) { text << value; });
  return printable(text.str());
}

/// A table of the plan that knows its file and name; keys that nobody asked for are refused at the end.
class Table {
 public:
  Table(const std::string& file, std::string name, const toml::table& table)
      : file_(file), name_(std::move(name)), table_(table) {}

  [[noreturn]] void refuse(const toml::node& node, const std::string& key, const std::string& what,
                           const std::string& allowed) const {
    const auto at = node.source().begin;
    throw InputError(Complaint{fmt::format("{}:{}:{}", file_, at.line, at.column),
                               fmt::format("`{}` {}", full(key), what), allowed, kRemedy});
  }
  const toml::node* find(const std::string& key) {
    known_.insert(key);
    return table_.get(key);
  }
  const toml::node& get(const std::string& key) {
    const toml::node* node = find(key);
    if (node == nullptr) {
      throw InputError(
          Complaint{file_, fmt::format("`{}` is missing", full(key)), "a plan of a failure database", kRemedy});
    }
    return *node;
  }
  double number(const std::string& key, double least, double most) {
    const toml::node& node = get(key);
    const auto value = node.value<double>();
    if (!value || !std::isfinite(*value) || *value < least || *value > most) {
      refuse(node, key, "= " + shown(node) + " is not allowed", fmt::format("a number from {} to {}", least, most));
    }
    return *value;
  }
  double number_or(const std::string& key, double otherwise, double least, double most) {
    return find(key) == nullptr ? otherwise : number(key, least, most);
  }
  /// A list that rises.
  std::vector<double> numbers(const std::string& key, double least, double most) {
    const toml::node& node = get(key);
    const std::string allowed = fmt::format("a list of rising numbers from {} to {}", least, most);
    const toml::array* list = node.as_array();
    if (list == nullptr || list->empty()) refuse(node, key, "is not a list", allowed);
    std::vector<double> values;
    for (const toml::node& entry : *list) {
      const auto value = entry.value<double>();
      const bool rises = value && (values.empty() || *value > values.back());
      if (!rises || !(*value >= least && *value <= most)) refuse(entry, key, "has " + shown(entry), allowed);
      values.push_back(*value);
    }
    return values;
  }
  int whole(const std::string& key, int least, int most) {
    const toml::node& node = get(key);
    const auto value = node.value_exact<std::int64_t>();
    if (!value || *value < least || *value > most) {
      refuse(node, key, "= " + shown(node) + " is not allowed",
             fmt::format("a whole number from {} to {}", least, most));
    }
    return static_cast<int>(*value);
  }
  bool flag_or(const std::string& key, bool otherwise) {
    const toml::node* node = find(key);
    if (node == nullptr) return otherwise;
    if (!node->is_boolean()) refuse(*node, key, "is neither true nor false", "true or false");
    return *node->value<bool>();
  }
  template <std::size_t N>
  std::size_t choice_or(const std::string& key, const std::array<const char*, N>& names, std::size_t otherwise) {
    const toml::node* node = find(key);
    if (node == nullptr) return otherwise;
    const std::string value = node->value_or(std::string());
    for (std::size_t i = 0; i < N; ++i) {
      if (value == names[i]) return i;
    }
    refuse(*node, key, "= " + shown(*node) + " is not allowed", fmt::format("\"{}\"", fmt::join(names, "\", \"")));
  }
  Table table(const std::string& key, const std::string& allowed = "a table") {
    const toml::node& node = get(key);
    if (!node.is_table()) refuse(node, key, "= " + shown(node) + " is not allowed", allowed);
    return {file_, full(key), *node.as_table()};
  }
  void refuse_unknown_keys() const {
    for (const auto& [key, node] : table_) {
      if (known_.contains(std::string(key.str()))) continue;
      refuse(node, std::string(key.str()), "is not known", fmt::format("{}", fmt::join(known_, ", ")));
    }
  }

 private:
  std::string full(const std::string& key) const { return name_.empty() ? key : name_ + "." + key; }

  const std::string& file_;
  std::string name_;
  const toml::table& table_;
  std::set<std::string> known_;
};

/// @throws InputError with file, line and remedy.
toml::table parse_plan(const std::string& path);

}  // namespace brash::training
