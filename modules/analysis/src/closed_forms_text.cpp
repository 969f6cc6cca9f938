// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "brash/analysis/closed_forms.hpp"
#include "brash/analysis/tables.hpp"
#include "brash/core/constants.hpp"
#include "brash/standards/inputs.hpp"

namespace brash::analysis {

using nlohmann::ordered_json;

namespace {

/// The unit of an input, which has one in all formulas.
std::string unit_of(const std::string& name) {
  std::string unit;
  const auto seek = [&](const auto& numbers) {
    for (const auto& number : numbers)
      if (name == number.name) unit = number.unit;
  };
  seek(standards::kCroasdaleInputs);
  seek(standards::kRalstonInputs);
  seek(standards::kNevelInputs);
  seek(standards::kCrushingInputs);
  seek(standards::kLindqvistInputs);
  seek(standards::kRiskaInputs);
  seek(standards::kJeongInputs);
  return unit;
}

/// A number for people: "350 MPa", "61.4 deg", "1025 kg/m3".
std::string quantity_text(double value, const std::string& unit) {
  if (unit == "Pa" && value >= 1e9) return fmt::format("{:.4g} GPa", value / 1e9);
  if (unit == "Pa" && value >= 1e6) return fmt::format("{:.4g} MPa", value / 1e6);
  if (unit == "Pa") return fmt::format("{:.4g} kPa", value / 1e3);
  if (unit == "rad") return fmt::format("{:.4g} deg", value / radians(1.0));
  const std::string shown = unit == "1" ? "" : unit == "kg m-3" ? " kg/m3" : unit == "m s-1" ? " m/s" : " " + unit;
  return fmt::format("{:.4g}{}", value, shown);
}

/// An input with the formulas that took this value.
struct UsedInput {
  std::string name, value;
  std::vector<std::string> formulas;
};

/// The inputs of all formulas, in the order in which they come; several values of one input follow each other.
std::vector<UsedInput> used_inputs(const ordered_json& loads) {
  std::vector<UsedInput> used;
  for (const ordered_json& load : loads) {
    if (!load.contains("inputs")) continue;
    const auto formula = load["formula"].get<std::string>();
    for (const auto& [name, number] : load["inputs"].items()) {
      const std::string value = quantity_text(number.get<double>(), unit_of(name));
      auto at = std::ranges::find_if(
          used, [&, &name = name](const UsedInput& u) { return u.name == name && u.value == value; });
      if (at == used.end()) {
        const auto last =
            std::find_if(used.rbegin(), used.rend(), [&name = name](const UsedInput& u) { return u.name == name; });
        at = used.insert(last == used.rend() ? used.end() : last.base(), {name, value, {}});
      }
      if (std::ranges::find(at->formulas, formula) == at->formulas.end()) at->formulas.push_back(formula);
    }
  }
  return used;
}

std::string inputs_text(const ordered_json& loads) {
  const std::vector<UsedInput> used = used_inputs(loads);
  if (used.empty()) return "";
  std::string text = "inputs used\n";
  for (const auto& [name, value, formulas] : used) {
    std::string words = name;
    std::ranges::replace(words, '_', ' ');
    text += fmt::format("  {:<22}{:>12}  {}\n", words, value, fmt::join(formulas, ", "));
  }
  return text;
}

}  // namespace

std::string loads_text(const ordered_json& loads) {
  std::vector<double> all;
  for (const ordered_json& load : loads["loads"])
    for (const char* const direction : {"horizontal", "vertical"})
      if (load.contains(direction)) all.push_back(load[direction].get<double>());
  const TableUnit unit = unit_for(all, "N");
  std::string text = fmt::format("{}: closed-form loads [{}], {}\n  horizontal  vertical  method\n",
                                 loads["case"].get<std::string>(), unit.name, loads["kind"].get<std::string>());
  for (const ordered_json& load : loads["loads"]) {
    const auto method = load["method"].get<std::string>(), source = load["source"].get<std::string>();
    if (load.contains("not_applicable")) {
      text += fmt::format("           -         -  {}; {}\n{:24}not applicable: {}\n", method, source, "",
                          load["not_applicable"].get<std::string>());
      continue;
    }
    const std::string vertical =
        load.contains("vertical") ? fmt::format("{:.1f}", load["vertical"].get<double>() / unit.one) : "-";
    text += fmt::format("  {:10.1f}{:>10}  {}; {}\n{:24}", load["horizontal"].get<double>() / unit.one, vertical,
                        method, source, "");
    std::string separator;
    for (const auto& [name, value] : load["components"].items()) {
      text += fmt::format("{}{} {:.1f}", separator, name, value.get<double>() / unit.one);
      separator = ", ";
    }
    text += load.contains("in_range") && !load["in_range"].get<bool>() ? "; outside the formula's range\n" : "\n";
  }
  return text + inputs_text(loads["loads"]);
}

}  // namespace brash::analysis
