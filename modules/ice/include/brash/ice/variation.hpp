// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "brash/core/vec.hpp"
#include "brash/failure/criterion.hpp"
#include "brash/geometry/polygon.hpp"
#include "brash/model/case.hpp"
#include "brash/statistics/random.hpp"

namespace brash::ice {

/// A random field in the plane with mean 0, deviation 1 and the correlation exp(-(r / l)^2) at the distance r:
///
///     g(x) = sqrt(2 / n) sum_i cos(k_i . x + phi_i).
///
/// It is a function of the place alone, so neither a grid nor an order of calls changes it. The wave vectors k_i are
/// drawn from the field's spectrum, a normal distribution of deviation sqrt(2) / l. Shinozuka and Deodatis 1991: Appl.
/// Mech. Rev. 44(4); docs/theory/ice.md, (R1).
class GaussianField {
 public:
  /// @param length  l [m], > 0.
  GaussianField(double length, statistics::RandomStream random);

  /// @param place  [m].
  double at(Vec2 place) const;

 private:
  struct Wave {
    Vec2 vector{};       ///< [1/m]
    double phase = 0.0;  ///< [rad]
  };
  std::vector<Wave> waves_;
};

/// Thickness and flexural strength of level ice from place to place: independent log-normal fields about the ice's own
/// values, which are their means; and its first edge, a Gaussian field about the line x = 0. docs/theory/ice.md, (R2)
/// and (R3).
class Variation {
 public:
  /// Even ice.
  Variation() = default;
  /// The fields of a case: streams of its seed and its replicate.
  explicit Variation(const model::Case& resolved);

  /// Whether thickness or strength vary.
  explicit operator bool() const { return thickness_ || flexural_strength_; }

  /// `ice` with thickness and strength of a place, frame of the level ice [m].
  failure::IceProperties at(const failure::IceProperties& ice, Vec2 place) const;

  /// Corners of the first edge of ice of this width [m], from y = width / 2 to -width / 2; two where it is straight.
  std::vector<Vec2> first_edge(double width) const;

  /// `ice` with the mean thickness and strength over `piece`: in each triangle of its convex parts, the mean over the
  /// middles of the sides. Triangles with sides beyond the correlation length are divided.
  failure::IceProperties mean(const failure::IceProperties& ice, const geometry::Polygon& piece) const;

 private:
  /// A factor of mean 1.
  struct LogNormal {
    GaussianField field;
    double deviation = 0.0;  ///< of the factor's logarithm

    double at(Vec2 place) const;
  };
  static std::optional<LogNormal> field(const model::Case& resolved, double coefficient, const char* purpose);

  double length_ = 0.0;  ///< correlation length [m]
  std::optional<LogNormal> thickness_;
  std::optional<LogNormal> flexural_strength_;

  /// The first edge: x at y is the value of `field`, times `deviation`.
  struct RoughEdge {
    GaussianField field;
    double deviation = 0.0;  ///< [m]
    double spacing = 0.0;    ///< of its corners [m]
  };
  std::optional<RoughEdge> edge_;
};

/// Whether thickness or strength vary.
bool varies(const model::IceSection& ice);

}  // namespace brash::ice
