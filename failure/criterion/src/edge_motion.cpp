// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/failure/edge_motion.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"
#include "brash/failure/edge_break.hpp"
#include "brash/failure/edge_responses.hpp"

namespace brash::failure {
namespace {

/// The lengths of a moving sheet over the lengths of one at rest are sought in this range. They are not longer: on a
/// protrusion the static hump stays where it is at any length, and none may be as far in as the moving one.
constexpr double kShortest = 0.15, kLongest = 1.0;
constexpr int kHalvings = 8;
/// A moment along the edge less than this share of the largest one across the axis passes through zero: its ratio means
/// nothing.
constexpr double kHardlyBent = 0.05;

/// Where the axis is bent, and how much.
struct Bending {
  double largest = 0.0;  ///< moment farther in than h
  double middle = 0.0;   ///< centroid of the hump: of the moments above half the largest one, that half taken off
};

/// @param lengths  the stations are in units of this.
template <typename Moment>
Bending bending_of(const std::vector<double>& station, double lengths, double thickness, const Moment& moment) {
  Bending result;
  std::vector<double> m(station.size());
  for (std::size_t i = 0; i < station.size(); ++i) {
    m[i] = moment(i);
    if (lengths * station[i] >= thickness) result.largest = std::max(result.largest, m[i]);
  }
  double area = 0.0, first = 0.0;
  for (std::size_t i = 0; i < station.size(); ++i) {
    const double width = station[std::min(i + 1, station.size() - 1)] - station[i > 0 ? i - 1 : 0];
    const double weight = width * std::max(0.0, m[i] - 0.5 * result.largest);
    area += weight;
    first += weight * lengths * station[i];
  }
  if (area > 0.0) result.middle = first / area;
  return result;
}

}  // namespace

double EdgeHistory::slope_after(std::size_t knot) const {
  // Beyond the end the force continues as before.
  const std::size_t i = std::min(knot, knots_.size() - 2);
  return (knots_[i + 1].force - knots_[i].force) / (knots_[i + 1].time - knots_[i].time);
}

void EdgeHistory::extend(double time, double force, double memory) {
  BRASH_EXPECTS(time > knots_.back().time && force >= 0.0, time, knots_.back().time, force);
  knots_.push_back({time, force});
  std::size_t n_old = 0;
  double before = settled_.slope;
  while (n_old + 2 < knots_.size() && knots_[n_old].time < time - memory) {
    const double after = slope_after(n_old);
    settled_.slope += after - before;
    settled_.moment += (after - before) * knots_[n_old].time;
    before = after;
    ++n_old;
  }
  knots_.erase(knots_.begin(), knots_.begin() + static_cast<std::ptrdiff_t>(n_old));
}

double EdgeHistory::Weights::of(const double* series, std::size_t stride, double static_value) const {
  double sum = at_rest * static_value;
  for (std::size_t i = 0; i < of_time.size(); ++i)
    if (of_time[i] != 0.0) sum += of_time[i] * series[i * stride];
  return sum;
}

EdgeHistory::Weights EdgeHistory::weights(const std::vector<double>& series_time, double period, double at) const {
  Weights sum{std::vector<double>(series_time.size(), 0.0), 0.0};
  if (knots_.size() < 2) return sum;
  // t F(t) of a slope that began long ago grows by the static value, and keeps its lag at the end.
  const double lag = settled_.slope * period * series_time.back();
  sum.at_rest = settled_.slope * at - settled_.moment - lag;
  sum.of_time.back() = lag;
  double before = settled_.slope;
  for (std::size_t i = 0; i < knots_.size(); ++i) {
    const double age = std::max(0.0, at - knots_[i].time), after = slope_after(i);
    const plate::SeriesWeights w = plate::series_weights(series_time, age / period);
    const double grown = (after - before) * age;
    for (std::size_t j = 0; j < w.weight.size(); ++j) sum.of_time[w.first + j] += grown * w.weight[j];
    sum.at_rest += grown * w.at_rest;
    before = after;
  }
  return sum;
}

EdgeDynamics::EdgeDynamics(Responses responses, const IceProperties& ice, double ice_density)
    : responses_(std::move(responses)),
      ice_(ice),
      l_c_(characteristic_length(ice)),
      period_(std::sqrt(l_c_ / kGravity)),
      ice_density_(ice_density),
      mass_ratio_(mass_ratio(ice, ice_density)) {
  memory_ = period_ * responses_(geometry({.contact_length = ice.thickness}, false)).time.back();
}

EdgeDynamics EdgeDynamics::of_thickness(double thickness) const {
  IceProperties ice = ice_;
  ice.thickness = thickness;
  return {responses_, ice, ice_density_};
}

plate::EdgeGeometry EdgeDynamics::geometry(const LoadCase& load, bool split) const {
  return {.depth = load.depth / l_c_,
          .contact_length = load.contact_length / l_c_,
          .angle = load.angle,
          .mass_ratio = mass_ratio_,
          .thickness = ice_.thickness / l_c_,
          .split = split};
}

double EdgeDynamics::deflection(const LoadCase& load, const EdgeHistory& history, double at) const {
  const plate::EdgeResponses r = responses_(geometry(load, false));
  const double force = history.weights(r.time, period_, at).of(r.deflection.data(), 1, r.static_deflection);
  return force / (load.contact_length * ice_.water_density * kGravity * l_c_);
}

EdgeMotion EdgeDynamics::motion(const LoadCase& load, const EdgeHistory& history) const {
  return {sheet_motion(load, history, false), sheet_motion(load, history, true)};
}

/// Finds the scale of lengths at which the axis of the trapezoid at rest is bent as far in as it is now, then compares
/// the moments under the same force.
SheetMotion EdgeDynamics::sheet_motion(const LoadCase& load, const EdgeHistory& history, bool split) const {
  const plate::EdgeGeometry here = geometry(load, split);
  const plate::EdgeResponses r = responses_(here);
  const EdgeHistory::Weights weights = history.weights(r.time, period_, history.time());
  const double force = history.force();
  const std::size_t n = r.station.size();
  const Bending now = bending_of(r.station, 1.0, here.thickness, [&](std::size_t i) {
    return weights.of(r.axis_moment.data() + i, n, r.static_axis_moment[i]) / force;
  });
  if (!(force > 0.0) || !(now.largest > 0.0)) return {};

  const auto at_rest = [&](double length) {
    plate::EdgeGeometry scaled = here;
    scaled.depth /= length;
    scaled.contact_length /= length;
    scaled.thickness /= length;
    return responses_(scaled);
  };
  const auto bent = [&](const plate::EdgeResponses& rest, double length) {
    return bending_of(rest.station, length, here.thickness,
                      [&](std::size_t i) { return length * rest.static_axis_moment[i]; });
  };
  double shorter = kShortest, longer = kLongest;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = std::sqrt(shorter * longer);
    (bent(at_rest(middle), middle).middle < now.middle ? shorter : longer) = middle;
  }
  SheetMotion result{.length = std::sqrt(shorter * longer)};
  const plate::EdgeResponses rest = at_rest(result.length);
  const double largest = bent(rest, result.length).largest;
  result.stress = now.largest / largest;
  const double radial = weights.of(r.edge_moment.data(), 1, r.static_edge_moment) / force;
  const double radial_at_rest = result.length * rest.static_edge_moment;
  result.radial = std::abs(radial_at_rest) > kHardlyBent * largest ? radial / radial_at_rest : result.stress;
  return result;
}

EdgeDynamics make_edge_dynamics(const IceProperties& ice, double ice_density) {
  const auto source = std::make_shared<const EdgeSource>("");
  return {[source](const plate::EdgeGeometry& geometry) { return source->at(geometry).responses; }, ice, ice_density};
}

}  // namespace brash::failure
