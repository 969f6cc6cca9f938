// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace brash::cli {

/// From here on Ctrl-C (SIGINT), a request to end (SIGTERM) and a terminal that closes (SIGHUP) do not end the process:
/// is_asked_to_end() reports them. The process continues to ignore signals that it was started to ignore, as under
/// nohup.
void catch_requests_to_end();

/// Whether the process was asked to end since.
bool is_asked_to_end();

}  // namespace brash::cli
