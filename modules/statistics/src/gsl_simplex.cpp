// SPDX-License-Identifier: GPL-3.0-or-later
#include "gsl_simplex.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multimin.h>

#include "brash/core/error.hpp"
#include "gsl_checked.hpp"

namespace brash::statistics {
namespace {

constexpr int kIterations = 500;  // a simplex of two sides needs about 60

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
  for (int i = 0; i < kIterations; ++i) {
    if (gsl_multimin_fminimizer_iterate(search.get()) != GSL_SUCCESS) break;
    if (gsl_multimin_test_size(gsl_multimin_fminimizer_size(search.get()), tolerance) == GSL_SUCCESS) break;
  }
  SimplexMinimum minimum{std::move(start), gsl_multimin_fminimizer_minimum(search.get())};
  for (std::size_t i = 0; i < n; ++i) minimum.at[i] = gsl_vector_get(gsl_multimin_fminimizer_x(search.get()), i);
  return minimum;
}

}  // namespace brash::statistics
