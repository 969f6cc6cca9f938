// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "brash/core/error.hpp"
#include "brash/core/text.hpp"

namespace brash::meta_model {

using Json = nlohmann::json;  // keys are sorted, so the text of equal content is equal

/// A value of the file together with where it stands, so that every message can say so.
class Place {
 public:
  Place(const std::string& file, const Json& value, std::string pointer)
      : file_(file), value_(value), pointer_(std::move(pointer)) {}

  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(Complaint{fmt::format("{}: {}", file_, pointer_.empty() ? "/" : pointer_), what,
                               "a whole model file that this version of `brash failure train` wrote",
                               "write the model again with `brash failure train`, or copy it again"});
  }
  Place operator[](const char* key) const {
    if (!value_.is_object() || !value_.contains(key)) refuse(fmt::format("the key `{}` is missing", key));
    return {file_, value_.at(key), pointer_ + "/" + key};
  }
  Place operator[](std::size_t index) const { return {file_, value_.at(index), fmt::format("{}/{}", pointer_, index)}; }
  double number() const {
    constexpr double kMost = 1e9;  // the largest number of the models that come with the program is 6e3
    if (!value_.is_number() || !(std::abs(value_.get<double>()) <= kMost))
      refuse(fmt::format("is {}, must be a finite number within +-{:g}", shown(), kMost));
    return value_.get<double>();
  }
  double positive() const {
    constexpr double kLeast = 1e-9;
    if (!(number() > 0.0)) refuse("is " + shown() + ", must be > 0");
    if (number() < kLeast) refuse(fmt::format("is {}, must be at least {:g}", shown(), kLeast));
    return number();
  }
  /// A whole number in [1, 1e6]; more is beyond any use.
  std::size_t count() const {
    constexpr double kMost = 1e6;
    if (positive() != std::floor(number()) || number() > kMost) {
      refuse(fmt::format("is {}, must be a whole number from 1 to {}", shown(), kMost));
    }
    return static_cast<std::size_t>(number());
  }
  /// Of a list.
  std::size_t size() const {
    if (!value_.is_array()) refuse("must be a list");
    return value_.size();
  }
  std::string text() const {
    if (!value_.is_string()) refuse("is " + shown() + ", must be a text");
    return value_.get<std::string>();
  }
  void expect_size(std::size_t size) const {
    if (!value_.is_array() || value_.size() != size) refuse(fmt::format("is {}, must be a list of {}", shown(), size));
  }
  void expect_text(const std::string& wanted) const {
    if (text() != wanted) refuse(fmt::format("is `{}`, must be `{}`", text(), wanted));
  }
  std::vector<double> numbers(std::size_t size) const {
    expect_size(size);
    std::vector<double> values;
    for (std::size_t i = 0; i < size; ++i) values.push_back((*this)[i].number());
    return values;
  }
  std::vector<double> matrix(std::size_t n_rows, std::size_t n_columns) const {
    expect_size(n_rows);
    std::vector<double> values;
    for (std::size_t i = 0; i < n_rows; ++i) {
      const auto row = (*this)[i].numbers(n_columns);
      values.insert(values.end(), row.begin(), row.end());
    }
    return values;
  }

 private:
  /// The value, for messages.
  std::string shown() const {
    return value_.is_array() ? fmt::format("a list of {}", value_.size()) : printable(value_.dump());
  }

  const std::string& file_;
  const Json& value_;
  std::string pointer_;
};

/// Reads a model file and checks its format, version and content hash.
/// @throws InputError naming file, place and error.
Json read_model(const std::string& path, const std::string& format, int version);

/// Adds format, version and content hash to `model`, writes it by rename when whole, and returns the hash.
/// @throws RunError when it cannot be written.
std::string write_model(const std::string& path, const std::string& format, int version, Json model, int indentation);

}  // namespace brash::meta_model
