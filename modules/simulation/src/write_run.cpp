// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include "brash/simulation/run.hpp"

namespace brash::simulation {

void write_run(const std::string& directory, const std::string& case_file, const io::Case& resolved, const Run& run) {
  std::filesystem::create_directories(directory);
  io::write_results(directory, resolved, run.results);
  io::write_file(directory + "/summary.json", to_json(run.summary));
}

}  // namespace brash::simulation
