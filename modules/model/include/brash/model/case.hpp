// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "brash/core/vec.hpp"
#include "brash/model/choices.hpp"
#include "brash/model/structure.hpp"

namespace brash::model {

/// [algorithm]
struct AlgorithmSection {
  Preset preset = Preset::kBrash;

  friend bool operator==(const AlgorithmSection&, const AlgorithmSection&) = default;
};

/// [ice.variation]
struct IceVariation {
  double thickness = 0.0;           ///< coefficient of variation [-]
  double flexural_strength = 0.0;   ///< coefficient of variation [-]
  double correlation_length = 0.0;  ///< 0: ten thicknesses

  friend bool operator==(const IceVariation&, const IceVariation&) = default;
};

/// [ice]; SI throughout. Unit, range, default and source of every key are in case.schema.json; the defaults here are
/// the same, and those without one are zero.
struct IceSection {
  double thickness = 0.0;
  double density = 900.0;
  double youngs_modulus = 0.0;
  double poisson_ratio = 0.3;
  double flexural_strength = 0.0;
  double compressive_strength = 1.0e6;
  double fracture_toughness = 1.5e5;  ///< K_IC [Pa m^0.5]
  double crushing_factor = 0.5;
  double friction_structure = 0.027;
  double friction_ice = 0.3;
  IceVariation variation;

  friend bool operator==(const IceSection&, const IceSection&) = default;
};

/// [water]
struct WaterSection {
  double density = 1025.0;
  Vec2 current{};                 ///< `current = [0, 0]`
  std::optional<double> depth{};  ///< of a flat bed below the surface [m]; absent: deep water
  double bed_friction = 0.3;      ///< of ice on the bed [-]

  friend bool operator==(const WaterSection&, const WaterSection&) = default;
};

/// [wind]
struct WindSection {
  Vec2 velocity{};
  double density = 1.3;
  double skin_friction = 0.0015;  ///< drag coefficient of a floe's top [-]

  friend bool operator==(const WindSection&, const WindSection&) = default;
};

/// [field.size]: sizes L of generated floes, the square roots of their areas. Each law has its own keys.
struct FloeSizes {
  SizeLaw kind = SizeLaw::kPowerLaw;
  double exponent = 2.0;            ///< of the power law: the number of floes above L falls as L^-exponent
  std::optional<double> least{};    ///< size of the power law
  std::optional<double> largest{};  ///< size of the power law
  std::optional<double> median{};   ///< size of the log-normal law
  double deviation = 0.4;           ///< of the logarithm of its sizes
  std::vector<double> values{};     ///< of the list, each as likely as the others

  friend bool operator==(const FloeSizes&, const FloeSizes&) = default;
};

/// The keys of [field] with `kind = "floes"`.
struct FloeFieldSection {
  std::optional<double> concentration;  ///< of generated floes: their area over the area of the field
  FloeShape shape = FloeShape::kVoronoi;
  FloeSizes size;
  FloeBorder border = FloeBorder::kFree;  ///< along both sides and at the far end

  friend bool operator==(const FloeFieldSection&, const FloeFieldSection&) = default;
};

/// [field]
struct FieldSection {
  FieldKind kind = FieldKind::kLevelIce;
  double length = 0.0;
  double width = 0.0;
  bool initial_crack = true;
  double initial_crack_radius = 0.0;     ///< 0: the breaking length of a straight edge
  double edge_roughness = 0.0;           ///< standard deviation of the first edge about x = 0 [m]
  double edge_correlation_length = 0.0;  ///< of the first edge [m]; 0: ten thicknesses
  std::string file;      ///< of outlines, absolute; empty: level ice is a rectangle, floes are generated
  std::string openings;  ///< file of open water in level ice, absolute; empty: none
  std::string cracks;    ///< file of lines that part level ice, absolute; empty: none
  std::string shore;     ///< file of fixed outlines, absolute; empty: none
  Vec2 origin{};         ///< the place of x = 0, y = 0 in the coordinates of these files [m]
  Border border = Border::kFixed;
  double smallest_plate = 5.0;  ///< least breadth of ice afloat that bends as a plate, in characteristic lengths
  FloeFieldSection floes{};

  friend bool operator==(const FieldSection&, const FieldSection&) = default;
};

/// [failure]
struct FailureSection {
  FailureModel model = FailureModel::kPlateOutline;
  std::string file;  ///< model file, absolute; empty: the model that comes with the program
  CrackOrder order = CrackOrder::kRadialFirst;
  bool second_order = true;  ///< the in-plane force acts on the bent plate
  bool under_floes = true;   ///< the sheet also breaks where floes press on it
  bool joint_loads = true;   ///< all loads on the sheet act together
  std::array<int, 2> wedges{3, 5};
  double lateness = 0.2;        ///< longest time between two solutions of a contact's sheet [s]; 0: in every step
  double smallest_floe = 0.01;  ///< pieces below this area become brash [m2]
  EdgeMotion edge = EdgeMotion::kDynamic;
  JudgedAt judged = JudgedAt::kAnywhere;
  CrackPattern pattern = CrackPattern::kStress;
  EdgePressure pressure = EdgePressure::kEdge;  ///< p of Eqs. 17 and 19
  LengthDensity length_density = LengthDensity::kWater;
  SmallContact small_contact = SmallContact::kKeepsForce;
  CrushedIce crushed_ice = CrushedIce::kLeaves;
  Pieces pieces = Pieces::kBreak;  ///< whether floes break again

