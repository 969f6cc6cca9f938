# SPDX-License-Identifier: GPL-3.0-or-later
# Writes OUTPUT, a source file with the commit of SOURCE, at each build; untouched when it is the same.
execute_process(COMMAND git -C ${SOURCE} describe --always --abbrev=12 --dirty --exclude=*
  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT [[
// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/core/version.hpp"
const char* const brash::kCommit = "@commit@";
]])
