// SPDX-License-Identifier: GPL-3.0-or-later
// Reads inputs of the closed forms as JSON from stdin and prints their loads, for scipy_check.py to compare.
#include <array>
#include <iostream>
#include <nlohmann/json.hpp>

#include "brash/standards/inputs.hpp"

namespace {

using namespace brash::standards;
using nlohmann::json;

/// The numbers of an input by the names that users give them.
template <typename Input, std::size_t n>
Input input_of(const json& in, const std::array<InputNumber<Input>, n>& numbers) {
  Input input;
  for (const InputNumber<Input>& number : numbers)
    if (in.contains(number.name)) input.*number.member = in[number.name];
  return input;
}

json ralston_json(const json& in) {
  RalstonInput input = input_of(in, kRalstonInputs);
  input.breaking = in["downward"] ? Breaking::kDownward : Breaking::kUpward;
  input.yield = in["tresca"] ? Yield::kTresca : Yield::kJohansen;
  const auto load = ralston(input);
  if (!load) return nullptr;
  return {load->breaking_horizontal, load->ride_horizontal, load->breaking_vertical, load->ride_vertical,
          load->horizontal,          load->vertical,        load->radius_ratio};
}

json lindqvist_json(const json& in) {
  const auto load = lindqvist(input_of(in, kLindqvistInputs));
  if (!load) return nullptr;
  return {load->crushing, load->bending, load->submersion, load->total};
}

json nevel_json(const json& in) {
  const NevelLoad load = nevel(input_of(in, kNevelInputs));
  return {load.vertical, load.in_range};
}

json crushing_json(const json& in) {
  const auto load = global_crushing(input_of(in, kCrushingInputs));
  if (!load) return nullptr;
  return {load->horizontal, load->pressure};
}

json jeong_json(const json& in) {
  const JeongLoad load = jeong(input_of(in, kJeongInputs));
  return {load.buoyancy, load.clearing, load.breaking, load.total};
}

}  // namespace

int main() {
  const json in = json::parse(std::cin);
  json out = json::object();
  const auto answer = [&](const char* formula, json (*load)(const json&)) {
    out[formula] = json::array();
    for (const json& input : in[formula]) out[formula].push_back(load(input));
  };
  answer("ralston", ralston_json);
  answer("lindqvist", lindqvist_json);
  answer("nevel", nevel_json);
  answer("crushing", crushing_json);
  answer("jeong", jeong_json);
  std::cout << out << '\n';
}
