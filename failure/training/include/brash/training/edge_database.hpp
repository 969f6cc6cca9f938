// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "brash/plate/edge_responses.hpp"
#include "brash/training/database.hpp"

namespace brash::training {

/// A grid of geometries of a moving edge. A straight edge (b = 0) is solved once for all angles.
struct EdgePlan {
  std::vector<double> b_lc;               ///< rising, from 0
  std::vector<double> c_lc;               ///< rising
  std::vector<double> theta;              ///< [rad], rising; `theta_deg` in the file
  std::vector<double> thickness_over_lc;  ///< rising
  double density_ratio = 0.88;            ///< rho_i / rho_w: the mass ratio is that times h / l_c
  bool split = false;                     ///< by a radial crack, as plate::EdgeGeometry::split
  plate::EdgeOptions options{};
};

/// Reads a plan of a moving edge (TOML, strict): one with a table `edge`.
/// @throws InputError with file, line, key, the allowed values and the remedy.
EdgePlan read_edge_plan(const std::string& path);

/// Whether the plan at `path` has a table `edge`.
/// @throws InputError when it cannot be read.
bool is_edge_plan(const std::string& path);

/// The plan with every key, in a fixed order.
std::string to_text(const EdgePlan& plan);

/// The geometries of the plan: the geometries of one outline follow each other.
std::vector<plate::EdgeGeometry> design(const EdgePlan& plan);

struct EdgeRecord {
  int index = 0;  ///< in the design
  plate::EdgeGeometry geometry{};
  bool solved = false;
  std::string error{};               ///< why it was not solved
  plate::EdgeResponses responses{};  ///< empty when not solved
};

/// A database file in memory, records by geometry.
struct EdgeDatabase {
  std::string plan;         ///< to_text of the plan
  std::string plan_sha256;  ///< of that text
  std::vector<EdgeRecord> records{};
};

/// As the functions for a Plan.
Progress build(const EdgePlan& plan, const std::string& path, const std::function<bool(const Progress&)>& go_on = {});
std::vector<int> missing_chunks(const EdgePlan& plan, const std::string& path);
void solve_chunk(const EdgePlan& plan, const std::string& path, int first);

/// Whether the netCDF file at `path` is a database of a moving edge.
/// @throws InputError when it cannot be read.
bool is_edge_database(const std::string& path);

/// @throws InputError naming the file and the error.
EdgeDatabase read_edge_database(const std::string& path);

}  // namespace brash::training
