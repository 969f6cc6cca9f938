// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace brash::report {

/// `value` as whole multiples of `unit`.
std::int32_t rounded_to(double unit, double value);

/// The arrays of a report, packed small: numbers of one kind byte plane after byte plane, whole numbers as differences
/// to the one before (zigzag: 0, -1, 1, -2, ... become 0, 1, 2, 3, ...), everything deflated together.
class Blocks {
 public:
  /// Names that are added from here on begin with `prefix`.
  void begin(const std::string& prefix) { prefix_ = prefix; }
  void add(const std::string& name, const std::vector<double>& values);
  /// Rounded to whole multiples of `unit`; the page multiplies them again.
  void add_rounded(const std::string& name, const std::vector<double>& values, double unit);
  /// Single precision, for values that are drawn and not computed with.
  void add_single(const std::string& name, const std::vector<double>& values);
  void add(const std::string& name, const std::vector<std::int32_t>& values, double unit = 1.0);

  /// The directory that the page needs to unpack: name, kind, count and unit of each, in order.
  const nlohmann::ordered_json& directory() const { return directory_; }
  /// All arrays, deflated (zlib), in base64.
  std::string packed() const;

 private:
  template <typename T>
  void append(const std::string& name, const char* kind, const std::vector<T>& values, double unit);

  std::string prefix_;
  nlohmann::ordered_json directory_ = nlohmann::ordered_json::array();
  std::string bytes_;
};

}  // namespace brash::report
