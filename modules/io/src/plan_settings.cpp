// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <tuple>

#include "schema.hpp"

namespace brash::io {
namespace {

constexpr std::size_t kLongestLabel = 40;
constexpr const char* kAssignment = "keys of the case file, `section.key = value`";

bool stands_before(const toml::node& a, const toml::node& b) {
  const auto at = [](const toml::node& node) {
    return std::tuple(node.source().begin.line, node.source().begin.column);
  };
  return at(a) < at(b);
}

bool belongs_in_a_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || std::string_view(".-+=").find(c) != std::string_view::npos;
}

/// The text of a value in a setting's name: "50 deg" becomes 50deg, [3, 5] becomes 3-5.
std::string label_of(const toml::node& value) {
  if (const auto* array = value.as_array()) {
    std::string label;
    for (const toml::node& item : *array) label += (label.empty() ? "" : "-") + label_of(item);
    return label;
  }
  std::string label;
  for (const char c : value.is_string() ? value.as_string()->get() : value_text(value))
    if (c != ' ') label += belongs_in_a_name(c) ? c : '-';
  return label;
}

/// Whether a case has this section, such as field.size within field.
bool is_section(const std::string& name) { return schema_of_cases().sections().contains(name); }

/// Reads one [[grid]].
class AxisReader {
 public:
  AxisReader(const std::string& file, const toml::table& table, std::vector<Problem>& problems)
      : file_(file), table_(table), problems_(problems) {}

  Axis read() {
    for (const auto& [section, node] : table_)
      if (section.str() != "labels") add_section(std::string(section.str()), node);
    std::ranges::sort(rows_, [](const Row& a, const Row& b) { return stands_before(*a.values, *b.values); });
    if (rows_.empty()) {
      report(table_, "grid", "", "varies nothing", "keys of the case file, `section.key = [values]`",
             "add `structure.speed = [0.5, 1.2]` or the like under `[[grid]]`");
      return {};
    }
    return points(labels());
  }

 private:
  struct Row {
    std::string section;
    std::string key;
    const toml::array* values;
  };

  void report(const toml::node& at, const std::string& key, std::string value, std::string what, std::string allowed,
              std::string remedy) {
    problems_.push_back(
        {place_of(file_, at), key, std::move(value), std::move(what), std::move(allowed), "", std::move(remedy)});
  }

  void add_section(const std::string& section, const toml::node& node) {
    const toml::table* const keys = node.as_table();
    if (keys == nullptr) {
      report(node, "grid." + section, value_text(node), "is not a section of the case file",
             "`section.key = [values]`, and `labels`",
             "write the section before the key: `structure.speed = [0.5, 1.2]`");
      return;
    }
    for (const auto& [key, values] : *keys) {
      const std::string name = section + "." + std::string(key.str());
      const toml::array* const array = values.as_array();
      if (is_section(name) && values.is_table()) {
        add_section(name, values);
      } else if (array == nullptr || array->empty()) {
        report(values, "grid." + name, value_text(values), "is not an array of values",
               "an array of at least one value", "write the values in brackets");
      } else {
        rows_.push_back({section, std::string(key.str()), array});
      }
    }
  }

  /// The given labels, or labels made from the values of the first key.
  std::vector<std::string> labels() {
    std::vector<std::string> made;
    for (const toml::node& value : *rows_.front().values) made.push_back(rows_.front().key + "-" + label_of(value));
    const toml::node* const given = table_.get("labels");
    if (given == nullptr) return made;
    const toml::array* const texts = given->as_array();
    std::vector<std::string> read;
    for (std::size_t i = 0; texts != nullptr && i < texts->size(); ++i) {
      const std::string text = texts->get(i)->value_or(std::string());
      if (!text.empty() && std::ranges::all_of(text, belongs_in_a_name)) read.push_back(text);
    }
    if (texts != nullptr && read.size() == texts->size() && read.size() == made.size()) return read;
    report(*given, "grid.labels", value_text(*given), "are not labels of the axis",
           fmt::format("{} texts of letters, digits, and . - + =", made.size()), "change them, or remove the line");
    return made;
  }

