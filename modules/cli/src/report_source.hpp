// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "brash/report/report.hpp"
#include "load_history.hpp"

namespace brash::cli {

/// The run in `directory` with all that its page shows: closed forms, statistics of each load, load events.
/// @throws InputError naming a file that is missing or unreadable.
report::RunSource report_source(const std::string& directory);

/// The column of `file` that `choice` names, to be drawn over the horizontal load of a run.
/// @throws InputError as read_history(), and when the column is in a unit that is not of a force.
report::MeasuredHistory measured_history(const std::string& file, const HistoryChoice& choice);

}  // namespace brash::cli
