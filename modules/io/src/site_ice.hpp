// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace brash::io {

/// The ice of a template: the model ice of the validation case, or typical ice of a site. The data and their
/// sources are in modules/io/site_ice.json.
class SiteIce {
 public:
  /// @param name  "basin" for the model ice, else a site such as "baltic".
  /// @throws InputError naming the sites that there are.
  explicit SiteIce(std::string name);

  /// A value of a key, and its source.
  struct Value {
    std::string toml;
    std::string source;  ///< sentences
  };
  /// The value of `key`, such as "ice.thickness"; nothing where the schema's own default or example holds.
  std::optional<Value> value_of(const std::string& key) const;

  const std::string& name() const { return name_; }
  /// Such as "first-year level ice of the northern Baltic".
  std::string description() const;

 private:
  std::string name_;
};

}  // namespace brash::io
