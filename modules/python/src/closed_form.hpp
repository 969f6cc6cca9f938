// SPDX-License-Identifier: GPL-3.0-or-later
// Calls of closed forms from Python: keyword arguments that are numbers or arrays, and named tuples of results.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "brash/standards/applicability.hpp"
#include "brash/standards/inputs.hpp"
#include "convert.hpp"
#include "rooms.hpp"
#include "signals.hpp"

namespace brash::python {

/// Adds a named tuple type to the module.
py::object add_named_tuple(py::module_& m, const char* name, const std::vector<std::string>& fields, const char* doc);

/// What to write instead of a number that is out of range, by its unit in UDUNITS.
std::string remedy_for(const std::string& unit);
/// "m", "kg/m3", "-".
std::string shown_unit(const std::string& unit);
/// "above 0 and at most 0.5".
std::string range_text(const standards::Range& range);
/// "[2, 1]" of the element `i` of an array; "" for a number.
std::string index_text(const std::vector<py::ssize_t>& shape, std::size_t i);
/// The common shape. @throws InputError with all shapes when there is none.
std::vector<py::ssize_t> common_shape(const std::vector<std::string>& names, const std::vector<Array>& arrays);
/// The array broadcast to that shape.
Array broadcast_to(const Array& array, const std::vector<py::ssize_t>& shape);

/// The keyword arguments of one call, checked: floats or arrays that broadcast against each other.
template <typename Input, std::size_t n>
class Arguments {
 public:
  using Numbers = std::array<standards::InputNumber<Input>, n>;

  /// @throws TypeError for an argument that is missing or unknown: a number that changes the load has no default.
  /// @throws InputError for a value out of range.
  Arguments(const char* form, const py::kwargs& given, const Numbers& numbers) : numbers_(numbers) {
    expect_names(form, given);
    std::vector<std::string> names;
    std::vector<Array> arrays;
    for (std::size_t i = 0; i < n; ++i) {
      if (!given.contains(numbers_[i].name)) continue;
      const py::object value = given[numbers_[i].name];
      const Array array = python::numbers(value, numbers_[i].name);
      expect_range(form, numbers_[i], array);
      used_.push_back(i);
      names.emplace_back(numbers_[i].name);
      arrays.push_back(array);
    }
    shape_ = common_shape(names, arrays);
    for (const py::ssize_t length : shape_) size_ *= static_cast<std::size_t>(length);
    for (const Array& array : arrays) {
      columns_.push_back(array.ndim() == 0 ? array : broadcast_to(array, shape_));
      data_.push_back(columns_.back().data());
      steps_.push_back(array.ndim() == 0 ? 0 : 1);
    }
  }

  bool is_scalar() const { return shape_.empty(); }
  std::size_t size() const { return size_; }
  const std::vector<py::ssize_t>& shape() const { return shape_; }

  Input at(std::size_t row) const {
    Input input;
    for (std::size_t i = 0; i < used_.size(); ++i) input.*numbers_[used_[i]].member = data_[i][row * steps_[i]];
    return input;
  }

 private:
  using Number = standards::InputNumber<Input>;

  /// Whether a call must give a number: rubble without a height has no properties.
  static bool is_required(const Number& number, const py::kwargs& given) {
    if (number.given != standards::Given::kWithRubble || !given.contains("rubble_height"))
      return number.given == standards::Given::kAlways;
    const py::object value = given["rubble_height"];
    const Array height = python::numbers(value, "rubble_height");
    return std::ranges::any_of(span_of(height), [](double h) { return h != 0.0; });
  }

  void expect_names(const char* form, const py::kwargs& given) const {
    std::vector<std::string> names, missing;
    std::size_t n_known = 0;
    for (const Number& number : numbers_) {
      names.emplace_back(number.name);
      if (given.contains(number.name))
        ++n_known;
      else if (is_required(number, given))
        missing.push_back(fmt::format("{} [{}]", number.name, shown_unit(number.unit)));
    }
    if (!missing.empty())
      throw py::type_error(
          fmt::format("{}() misses {}: the load depends on it, so it has no default", form, fmt::join(missing, ", ")));
    if (n_known < given.size())
      throw py::type_error(
          fmt::format("{}() has an argument that is not known; there are: {}", form, fmt::join(names, ", ")));
  }

