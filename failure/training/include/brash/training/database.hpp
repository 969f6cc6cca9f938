// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "brash/plate/plate.hpp"
#include "brash/training/plan.hpp"

namespace brash::training {

/// One labelled row: the answer of the plate to a load point.
struct Row {
  LoadPoint load;
  plate::Response response;
};

/// One geometry with all that was computed for it.
struct Record {
  int geometry = 0;  ///< index in the design
  plate::WedgePlate plate{};
  bool solved = false;
  std::string error{};             ///< why it was not solved
  plate::UnitProfiles profiles{};  ///< empty when not solved
  std::vector<Row> rows{};         ///< empty when not solved
};

/// A database file in memory, records by geometry.
struct Database {
  std::string plan;         ///< to_text of the plan
  std::string plan_sha256;  ///< of that text
  std::vector<Record> records{};
};

/// How far a build is.
struct Progress {
  int done = 0;    ///< geometries, earlier runs included
  int failed = 0;  ///< of these, not solved
  int total = 0;
};

/// Solves every geometry of `plan` and writes the database to `path` (netCDF-4) by rename when whole.
///
/// Finished chunks lie in `path`.chunks until then. A build that was stopped or killed continues after its last
/// whole chunk, so no geometry appears twice. A database that is already there for the same plan is left alone.
///
/// @param go_on  called after each chunk; the build stops when it returns false.
/// @return the progress; `done < total` when stopped.
/// @throws InputError when `path` or its chunks belong to another plan. @throws RunError when a file cannot be written.
Progress build(const Plan& plan, const std::string& path, const std::function<bool(const Progress&)>& go_on = {});

/// The first geometries of the chunks that a build to `path` has still to solve; none when the database is there.
/// @throws InputError as build.
std::vector<int> missing_chunks(const Plan& plan, const std::string& path);

/// The file of the chunk that begins with geometry `first`, until `path` is whole.
std::string chunk_file(const std::string& path, int first);

/// Solves the chunk of `plan` that begins with geometry `first` and writes its file. Chunks may be solved in any order
/// and by several processes; build then puts them together.
/// @throws RunError when the file cannot be written.
void solve_chunk(const Plan& plan, const std::string& path, int first);

/// @throws InputError naming the file and the error.
Database read_database(const std::string& path);

}  // namespace brash::training
