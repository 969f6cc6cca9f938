// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/power_law.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_multifit.h>

#include <cmath>

#include "brash/core/contract.hpp"
#include "gsl_checked.hpp"

namespace brash::statistics {
namespace {

using Matrix = GslOwner<gsl_matrix, gsl_matrix_free>;
using Vector = GslOwner<gsl_vector, gsl_vector_free>;
using Workspace = GslOwner<gsl_multifit_linear_workspace, gsl_multifit_linear_free>;

constexpr double kSmallestShare = 1e-9;  // of the largest singular value: below it, inputs rise together

}  // namespace

std::optional<PowerLaw> fit_power_law(const std::vector<std::vector<double>>& inputs, std::span<const double> values,
                                      double confidence) {
  const std::size_t n = values.size(), n_terms = inputs.size() + 1;
  for (const std::vector<double>& input : inputs) BRASH_EXPECTS(input.size() == n);
  if (n <= n_terms) return std::nullopt;
  quiet_gsl();
  const Matrix terms(gsl_matrix_alloc(n, n_terms)), covariance(gsl_matrix_alloc(n_terms, n_terms));
  const Vector logarithms(gsl_vector_alloc(n)), fitted(gsl_vector_alloc(n_terms));
  for (std::size_t i = 0; i < n; ++i) {
    BRASH_EXPECTS(values[i] > 0.0);
    gsl_vector_set(logarithms.get(), i, std::log(values[i]));
    gsl_matrix_set(terms.get(), i, 0, 1.0);
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      BRASH_EXPECTS(inputs[k][i] > 0.0);
      gsl_matrix_set(terms.get(), i, k + 1, std::log(inputs[k][i]));
    }
  }
  const Workspace workspace(gsl_multifit_linear_alloc(n, n_terms));
  double squares = 0.0;
  std::size_t rank = 0;
  check_gsl(gsl_multifit_linear_tsvd(terms.get(), logarithms.get(), kSmallestShare, fitted.get(), covariance.get(),
                                     &squares, &rank, workspace.get()),
            "the fit of a power law");
  if (rank < n_terms) return std::nullopt;
  const auto freedom = static_cast<double>(n - n_terms);
  const double t = gsl_cdf_tdist_Pinv(0.5 + 0.5 * confidence, freedom);
  const auto term = [&](std::size_t k) {
    const double value = gsl_vector_get(fitted.get(), k);
    const double half_width = t * std::sqrt(gsl_matrix_get(covariance.get(), k, k));
    return Estimate{value, {value - half_width, value + half_width}};
  };
  const Estimate factor = term(0);
  PowerLaw law{.factor = {std::exp(factor.value), {std::exp(factor.interval.lower), std::exp(factor.interval.upper)}},
               .powers = {},
               .spread = std::sqrt(squares / freedom)};
  for (std::size_t k = 1; k < n_terms; ++k) law.powers.push_back(term(k));
  return law;
}

}  // namespace brash::statistics
