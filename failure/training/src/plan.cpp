// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/training/plan.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "brash/core/constants.hpp"
#include "plan_table.hpp"

namespace brash::training {
namespace {

constexpr std::array<const char*, 4> kSpacingNames{"linear", "logarithmic", "quadratic", "by-contact"};
constexpr std::array<const char*, 2> kTheoryNames{"reissner-mindlin", "kirchhoff"};
constexpr int kMostGeometries = 1'000'000;
constexpr int kMostRows = 10'000;

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
  const bool needs_positive = axis.spacing == Spacing::kByContact || axis.spacing == Spacing::kQuadratic;
  if (needs_positive && axis.from < 0.0)
    table.refuse(table.get("from"), "from", "is below 0", "0 or more with this spacing; bays with linear spacing");
  if (axis.spacing == Spacing::kByContact && key != "b_lc") {
    table.refuse(table.get("spacing"), "spacing", "= \"by-contact\" is not allowed", "that spacing for `b_lc` only");
  }
  table.refuse_unknown_keys();
  return axis;
}

std::string axis_text(const char* name, const Axis& axis) {
  return fmt::format("{} = {{ from = {}, to = {}, spacing = \"{}\" }}\n", name, axis.from, axis.to,
                     kSpacingNames[static_cast<std::size_t>(axis.spacing)]);
}

}  // namespace

Plan read_plan(const std::string& path) {
  const toml::table root = parse_plan(path);
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
  plan.b_lc = read_axis(range, "b_lc", -5.0, 5.0);
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

}  // namespace brash::training
