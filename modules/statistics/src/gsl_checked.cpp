// SPDX-License-Identifier: GPL-3.0-or-later
#include "gsl_checked.hpp"

#include <gsl/gsl_errno.h>

#include <string>

#include "brash/core/error.hpp"

namespace brash::statistics {

void quiet_gsl() {
  static gsl_error_handler_t* const previous_handler = gsl_set_error_handler_off();
  (void)previous_handler;
}

void check_gsl(int status, const char* what) {
  if (status != GSL_SUCCESS) throw RunError(std::string(what) + ": " + gsl_strerror(status));
}

}  // namespace brash::statistics
