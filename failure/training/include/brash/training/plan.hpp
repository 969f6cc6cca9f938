// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "brash/plate/plate.hpp"

namespace brash::training {

/// How a coordinate u in [0, 1] of the design becomes a value: evenly, evenly in the logarithm, as u^2 (dense below),
/// or evenly in ln(b + c/2), the scale on which the fields near a contact of length c change (the depth only).
enum class Spacing { kLinear, kLogarithmic, kQuadratic, kByContact };

/// Range of one input.
struct Axis {
  double from = 0.0;
  double to = 0.0;
  Spacing spacing = Spacing::kLinear;
};

/// A design of experiments over the inputs of Eq. 17.
struct Plan {
  int geometries = 0;         ///< number of (b, c, theta, h) points, each solved once
  int first = 0;              ///< number of its first point in the sequence: designs that do not overlap share no point
  int rows_per_geometry = 8;  ///< (mu1, mu2) points on each, by superposition
  double edge_share = 0.06;   ///< part of each axis that is folded onto its two ends, so that the ends are sampled
  Axis b_lc;                  ///< b / l_c [-]
  Axis c_lc;                  ///< c / l_c [-]
  Axis theta;                 ///< [rad]; `theta_deg` in the file
  Axis thickness_over_lc;     ///< h / l_c [-]
  Axis mu1;
  Axis mu2;
  double poisson_ratio = 0.3;
  plate::Theory theory = plate::Theory::kReissnerMindlin;
  bool split = false;  ///< by a radial crack, as plate::WedgePlate::split
  plate::MeshOptions mesh;
};

/// Reads a plan (TOML, strict).
/// @throws InputError with file, line, key, the allowed values and the remedy.
Plan read_plan(const std::string& path);

/// The plan with every key, in a fixed order: equal plans have equal text.
std::string to_text(const Plan& plan);

/// One (mu1, mu2) point.
struct LoadPoint {
  double mu1 = 0.0;
  double mu2 = 0.0;
};

/// One geometry of the design with its load points.
struct DesignPoint {
  plate::WedgePlate plate;
  std::vector<LoadPoint> loads;
};

/// The points of the plan: Sobol's sequence in (b, c, theta, h) and another one in (mu1, mu2), so a plan with more
/// geometries begins with the same ones.
std::vector<DesignPoint> design(const Plan& plan);

}  // namespace brash::training
