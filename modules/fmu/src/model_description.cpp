// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/fmu/model_description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <set>
#include <sstream>

#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "brash/core/version.hpp"
#include "brash/fmu/variables.hpp"
#include "component.hpp"

namespace brash::fmu {
namespace {

std::string escaped_xml(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else if (static_cast<unsigned char>(c) < 0x20)
      out += ' ';
    else
      out += c;
  }
  return out;
}

std::string attribute(const char* name, const std::string& value) {
  return fmt::format(" {}=\"{}\"", name, escaped_xml(value));
}

std::string number_text(const Number& number) {
  return std::visit([](auto value) { return fmt::format("{}", value); }, number);
}

/// The exponents of kilogram, metre, second and radian in a unit.
struct Exponents {
  int kg = 0, m = 0, s = 0, rad = 0;
};

Exponents exponents_of(const std::string& symbol) {
  if (symbol == "kg") return {.kg = 1};
  if (symbol == "m") return {.m = 1};
  if (symbol == "s") return {.s = 1};
  if (symbol == "rad") return {.rad = 1};
  if (symbol == "N") return {.kg = 1, .m = 1, .s = -2};
  if (symbol == "Pa") return {.kg = 1, .m = -1, .s = -2};
  BRASH_EXPECTS(symbol == "1", symbol);
  return {};
}

/// A unit as a product of powers: "kg m-3".
Exponents base_units(const std::string& unit) {
  Exponents sum;
  std::istringstream factors(unit);
  for (std::string factor; factors >> factor;) {
    const std::size_t end = factor.find_first_of("-0123456789", 1);
    const int power = end == std::string::npos ? 1 : std::atoi(factor.c_str() + end);
    const Exponents one = exponents_of(factor.substr(0, end));
    sum.kg += power * one.kg;
    sum.m += power * one.m;
    sum.s += power * one.s;
    sum.rad += power * one.rad;
  }
  return sum;
}

std::string unit_definitions(const std::vector<Variable>& variables) {
  std::set<std::string> units;
  for (const Variable& variable : variables)
    if (variable.unit != "1") units.insert(variable.unit);
  std::string text = "  <UnitDefinitions>\n";
  for (const std::string& unit : units) {
    const Exponents e = base_units(unit);
    std::string exponents;
    for (const auto& [name, exponent] : {std::pair{"kg", e.kg}, {"m", e.m}, {"s", e.s}, {"rad", e.rad}})
      if (exponent != 0) exponents += attribute(name, std::to_string(exponent));
    text += fmt::format("    <Unit{}><BaseUnit{}/></Unit>\n", attribute("name", unit), exponents);
  }
  return text + "  </UnitDefinitions>\n";
}

std::string log_categories() {
  return fmt::format(
      "  <LogCategories>\n    <Category name=\"{}\" description=\"results that are in doubt, and why\"/>\n"
      "    <Category name=\"{}\" description=\"calls that changed nothing, and why\"/>\n"
      "    <Category name=\"{}\" description=\"calls that ended the instance, and why\"/>\n  </LogCategories>\n",
      kWarningCategory, kDiscardCategory, kErrorCategory);
}

std::string default_experiment(const model::Case& c) {
  return fmt::format("  <DefaultExperiment startTime=\"0\" stopTime=\"{}\" stepSize=\"{}\"/>\n", c.time.duration,
                     c.time.step);
}

std::string head(const Unit& unit, const char* version, const char* token_attribute) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiModelDescription";
  text += attribute("fmiVersion", version) + attribute("modelName", unit.resolved.name);
  text += attribute(token_attribute, unit.token);
  text += attribute("description", "The load of level ice on a structure that breaks it");
  text += attribute("generationTool", std::string("brash ") + kVersion) + attribute("license", "GPL-3.0-or-later");
  return text + attribute("variableNamingConvention", "flat") + ">\n";
}

bool is_whole(const Variable& variable) { return std::holds_alternative<std::int64_t>(variable.start); }

/// Causality, variability and how the value at the start comes about.
std::string kind_attributes(const Variable& variable) {
  switch (variable.causality) {
    case Causality::kIndependent:
      return attribute("causality", "independent") + attribute("variability", "continuous");
    case Causality::kInput:
      return attribute("causality", "input") + attribute("variability", "continuous");
    case Causality::kOutput:
      return attribute("causality", "output") + attribute("variability", "continuous") +
             attribute("initial", "calculated");
    case Causality::kParameter:
      return attribute("causality", "parameter") + attribute("variability", "fixed") + attribute("initial", "exact");
  }
  return "";
}

/// Unit, bounds and start of the variable, as far as it has them.
std::string value_attributes(const Variable& variable) {
  std::string text;
  if (variable.unit != "1") text += attribute("unit", variable.unit);
  const auto bound = [&](double value) {
    return is_whole(variable) ? number_text(static_cast<std::int64_t>(value)) : number_text(value);
  };
  if (variable.least) text += attribute("min", bound(*variable.least));
  const bool has_most = variable.most && (!is_whole(variable) || *variable.most < 0x1p63);
  if (has_most) text += attribute("max", bound(*variable.most));
  const bool has_start = variable.causality == Causality::kParameter || variable.causality == Causality::kInput;
  if (has_start) text += attribute("start", number_text(variable.start));
  return text;
}

