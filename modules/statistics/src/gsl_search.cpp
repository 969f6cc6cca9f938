// SPDX-License-Identifier: GPL-3.0-or-later
#include "gsl_search.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_min.h>
#include <gsl/gsl_roots.h>

#include <algorithm>
#include <utility>

#include "brash/core/error.hpp"
#include "gsl_checked.hpp"

namespace brash::statistics {
namespace {

constexpr int kIterations = 200;  // bisection alone would need 50 to rounding

}  // namespace

std::optional<double> find_root(gsl_function& function, double lower, double upper, double relative, double absolute) {
  quiet_gsl();
  const GslOwner<gsl_root_fsolver, gsl_root_fsolver_free> solver(gsl_root_fsolver_alloc(gsl_root_fsolver_brent));
  if (!solver) throw RunError("root search: out of memory");
  if (gsl_root_fsolver_set(solver.get(), &function, lower, upper) != GSL_SUCCESS) return std::nullopt;
  for (int i = 0; i < kIterations; ++i) {
    if (gsl_root_fsolver_iterate(solver.get()) != GSL_SUCCESS) return std::nullopt;
    const double low = gsl_root_fsolver_x_lower(solver.get()), high = gsl_root_fsolver_x_upper(solver.get());
    if (gsl_root_test_interval(low, high, absolute, relative) == GSL_SUCCESS) break;
  }
  return gsl_root_fsolver_root(solver.get());
}

double find_minimum(gsl_function& function, double lower, double middle, double upper, double tolerance) {
  quiet_gsl();
  const GslOwner<gsl_min_fminimizer, gsl_min_fminimizer_free> search(
      gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent));
  if (!search) throw RunError("minimum search: out of memory");
  if (gsl_min_fminimizer_set(search.get(), &function, middle, lower, upper) != GSL_SUCCESS) return middle;
  for (int i = 0; i < kIterations; ++i) {
    if (gsl_min_fminimizer_iterate(search.get()) != GSL_SUCCESS) break;
    const double low = gsl_min_fminimizer_x_lower(search.get()), high = gsl_min_fminimizer_x_upper(search.get());
    if (gsl_min_test_interval(low, high, tolerance, tolerance) == GSL_SUCCESS) break;
  }
  return gsl_min_fminimizer_x_minimum(search.get());
}

Minimum find_minimum_from(gsl_function& function, double start, double step, double lower, double upper,
                          double tolerance) {
  const auto at = [&](double x) {
    const double inside = std::clamp(x, lower, upper);
    return Minimum{inside, GSL_FN_EVAL(&function, inside)};
  };
  Minimum behind = at(start), middle = at(start + step), ahead = behind;
  if (middle.value > behind.value) {
    std::swap(behind, middle);
    step = -step;
  }
  for (int i = 0; i < kIterations; ++i) {
    step *= 2.0;
    ahead = at(middle.at + step);
    if (ahead.at == middle.at || ahead.value >= middle.value) break;
    behind = std::exchange(middle, ahead);
  }
  const auto [left, right] = std::minmax(behind.at, ahead.at);
  const double found = find_minimum(function, left, middle.at, right, tolerance);
  return {found, GSL_FN_EVAL(&function, found)};
}

}  // namespace brash::statistics
