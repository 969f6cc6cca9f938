// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace brash::model {

/// Input that is legal and looks wrong, or a result that cannot support its use. It follows the result everywhere.
/// docs/reference/warnings.md lists each with the input that triggers it and its source.
struct Warning {
  std::string id;    ///< short name for tables: `flexural-strength`
  std::string text;  ///< found, expected, remedy

  friend bool operator==(const Warning&, const Warning&) = default;
};

}  // namespace brash::model
