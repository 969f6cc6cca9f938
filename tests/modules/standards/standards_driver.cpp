// SPDX-License-Identifier: GPL-3.0-or-later
// Reads inputs of the closed forms as JSON from stdin and prints their loads, for scipy_check.py to compare.
#include <iostream>
#include <nlohmann/json.hpp>

#include "brash/standards/lindqvist.hpp"
#include "brash/standards/ralston.hpp"

namespace {

using namespace brash::standards;
using nlohmann::json;

json ralston_json(const json& in) {
  RalstonInput input;
  input.slope = in["slope"];
  input.waterline_width = in["waterline_width"];
  input.end_width = in["end_width"];
  input.thickness = in["thickness"];
  input.ride_thickness = in["ride_thickness"];
  input.flexural_strength = in["flexural_strength"];
  input.friction_structure = in["friction"];
  input.ice_density = in["ice_density"];
  input.water_density = in["water_density"];
  input.breaking = in["downward"] ? Breaking::kDownward : Breaking::kUpward;
  input.yield = in["tresca"] ? Yield::kTresca : Yield::kJohansen;
  const auto load = ralston(input);
  if (!load) return nullptr;
  return {load->breaking_horizontal, load->ride_horizontal, load->breaking_vertical, load->ride_vertical,
          load->horizontal, load->vertical, load->radius_ratio};
}

json lindqvist_json(const json& in) {
  LindqvistInput input;
  input.length = in["length"];
  input.breadth = in["breadth"];
  input.draught = in["draught"];
  input.stem_angle = in["stem_angle"];
  input.waterline_angle = in["waterline_angle"];
  input.speed = in["speed"];
  input.thickness = in["thickness"];
  input.flexural_strength = in["flexural_strength"];
  input.youngs_modulus = in["youngs_modulus"];
  input.poisson_ratio = in["poisson_ratio"];
  input.friction = in["friction"];
  input.ice_density = in["ice_density"];
  input.water_density = in["water_density"];
  const auto load = lindqvist(input);
  if (!load) return nullptr;
  return {load->crushing, load->bending, load->submersion, load->total};
}

}  // namespace

int main() {
  const json in = json::parse(std::cin);
  json out{{"ralston", json::array()}, {"lindqvist", json::array()}};
  for (const json& input : in["ralston"]) out["ralston"].push_back(ralston_json(input));
  for (const json& input : in["lindqvist"]) out["lindqvist"].push_back(lindqvist_json(input));
  std::cout << out << '\n';
}
