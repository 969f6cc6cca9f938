// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "brash/core/vec.hpp"
#include "brash/geometry/polygon.hpp"
#include "brash/model/case.hpp"
#include "brash/model/records.hpp"

namespace brash::model {

/// One value a row. Polygons are exact, in grid units.
using ColumnValues = std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::string>,
                                  std::vector<geometry::Polygon>>;

struct Column {
  std::string name;
  std::string unit;  ///< UDUNITS; "1" where there is none
  std::string meaning;
  ColumnValues values;

  friend bool operator==(const Column&, const Column&) = default;
};

/// Things of one kind, a row each. All columns have the same length.
struct Table {
  std::string name;
  std::vector<Column> columns;

  std::size_t n_rows() const;
  /// @throws ContractViolation when there is no such column.
  const Column& column(std::string_view wanted) const;
  Column& column(std::string_view wanted);

  friend bool operator==(const Table&, const Table&) = default;
};

/// Everything that a run needs to continue as if it had not been interrupted. Nothing in it is rounded.
///
/// Each owner of state saves its members in tables of its own and restores itself from them. Files know tables only.
struct Checkpoint {
  Case resolved;  ///< a run resumes its own case only
  std::vector<Table> tables;
  RunResults results;  ///< so far

  /// @throws ContractViolation when there is no such table.
  const Table& table(std::string_view wanted) const;
  Table& table(std::string_view wanted);

  friend bool operator==(const Checkpoint&, const Checkpoint&) = default;
};

/// A column's name in two parts, joined only where a column is made.
struct ColumnName {
  std::string_view stem;
  std::string_view component;

  std::string joined() const { return std::string(stem) + std::string(component); }
  bool operator==(std::string_view name) const {
    return name.size() == stem.size() + component.size() && name.starts_with(stem) && name.ends_with(component);
  }
};

/// Calls `cell(name, unit, meaning, value)` for each number of a member: a `visit` names its members once, and the same
/// list serves saving and restoring. Vectors become a column for each component.
template <typename Cells>
class RowVisitor {
 public:
  template <typename Value>
  void operator()(std::string_view name, std::string_view unit, std::string_view meaning, Value& value) {
    static_cast<Cells&>(*this).cell({name, ""}, unit, meaning, value);
  }
  template <typename Vector>
  requires std::is_same_v<std::remove_const_t<Vector>, Vec2>
  void operator()(std::string_view name, std::string_view unit, std::string_view meaning, Vector& vector) {
    auto& cells = static_cast<Cells&>(*this);
    cells.cell({name, "x"}, unit, meaning, vector.x);
    cells.cell({name, "y"}, unit, meaning, vector.y);
  }
  template <typename Vector>
  requires std::is_same_v<std::remove_const_t<Vector>, Vec3>
  void operator()(std::string_view name, std::string_view unit, std::string_view meaning, Vector& vector) {
    auto& cells = static_cast<Cells&>(*this);
    cells.cell({name, "x"}, unit, meaning, vector.x);
    cells.cell({name, "y"}, unit, meaning, vector.y);
    cells.cell({name, "z"}, unit, meaning, vector.z);
  }
};

/// Adds a row to a table: visit the same members in the same order for each row.
class SavedRow : public RowVisitor<SavedRow> {
 public:
  explicit SavedRow(Table& table);

  void cell(ColumnName name, std::string_view unit, std::string_view meaning, double value);
  void cell(ColumnName name, std::string_view unit, std::string_view meaning, std::int64_t value);
  void cell(ColumnName name, std::string_view unit, std::string_view meaning, const geometry::Polygon& value);
  /// Written as a whole number: twice the area in squared grid units.
  void cell(ColumnName name, std::string_view unit, std::string_view meaning, geometry::ExactArea value);
  void cell(ColumnName name, std::string_view unit, std::string_view meaning, std::uint64_t value) {
    cell(name, unit, meaning, static_cast<std::int64_t>(value));
  }
  void cell(ColumnName name, std::string_view unit, std::string_view meaning, int value) {
    cell(name, unit, meaning, std::int64_t{value});
  }
  void cell(ColumnName name, std::string_view unit, std::string_view meaning, bool value) {
    cell(name, unit, meaning, std::int64_t{value});
  }

 private:
  template <typename Value>
  void append(ColumnName name, std::string_view unit, std::string_view meaning, const Value& value);

  Table* table_;
  bool first_;
  std::size_t next_ = 0;  ///< column
};

/// Reads a row of a table back.
/// @throws ContractViolation when a column is missing or holds values of another kind.
class RestoredRow : public RowVisitor<RestoredRow> {
 public:
  RestoredRow(const Table& table, std::size_t row) : table_(&table), row_(row) {}

  void cell(ColumnName name, std::string_view, std::string_view, double& value) { value = get<double>(name); }
  void cell(ColumnName name, std::string_view, std::string_view, std::int64_t& value) {
    value = get<std::int64_t>(name);
  }
  void cell(ColumnName name, std::string_view, std::string_view, geometry::Polygon& value) {
    value = get<geometry::Polygon>(name);
  }
  void cell(ColumnName name, std::string_view, std::string_view, geometry::ExactArea& value);
  void cell(ColumnName name, std::string_view, std::string_view, std::uint64_t& value) {
    value = static_cast<std::uint64_t>(get<std::int64_t>(name));
  }
  void cell(ColumnName name, std::string_view, std::string_view, int& value) {
    value = static_cast<int>(get<std::int64_t>(name));
  }
  void cell(ColumnName name, std::string_view, std::string_view, bool& value) { value = get<std::int64_t>(name) != 0; }

 private:
  template <typename Value>
  const Value& get(ColumnName name);

  const Table* table_;
  std::size_t row_;
  std::size_t next_ = 0;  ///< column, where it is looked for first
};

/// The members of a pose and of a twist, for the `visit` of an owner that has one.
template <typename AnyPose, typename Visit>
void visit_pose(AnyPose& pose, Visit&& visit) {
  visit("", "m", "position", pose.position);
  visit("qw", "1", "rotation from body to world frame, quaternion w", pose.rotation.w);
  visit("qx", "1", "quaternion x", pose.rotation.x);
  visit("qy", "1", "quaternion y", pose.rotation.y);
  visit("qz", "1", "quaternion z", pose.rotation.z);
}
template <typename AnyTwist, typename Visit>
void visit_twist(AnyTwist& twist, Visit&& visit) {
  visit("linear_", "m s-1", "velocity", twist.linear);
  visit("angular_", "rad s-1", "angular velocity", twist.angular);
}

/// Adds the table `name` with one row, the members of `owner`.
template <typename Owner>
void save(Checkpoint& checkpoint, const char* name, const Owner& owner) {
  Table& table = checkpoint.tables.emplace_back(Table{name, {}});
  SavedRow row(table);
  Owner::visit(owner, row);
}

/// Reads the one row of the table `name` back.
template <typename Owner>
void restore(const Checkpoint& checkpoint, const char* name, Owner& owner) {
  RestoredRow row(checkpoint.table(name), 0);
  Owner::visit(owner, row);
}

}  // namespace brash::model
