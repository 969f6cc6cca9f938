// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/database/plan.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <array>
#include <cmath>
#include <set>
#include <sstream>

#include "brash/core/constants.hpp"
#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/nesting.hpp"
#include "brash/core/text.hpp"

namespace brash::database {
namespace {

constexpr std::array<const char*, 4> kSpacingNames{"linear", "logarithmic", "quadratic", "by-contact"};
constexpr std::array<const char*, 2> kTheoryNames{"reissner-mindlin", "kirchhoff"};
constexpr int kMostGeometries = 1'000'000;
constexpr int kMostRows = 10'000;

constexpr const char* kRemedy = "write it as in experiments/failure_database/plan.toml";

/// A value as a plan has it, for messages.
std::string shown(const toml::node& node) {
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

/// `key = { from = .., to = .., spacing = ".." }`, or a number for a fixed value.
Axis read_axis(Table& tables, const std::string& key, double least, double most, double unit = 1.0) {
  if (tables.get(key).is_number()) {
    const double value = tables.number(key, least, most) * unit;
    return {value, value, Spacing::kLinear};
  }
  Table table = tables.table(key, fmt::format("a number from {} to {}, or {{ from = .., to = .. }}", least, most));
  Axis axis{table.number("from", least, most) * unit, table.number("to", least, most) * unit};
  axis.spacing = static_cast<Spacing>(table.choice_or("spacing", kSpacingNames, 0));
  if (axis.to < axis.from) table.refuse(table.get("to"), "to", "is below `from`", "`from` or more");
  if (axis.spacing == Spacing::kLogarithmic && !(axis.from > 0.0)) {
    table.refuse(table.get("from"), "from", "is 0", "above 0 with logarithmic spacing");
  }
  if (axis.spacing == Spacing::kByContact && key != "b_lc") {
    table.refuse(table.get("spacing"), "spacing", "= \"by-contact\" is not allowed", "that spacing for `b_lc` only");
  }
  table.refuse_unknown_keys();
  return axis;
}

toml::table parse(const std::string& path) {
  const std::string text = read_text_file(path, "a plan of a failure database (TOML)", 1);
  if (const auto deep = find_deep_nesting(text))
    throw InputError(Complaint{fmt::format("{}:{}:{}", path, deep->line, deep->column), "is nested too deeply",
                               fmt::format("at most {} levels", kDeepestNesting), kRemedy});
  try {
    return toml::parse(text, path);
  } catch (const toml::parse_error& error) {
    const auto at = error.source().begin;
    throw InputError(Complaint{fmt::format("{}:{}:{}", path, at.line, at.column), std::string(error.description()),
                               "TOML 1.0: lines `key = value` under a line `[section]`", kRemedy});
  }
}

std::string axis_text(const char* name, const Axis& axis) {
  return fmt::format("{} = {{ from = {}, to = {}, spacing = \"{}\" }}\n", name, axis.from, axis.to,
                     kSpacingNames[static_cast<std::size_t>(axis.spacing)]);
}

}  // namespace

Plan read_plan(const std::string& path) {
  const toml::table root = parse(path);
  Table file(path, "", root);
  Plan plan;

  Table points = file.table("design");
  plan.geometries = points.whole("geometries", 1, kMostGeometries);
  plan.rows_per_geometry = points.whole("rows_per_geometry", 1, kMostRows);
  if (points.find("first") != nullptr) plan.first = points.whole("first", 0, kMostGeometries);
  plan.edge_share = points.number_or("edge_share", plan.edge_share, 0.0, 0.5);
  points.refuse_unknown_keys();

  // Limits of the plate solver, not of the cases that may be of interest.
  Table range = file.table("range");
  plan.b_lc = read_axis(range, "b_lc", 0.0, 5.0);
  plan.c_lc = read_axis(range, "c_lc", 1e-3, 10.0);
  plan.theta = read_axis(range, "theta_deg", 0.0, 170.0, radians(1.0));
  plan.thickness_over_lc = read_axis(range, "thickness_over_lc", 1e-3, 1.0);
  plan.mu1 = read_axis(range, "mu1", 1e-3, 100.0);
  plan.mu2 = read_axis(range, "mu2", -10.0, 10.0);
  range.refuse_unknown_keys();

  Table solver = file.table("plate");
  plan.poisson_ratio = solver.number("poisson_ratio", 0.0, 0.49);
  plan.theory = static_cast<plate::Theory>(solver.choice_or("theory", kTheoryNames, 0));
  plan.split = solver.flag_or("split", plan.split);
  plan.mesh.tip_size = solver.number_or("tip_size", 0.0, 0.0, 1.0);
  plan.mesh.far_size = solver.number_or("far_size", 0.0, 0.0, 10.0);
  plan.mesh.half_width = solver.number_or("half_width", 0.0, 0.0, 100.0);
  solver.refuse_unknown_keys();
  file.refuse_unknown_keys();
  return plan;
}

std::string to_text(const Plan& plan) {
  return fmt::format("[design]\ngeometries = {}\n", plan.geometries) +
         (plan.first > 0 ? fmt::format("first = {}\n", plan.first) : "") +
         fmt::format("rows_per_geometry = {}\nedge_share = {}\n[range]\n", plan.rows_per_geometry, plan.edge_share) +
         axis_text("b_lc", plan.b_lc) + axis_text("c_lc", plan.c_lc) + axis_text("theta", plan.theta) +
         axis_text("thickness_over_lc", plan.thickness_over_lc) + axis_text("mu1", plan.mu1) +
         axis_text("mu2", plan.mu2) +
         fmt::format("[plate]\npoisson_ratio = {}\ntheory = \"{}\"\ntip_size = {}\nfar_size = {}\nhalf_width = {}\n",
                     plan.poisson_ratio, kTheoryNames[static_cast<std::size_t>(plan.theory)], plan.mesh.tip_size,
                     plan.mesh.far_size, plan.mesh.half_width) +
         (plan.split ? "split = true\n" : "");
}

}  // namespace brash::database
