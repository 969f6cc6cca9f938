// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/fmu/unit.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "brash/core/error.hpp"
#include "brash/model/case_keys.hpp"

namespace brash::fmu {
namespace {

using Json = nlohmann::json;

constexpr const char* kFormat = "brash-fmu-1";

Json tree_of(const Parameter& p) {
  return {{"section", p.section}, {"key", p.key},     {"unit", p.unit},
          {"meaning", p.meaning}, {"least", p.least}, {"most", p.most}};
}

Parameter parameter_from(const Json& tree) {
  return {tree.at("section"), tree.at("key"), tree.at("unit"), tree.at("meaning"), tree.at("least"), tree.at("most")};
}

}  // namespace

std::string to_json(const Unit& unit) {
  Json parameters = Json::array();
  for (const Parameter& parameter : unit.parameters) parameters.push_back(tree_of(parameter));
  const Json tree{{"format", kFormat},
                  {"name", unit.resolved.name},
                  {"case", model::to_tree<Json>(unit.resolved)},
                  {"parameters", std::move(parameters)},
                  {"token", unit.token},
                  {"velocity_from_poses", unit.velocity_from_poses}};
  return tree.dump(1) + '\n';
}

Unit unit_from(const std::string& text, const std::string& path) {
  try {
    const Json tree = Json::parse(text);
    if (tree.at("format") != kFormat) throw std::runtime_error("is not of this version");
    Unit unit{model::from_tree(tree.at("case")), {}, tree.at("token"), tree.value("velocity_from_poses", false)};
    unit.resolved.name = tree.at("name");
    for (const Json& parameter : tree.at("parameters")) unit.parameters.push_back(parameter_from(parameter));
    return unit;
  } catch (const std::exception& error) {
    throw InputError(Complaint{path, error.what(), "the file as `brash export fmu` wrote it", "export the unit again"});
  }
}

}  // namespace brash::fmu
