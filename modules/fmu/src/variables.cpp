// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/fmu/variables.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

#include "brash/core/contract.hpp"
#include "brash/model/case_keys.hpp"

namespace brash::fmu {
Number value_of(const model::Case& c, const Parameter& parameter) {
  std::optional<Number> number;
  model::visit_keys(c, [&](const char* section, const char* key, const auto& value) {
    using Value = std::remove_cvref_t<decltype(value)>;
    if (parameter.section != section || parameter.key != key) return;
    if constexpr (std::is_same_v<Value, double>)
      number = value;
    else if constexpr (std::is_same_v<Value, std::uint64_t>)
      number = static_cast<std::int64_t>(value);
  });
  BRASH_EXPECTS(number.has_value(), parameter.section, parameter.key);
  return *number;
}

void set_value(model::Case& c, const Parameter& parameter, Number value) {
  auto tree = model::to_tree<nlohmann::json>(c);
  std::visit([&](auto number) { tree.at(parameter.section).at(parameter.key) = number; }, value);
  model::Case changed = model::from_tree(tree);
  changed.name = c.name;
  c = changed;
}

bool is_velocity(std::string_view input) {
  return input.starts_with("structure_v") || input.starts_with("structure_w");
}

bool is_driven(const model::Case& c) { return std::holds_alternative<model::Driven>(c.structure.motion); }

Inputs inputs_at_rest(const model::Case& c) { return {.place = {-c.structure.start_distance, 0.0, 0.0}}; }

namespace {

bool has_region(const model::StructureSection& structure, std::size_t region) {
  const std::size_t n_legs = structure.legs.size();
  if (n_legs > 0) return region >= model::kHullRegions && region < model::kHullRegions + n_legs;
  return region < model::kHullRegions &&
         (std::holds_alternative<model::Ship>(structure.shape) || std::holds_alternative<model::Mesh>(structure.shape));
}

/// Whether the case, and not the host, moves the structure this way.
bool has_motion(const model::Case& c, const std::string& name) {
  const auto& motion = c.structure.motion;
  const bool is_body = std::holds_alternative<model::Free>(motion) || std::holds_alternative<model::Moored>(motion);
  if (is_body) return true;
  const auto* const towed = std::get_if<model::Towed>(&motion);
  if (name == "structure_heading" || name == "structure_wz") return towed != nullptr && !towed->path.empty();
  constexpr std::array<std::string_view, 4> kInPlan{"structure_x", "structure_y", "structure_vx", "structure_vy"};
  return !is_driven(c) && std::ranges::find(kInPlan, name) != kInPlan.end();
}

/// Where the structure is, if it moves on its own; loads by region of a ship's or a mesh's hull, or by leg; all others.
bool has_output(const model::Case& c, const std::string& name) {
  if (name.starts_with("structure_")) return has_motion(c, name);
  bool has = true;
  model::RegionLoads::visit([&](const std::string& region, const char*, std::size_t i) {
    if (name.find("_" + region) != std::string::npos) has = has_region(c.structure, i);
  });
  return has;
}

}  // namespace

std::vector<Variable> variables_of(const Unit& unit) {
  std::vector<Variable> variables{{"time", "s", "simulated time", Causality::kIndependent, 0.0}};
  std::size_t place = 0;
  const Inputs inputs = inputs_at_rest(unit.resolved);
  if (is_driven(unit.resolved))
    Inputs::visit(inputs, [&](const char* name, const char* unit_of, const char* meaning, double start) {
      const std::size_t here = place++;
      if (!(unit.velocity_from_poses && is_velocity(name)))
        variables.push_back({name, unit_of, meaning, Causality::kInput, start, here});
    });
  place = 0;
  const Outputs outputs;
  Outputs::visit(outputs, [&](std::string name, const char* unit_of, std::string meaning, double) {
    const std::size_t here = place++;
    if (has_output(unit.resolved, name))
      variables.push_back({std::move(name), unit_of, std::move(meaning), Causality::kOutput, 0.0, here});
  });
  place = 0;
  for (const Parameter& p : unit.parameters)
    variables.push_back({p.section + "." + p.key, p.unit, p.meaning, Causality::kParameter, value_of(unit.resolved, p),
                         place++, p.least, p.most});
  return variables;
}

}  // namespace brash::fmu
