// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/failure/edge_break.hpp"

#include <algorithm>
#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"

namespace brash::failure {
namespace {

/// Steps to the break of the first try, by the static answer, and the fewest of the last one.
constexpr int kFirstSteps = 200;
constexpr int kFewestSteps = 120;
/// Most of the load's change in a step that the edge's own motion in that step may take back. The contact is stiff:
/// from 1 on, linear loads between the steps make it oscillate.
constexpr double kMostFeedback = 0.1;
/// A slower edge [m/s] breaks as one at rest, within 0.01 %. Followed in time, it would take steps without end.
constexpr double kSlowest = 1e-3;
/// No edge needs so many times its static time.
constexpr int kLongest = 20;

/// One edge under one push, SI.
class PushedEdge {
 public:
  PushedEdge(const plate::EdgeResponses& responses, const IceProperties& ice, const EdgePush& push)
      : responses_(responses),
        ice_(ice),
        push_(push),
        l_c_(characteristic_length(ice)),
        period_(std::sqrt(l_c_ / kGravity)),
        flexibility_(1.0 / (ice.water_density * kGravity * l_c_)),
        cot_(1.0 / std::tan(push.slope)),
        stiffness_(ice.compressive_strength * ice.crushing_factor * push.contact_length *
                   (std::tan(push.slope) + push.friction)) {
    profiles_.station = responses.station;
    for (const double n : responses.axis_normal) profiles_.normal.push_back({n, 0.0, 0.0});
    profiles_.normal.front().yy = responses.edge_normal;
    profiles_.tangential.resize(profiles_.station.size());
    profiles_.bending.resize(profiles_.station.size());
  }

  EdgeBreak at_rest() {
    set_moments(std::vector<double>(responses_.time.size(), 0.0), 1.0);
    const plate::Response r = respond();
    const double load = load_at(r.sigma_over_p);
    EdgeBreak result{.load = load,
                     .deflection = flexibility_ * responses_.static_deflection * line_load(load),
                     .breaking_length = l_c_ * r.lbreak_over_lc};
    note_radial(r, load_at(r.sigma_radial_over_p), result);
    return result;
  }

  /// Steps of `dt` until it breaks.
  EdgeBreak follow(double dt, double longest) {
    slopes_.clear();
    moved_.clear();
    weights_.assign(1, {});
    EdgeBreak before, now;
    double stress_before = 0.0;
    while (true) {
      step(dt, now);
      BRASH_EXPECTS(now.time < longest, now.time, longest, now.load);
      const plate::Response r = respond();
      const double pressure = now.load / (push_.contact_length * ice_.thickness);
      const double stress = r.sigma_over_p * pressure;
      now.breaking_length = l_c_ * r.lbreak_over_lc;
      if (now.radial_load == 0.0 && r.sigma_radial_over_p * pressure > ice_.flexural_strength)
        now.radial_load = now.load;
      if (stress > ice_.flexural_strength)
        return between(before, now, (ice_.flexural_strength - stress_before) / (stress - stress_before));
      stress_before = stress;
      before = now;
    }
  }

  /// `dt`, or a shorter step whose feedback is small.
  double stable_step(double dt) const {
    const auto feedback = [&] {
      return push_.mu1 * stiffness_ / push_.contact_length * cot_ * flexibility_ *
             ramp_deflection(plate::series_weights(responses_.time, dt / period_));
    };
    while (feedback() > kMostFeedback) dt *= 0.7;
    return dt;
  }

  /// The time in which the surface would break a static edge.
  double time_at_rest() {
    const EdgeBreak rest = at_rest();
    return (rest.load / stiffness_ + rest.deflection * cot_) / push_.speed;
  }

 private:
  double line_load(double load) const { return push_.mu1 * load / push_.contact_length; }
  double load_at(double sigma_over_p) const {
    return sigma_over_p > 0.0 ? ice_.flexural_strength / sigma_over_p * push_.contact_length * ice_.thickness : 0.0;
  }
  plate::Response respond() const { return plate::respond(profiles_, ice_.thickness / l_c_, push_.mu1, 0.0); }

  void note_radial(const plate::Response& r, double load, EdgeBreak& result) const {
    result.radial_first = r.sigma_radial_over_p > r.sigma_over_p;
    result.radial_load = result.radial_first ? load : 0.0;
  }

  static EdgeBreak between(const EdgeBreak& a, const EdgeBreak& b, double share) {
    const auto mix = [share](double x, double y) { return x + share * (y - x); };
    EdgeBreak result = b;
    result.load = mix(a.load, b.load);
    result.time = mix(a.time, b.time);
    result.deflection = mix(a.deflection, b.deflection);
    result.radial_first = b.radial_load > 0.0 && b.radial_load <= result.load;
    if (!result.radial_first) result.radial_load = 0.0;
    return result;
  }

