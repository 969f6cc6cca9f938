// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/model/case.hpp"

namespace brash::simulation {

/// Lengths and times that follow from a case: Setup::scales.
struct DerivedScales {
  double characteristic_length = 0.0;  ///< l_c, Eq. 18 [m]
  double thickness_over_lc = 0.0;      ///< h / l_c [-]
  double front_slope = 0.0;            ///< of the structure straight ahead, from the horizontal [rad]
  double mu1 = 0.0;                    ///< P / N of a contact straight ahead [-]
  double freeboard = 0.0;              ///< [m]
  double draft = 0.0;                  ///< [m]
  double initial_crack_radius = 0.0;   ///< of Fig. 5 [m]
  double correlation_length = 0.0;     ///< of ice that varies; 0: it is even [m]
  double collision_time = 0.0;         ///< T_col of a piece of l_c^2 / 4, Eqs. 11, 12 [s]
};

/// T_col = (pi/2) sqrt((1 + alpha) m / K) of a floe of `mass` [kg], Eqs. 11, 12 [s].
double collision_time(const model::Case& resolved, double mass);

}  // namespace brash::simulation