  Axis points(const std::vector<std::string>& labels) {
    Axis axis;
    for (const std::string& label : labels) {
      if (label.size() > kLongestLabel)
        report(table_, "grid.labels", label, "is too long for a name", fmt::format("at most {} letters", kLongestLabel),
               "add shorter labels to the axis: `labels = [\"a\", \"b\"]`");
      axis.points.push_back({label, {}});
    }
    for (const Row& row : rows_) {
      const std::string name = row.section + "." + row.key;
      axis.names.push_back(name);
      if (row.values->size() != labels.size()) {
        report(*row.values, "grid." + name, value_text(*row.values),
               fmt::format("has {} values, but {}.{} has {}", row.values->size(), rows_.front().section,
                           rows_.front().key, rows_.front().values->size()),
               "as many values for all keys of one axis",
               "add or remove values, or give the key a [[grid]] of its own");
        continue;
      }
      for (std::size_t i = 0; i < labels.size(); ++i)
        axis.points[i].assignments.push_back(
            {row.section, row.key, row.values->get(i), place_of(file_, *row.values->get(i))});
    }
    return axis;
  }

  const std::string& file_;
  const toml::table& table_;
  std::vector<Problem>& problems_;
  std::vector<Row> rows_;
};

}  // namespace

namespace {

/// The keys of a section and of the sections within it.
void add_assignments(const std::string& file, const std::string& section, const toml::table& keys,
                     std::vector<Assignment>& all) {
  for (const auto& [key, value] : keys) {
    const std::string name(key.str());
    if (const toml::table* const inner = value.as_table(); inner != nullptr && is_section(section + "." + name))
      add_assignments(file, section + "." + name, *inner, all);
    else
      all.push_back({section, name, &value, place_of(file, value)});
  }
}

}  // namespace

std::vector<Assignment> read_assignments(const std::string& file, const std::string& path, const toml::node* node,
                                         std::vector<Problem>& problems) {
  std::vector<Assignment> all;
  if (node == nullptr) return all;
  const auto report = [&](const toml::node& at, const std::string& name) {
    problems.push_back({place_of(file, at), name, value_text(at), "does not say what it sets", kAssignment, "",
                        "write it as `ice.thickness = 0.4` or the like"});
  };
  const toml::table* const sections = node->as_table();
  if (sections == nullptr) {
    report(*node, path);
    return all;
  }
  for (const auto& [section, keys] : *sections) {
    const std::string name(section.str());
    if (!keys.is_table()) {
      report(keys, path + "." + name);
      continue;
    }
    add_assignments(file, name, *keys.as_table(), all);
  }
  std::ranges::sort(all, [](const Assignment& a, const Assignment& b) { return stands_before(*a.value, *b.value); });
  return all;
}

std::vector<Axis> read_axes(const std::string& file, const toml::node* grid, std::vector<Problem>& problems) {
  std::vector<Axis> axes;
  if (grid == nullptr) return axes;
  const toml::array* const tables = grid->as_array();
  for (std::size_t i = 0; tables != nullptr && i < tables->size(); ++i) {
    if (const toml::table* const table = tables->get(i)->as_table())
      axes.push_back(AxisReader(file, *table, problems).read());
  }
  if (tables == nullptr || axes.size() != tables->size())
    problems.push_back({place_of(file, *grid), "grid", value_text(*grid), "is not a grid",
                        "tables `[[grid]]`, each an axis", "", "write each axis under a line `[[grid]]`"});
  return axes;
}

void thin_out(Axis& axis, int n) {
  const std::size_t wanted = static_cast<std::size_t>(n);
  const std::size_t last = axis.points.size() - 1;
  if (wanted > last) return;
  std::vector<AxisPoint> kept{std::move(axis.points.front())};
  for (std::size_t i = 1; i < wanted; ++i)
    kept.push_back(std::move(axis.points[(2 * i * last + wanted - 1) / (2 * (wanted - 1))]));
  axis.points = std::move(kept);
}

}  // namespace brash::io
