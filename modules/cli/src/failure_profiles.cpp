// SPDX-License-Identifier: GPL-3.0-or-later
#include "failure_profiles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace brash::cli {
namespace {

/// Order statistic at `share` of the values.
double quantile(std::vector<double> values, double share) {
  const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}

void print_line(const char* name, const std::vector<double>& stress, const std::vector<double>& length) {
  if (stress.empty()) return;
  fmt::print(
      "{:<24} {:>6} rows  stress error median {:.2f} %, 95 % {:.2f} %, max {:.2f} %; "
      "length error median {:.4f}, 95 % {:.4f} l_c\n",
      name, stress.size(), 100 * quantile(stress, 0.5), 100 * quantile(stress, 0.95), 100 * quantile(stress, 1.0),
      quantile(length, 0.5), quantile(length, 0.95));
}

}  // namespace

meta_model::ProfileSample to_profile_sample(const database::Record& record) {
  const plate::UnitProfiles& unit = record.profiles;
  meta_model::ProfileSample sample{{record.plate.depth, record.plate.contact_length, record.plate.angle}, {}};
  meta_model::Profiles& p = sample.profiles;
  p.station = unit.station;
  for (std::size_t i = 0; i < unit.station.size(); ++i) {
    p.bending_xx.push_back(unit.bending[i].xx);
    p.bending_yy.push_back(unit.bending[i].yy);
    p.normal_xx.push_back(unit.normal[i].xx);
    p.normal_yy.push_back(unit.normal[i].yy);
    p.tangential_xy.push_back(unit.tangential[i].xy);
  }
  return sample;
}

plate::UnitProfiles to_unit_profiles(const meta_model::Profiles& p) {
  plate::UnitProfiles unit;
  unit.station = p.station;
  for (std::size_t i = 0; i < p.station.size(); ++i) {
    unit.bending.push_back({p.bending_xx[i], p.bending_yy[i], 0.0});
    unit.normal.push_back({p.normal_xx[i], p.normal_yy[i], 0.0});
    unit.tangential.push_back({0.0, 0.0, p.tangential_xy[i]});
  }
  return unit;
}

void print_profile_errors(const meta_model::ProfileModel& model, const std::vector<const database::Record*>& records) {
  constexpr double kStressThatMatters = 0.25;  // below this sigma/p the ice is crushed before it bends
  std::vector<double> stress, length, stress_that_matters, length_there;
  for (const database::Record* record : records) {
    const plate::UnitProfiles unit = to_unit_profiles(
        model.predict(model.clamp({record->plate.depth, record->plate.contact_length, record->plate.angle})));
    for (const database::Row& row : record->rows) {
      const plate::Response r = plate::respond(unit, record->plate.thickness, row.load.mu1, row.load.mu2);
      stress.push_back(std::abs(r.sigma_over_p / row.response.sigma_over_p - 1.0));
      length.push_back(std::abs(r.lbreak_over_lc - row.response.lbreak_over_lc));
      if (row.response.sigma_over_p < kStressThatMatters) continue;
      stress_that_matters.push_back(stress.back());
      length_there.push_back(length.back());
    }
  }
  print_line("test", stress, length);
  print_line("test, sigma/p >= 0.25", stress_that_matters, length_there);
}

}  // namespace brash::cli
