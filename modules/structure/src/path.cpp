// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/structure/path.hpp"

#include <algorithm>
#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"

namespace brash::structure {
namespace {

/// Slopes that differ by less, over the sum of the four, are the same: some 1e6 roundings. Were it 0, rounding would
/// set the weights at the corner of two straight parts.
constexpr double kSameSlope = 1e-9;

/// Akima's slope between the second and the third of four chords' slopes.
double akima(double a, double b, double c, double d) {
  const double before = std::abs(b - a), after = std::abs(d - c);
  if (before + after <= kSameSlope * (std::abs(a) + std::abs(b) + std::abs(c) + std::abs(d))) return 0.5 * (b + c);
  return (after * b + before * c) / (before + after);
}

}  // namespace

Path::Path(const std::vector<model::Waypoint>& rows) {
  BRASH_EXPECTS(rows.size() >= 2, rows.size());
  for (const model::Waypoint& row : rows) {
    BRASH_EXPECTS(times_.empty() || row.time > times_.back(), row.time);
    const double turns = values_.empty() ? 0.0 : std::round((row.heading - values_.back()[2]) / (2.0 * kPi));
    times_.push_back(row.time);
    values_.push_back({row.position.x, row.position.y, row.heading - 2.0 * kPi * turns});
  }
  const std::size_t n = times_.size();
  slopes_.resize(n);
  for (std::size_t k = 0; k < 3; ++k) {
    // Two chords more at each end continue the change of the last two.
    std::vector<double> chords(n + 3);
    for (std::size_t i = 0; i + 1 < n; ++i)
      chords[i + 2] = (values_[i + 1][k] - values_[i][k]) / (times_[i + 1] - times_[i]);
    const double first = n > 2 ? chords[3] - chords[2] : 0.0, last = n > 2 ? chords[n] - chords[n - 1] : 0.0;
    chords[1] = chords[2] - first;
    chords[0] = chords[1] - first;
    chords[n + 1] = chords[n] + last;
    chords[n + 2] = chords[n + 1] + last;
    for (std::size_t i = 0; i < n; ++i) slopes_[i][k] = akima(chords[i], chords[i + 1], chords[i + 2], chords[i + 3]);
  }
}

Pose Path::at(double time) const {
  const double t = std::clamp(time, times_.front(), times_.back());
  const auto above = std::upper_bound(times_.begin() + 1, times_.end() - 1, t);
  const auto i = static_cast<std::size_t>(above - times_.begin()) - 1;
  const double length = times_[i + 1] - times_[i], s = (t - times_[i]) / length;
  Values now{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double h10 = s * (1.0 - s) * (1.0 - s), h01 = s * s * (3.0 - 2.0 * s), h11 = s * s * (s - 1.0);
    now[k] = (1.0 - h01) * values_[i][k] + h01 * values_[i + 1][k] +
             length * (h10 * slopes_[i][k] + h11 * slopes_[i + 1][k]);
  }
  return {{now[0], now[1], 0.0}, {std::cos(0.5 * now[2]), 0.0, 0.0, std::sin(0.5 * now[2])}};
}

}  // namespace brash::structure
