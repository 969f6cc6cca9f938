// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "brash/model/case.hpp"

namespace brash::report {

/// Whether this build carries the page; without Node.js it does not, and no report can be written.
bool has_page();

/// The resolved case of the run in `directory`, from its manifest.
/// @throws InputError when there is no manifest or it holds no case.
model::Case case_of_run(const std::string& directory);

/// Writes `directory`/report.html from the run's run.nc, summary.json and manifest.json: one file that needs no
/// network.
///
/// @param closed_forms  closed-form loads of the run's case, as JSON (`brash loads --json`).
/// @return the path of the report.
/// @throws InputError naming the file that is missing or unreadable. @throws RunError without a page, or when the
/// report
///         cannot be written.
std::string write_run_report(const std::string& directory, const std::string& closed_forms);

/// The same of a campaign, from its summary.json, campaign.csv and manifest.json.
std::string write_campaign_report(const std::string& directory);

/// Whether `directory` holds a campaign, and not a run.
bool is_campaign(const std::string& directory);

}  // namespace brash::report
