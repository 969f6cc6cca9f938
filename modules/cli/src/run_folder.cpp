// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_folder.hpp"

#include "brash/report/plan_view.hpp"

namespace brash::cli {

void write_run_folder(const std::string& directory, const std::string& case_file, const io::Case& resolved,
                      const simulation::Run& run) {
  io::write_file(directory + "/plan.svg", report::plan_view(resolved, run.results));
  simulation::write_run(directory, case_file, resolved, run, {"plan.svg"});
}

}  // namespace brash::cli
