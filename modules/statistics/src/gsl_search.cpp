// SPDX-License-Identifier: GPL-3.0-or-later
#include "gsl_search.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_min.h>
#include <gsl/gsl_multimin.h>
#include <gsl/gsl_roots.h>

#include <algorithm>
#include <utility>

#include "brash/core/error.hpp"
#include "gsl_checked.hpp"

namespace brash::statistics {
namespace {

constexpr int kIterations = 200;  // bisection alone would need 50 to rounding

constexpr int kSimplexIterations = 500;  // a simplex of two sides needs about 60

struct Problem {
  const std::function<double(const std::vector<double>&)>& cost;
  std::vector<double> point;
};

double cost_of(const gsl_vector* at, void* context) {
  auto& problem = *static_cast<Problem*>(context);
  for (std::size_t i = 0; i < problem.point.size(); ++i) problem.point[i] = gsl_vector_get(at, i);
  return problem.cost(problem.point);
}

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

SimplexMinimum find_simplex_minimum(const std::function<double(const std::vector<double>&)>& cost,
                                    std::vector<double> start, double step, double tolerance) {
  quiet_gsl();
  const std::size_t n = start.size();
  Problem problem{cost, start};
  gsl_multimin_function function{&cost_of, n, &problem};
  const GslOwner<gsl_vector, gsl_vector_free> from(gsl_vector_alloc(n)), steps(gsl_vector_alloc(n));
  const GslOwner<gsl_multimin_fminimizer, gsl_multimin_fminimizer_free> search(
      gsl_multimin_fminimizer_alloc(gsl_multimin_fminimizer_nmsimplex2, n));
  if (!from || !steps || !search) throw RunError("minimum search: out of memory");
  for (std::size_t i = 0; i < n; ++i) gsl_vector_set(from.get(), i, start[i]);
  gsl_vector_set_all(steps.get(), step);
  check_gsl(gsl_multimin_fminimizer_set(search.get(), &function, from.get(), steps.get()), "minimum search");
  for (int i = 0; i < kSimplexIterations; ++i) {
    if (gsl_multimin_fminimizer_iterate(search.get()) != GSL_SUCCESS) break;
    if (gsl_multimin_test_size(gsl_multimin_fminimizer_size(search.get()), tolerance) == GSL_SUCCESS) break;
  }
  SimplexMinimum minimum{std::move(start), gsl_multimin_fminimizer_minimum(search.get())};
  for (std::size_t i = 0; i < n; ++i) minimum.at[i] = gsl_vector_get(gsl_multimin_fminimizer_x(search.get()), i);
  return minimum;
}

}  // namespace brash::statistics
