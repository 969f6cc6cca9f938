// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "brash/plate/plate.hpp"

namespace brash::plate {

/// A trapezoidal protrusion of a free edge that moves, or a bay: lengths over the characteristic length l_c.
struct EdgeGeometry {
  double depth = 0.0;           ///< b / l_c [-]; negative: of a bay
  double contact_length = 0.0;  ///< c / l_c [-], > 0
  double angle = 0.0;           ///< theta, full opening angle [rad], in [0, pi); of a bay towards the water
  double mass_ratio = 0.0886;   ///< rho_i h / (rho_w l_c) [-], > 0
  double thickness = 0.1;       ///< h / l_c [-]
  bool split = false;           ///< by a radial crack from B along the whole centre line

  friend bool operator==(const EdgeGeometry&, const EdgeGeometry&) = default;
};

/// The motion depends on the mass ratio almost only through t / sqrt(mass_ratio + kMassShift).
inline constexpr double kMassShift = 0.15;
/// The mass ratio whose times EdgeResponses has in production: the validation case's.
inline constexpr double kUsualMass = 0.0886;

/// How the edge of a floating sheet, at rest before, answers a line load on its tip that is even over the contact
/// length and grows as Q = t.
///
/// Units: lengths over l_c, time over T = sqrt(l_c / g). Q is the vertical load per metre of the tip edge. Deflections
/// are per Q / (rho_w g l_c), positive in the direction of the load. Moments are per Q l_c, signed as
/// UnitProfiles::bending: positive where the surface that the load pushes on is in tension.
///
/// Each series is the response to the ramp, **divided by t**: it tends to the static value. With F(t) such a series, a
/// load whose slope changes by dQ' at the times t_k gives the sum of dQ'_k (t - t_k) F(t - t_k). Behind the
/// last time F is `static + (F(last) - static) last / t`; before the first it grows as t. series_weights() knows this.
///
/// Membrane stresses are static, per p = N / h for a line load N in the plane: they reach across the sheet at once.
/// @see docs/theory/fracture-of-the-edge.md, (W4)
struct EdgeResponses {
  std::vector<double> time;         ///< t / T, shape=(n_times,), > 0, in equal steps of its logarithm
  std::vector<double> station;      ///< |AB| / l_c on the centre line, shape=(n_stations,), from 0
  std::vector<double> deflection;   ///< of B, shape=(n_times,)
  std::vector<double> edge_moment;  ///< along the edge at B (yy), shape=(n_times,): the radial crack's
  std::vector<double>
      axis_moment;  ///< across the axis (xx), shape=(n_times, n_stations), row by row: the circumferential
  double static_deflection = 0.0;
  double static_edge_moment = 0.0;
  std::vector<double> static_axis_moment;  ///< shape=(n_stations,)
  std::vector<double> axis_normal;         ///< membrane stress xx under N over p, shape=(n_stations,)
  double edge_normal = 0.0;                ///< membrane stress yy at B under N over p

  /// Moments at one time, shape=(n_stations,).
  const double* axis_moment_at(std::size_t i_time) const { return axis_moment.data() + i_time * station.size(); }
};

/// How finely a moving edge is solved; 0: production.
struct EdgeOptions {
  double scale = 0.0;  ///< of the element sizes against production
  double reach = 0.0;  ///< of the sheet beyond the protrusion, sideways and inwards, over l_c
  int n_vectors = 0;   ///< of the Krylov space
};

/// The sheet of one outline and the water under it, meshed and factorised once for all thicknesses.
class MovingEdge {
 public:
  /// @param outline  of it only depth, contact length and angle count.
  static tl::expected<MovingEdge, PlateError> prepare(const EdgeGeometry& outline, const EdgeOptions& options = {});
  MovingEdge(MovingEdge&&) noexcept;
  MovingEdge& operator=(MovingEdge&&) noexcept;
  ~MovingEdge();

  /// The responses for a Poisson ratio of 0.3; only thickness, mass ratio and split are taken from `geometry`.
  tl::expected<EdgeResponses, PlateError> respond(const EdgeGeometry& geometry) const;
  int n_elements() const;

 private:
  struct Impl;
  explicit MovingEdge(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// The responses of one edge.
tl::expected<EdgeResponses, PlateError> solve(const EdgeGeometry& geometry, const EdgeOptions& options = {});

/// How a series gives its value at some time: the sum of `weight[i]` times the value at `time[first + i]`, and
/// `at_rest` times the static value.
struct SeriesWeights {
  std::size_t first = 0;
  std::array<double, 4> weight{};
  double at_rest = 0.0;
};

/// The weights at the time t >= 0: a cubic in ln t between the times of a series; as t before the first.
/// @param time  EdgeResponses::time, at least 4.
SeriesWeights series_weights(const std::vector<double>& time, double t);

}  // namespace brash::plate
