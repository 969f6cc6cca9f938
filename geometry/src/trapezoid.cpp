// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/geometry/trapezoid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"
#include "profile.hpp"

namespace brash::geometry {
namespace {

/// Largest full opening angle that is looked for [rad].
constexpr double kMaxAngle = 150.0 * kPi / 180.0;
/// Coarse search: values of depth, angle and, where it is sought, contact length.
constexpr std::array<int, 3> kGridSize{13, 11, 9};
/// Samples of the profile on each side that the coarse search looks at.
constexpr int kSamples = 48;
/// Coarse minima that are followed.
constexpr std::size_t kStarts = 3;
/// The search stops at steps of this share of the ranges: 1e-4 reach and 0.015 deg.
constexpr double kFinestStep = 1e-4;
/// Above this share of the window a chain counts as distorted (Fig. 4).
constexpr double kDistorted = 0.1;

/// Depth b / reach, angle / kMaxAngle, contact length c / reach: all in [0, 1].
using Shape = std::array<double, 3>;

/// Depth that the sides gain over distance from the centre line; a right side is drawn with a run of a nanometre for
/// each metre of depth.
double rise_of(double angle) { return 1.0 / std::max(1e-9, std::tan(0.5 * angle * kMaxAngle)); }

/// The trapezoid's depth at distance s from the centre line: 0 on the tip edge, b beyond the sides.
struct Outline {
  Outline(const Shape& shape, double reach, double side_rise)
      : half_tip(0.5 * shape[2] * reach), depth(shape[0] * reach), rise(side_rise) {}
  Outline(const Shape& shape, double reach) : Outline(shape, reach, rise_of(shape[1])) {}

  double at(double s) const { return std::min(std::max((s - half_tip) * rise, 0.0), depth); }

  double half_tip;
  double depth;
  double rise;
};

/// Integral of |d| over a length on which d runs linearly from d0 to d1.
double integral_of_magnitude(double d0, double d1, double length) {
  const double sum = std::abs(d0) + std::abs(d1);
  if (d0 * d1 >= 0.0) return 0.5 * sum * length;
  return 0.5 * (d0 * d0 + d1 * d1) / sum * length;
}

/// A sum that makes sum / whole >= limit, whatever is rounded.
double enough_for(double limit, double whole) { return limit * whole * (1.0 + 1e-12); }

/// Area between outline and profile over the window, exact for piecewise linear profiles [-]; or, as soon as it is
/// known to be no less than `limit`, some number that is not either.
double exact_error(const Profile& profile, const Shape& shape, double limit) {
  const double reach = profile.reach();
  const double window = 2.0 * reach * reach;
  const double enough = enough_for(limit, window);
  const Outline outline(shape, reach);
  const std::array<double, 2> corners{outline.half_tip, outline.half_tip + outline.depth / outline.rise};
  double sum = 0.0;
  for (const int which : {0, 1}) {
    for (const Profile::Piece& piece : profile.side(which)) {
      const double slope = (piece.x1 - piece.x0) / (piece.s1 - piece.s0);
      double s = piece.s0, x = piece.x0, f = outline.at(s);
      const auto step_to = [&](double to, double x_to) {
        const double f_to = outline.at(to);
        sum += integral_of_magnitude(x - f, x_to - f_to, to - s);
        s = to, x = x_to, f = f_to;
      };
      for (const double corner : corners) {
        if (corner > s && corner < piece.s1) step_to(corner, piece.x0 + slope * (corner - piece.s0));
      }
      step_to(piece.s1, piece.x1);
      if (sum >= enough) return sum / window;
    }
  }
  return sum / window;
}

/// Both sides of a profile at the middles of kSamples equal strips.
class Samples {
 public:
  explicit Samples(const Profile& profile) : reach_(profile.reach()) {
    for (int i = 0; i < kSamples; ++i) places_[i] = (i + 0.5) / kSamples * reach_;
    for (const int which : {0, 1}) {
      auto piece = profile.side(which).begin();
      for (int i = 0; i < kSamples; ++i) {
        const double s = places_[i];
        while (piece->s1 < s && piece + 1 != profile.side(which).end()) ++piece;
        const double slope = (piece->x1 - piece->x0) / (piece->s1 - piece->s0);
        depths_[i][which] = piece->x0 + slope * (s - piece->s0);
      }
    }
  }

  double reach() const { return reach_; }

  /// The error of `outline` by the midpoint rule; or, as soon as it is known to be no less than `limit`, some number
  /// that is not either.
  double error(const Outline& outline, double limit) const {
    const double whole = 2.0 * kSamples * reach_;
    const double enough = enough_for(limit, whole);
    Sides sum{};
    for (int i = 0; i < kSamples;) {
      for (const int end = i + kLook; i < end; ++i) {
        const double f = outline.at(places_[i]);
        const Sides over = depths_[i] - f, under = f - depths_[i];
        sum += over > under ? over : under;
      }
      if (sum[0] + sum[1] >= enough) break;
    }
    return (sum[0] + sum[1]) / whole;
  }

 private:
  /// Left and right of the centre line.
  using Sides = double __attribute__((vector_size(16)));
  /// Samples between two looks at the limit.
  static constexpr int kLook = 8;
  static_assert(kSamples % kLook == 0);

