// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

namespace brash::failure {

/// Ice and water as the failure criterion sees them; SI.
struct IceProperties {
  double thickness = 0.0;             ///< h [m]
  double youngs_modulus = 0.0;        ///< E [Pa]
  double poisson_ratio = 0.3;         ///< nu [-]
  double flexural_strength = 0.0;     ///< sigma_f [Pa]
  double compressive_strength = 0.0;  ///< sigma_c [Pa]
  double crushing_factor = 0.5;       ///< R of Eq. 15 [-]
  double water_density = 1025.0;      ///< rho_w [kg/m3]
};

/// l_c = (E h^3 / (12 rho_w g (1 - nu^2)))^(1/4) [m], Eq. 18 with the water's density.
double characteristic_length(const IceProperties& ice);

/// F_n = sigma_c A R [N] on a contact of area `area` [m2], Eq. 15.
double crushing_force(const IceProperties& ice, double area);

/// A cone's or plane's contact with the ice edge, split into the paper's components per unit normal contact force.
struct LoadRatios {
  double horizontal = 0.0;  ///< in-plane normal N over the contact's normal force [-]
  double mu1 = 0.0;         ///< P / N [-]
  double mu2 = 0.0;         ///< f / N, positive counter-clockwise along the structure's section [-]
};

/// Resolves a contact on a surface that slopes at `slope` from the horizontal and slides against the ice.
///
/// The structure moves at an angle `heading` [rad] from the contact's plan normal (into the ice); friction acts along
/// the sliding direction with the coefficient `friction`.
/// @see docs/theory/failure.md; at heading 0, mu1 = (cos a - mu sin a)/(sin a + mu cos a).
LoadRatios load_ratios(double slope, double friction, double heading);

/// One contact, ready for the criterion.
struct LoadCase {
  double depth = 0.0;           ///< b [m]
  double contact_length = 0.0;  ///< c [m]
  double angle = 0.0;           ///< theta [rad]
  double mu1 = 0.0;             ///< P / N [-]
  double mu2 = 0.0;             ///< f / N [-]
  double pressure = 0.0;        ///< p = N / (c h) [Pa]
};

/// What the criterion says of a load case.
struct Assessment {
  bool fails = false;            ///< sigma_max > sigma_f
  double sigma_max = 0.0;        ///< largest principal stress [Pa]
  double breaking_length = 0.0;  ///< l_break [m]
  bool below_range = false;      ///< an input was clamped up to the model's range
  bool above_range = false;      ///< an input exceeds the model's range (and was clamped down)
};

/// Says whether the ice fails in bending and how far in. Stateless after construction.
class BendingCriterion {
 public:
  virtual ~BendingCriterion() = default;
  virtual Assessment assess(const LoadCase& load) const = 0;
};

/// The criterion named `model`: `network` (needs `file`), `plate` (direct solve) or `wedge` (Nevel).
/// @throws InputError for an unknown name or an unreadable file.
std::unique_ptr<BendingCriterion> make_criterion(const std::string& model, const std::string& file,
                                                 const IceProperties& ice);

}  // namespace brash::failure
