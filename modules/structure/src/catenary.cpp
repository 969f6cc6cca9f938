// SPDX-License-Identifier: GPL-3.0-or-later
#include "catenary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "brash/core/contract.hpp"

namespace brash::structure {
namespace {

/// Integral of the tension T and of T^2 / 2 E A along the part of a line that hangs, from the vertical force 0 or
/// `bottom` at its lower end to `top` [N m].
double hanging(const Line& line, double h, double bottom, double top) {
  const auto tension = [&](double v) {
    return 0.5 * (v * std::hypot(h, v) + (h > 0.0 ? h * h * std::asinh(v / h) : 0.0));
  };
  const auto square = [&](double v) { return h * h * v + v * v * v / 3.0; };
  return (tension(top) - tension(bottom) + 0.5 * (square(top) - square(bottom)) / line.stiffness) / line.weight;
}

/// The line under the pull (h, v) of its upper end, h > 0: the place of that end, its derivatives and the energy that
/// is complementary to the line's. The place is the gradient of that energy, which is convex.
struct Shape {
  double span = 0.0, rise = 0.0;
  double span_by_h = 0.0, span_by_v = 0.0, rise_by_v = 0.0;
  double complementary = 0.0;
};

Shape shape_under(const Line& line, double h, double v) {
  const double w = line.weight, flexible = line.length / line.stiffness;
  const double bottom = std::max(0.0, v - w * line.length), top = std::hypot(h, v);
  const double resting = std::max(0.0, line.length - v / w);
  const double low = std::hypot(h, bottom);
  Shape s;
  const double angles = std::asinh(v / h) - std::asinh(bottom / h);
  s.span = resting + h / w * angles + h * flexible;
  s.rise = (top - low) / w + 0.5 * (v * v - bottom * bottom) / (w * line.stiffness);
  s.span_by_h = (angles - v / top + bottom / low) / w + flexible;
  s.span_by_v = h / w * (1.0 / top - 1.0 / low);
  s.rise_by_v = (v / top - bottom / low) / w + (v - bottom) / (w * line.stiffness);
  s.complementary = hanging(line, h, bottom, v) + resting * (h + 0.5 * h * h / line.stiffness);
  return s;
}

/// Ends closer than this to where they should be are there, over the line's length.
constexpr double kClose = 1e-13;

/// The pull of a line that hangs off the bed, nearly upright: to first order in the span. Its weight and the pull of
/// its lower end stretch it. It holds where the horizontal force is small against that end's vertical one.
LinePull upright(const Line& line, double span, double rise) {
  const double w = line.weight, ea = line.stiffness;
  const double v = ea * (rise / line.length - 1.0) + 0.5 * w * line.length;
  const double bottom = std::max(0.0, v - w * line.length);
  const double h = bottom > 0.0 ? span / (std::log(v / bottom) / w + line.length / ea) : 0.0;
  return {h, v, v * rise + 0.5 * h * span - hanging(line, 0.0, bottom, v)};
}

/// A line nearly upright, and otherwise the start of Jonkman (2007, NREL/TP-500-41958, Eqs. 2-37 and 2-38).
void first_guess(const Line& line, double span, double rise, double& h, double& v) {
  if (const LinePull near = upright(line, span, rise);
      near.horizontal < 0.1 * (near.downward - line.weight * line.length)) {
    h = near.horizontal;
    v = near.downward;
    return;
  }
  const double l2 = line.length * line.length, chord2 = span * span + rise * rise;
  const double lambda = chord2 >= l2 ? 0.2 : std::sqrt(3.0 * ((l2 - rise * rise) / (span * span) - 1.0));
  h = std::abs(0.5 * line.weight * span / lambda);
  v = 0.5 * line.weight * (rise / std::tanh(lambda) + line.length);
}

}  // namespace

/// The pull is where `complementary - h span - v rise` is least: Newton's steps, halved until it falls. At one rise the
/// vertical force grows with the span, so the slack or upright line bounds it from below. Without the bound a
/// first guess too high lets both forces shrink together to nothing.
LinePull pull_of(const Line& line, double span, double rise) {
  BRASH_EXPECTS(line.length > 0.0 && line.weight > 0.0 && line.stiffness > 0.0 && span >= 0.0 && rise > 0.0,
                line.length, line.weight, line.stiffness, span, rise);
  // A slack line hangs straight down and lies on the bed.
  const double w = line.weight, ea = line.stiffness;
  const double hung = ea * (std::sqrt(1.0 + 2.0 * w * rise / ea) - 1.0);
  const bool rests = hung <= w * line.length;
  if (rests && span <= line.length - hung / w) return {0.0, hung, hung * rise - hanging(line, 0.0, 0.0, hung)};
  const LinePull beside = upright(line, span, rise);
  if (span <= kClose * line.length) return beside;
  const double least_v = rests ? hung : beside.downward;

  constexpr int kMostSteps = 200;
  double h = 0.0, v = 0.0;
  first_guess(line, span, rise, h, v);
  v = std::max(v, least_v);
  Shape s = shape_under(line, h, v);
  const auto height = [&](const Shape& at, double x, double z) { return at.complementary - x * span - z * rise; };
  const auto distance = [&](const Shape& at) { return std::hypot(span - at.span, rise - at.rise); };
  for (int i = 0; i < kMostSteps; ++i) {
    const double dx = span - s.span, dz = rise - s.rise;
    if (distance(s) <= kClose * line.length) break;
    const double det = s.span_by_h * s.rise_by_v - s.span_by_v * s.span_by_v;
    const double dh = (s.rise_by_v * dx - s.span_by_v * dz) / det, dv = (s.span_by_h * dz - s.span_by_v * dx) / det;
    bool moved = false;
    for (double share = 1.0; share > 1e-12 && !moved; share *= 0.5) {
      const double next_h = std::max(h + share * dh, 0.1 * h), next_v = std::max(v + share * dv, least_v);
      const Shape next = shape_under(line, next_h, next_v);
      // Near the least value rounding hides its fall, and the distance still falls.
      moved = height(next, next_h, next_v) < height(s, h, v) || (share == 1.0 && distance(next) < distance(s));
      if (!moved) continue;
      h = next_h;
      v = next_v;
      s = next;
    }
    if (!moved) break;  // as near as the rounding allows
  }
  const double rounding =
      16.0 * std::numeric_limits<double>::epsilon() * std::hypot(h, v) / w;  // of a taut line's rise
  BRASH_EXPECTS(distance(s) < 1e-9 * line.length + rounding, line.length, w, ea, span, rise, h, v);
  return {h, v, h * span + v * rise - s.complementary};
}

}  // namespace brash::structure