  double reach_;
  std::array<double, kSamples> places_{};
  std::array<Sides, kSamples> depths_{};
};

struct Candidate {
  double error = std::numeric_limits<double>::infinity();
  Shape shape{};
};

/// The best points of the coarse grid, best first; in a tie the shallower and narrower one.
std::array<Candidate, kStarts> coarse_minima(const Samples& samples, double contact_length, bool is_known) {
  std::array<Candidate, kStarts> best;
  std::array<double, kGridSize[1]> rises{};
  for (int ia = 0; ia < kGridSize[1]; ++ia) rises[ia] = rise_of(ia / (kGridSize[1] - 1.0));
  const int n_c = is_known ? 1 : kGridSize[2];
  for (int ib = 0; ib < kGridSize[0]; ++ib) {
    for (int ia = 0; ia < kGridSize[1]; ++ia) {
      for (int ic = 0; ic < n_c; ++ic) {
        const double c = is_known ? contact_length : static_cast<double>(ic) / (n_c - 1);
        Candidate here{0.0, {ib / (kGridSize[0] - 1.0), ia / (kGridSize[1] - 1.0), c}};
        here.error = samples.error(Outline(here.shape, samples.reach(), rises[ia]), best.back().error);
        for (Candidate& other : best) {
          if (here.error < other.error) std::swap(here, other);
        }
      }
    }
  }
  return best;
}

/// Walks downhill along the axes from `start`, halving `step` where no neighbour is better, down to `finest`. `error`
/// returns the error of a shape, if it is less than a limit.
template <typename Error>
Candidate descend(Candidate start, const Error& error, Shape step, double finest) {
  while (std::max({step[0], step[1], step[2]}) > finest) {
    bool is_better = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (step[axis] == 0.0) continue;
      for (const double sign : {-1.0, 1.0}) {
        Candidate next = start;
        next.shape[axis] = std::clamp(start.shape[axis] + sign * step[axis], 0.0, 1.0);
        if (next.shape[axis] == start.shape[axis]) continue;
        next.error = error(next.shape, start.error);
        if (next.error >= start.error) continue;
        start = next;
        is_better = true;
        break;
      }
    }
    if (is_better) continue;
    for (double& s : step) s *= 0.5;
  }
  return start;
}

/// Best shape over all depths, angles and, unless `contact_length` (in reaches) is known, contact lengths.
Candidate best_shape(const Profile& profile, double contact_length, bool is_known) {
  const Samples samples(profile);
  const auto sampled = [&](const Shape& s, double limit) { return samples.error(Outline(s, samples.reach()), limit); };
  const auto exact = [&](const Shape& s, double limit) { return exact_error(profile, s, limit); };
  const Shape cell{0.5 / (kGridSize[0] - 1), 0.5 / (kGridSize[1] - 1), is_known ? 0.0 : 0.5 / (kGridSize[2] - 1)};
  constexpr double kSampleStep = 0.5 / kSamples;

  Candidate best;
  for (const Candidate& start : coarse_minima(samples, contact_length, is_known)) {
    const Candidate here = descend(start, sampled, cell, kSampleStep);
    if (here.error < best.error) best = here;
  }
  constexpr double kAny = std::numeric_limits<double>::infinity();
  best.error = exact(best.shape, kAny);
  const Shape fine{kSampleStep, kSampleStep, is_known ? 0.0 : kSampleStep};
  best = descend(best, exact, fine, kFinestStep);

  // No protrusion at all wins a tie.
  const Candidate flat{exact({0.0, 0.0, contact_length}, kAny), {0.0, 0.0, contact_length}};
  return flat.error <= best.error ? flat : best;
}

std::vector<std::vector<Vec2>> in_frame(std::span<const std::vector<Vec2>> edges, const FitRequest& request) {
  std::vector<std::vector<Vec2>> result;
  result.reserve(edges.size());
  for (const std::vector<Vec2>& edge : edges) {
    std::vector<Vec2>& line = result.emplace_back();
    line.reserve(edge.size());
    for (const Vec2 p : edge) {
      const Vec2 r = p - request.at;
      line.push_back({dot(r, request.towards), cross(request.towards, r)});
    }
  }
  return result;
}

}  // namespace

Trapezoid fit_trapezoid(std::span<const std::vector<Vec2>> edges, const FitRequest& request) {
  BRASH_EXPECTS(std::isfinite(request.reach) && request.reach >= kGridUnit, request.reach);
  BRASH_EXPECTS(request.contact_length >= 0.0, request.contact_length);
  // A unit vector from a square root and a division is within a few roundings of 1.
  BRASH_EXPECTS(std::abs(norm(request.towards) - 1.0) < 1e-9, request.towards.x, request.towards.y);

  const double reach = request.reach;
  const bool is_known = request.contact_length > 0.0;
  // A tip edge wider than the window leaves nothing of the sides to see.
  const double contact_length = is_known ? std::min(request.contact_length / reach, 2.0) : 0.0;
  const std::vector<std::vector<Vec2>> lines = in_frame(edges, request);

  const auto has_segment = [](const std::vector<Vec2>& line) { return line.size() >= 2; };
  if (std::none_of(edges.begin(), edges.end(), has_segment)) return {0.0, request.contact_length, 0.0, 1.0, true};

  bool is_reidentified = false;
  std::optional<Profile> profile = Profile::of_chain(lines, reach);
  Candidate best;
  if (profile) best = best_shape(*profile, contact_length, is_known);
  if (!profile || best.error > kDistorted) {
    is_reidentified = true;
    best = best_shape(Profile::of_envelope(lines, reach), contact_length, is_known);
  }

  Trapezoid fit{.depth = best.shape[0] * reach,
                .contact_length = is_known ? request.contact_length : best.shape[2] * reach,
                .angle = best.shape[1] * kMaxAngle,
                .error = best.error,
                .reidentified = is_reidentified};
  if (fit.depth == 0.0) fit.angle = 0.0;
  return fit;
}

}  // namespace brash::geometry
