// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "brash/core/write_file.hpp"
#include "brash/model/case.hpp"
#include "brash/model/records.hpp"

namespace brash::io {

/// Writes run.nc (netCDF-4, CF), history.csv and events.csv into `directory`, each by rename when whole.
/// @param earlier  files of write_earlier_rows() with the rows before those of `results`, oldest first.
/// @throws RunError naming the file and the system's reason.
void write_results(const std::string& directory, const model::Case& resolved, const model::RunResults& results,
                   const std::vector<std::string>& earlier = {});

/// Writes history.csv alone.
/// @throws StorageError naming the file and the system's reason.
void write_history(const std::string& directory, const model::RunResults& results,
                   const std::vector<std::string>& earlier = {});

/// Reads the results that write_results wrote into run.nc.
/// @throws InputError naming the file and the missing part, or the value that cannot have come from a run.
model::RunResults read_results(const std::string& path);

/// Reads the loads of a run from its run.nc or its history.csv, row by row.
/// @throws InputError naming the file and a column that it lacks, or the place of a value that is missing.
std::vector<model::LoadRow> read_loads(const std::string& path);

/// The resolved case in a run.nc, as to_toml() wrote it. @throws InputError as read_results() does.
std::string read_case_of(const std::string& path);

/// The values that can differ between two equal runs of one case.
struct Volatile {
  std::string started_at;  ///< ISO 8601, UTC
  double wall_seconds = 0.0;
  std::string host_cpu;                           ///< empty: the name in /proc/cpuinfo
  std::map<std::string, double> stage_seconds{};  ///< wall time of each stage of the step [s]
  int threads = 1;                                ///< that worked at the run
};

/// A file that was read.
struct HashedFile {
  std::string path;    ///< as given
  std::string sha256;  ///< when it was read
  std::size_t n_bytes = 0;
  std::string copy;  ///< its name in the folder of the results; empty: none
};

/// Writes manifest.json: resolved case, versions of the program, compiler and libraries, CPU and glibc, seeds, SHA-256
/// of every input and output; times and host under the key `volatile`.
///
/// @param inputs   the case's file first.
/// @param outputs  names of files in `directory`.
/// @throws RunError when a file cannot be hashed or the manifest not written.
void write_manifest(const std::string& directory, const model::Case& resolved, const std::vector<HashedFile>& inputs,
                    const std::vector<std::string>& outputs, const Volatile& context);

/// SHA-256 of the program, or of the Python module, that this code runs in.
std::string sha256_of_program();

}  // namespace brash::io
