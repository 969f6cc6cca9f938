// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "brash/core/vec.hpp"

namespace brash::plate {

enum class Theory { kReissnerMindlin, kKirchhoff };

/// A trapezoidal protrusion of the free edge of a wide floating plate, or a bay; lengths over the characteristic length
/// l_c. The load acts on the tip edge, which is the head of a protrusion or the bottom of a bay.
///
/// Frame: origin at B, the middle of the tip edge; x along the centre line into the ice; y along the tip edge.
struct WedgePlate {
  double depth = 0.0;           ///< b / l_c [-]; negative: of a bay
  double contact_length = 0.0;  ///< c / l_c [-], > 0
  double angle = 0.0;           ///< theta, full opening angle [rad], in [0, pi); of a bay towards the water
  double thickness = 0.1;       ///< h / l_c [-]
  double poisson_ratio = 0.3;   ///< nu [-]
  Theory theory = Theory::kReissnerMindlin;
  /// N / sqrt(k D) [-] of the in-plane load that also acts on the bent plate (second order); 0: first order.
  double in_plane_load = 0.0;
  /// Whether UnitProfiles::in_plane is wanted; then in_plane_load must be 0.
  bool with_in_plane_terms = false;
  /// Whether a radial crack from B has split the sheet along the whole centre line: no moments across it. In the plane
  /// it is closed.
  bool split = false;

  friend bool operator==(const WedgePlate&, const WedgePlate&) = default;
};

/// How finely the plate is meshed. Sizes are longest element edges.
struct MeshOptions {
  double tip_size = 0.0;    ///< size along the tip over l_c, all other sizes follow in proportion; 0: production
  double far_size = 0.0;    ///< largest size over l_c; 0: no limit but the growth with distance
  double half_width = 0.0;  ///< sheet beyond the protrusion, sideways and inwards, over l_c; 0: production
};

/// Symmetric plane tensor at one station.
struct Tensor2 {
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;

  friend Tensor2 operator+(const Tensor2& a, const Tensor2& b) { return {a.xx + b.xx, a.yy + b.yy, a.xy + b.xy}; }
  friend Tensor2 operator*(double factor, const Tensor2& t) { return {factor * t.xx, factor * t.yy, factor * t.xy}; }
};

/// How the in-plane normal load changes the moments of UnitProfiles (second order). With n = N / sqrt(k D) and
/// r = n / buckling_load the moments are `bending + r first + r^2 / (1 - r) rest`: the exact series up to r^2, and a
/// geometric one of the buckling mode beyond.
/// @see docs/theory/fracture-of-the-edge.md, (5)
struct InPlaneTerms {
  double buckling_load = 0.0;  ///< n at which the plate buckles [-]; 0: the terms are not there
  std::vector<Tensor2> first;  ///< shape=(n_stations,) both, as UnitProfiles::bending
  std::vector<Tensor2> rest;
};

/// The three unit fields along the centre line; shape=(n_stations,) each, n_stations >= 200, from B to 4 l_c beyond the
/// base line, denser at the tip and the base line.
///
/// The stress on a surface is, with p = N/h the mean pressure on the tip edge,
/// `sigma / p = +-6 mu1 (l_c/h) bending + normal + mu2 tangential`.
struct UnitProfiles {
  std::vector<double> station;      ///< |AB| / l_c
  std::vector<Tensor2> bending;     ///< moments per unit P l_c, for the out-of-plane line load P = mu1 N
  std::vector<Tensor2> normal;      ///< membrane stress over p, for the in-plane normal load N
  std::vector<Tensor2> tangential;  ///< membrane stress over p, for the in-plane tangential load f = N
  std::vector<double> deflection;   ///< w k l_c / P [-] along the stations
  InPlaneTerms in_plane{};          ///< where WedgePlate::with_in_plane_terms asked for them
  double root_bending = 0.0;        ///< largest principal moment outside a disc of radius h/2 at the re-entrant roots
  double root_normal = 0.0;         ///< largest principal membrane stress there, under N
  double root_tangential = 0.0;     ///< largest absolute principal membrane stress there, under f
  int n_elements = 0;
};

/// Why a plate could not be solved.
struct PlateError {
  std::string what;
  bool buckled = false;  ///< the in-plane load exceeds the buckling load
};

/// Solves the floating plate for its three unit loads (one factorisation of each operator, three right-hand sides).
/// @see docs/theory/fracture-of-the-edge.md, (2)
tl::expected<UnitProfiles, PlateError> solve(const WedgePlate& plate, const MeshOptions& options = {});

/// The fields with the moments of the plate that is also compressed by n = N / sqrt(k D) [-], from their in-plane
/// terms.
/// @return nothing where the plate buckles.
std::optional<UnitProfiles> compressed(UnitProfiles profiles, double in_plane_load);

/// Stresses and places that decide about failure, for one pair of load ratios.
struct Response {
  double sigma_over_p = 0.0;         ///< largest principal stress on the centre line, surface that P puts in tension
  double lbreak_over_lc = 0.0;       ///< its place |AB| / l_c
  double plateau_from = 0.0;         ///< where the stress first exceeds 99 % of its peak (the hump of the peak)
  double plateau_to = 0.0;           ///< where it last does
  double sigma_radial_over_p = 0.0;  ///< tensile stress along the edge at B, other surface: the radial crack
  double sigma_root_over_p = 0.0;    ///< bound on the principal stress at the re-entrant roots
};

/// Superposes the unit fields, docs/theory/fracture-of-the-edge.md, (3): exact in P/N, f/N and l_c/h =
/// 1/plate.thickness.
///
/// @param thickness_over_lc  h / l_c [-], > 0; for shear-flexible profiles, the ratio of the plate solved for them.
/// @param mu1  its sign says which surface P puts in tension and has no other effect.
/// @param mu2  its sign has no effect on the centre line.
Response respond(const UnitProfiles& profiles, double thickness_over_lc, double mu1, double mu2);

}  // namespace brash::plate