  friend bool operator==(const FailureSection&, const FailureSection&) = default;
};

/// [contact]
struct ContactSection {
  ContactEngine engine = ContactEngine::kBrash;
  double restitution = 0.0;
  ContactArea area = ContactArea::kSurface;
  CrushingBound crushing_bound = CrushingBound::kAll;
  double margin = 0.005;
  int iterations = 30;
  double stiffness = 1.0e6;                        ///< K of Eq. 11 [N/m]
  FloeStress floe_stress = FloeStress::kAveraged;  ///< that crushes a floe

  friend bool operator==(const ContactSection&, const ContactSection&) = default;
};

/// [hydrodynamics]
struct HydrodynamicsSection {
  DragLaw drag = DragLaw::kSurface;
  bool shading = true;
  double shading_gap = 0.5;  ///< in ice thicknesses
  double drag_travel = 0.1;  ///< a floe's drag coefficients are kept for that way, in ice thicknesses
  double form_drag = 1.0;
  FormDragAlong form_drag_along = FormDragAlong::kNormal;
  double rotational_drag = 1.0;
  double skin_friction = 0.005;
  AddedMassLaw added_mass_law = AddedMassLaw::kPlate;
  double added_mass = 0.5;     ///< of kIsotropic, in masses of the floe
  bool ventilation = true;     ///< the top of a floe stays dry until water has run in over its edge
  bool structure_flow = true;  ///< the water gives way to the structure

  friend bool operator==(const HydrodynamicsSection&, const HydrodynamicsSection&) = default;
};

/// [time]
struct TimeSection {
  double step = 0.01;
  double duration = 0.0;
  double settle_speed = 0.0;

  friend bool operator==(const TimeSection&, const TimeSection&) = default;
};

/// [random]
struct RandomSection {
  std::uint64_t seed = 1;
  std::uint64_t replicate = 0;

  friend bool operator==(const RandomSection&, const RandomSection&) = default;
};

/// [output]
struct OutputSection {
  double frames_per_second = 15.0;
  double checkpoint_interval = 5.0;       ///< simulated time between checkpoints [s]; 0 keeps none
  std::optional<double> statistics_from;  ///< [s]; absent: when the structure's centre passes the initial edge

  friend bool operator==(const OutputSection&, const OutputSection&) = default;
};

/// [reference]: a measured load to print beside the simulated one; the simulation does not see it.
struct ReferenceSection {
  std::optional<double> mean_horizontal;  ///< [N]
  std::string source = "reference";

  friend bool operator==(const ReferenceSection&, const ReferenceSection&) = default;
};

/// Whether ice in large parts is there at the start, not floes alone.
inline bool has_level_ice(const FieldSection& field) { return field.kind != FieldKind::kFloes; }

/// Whether files say where the level ice is at the start.
inline bool has_ice_files(const FieldSection& field) {
  const bool is_plain = field.file.empty() && field.openings.empty() && field.cracks.empty() && field.shore.empty();
  return has_level_ice(field) && !is_plain;
}

/// A resolved case: every key has its value, in SI. Valid by construction when it comes from read_case.
struct Case {
  std::string name;  ///< the file's stem
  AlgorithmSection algorithm;
  IceSection ice;
  WaterSection water;
  WindSection wind;
  StructureSection structure;
  FieldSection field;
  FailureSection failure;
  ContactSection contact;
  HydrodynamicsSection hydrodynamics;
  TimeSection time;
  RandomSection random;
  OutputSection output;
  ReferenceSection reference;
  HullSection hull;

  friend bool operator==(const Case&, const Case&) = default;
};

/// Correlation length of what varies in ice of this thickness, where the case gives none (0) [m].
inline double correlation_length(double given, double thickness) {
  constexpr double kThicknesses = 10.0;
  return given > 0.0 ? given : kThicknesses * thickness;
}
/// Of thickness and strength [m].
inline double correlation_length(const IceSection& ice) {
  return correlation_length(ice.variation.correlation_length, ice.thickness);
}
/// Of the first edge [m].
inline double edge_correlation_length(const Case& c) {
  return correlation_length(c.field.edge_correlation_length, c.ice.thickness);
}

/// Velocity of the water past the ice at rest, structure and waves aside: `water.current`, and with it the water that
/// stays with the structure [m/s].
inline Vec2 current_past_ice(const Case& c) {
  const bool stays = c.structure.frame == MotionFrame::kIceDriftsThroughStillWater;
  return c.water.current + (stays ? Vec2{speed(c.structure.motion), 0.0} : Vec2{});
}

/// Velocity of the bed of the water past the ice at rest [m/s]: the bed rests with a structure past which ice drifts.
inline Vec2 bed_past_ice(const Case& c) {
  const bool moves = c.structure.frame != MotionFrame::kStructureMoves;
  return moves ? Vec2{speed(c.structure.motion), 0.0} : Vec2{};
}

}  // namespace brash::model
