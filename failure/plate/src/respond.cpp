// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "brash/core/contract.hpp"
#include "brash/plate/plate.hpp"
#include "recovery.hpp"

namespace brash::plate {

namespace {

/// The plateau is where the stress exceeds this share of its peak.
constexpr double kPlateau = 0.99;

Tensor2 combine(double a, const Tensor2& bending, const Tensor2& normal, double mu2, const Tensor2& tangential) {
  return {a * bending.xx + normal.xx + mu2 * tangential.xx, a * bending.yy + normal.yy + mu2 * tangential.yy,
          a * bending.xy + normal.xy + mu2 * tangential.xy};
}

/// Peak of the parabola through three points around the largest value; the point itself at an end of the line.
struct Peak {
  double place = 0.0;
  double value = 0.0;
};

Peak refine(const std::vector<double>& x, const std::vector<double>& f, std::size_t i) {
  if (i == 0 || i + 1 == x.size()) return {x[i], f[i]};
  const double left = (f[i] - f[i - 1]) / (x[i] - x[i - 1]);
  const double right = (f[i + 1] - f[i]) / (x[i + 1] - x[i]);
  const double curvature = (right - left) / (x[i + 1] - x[i - 1]);
  if (curvature >= 0.0) return {x[i], f[i]};
  // Newton's form: f[i-1] + left (s - x[i-1]) + curvature (s - x[i-1]) (s - x[i]).
  const double place = 0.5 * (x[i - 1] + x[i]) - 0.5 * left / curvature;
  return {place, f[i - 1] + left * (place - x[i - 1]) + curvature * (place - x[i - 1]) * (place - x[i])};
}

double crossing(double xa, double fa, double xb, double fb, double level) {
  return xa + (level - fa) / (fb - fa) * (xb - xa);
}

}  // namespace

Response respond(const UnitProfiles& profiles, double thickness_over_lc, double mu1, double mu2) {
  BRASH_EXPECTS(thickness_over_lc > 0.0, thickness_over_lc);
  BRASH_EXPECTS(!profiles.station.empty() && profiles.bending.size() == profiles.station.size(),
                profiles.station.size(), profiles.bending.size());
  // The surface that P puts in tension changes with the sign of P: only the size of mu1 matters.
  const double factor = 6.0 * std::abs(mu1) / thickness_over_lc;
  const auto& x = profiles.station;
  std::vector<double> stress;
  for (std::size_t i = 0; i < x.size(); ++i) {
    stress.push_back(
        largest_principal(combine(factor, profiles.bending[i], profiles.normal[i], mu2, profiles.tangential[i])));
  }

  const auto best = static_cast<std::size_t>(std::max_element(stress.begin(), stress.end()) - stress.begin());
  const Peak peak = refine(x, stress, best);
  Response response;
  response.sigma_over_p = peak.value;
  response.lbreak_over_lc = peak.place;

  const double level = kPlateau * peak.value;
  std::size_t from = best;
  while (from > 0 && stress[from - 1] >= level) --from;
  std::size_t to = best;
  while (to + 1 < x.size() && stress[to + 1] >= level) ++to;
  response.plateau_from = from == 0 ? x[0] : crossing(x[from - 1], stress[from - 1], x[from], stress[from], level);
  response.plateau_to = to + 1 == x.size() ? x[to] : crossing(x[to], stress[to], x[to + 1], stress[to + 1], level);

  // The refined peak is above every station: it belongs to its plateau all the same.
  response.plateau_from = std::min(response.plateau_from, peak.place);
  response.plateau_to = std::max(response.plateau_to, peak.place);

  response.sigma_radial_over_p =
      combine(-factor, profiles.bending[0], profiles.normal[0], mu2, profiles.tangential[0]).yy;
  response.sigma_root_over_p =
      factor * profiles.root_bending + profiles.root_normal + std::abs(mu2) * profiles.root_tangential;
  return response;
}

}  // namespace brash::plate
