// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "brash/failure/unit_profiles.hpp"
#include "brash/training/hump_training.hpp"

namespace brash::training {
namespace {

plate::Tensor2 between(const plate::Tensor2& a, const plate::Tensor2& b, double share) {
  return {a.xx + share * (b.xx - a.xx), a.yy + share * (b.yy - a.yy), a.xy + share * (b.xy - a.xy)};
}

using Field = std::vector<plate::Tensor2> plate::UnitProfiles::*;
constexpr std::array<Field, 3> kFields{&plate::UnitProfiles::bending, &plate::UnitProfiles::normal,
                                       &plate::UnitProfiles::tangential};

void add_station(const plate::UnitProfiles& from, std::size_t i, plate::UnitProfiles& to) {
  to.station.push_back(from.station[i]);
  for (const Field field : kFields) (to.*field).push_back((from.*field)[i]);
}

/// The profiles up to kHumpBoundary and from there; both hold it as a station.
std::array<plate::UnitProfiles, kHumps> cut(const plate::UnitProfiles& whole) {
  const auto& x = whole.station;
  const auto first_far =
      static_cast<std::size_t>(std::upper_bound(x.begin(), x.end() - 1, meta_model::kHumpBoundary) - x.begin());
  plate::UnitProfiles at;
  const double share = (meta_model::kHumpBoundary - x[first_far - 1]) / (x[first_far] - x[first_far - 1]);
  at.station.push_back(meta_model::kHumpBoundary);
  for (const Field field : kFields) {
    (at.*field).push_back(between((whole.*field)[first_far - 1], (whole.*field)[first_far], share));
  }
  std::array<plate::UnitProfiles, kHumps> parts;
  for (std::size_t i = 0; i < first_far; ++i) add_station(whole, i, parts[0]);
  for (plate::UnitProfiles& part : parts) add_station(at, 0, part);
  for (std::size_t i = first_far; i < x.size(); ++i) add_station(whole, i, parts[1]);
  return parts;
}

}  // namespace

HumpSample hump_sample(const meta_model::ProfileModel& model, const Input& input, double thickness_over_lc) {
  const meta_model::Geometry geometry = model.clamp({input.b_lc, input.c_lc, input.theta, thickness_over_lc});
  const auto parts = cut(failure::to_unit_profiles(model.predict(geometry)));
  HumpSample sample{{geometry.b_lc, geometry.c_lc, geometry.theta, input.mu1, input.mu2}, {}};
  for (std::size_t hump = 0; hump < parts.size(); ++hump) {
    const plate::Response r = plate::respond(parts[hump], thickness_over_lc, input.mu1, input.mu2);
    sample.humps[hump] = {{r.sigma_over_p, r.lbreak_over_lc}, r.plateau_from, r.plateau_to};
  }
  return sample;
}

}  // namespace brash::training
