// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "problem.hpp"
#include "toml_source.hpp"

namespace brash::io {

/// A value for a key of the case, and where it was written.
struct Assignment {
  std::string section;
  std::string key;
  const toml::node* value;  ///< lives as long as the plan's tree
  Place place;

  std::string name() const { return section + "." + key; }
};

/// One value of an axis: its label and the keys that it sets.
struct AxisPoint {
  std::string label;  ///< its part of a setting's name
  std::vector<Assignment> assignments;
};

/// One [[grid]] of a plan.
struct Axis {
  std::vector<std::string> names;  ///< section.key, in the order of the file
  std::vector<AxisPoint> points;
};

/// The assignments `section.key = value` of the table `node`, in the order of the file; `path` is its name in the plan.
/// Faults go to `problems`.
std::vector<Assignment> read_assignments(const std::string& file, const std::string& path, const toml::node* node,
                                         std::vector<Problem>& problems);

/// The axes of a plan's grid. Faults go to `problems`.
std::vector<Axis> read_axes(const std::string& file, const toml::node* grid, std::vector<Problem>& problems);

/// At most `n` points of `axis`: the first, then the last, then evenly between them.
void thin_out(Axis& axis, int n);

}  // namespace brash::io
