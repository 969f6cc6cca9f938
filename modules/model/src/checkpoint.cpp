// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/model/checkpoint.hpp"

#include <algorithm>

#include "brash/core/contract.hpp"

namespace brash::model {
namespace {

using geometry::ExactArea;
using geometry::Int128;

std::string to_text(ExactArea area) {
  Int128 value = area.twice_in_grid_units();
  const bool negative = value < 0;
  std::string digits;
  do {
    const int digit = static_cast<int>(value % 10);
    digits += static_cast<char>('0' + (negative ? -digit : digit));
    value /= 10;
  } while (value != 0);
  if (negative) digits += '-';
  std::ranges::reverse(digits);
  return digits;
}

ExactArea area_from(const std::string& text) {
  const bool negative = text.starts_with('-');
  const std::string digits = text.substr(negative ? 1 : 0);
  BRASH_EXPECTS(!digits.empty(), text);
  Int128 value = 0;
  for (const char digit : digits) {
    BRASH_EXPECTS(digit >= '0' && digit <= '9', text);
    const Int128 next = negative ? '0' - digit : digit - '0';
    const bool fits =
        !__builtin_mul_overflow(value, Int128{10}, &value) && !__builtin_add_overflow(value, next, &value);
    BRASH_EXPECTS(fits, text);
  }
  return ExactArea(value);
}

template <typename Items>
auto& named(Items& items, std::string_view name) {
  const auto found = std::ranges::find(items, name, [](const auto& item) -> std::string_view { return item.name; });
  BRASH_EXPECTS(found != items.end(), std::string("there is no ") + std::string(name));
  return *found;
}

}  // namespace

std::size_t Table::n_rows() const {
  return columns.empty() ? 0 : std::visit([](const auto& values) { return values.size(); }, columns.front().values);
}

const Column& Table::column(std::string_view wanted) const { return named(columns, wanted); }
Column& Table::column(std::string_view wanted) { return named(columns, wanted); }

const Table& Checkpoint::table(std::string_view wanted) const { return named(tables, wanted); }
Table& Checkpoint::table(std::string_view wanted) { return named(tables, wanted); }

SavedRow::SavedRow(Table& table) : table_(&table), first_(table.columns.empty()) {}

template <typename Value>
void SavedRow::append(ColumnName name, std::string_view unit, std::string_view meaning, const Value& value) {
  if (first_) {
    std::string described(meaning);
    if (!name.component.empty()) described += ", " + std::string(name.component);
    table_->columns.push_back({name.joined(), std::string(unit), std::move(described), std::vector<Value>{}});
  }
  BRASH_EXPECTS(next_ < table_->columns.size() && name == table_->columns[next_].name, name.joined());
  std::get<std::vector<Value>>(table_->columns[next_++].values).push_back(value);
}

void SavedRow::cell(ColumnName name, std::string_view unit, std::string_view meaning, double value) {
  append(name, unit, meaning, value);
}
void SavedRow::cell(ColumnName name, std::string_view unit, std::string_view meaning, std::int64_t value) {
  append(name, unit, meaning, value);
}
void SavedRow::cell(ColumnName name, std::string_view unit, std::string_view meaning, const geometry::Polygon& value) {
  append(name, unit, meaning, value);
}
void SavedRow::cell(ColumnName name, std::string_view unit, std::string_view meaning, ExactArea value) {
  append(name, unit, meaning, to_text(value));
}

template <typename Value>
const Value& RestoredRow::get(ColumnName name) {
  const bool in_order = next_ < table_->columns.size() && name == table_->columns[next_].name;
  const Column& column = in_order ? table_->columns[next_] : table_->column(name.joined());
  ++next_;
  const auto* const values = std::get_if<std::vector<Value>>(&column.values);
  BRASH_EXPECTS(values != nullptr && row_ < values->size(), table_->name, column.name, row_);
  return (*values)[row_];
}

template const double& RestoredRow::get(ColumnName name);
template const std::int64_t& RestoredRow::get(ColumnName name);
template const geometry::Polygon& RestoredRow::get(ColumnName name);

void RestoredRow::cell(ColumnName name, std::string_view, std::string_view, ExactArea& value) {
  value = area_from(get<std::string>(name));
}

}  // namespace brash::model
