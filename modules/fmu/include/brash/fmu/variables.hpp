// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "brash/core/vec.hpp"
#include "brash/fmu/unit.hpp"
#include "brash/model/records.hpp"

namespace brash::fmu {

/// Where a driven structure is at a communication point, and how it moves in the step from there; sheet frame. A unit
/// may take the motion from the poses instead: from the mean velocity of the step before. The structure turns from the
/// sheet's axes by the yaw about z, then the pitch about its own y, then the roll about its own x.
struct Inputs {
  Vec3 place{};                               ///< of its origin [m]
  double roll = 0.0, pitch = 0.0, yaw = 0.0;  ///< [rad]
  Twist twist{};                              ///< of its origin, along and about the sheet's axes

  /// As Outputs::visit().
  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("structure_x", "m", "place of the structure's origin along the sheet's x", self.place.x);
    visit("structure_y", "m", "place of the structure's origin to port", self.place.y);
    visit("structure_z", "m", "height of the structure's waterplane above the water", self.place.z);
    visit("structure_roll", "rad", "turn about its own x, third", self.roll);
    visit("structure_pitch", "rad", "turn about its own y, second, bow down", self.pitch);
    visit("structure_yaw", "rad", "turn about z, first, to port", self.yaw);
    visit("structure_vx", "m s-1", "velocity of the origin along the sheet's x", self.twist.linear.x);
    visit("structure_vy", "m s-1", "velocity of the origin to port", self.twist.linear.y);
    visit("structure_vz", "m s-1", "velocity of the origin upwards", self.twist.linear.z);
    visit("structure_wx", "rad s-1", "angular velocity about the sheet's x", self.twist.angular.x);
    visit("structure_wy", "rad s-1", "angular velocity about the sheet's y", self.twist.angular.y);
    visit("structure_wz", "rad s-1", "angular velocity about z", self.twist.angular.z);
  }
};

/// The values that a step gives. Loads have the axes and signs of model::LoadRow, which turn with the structure's
/// heading. They are means over the time steps that end in the step of the host. If that is a whole number of time
/// steps and the heading stays, they keep its impulse.
struct Outputs {
  Wrench total, crushing, floe_normal, floe_friction;
  Vec3 place{};     ///< of the structure's origin, at the end of the step [m]
  Vec3 attitude{};  ///< roll, pitch and heading, at the end of the step [rad]
  Twist twist{};    ///< mean over the step [m/s], [rad/s]
  model::RegionLoads regions;

  /// Calls `visit(name, unit, meaning, number)` for each. history.csv has the same names. A unit has those
  /// that variables_of() lists.
  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit_wrench("", "total load on the structure", self.total, visit);
    visit_wrench("crushing_", "crushing at the sheet's edge", self.crushing, visit);
    visit_wrench("floe_normal_", "normal contact forces of floes", self.floe_normal, visit);
    visit_wrench("floe_friction_", "friction of floes", self.floe_friction, visit);
    visit("structure_x", "m", "place of the structure's origin along the sheet's x", self.place.x);
    visit("structure_y", "m", "place of the structure's origin to port", self.place.y);
    visit("structure_vx", "m s-1", "mean velocity of the structure's origin along the sheet's x", self.twist.linear.x);
    visit("structure_vy", "m s-1", "mean velocity of the structure's origin to port", self.twist.linear.y);
    visit("structure_z", "m", "height of the structure's origin", self.place.z);
    visit("structure_vz", "m s-1", "mean velocity of the structure's origin upwards", self.twist.linear.z);
    visit("structure_roll", "rad", "turn about its own x, third", self.attitude.x);
    visit("structure_pitch", "rad", "turn about its own y, second, bow down", self.attitude.y);
    visit("structure_heading", "rad", "turn about z, first, to port", self.attitude.z);
    visit("structure_wx", "rad s-1", "mean angular velocity about the sheet's x", self.twist.angular.x);
    visit("structure_wy", "rad s-1", "mean angular velocity about the sheet's y", self.twist.angular.y);
    visit("structure_wz", "rad s-1", "mean angular velocity about z", self.twist.angular.z);
    model::RegionLoads::visit([&](const std::string& region, const std::string& meaning, std::size_t i) {
      visit_force("_" + region, "load on " + meaning, self.regions[i].total, visit);
      visit_force("_" + region + "_crushing", "crushing at the sheet's edge on " + meaning, self.regions[i].crushing,
                  visit);
    });
  }

 private:
  template <typename AnyForce, typename Visit>
  static void visit_force(const std::string& part, const std::string& meaning, AnyForce& force, Visit&& visit) {
    visit("Fx" + part, "N", meaning + ", force against the heading", force.x);
    visit("Fy" + part, "N", meaning + ", force to starboard of the heading", force.y);
    visit("Fz" + part, "N", meaning + ", force upwards", force.z);
  }

  template <typename AnyWrench, typename Visit>
  static void visit_wrench(const std::string& cause, const std::string& meaning, AnyWrench& load, Visit&& visit) {
    visit(cause + "Fx", "N", meaning + ", force against the heading", load.force.x);
    visit(cause + "Fy", "N", meaning + ", force to starboard of the heading", load.force.y);
    visit(cause + "Fz", "N", meaning + ", force upwards", load.force.z);
    visit(cause + "Mx", "N m", meaning + ", moment about the axis of Fx", load.moment.x);
    visit(cause + "My", "N m", meaning + ", moment about the axis of Fy", load.moment.y);
    visit(cause + "Mz", "N m", meaning + ", moment about z", load.moment.z);
  }
};

enum class Causality { kIndependent, kInput, kOutput, kParameter };

using Number = std::variant<double, std::int64_t>;

/// A variable of a unit as its description lists it.
struct Variable {
  std::string name;
  std::string unit;  ///< UDUNITS; "1" where there is none
  std::string meaning;
  Causality causality = Causality::kOutput;
  Number start;           ///< its type is the variable's
  std::size_t place = 0;  ///< among the inputs and outputs that a `visit` names, or among the unit's parameters
  std::optional<double> least{}, most{};
};

/// Whether the host says how the structure of a case moves.
bool is_driven(const model::Case& c);

/// The inputs of a driven structure that rests at its start.
Inputs inputs_at_rest(const model::Case& c);

/// The variables of a unit: time, inputs, outputs, parameters. The place of one in the list is its value reference.
std::vector<Variable> variables_of(const Unit& unit);

/// The number of a case that a parameter names.
/// @throws ContractViolation when the case has none.
Number value_of(const model::Case& c, const Parameter& parameter);
/// @param value  of the type that value_of() gives.
void set_value(model::Case& c, const Parameter& parameter, Number value);

}  // namespace brash::fmu
