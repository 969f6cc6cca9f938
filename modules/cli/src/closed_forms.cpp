// SPDX-License-Identifier: GPL-3.0-or-later
#include "closed_forms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/standards/nevel.hpp"

namespace brash::cli {

using nlohmann::ordered_json;

tl::expected<standards::CroasdaleLoad, standards::NotApplicable> croasdale_of(const io::Case& c) {
  standards::CroasdaleInput input;
  input.slope = c.structure.angle;
  input.width = c.structure.waterline_width;
  input.thickness = c.ice.thickness;
  input.flexural_strength = c.ice.flexural_strength;
  input.youngs_modulus = c.ice.youngs_modulus;
  input.poisson_ratio = c.ice.poisson_ratio;
  input.friction_structure = c.ice.friction_structure;
  input.friction_ice = c.ice.friction_ice;
  input.ice_density = c.ice.density;
  input.water_density = c.water.density;
  return standards::croasdale(input);
}

tl::expected<standards::RalstonLoad, standards::NotApplicable> ralston_of(const io::Case& c, standards::Yield yield) {
  const bool downward = c.structure.breaking == "downward";
  const double slope_height =
      downward ? c.structure.height_under_water : c.structure.height - c.structure.height_under_water;
  standards::RalstonInput input;
  input.slope = c.structure.angle;
  input.waterline_width = c.structure.waterline_width;
  input.end_width = std::max(0.0, c.structure.waterline_width - 2.0 * slope_height / std::tan(c.structure.angle));
  input.thickness = c.ice.thickness;
  input.flexural_strength = c.ice.flexural_strength;
  input.friction_structure = c.ice.friction_structure;
  input.ice_density = c.ice.density;
  input.water_density = c.water.density;
  input.breaking = downward ? standards::Breaking::kDownward : standards::Breaking::kUpward;
  input.yield = yield;
  return standards::ralston(input);
}

namespace {

ordered_json refused(const char* method, const char* source, const standards::NotApplicable& why) {
  return {{"method", method}, {"source", source}, {"not_applicable", why.reason}};
}

ordered_json croasdale_json(const io::Case& c) {
  constexpr const char* kMethod = "elastic beam, no rubble, weight in air";
  constexpr const char* kSource = "ISO 19906, A.8.2.4.4 (Croasdale)";
  const auto load = croasdale_of(c);
  if (!load) return refused(kMethod, kSource, load.error());
  return {{"method", kMethod},
          {"source", kSource},
          {"horizontal", load->horizontal},
          {"vertical", load->vertical},
          {"components",
           {{"H_B", load->breaking},
            {"H_P", load->pushing},
            {"H_R", load->ride_up},
            {"H_L", load->lifting},
            {"H_T", load->turning}}},
          {"in_plane_factor", load->in_plane_factor},
          {"characteristic_length", load->characteristic_length},
          {"crack_length", load->crack_length}};
}

ordered_json ralston_json(const io::Case& c, standards::Yield yield) {
  const std::string method =
      fmt::format("plastic cone, {} breaking, {}", c.structure.breaking,
                  yield == standards::Yield::kTresca ? "Tresca (Y = 2.711)" : "Johansen (Y = 3.422)");
  constexpr const char* kSource = "ISO 19906, A.8.2.4.4 (Ralston)";
  const auto load = ralston_of(c, yield);
  if (!load) return refused(method.c_str(), kSource, load.error());
  return {{"method", method},
          {"source", kSource},
          {"horizontal", load->horizontal},
          {"vertical", load->vertical},
          {"components", {{"H_B", load->breaking_horizontal}, {"H_R", load->ride_horizontal}}},
          {"radius_ratio", load->radius_ratio}};
}

/// One break: the half disc in front of a contact, divided into wedges, each loaded over one thickness from its tip.
ordered_json nevel_json(const io::Case& c, int wedges) {
  standards::NevelInput input;
  input.wedge_angle = kPi / wedges;
  input.loaded_length = c.ice.thickness;
  input.thickness = c.ice.thickness;
  input.flexural_strength = c.ice.flexural_strength;
  input.youngs_modulus = c.ice.youngs_modulus;
  input.water_density = c.water.density;
  const standards::NevelLoad load = standards::nevel(input);
  // Friction on the slope inclines the force by atan(mu) from its normal.
  const double inclination = c.structure.angle + std::atan(c.ice.friction_structure);
  ordered_json out{{"method", fmt::format("one break of {} wedges, loaded over one thickness", wedges)},
                   {"source", "Nevel 1972, narrow wedges"}};
  if (inclination >= 0.5 * kPi) {
    out["not_applicable"] = "the ice locks: tan(slope) >= 1/friction";
    return out;
  }
  const double vertical = wedges * load.vertical;
  out["horizontal"] = vertical * std::tan(inclination);
  out["vertical"] = vertical;
  out["components"] = {{"P of one wedge", load.vertical}};
  out["in_range"] = load.in_range;
  return out;
}

}  // namespace

ordered_json closed_form_loads(const io::Case& c) {
  ordered_json loads = ordered_json::array();
  loads.push_back(croasdale_json(c));
  loads.push_back(ralston_json(c, standards::Yield::kTresca));
  loads.push_back(ralston_json(c, standards::Yield::kJohansen));
  for (int wedges = c.failure.wedges[0]; wedges <= c.failure.wedges[1]; ++wedges)
    loads.push_back(nevel_json(c, wedges));
  return {{"case", c.name}, {"kind", "peaks of one breaking event, not means"}, {"loads", loads}};
}

}  // namespace brash::cli
