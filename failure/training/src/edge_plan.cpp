// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/core/constants.hpp"
#include "brash/training/edge_database.hpp"
#include "plan_table.hpp"

namespace brash::training {
namespace {

std::string list_text(const char* name, const std::vector<double>& values) {
  return fmt::format("{} = [{}]\n", name, fmt::join(values, ", "));
}

}  // namespace

bool is_edge_plan(const std::string& path) { return parse_plan(path).contains("edge"); }

EdgePlan read_edge_plan(const std::string& path) {
  const toml::table root = parse_plan(path);
  Table file(path, "", root);
  EdgePlan plan;
  Table edge = file.table("edge");
  plan.b_lc = edge.numbers("b_lc", -5.0, 5.0);
  plan.c_lc = edge.numbers("c_lc", 1e-3, 100.0);
  plan.theta = edge.numbers("theta_deg", 0.0, 170.0);
  for (double& theta : plan.theta) theta = radians(theta);
  plan.thickness_over_lc = edge.numbers("thickness_over_lc", 1e-3, 1.0);
  plan.density_ratio = edge.number_or("density_ratio", plan.density_ratio, 0.5, 1.0);
  plan.split = edge.flag_or("split", plan.split);
  edge.refuse_unknown_keys();
  if (file.find("solver") != nullptr) {
    Table solver = file.table("solver");
    plan.options.scale = solver.number_or("scale", 0.0, 0.0, 10.0);
    plan.options.reach = solver.number_or("reach", 0.0, 0.0, 100.0);
    if (solver.find("vectors") != nullptr) plan.options.n_vectors = solver.whole("vectors", 1, 1000);
    solver.refuse_unknown_keys();
  }
  file.refuse_unknown_keys();
  return plan;
}

std::string to_text(const EdgePlan& plan) {
  return "[edge]\n" + list_text("b_lc", plan.b_lc) + list_text("c_lc", plan.c_lc) + list_text("theta", plan.theta) +
         list_text("thickness_over_lc", plan.thickness_over_lc) +
         fmt::format("density_ratio = {}\nsplit = {}\n[solver]\nscale = {}\nreach = {}\nvectors = {}\n",
                     plan.density_ratio, plan.split, plan.options.scale, plan.options.reach, plan.options.n_vectors);
}

std::vector<plate::EdgeGeometry> design(const EdgePlan& plan) {
  std::vector<plate::EdgeGeometry> geometries;
  for (const double b : plan.b_lc) {
    for (const double theta : plan.theta) {
      if (b == 0.0 && theta != plan.theta.front()) continue;
      for (const double c : plan.c_lc) {
        for (const double h : plan.thickness_over_lc)
          geometries.push_back({.depth = b,
                                .contact_length = c,
                                .angle = theta,
                                .mass_ratio = plan.density_ratio * h,
                                .thickness = h,
                                .split = plan.split});
      }
    }
  }
  return geometries;
}

}  // namespace brash::training