std::string name_attributes(const Variable& variable, std::size_t reference) {
  return attribute("name", variable.name) + attribute("valueReference", std::to_string(reference)) +
         attribute("description", variable.meaning);
}

/// `each(reference)` for every output, joined.
template <typename Each>
std::string for_outputs(const std::vector<Variable>& variables, Each&& each) {
  std::string text;
  for (std::size_t i = 0; i < variables.size(); ++i)
    if (variables[i].causality == Causality::kOutput) text += each(i);
  return text;
}

void expect_small(const Variable& variable) {
  const std::int64_t most = std::numeric_limits<std::int32_t>::max();
  if (!is_whole(variable) || std::get<std::int64_t>(variable.start) <= most) return;
  throw InputError(Complaint{variable.name, number_text(variable.start) + " exceeds the integers of FMI 2",
                             fmt::format("at most {}", most), "lower it, or take --fmi 3"});
}

std::string variables2(const std::vector<Variable>& variables) {
  std::string text = "  <ModelVariables>\n";
  for (std::size_t i = 0; i < variables.size(); ++i) {
    Variable variable = variables[i];
    expect_small(variable);
    if (is_whole(variable)) variable.most = std::min<double>(*variable.most, std::numeric_limits<std::int32_t>::max());
    text += fmt::format("    <ScalarVariable{}{}><{}{}/></ScalarVariable>\n", name_attributes(variable, i),
                        kind_attributes(variable), is_whole(variable) ? "Integer" : "Real", value_attributes(variable));
  }
  return text + "  </ModelVariables>\n";
}

/// Outputs hold the means of the last step: inputs act in the next one.
std::string structure2(const std::vector<Variable>& variables) {
  std::string text = "  <ModelStructure>\n    <Outputs>\n";
  text += for_outputs(variables, [](std::size_t reference) {
    return fmt::format("      <Unknown index=\"{}\" dependencies=\"\"/>\n", reference + 1);
  });
  text += "    </Outputs>\n    <InitialUnknowns>\n";
  text += for_outputs(
      variables, [](std::size_t reference) { return fmt::format("      <Unknown index=\"{}\"/>\n", reference + 1); });
  return text + "    </InitialUnknowns>\n  </ModelStructure>\n";
}

std::string description2(const Unit& unit, const std::vector<Variable>& variables) {
  std::string text = head(unit, "2.0", "guid");
  text += fmt::format(
      "  <CoSimulation modelIdentifier=\"{}\" canHandleVariableCommunicationStepSize=\"true\" "
      "canNotUseMemoryManagementFunctions=\"true\" canGetAndSetFMUstate=\"true\" canSerializeFMUstate=\"true\"/>\n",
      kModelIdentifier);
  text += unit_definitions(variables) + log_categories() + default_experiment(unit.resolved);
  return text + variables2(variables) + structure2(variables) + "</fmiModelDescription>\n";
}

std::string variables3(const std::vector<Variable>& variables) {
  std::string text = "  <ModelVariables>\n";
  for (std::size_t i = 0; i < variables.size(); ++i)
    text +=
        fmt::format("    <{}{}{}{}/>\n", is_whole(variables[i]) ? "Int64" : "Float64", name_attributes(variables[i], i),
                    kind_attributes(variables[i]), value_attributes(variables[i]));
  return text + "  </ModelVariables>\n";
}

std::string structure3(const std::vector<Variable>& variables) {
  std::string text = "  <ModelStructure>\n";
  text += for_outputs(variables, [](std::size_t reference) {
    return fmt::format("    <Output valueReference=\"{}\" dependencies=\"\"/>\n", reference);
  });
  text += for_outputs(variables, [](std::size_t reference) {
    return fmt::format("    <InitialUnknown valueReference=\"{}\"/>\n", reference);
  });
  return text + "  </ModelStructure>\n";
}

std::string description3(const Unit& unit, const std::vector<Variable>& variables) {
  std::string text = head(unit, "3.0", "instantiationToken");
  text += fmt::format(
      "  <CoSimulation modelIdentifier=\"{}\" canGetAndSetFMUState=\"true\" canSerializeFMUState=\"true\" "
      "canHandleVariableCommunicationStepSize=\"true\" fixedInternalStepSize=\"{}\"/>\n",
      kModelIdentifier, unit.resolved.time.step);
  text += unit_definitions(variables) + log_categories() + default_experiment(unit.resolved);
  return text + variables3(variables) + structure3(variables) + "</fmiModelDescription>\n";
}

}  // namespace

std::string library_path(Standard standard) {
  return fmt::format("binaries/{}/{}.so", standard == Standard::kFmi2 ? "linux64" : "x86_64-linux", kModelIdentifier);
}

std::string model_description(const Unit& unit, Standard standard) {
  const std::vector<Variable> variables = variables_of(unit);
  return standard == Standard::kFmi2 ? description2(unit, variables) : description3(unit, variables);
}

}  // namespace brash::fmu