  static void expect_range(const char* form, const Number& number, const Array& array) {
    const auto values = span_of(array);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (number.range.contains(values[i])) continue;
      const std::vector<py::ssize_t> shape(array.shape(), array.shape() + array.ndim());
      throw InputError(fmt::format("{}: {}{} = {} {} is out of range: it must be {}. {}", form, number.name,
                                   index_text(shape, i), values[i], shown_unit(number.unit), range_text(number.range),
                                   remedy_for(number.unit)));
    }
  }

  const Numbers& numbers_;
  std::vector<std::size_t> used_;  ///< the numbers that were given
  std::vector<Array> columns_;
  std::vector<const double*> data_;
  std::vector<std::size_t> steps_;  ///< between two rows: 0 for a number that all rows share
  std::vector<py::ssize_t> shape_;
  std::size_t size_ = 1;
};

/// A result as Python has it: a named tuple, or the number alone where there is one only.
template <typename Load, typename... Value>
struct Record {
  py::object type;  ///< None: no tuple
  std::tuple<Value Load::*...> members;

  /// Of one load, or of arrays.
  template <typename... Field>
  py::object of(const Field&... fields) const {
    const py::tuple all = py::make_tuple(fields...);
    return type.is_none() ? py::object(all[0]) : type(*all);
  }
  py::object of_load(const Load& load) const {
    return std::apply([&](auto... member) { return of(load.*member...); }, members);
  }
};

/// Adds the named tuple of a result to the module; its fields are given as pairs of name and pointer to member.
template <typename Load, typename... Value>
Record<Load, Value...> add_record(py::module_& m, const char* name, const char* doc,
                                  const std::pair<const char*, Value Load::*>&... fields) {
  return {add_named_tuple(m, name, {fields.first...}, doc), {fields.second...}};
}

template <typename Load>
Load applicable(tl::expected<Load, standards::NotApplicable> load) {
  if (!load) throw python::NotApplicable(load.error().reason);
  return *std::move(load);
}

/// The same for a formula of ships, of a case that may have no hull.
template <typename Load>
Load of_ship(std::optional<tl::expected<Load, standards::NotApplicable>> load) {
  if (!load) throw python::NotApplicable("the case has no section [hull]");
  return applicable(*std::move(load));
}

/// A field of a load, or nan where there is no load.
template <typename Load, typename Value>
Value value_or_nan(const Load* load, Value Load::*member) {
  return load != nullptr ? load->*member : std::numeric_limits<Value>::quiet_NaN();
}

/// Warns of the elements of a result that are nan because the formula does not apply to them.
void warn_of_gaps(const char* form, std::size_t n_gaps, std::size_t n_all, const std::string& first,
                  const std::string& why);

/// The results of all rows as arrays: nan where the formula does not apply, with one warning.
template <typename Input, std::size_t n, typename Load, typename... Value, typename Compute>
py::object arrays_of(const char* form, const Arguments<Input, n>& arguments, const Record<Load, Value...>& record,
                     const Compute& compute) {
  std::tuple<py::array_t<Value>...> columns{py::array_t<Value>(arguments.shape())...};
  const auto data = std::apply([](auto&... column) { return std::tuple(column.mutable_data()...); }, columns);
  std::size_t n_gaps = 0, first_gap = 0;
  std::string why;
  const auto store = [&]<std::size_t... k>(std::index_sequence<k...>, std::size_t i, const Load* load) {
    ((std::get<k>(data)[i] = value_or_nan(load, std::get<k>(record.members))), ...);
  };
  without_gil(arguments.size(), [&](std::size_t i) {
    const tl::expected<Load, standards::NotApplicable> load = compute(arguments.at(i));
    if (!load && n_gaps++ == 0) {
      first_gap = i;
      why = load.error().reason;
    }
    store(std::index_sequence_for<Value...>(), i, load ? &*load : nullptr);
  });
  if (n_gaps > 0) warn_of_gaps(form, n_gaps, arguments.size(), index_text(arguments.shape(), first_gap), why);
  return std::apply([&](auto&... column) { return record.of(column...); }, columns);
}

/// One call of a closed form: a result of floats for floats, and of arrays if an argument is one.
template <typename Input, std::size_t n, typename Load, typename... Value, typename Compute>
py::object call_form(const char* form, const py::kwargs& given,
                     const std::array<standards::InputNumber<Input>, n>& numbers, const Record<Load, Value...>& record,
                     const Compute& compute) {
  const Arguments<Input, n> arguments(form, given, numbers);
  return with_arguments_of(form, [&]() -> py::object {
    if (!arguments.is_scalar()) return arrays_of(form, arguments, record, compute);
    return record.of_load(applicable<Load>(compute(arguments.at(0))));
  });
}

}  // namespace brash::python
