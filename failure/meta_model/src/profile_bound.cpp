// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/meta_model/profile_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "profile_shape.hpp"

namespace brash::meta_model {
namespace {

/// Values of each of b, ln(c) and theta in the lattice.
constexpr int kLattice = 7;
/// A place where the load has spread over many times the width of any base line, over l_c.
constexpr double kFar = 1e3;

double largest(const std::vector<double>& values, double so_far) {
  for (const double value : values) so_far = std::max(so_far, std::abs(value));
  return so_far;
}

/// The beam's moment is a ratio of two linear functions of the place before the base line and behind it, so it is
/// largest at an end of either.
double bending_scale(const Geometry& g) {
  return 1.0 / std::min({beam_at(g, 0.0).bending, beam_at(g, g.b_lc).bending, beam_at(g, g.b_lc + kFar).bending});
}

/// A narrow protrusion that f pushes sideways presses on its root with the lever b over the width there.
double tangential_scale(const Geometry& g) { return 1.0 + g.b_lc / base_width(g); }

template <typename Visit>
void visit_lattice(const std::array<Geometry, 2>& range, double h_lc, Visit visit) {
  const auto& [low, high] = range;
  for (int i = 0; i < kLattice; ++i)
    for (int j = 0; j < kLattice; ++j)
      for (int k = 0; k < kLattice; ++k) {
        const auto between = [](double a, double b, int n) { return a + n * (b - a) / (kLattice - 1.0); };
        const double ln_c = between(std::log(low.c_lc), std::log(high.c_lc), j);
        visit(Geometry{.b_lc = between(low.b_lc, high.b_lc, i),
                       .c_lc = std::clamp(std::exp(ln_c), low.c_lc, high.c_lc),
                       .theta = between(low.theta, high.theta, k),
                       .h_lc = h_lc});
      }
}

}  // namespace

ProfileBound::ProfileBound(const ProfileModel& model, double h_lc) {
  most_.buckling_load = std::numeric_limits<double>::infinity();
  visit_lattice(model.range(), h_lc, [&](const Geometry& geometry) {
    const Profiles p = model.predict(model.clamp(geometry), true);
    const double of_bending = bending_scale(geometry), of_tangential = tangential_scale(geometry);
    most_.bending = std::max(most_.bending, largest(p.bending_yy, largest(p.bending_xx, 0.0)) / of_bending);
    most_.normal = largest(p.normal_yy, largest(p.normal_xx, most_.normal));
    most_.tangential = std::max(most_.tangential, largest(p.tangential_xy, 0.0) / of_tangential);
    most_.first = std::max(most_.first, largest(p.first_yy, largest(p.first_xx, 0.0)) / of_bending);
    most_.rest = std::max(most_.rest, largest(p.rest_yy, largest(p.rest_xx, 0.0)) / of_bending);
    most_.buckling_load = std::min(most_.buckling_load, p.buckling_load);
  });
}

ProfileExtremes ProfileBound::at(const Geometry& geometry) const {
  const double of_bending = bending_scale(geometry);
  return {.bending = most_.bending * of_bending,
          .normal = most_.normal,
          .tangential = most_.tangential * tangential_scale(geometry),
          .first = most_.first * of_bending,
          .rest = most_.rest * of_bending,
          .buckling_load = most_.buckling_load};
}

}  // namespace brash::meta_model
