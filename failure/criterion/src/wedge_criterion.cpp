// SPDX-License-Identifier: GPL-3.0-or-later
// A narrow wedge of ice as a tapered beam on water (Nevel's problem), cut off where it is c wide and loaded there.
//
//   (E h^3 / 12) (b0 x w'')'' + k b0 x w = 0,  x >= a,  M(a) = 0,  M'(a) = P_total,   b0 = 2 tan(theta / 2)
//
// x runs from the apex where the sides would meet, so a = c / b0. In lengths of l = (E h^3 / 12 k)^(1/4) the beam has
// one parameter, alpha = a / l:
//
//   sigma = 6 P_total / (b0 h^2 F(alpha)),   |AB| = l lambda(alpha),   P_total = mu1 p h c.
//
// F and lambda are rational in s = alpha^(1/3), fitted to the solved beam for 1e-3 <= alpha <= 300 (errors 1.1e-4 and
// 3e-5). They tend to the parallel strip of Hetenyi: alpha / F -> 0.455938, lambda -> pi sqrt(2) / 4.
// Nevel's polynomial 1.05 + 2 alpha + 0.5 alpha^3 belongs to another load: spread over the tip of a whole wedge.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "brash/core/constants.hpp"
#include "criteria.hpp"

namespace brash::failure {
namespace {

/// max M = kStripMoment q l of a semi-infinite strip with the line load q on its end (Hetenyi).
constexpr double kStripMoment = 0.455938;
/// Where it is, in l.
constexpr double kStripPlace = 0.25 * kPi * std::numbers::sqrt2;
/// Below this angle the wedge is the parallel strip within 1e-6: alpha is beyond the fits.
constexpr double kFitTo = 300.0;
constexpr double kFitFrom = 1e-3;

constexpr std::array<double, 5> kFTop{0.9951036993106014, -2.444202125547859, 7.3870047072422755, -7.234089615756816,
                                      5.660528328948926};
constexpr std::array<double, 5> kFBottom{1.0, -2.563359970812724, 7.1835084363718, -7.183324827038829,
                                         5.655946471110514};
constexpr std::array<double, 5> kPlaceTop{-7.400084927718987e-05, 1.0021423893947332, 0.7527869243192488,
                                          0.35782701759270313, 0.19331858576379768};
constexpr std::array<double, 5> kPlaceBottom{1.0, 0.5377666995605647, 0.9217377681476572, 0.3331104194576944,
                                             0.1946984685731559};

double polynomial(const std::array<double, 5>& c, double s) {
  return c[0] + s * (c[1] + s * (c[2] + s * (c[3] + s * c[4])));
}

/// alpha / F(alpha): the largest moment per unit width over (load per unit length of the tip times l).
double moment(double alpha) {
  if (alpha > kFitTo) return kStripMoment;
  const double s = std::cbrt(std::max(alpha, kFitFrom));
  const double F = (1.0 + alpha / kStripMoment) * polynomial(kFTop, s) / polynomial(kFBottom, s);
  return alpha / F;
}

/// lambda(alpha).
double place(double alpha) {
  if (alpha > kFitTo) return kStripPlace;
  const double s = std::cbrt(alpha);
  return std::max(0.0, kStripPlace * polynomial(kPlaceTop, s) / polynomial(kPlaceBottom, s));
}

class WedgeCriterion final : public BendingCriterion {
 public:
  explicit WedgeCriterion(const IceProperties& ice)
      : thickness_(ice.thickness),
        strength_(ice.flexural_strength),
        l_(std::pow(ice.youngs_modulus * std::pow(ice.thickness, 3) / (12.0 * ice.water_density * kGravity), 0.25)) {}

  Assessment assess(const LoadCase& load) const override {
    expect_valid(load);
    // theta = 0 gives alpha = infinity: the strip.
    const double alpha = load.contact_length / (2.0 * std::tan(0.5 * load.angle) * l_);
    const double sigma = 6.0 * load.mu1 * load.pressure * (l_ / thickness_) * moment(alpha);
    return {.fails = sigma > strength_, .sigma_max = sigma, .breaking_length = l_ * place(alpha)};
  }

  std::unique_ptr<BendingCriterion> for_ice(const IceProperties& ice) const override {
    return std::make_unique<WedgeCriterion>(ice);
  }

 private:
  double thickness_;
  double strength_;
  double l_;
};

}  // namespace

std::unique_ptr<BendingCriterion> make_wedge_criterion(const IceProperties& ice) {
  return std::make_unique<WedgeCriterion>(ice);
}

}  // namespace brash::failure
