// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "fem.hpp"

namespace brash::plate {

/// Polynomial order of the elements in production.
inline constexpr int kOrder = 3;
/// h / l_c that represents Kirchhoff's theory: the shear flexibility left changes stresses by 2e-4, and rounding
/// takes over at a third of it.
inline constexpr double kThinPlate = 1e-3;
/// The stations reach this far beyond the base line, over l_c.
inline constexpr double kReach = 4.0;

/// The stations are dense to this distance beyond the base line, over l_c.
inline constexpr double kDense = 1.5;

/// A place on the centre line around which stations cluster: their spacing falls with the distance from it, down to
/// a distance of `scale`.
struct Cluster {
  double place = 0.0;
  double scale = 0.0;
};

/// Stations from 0 to `length`, evenly spaced up to `dense`, thinner beyond, and denser in the clusters.
std::vector<double> make_stations(double length, double dense, const std::vector<Cluster>& clusters);

/// The stations of a protrusion or a bay: clustered at B, and where the centre line crosses the base line.
std::vector<double> stations_of(const WedgePlate& plate);

/// Largest principal values on a circle around a corner.
struct RootExtremes {
  double absolute = 0.0;
  double tensile = 0.0;
};

/// The extremes of `field` on the part of the circle that lies in the ice.
RootExtremes at_root(const Field& field, Vec2 root, double radius);

/// The thickness to solve with: kThinPlate for Kirchhoff's theory, and for plates thinner than it.
double effective_thickness(Theory theory, double thickness);

}  // namespace brash::plate