  /// Moments over Q l_c as a sum over the times of the responses and the static ones.
  void set_moments(const std::vector<double>& weights, double of_static) {
    const std::size_t n = responses_.station.size();
    for (std::size_t s = 0; s < n; ++s) {
      double xx = of_static * responses_.static_axis_moment[s];
      for (std::size_t i = 0; i < weights.size(); ++i)
        if (weights[i] != 0.0) xx += weights[i] * responses_.axis_moment[i * n + s];
      profiles_.bending[s].xx = xx;
    }
    double yy = of_static * responses_.static_edge_moment;
    for (std::size_t i = 0; i < weights.size(); ++i) yy += weights[i] * responses_.edge_moment[i];
    profiles_.bending.front().yy = yy;
  }

  double ramp_deflection(const plate::SeriesWeights& w) const {
    double sum = w.at_rest * responses_.static_deflection;
    for (std::size_t i = 0; i < w.weight.size(); ++i) sum += w.weight[i] * responses_.deflection[w.first + i];
    return sum;
  }

  /// The next step of the linear contact, implicit: Duhamel's integral over a load with a slope in each step.
  void step(double dt, EdgeBreak& now) {
    const std::size_t n = slopes_.size() + 1;
    const double age = static_cast<double>(n) * dt;
    weights_.push_back(plate::series_weights(responses_.time, age / period_));
    moved_.push_back(flexibility_ * age * ramp_deflection(weights_.back()));
    double known = 0.0;
    for (std::size_t k = 0; k + 1 < n; ++k) known += slopes_[k] * (moved_[n - k - 1] - moved_[n - k - 2]);
    const double per_depth = push_.mu1 * stiffness_ / push_.contact_length;
    const double before = line_load(now.load);
    const double missing = per_depth * (push_.speed * age - cot_ * known) - before;
    const double slope = std::max(missing / (dt + per_depth * cot_ * moved_.front()), -before / dt);
    slopes_.push_back(slope);
    now.load += slope * dt * push_.contact_length / push_.mu1;
    now.time = age;
    now.deflection = known + slope * moved_.front();
    superpose_moments(dt, line_load(now.load));
  }

  /// The moments over Q l_c of all slopes so far, for the line load Q.
  void superpose_moments(double dt, double line) {
    std::vector<double> of_times(responses_.time.size(), 0.0);
    double of_static = 0.0;
    const auto add = [&](double slope, std::size_t age) {
      const double factor = slope * static_cast<double>(age) * dt / line;
      const plate::SeriesWeights& w = weights_[age];
      for (std::size_t i = 0; i < w.weight.size(); ++i) of_times[w.first + i] += factor * w.weight[i];
      of_static += factor * w.at_rest;
    };
    for (std::size_t k = 0; k < slopes_.size() && line > 0.0; ++k) {
      add(slopes_[k], slopes_.size() - k);
      add(-slopes_[k], slopes_.size() - k - 1);
    }
    set_moments(of_times, of_static);
  }

  const plate::EdgeResponses& responses_;
  const IceProperties& ice_;
  const EdgePush& push_;
  double l_c_;
  double period_;       ///< T = sqrt(l_c / g)
  double flexibility_;  ///< 1 / (rho_w g l_c)
  double cot_;
  double stiffness_;  ///< N / d
  plate::UnitProfiles profiles_;
  std::vector<double> slopes_;                 ///< of the line load in every step
  std::vector<plate::SeriesWeights> weights_;  ///< of the responses 0, 1, 2, ... steps after a slope began
  std::vector<double> moved_;                  ///< by a unit slope of the line load, 1, 2, ... steps ago
};

void expect_valid(const EdgePush& push) {
  BRASH_EXPECTS(push.slope > 0.0 && push.slope < 0.5 * kPi, push.slope);
  BRASH_EXPECTS(push.mu1 > 0.0 && push.contact_length > 0.0, push.mu1, push.contact_length);
}

}  // namespace

double mass_ratio(const IceProperties& ice, double ice_density) {
  return ice_density * ice.thickness / (ice.water_density * characteristic_length(ice));
}

EdgeBreak break_edge_at_rest(const plate::EdgeResponses& responses, const IceProperties& ice, const EdgePush& push) {
  expect_valid(push);
  return PushedEdge(responses, ice, push).at_rest();
}

EdgeBreak break_edge(const plate::EdgeResponses& responses, const IceProperties& ice, const EdgePush& push) {
  expect_valid(push);
  BRASH_EXPECTS(push.speed > 0.0, push.speed);
  PushedEdge edge(responses, ice, push);
  const double longest = edge.time_at_rest();
  if (push.speed < kSlowest) {
    EdgeBreak rest = edge.at_rest();
    rest.time = longest;
    return rest;
  }
  double dt = edge.stable_step(longest / kFirstSteps);
  for (;;) {
    const EdgeBreak result = edge.follow(dt, kLongest * longest);
    if (result.time >= kFewestSteps * dt) return result;
    dt = result.time / kFirstSteps;  // a shorter one
  }
}

}  // namespace brash::failure
