// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <type_traits>

namespace brash::model {

/// The choices of a case, each an enum with its names in files: readers, writers and messages share the one list.
/// `case.schema.json` states the same names; a test compares the two.

/// [algorithm] preset: where the defaults of other keys come from.
enum class Preset { kBrash, kPaper };
/// [structure] breaking: the way the ice bends.
enum class Breaking { kDownward, kUpward };
/// [structure.motion] frame: which of structure, ice and water are at rest. The physics knows the ice's frame alone.
enum class MotionFrame {
  kStructureMoves,             ///< through ice and water at rest
  kIceDrifts,                  ///< with the water, past a structure at rest: the same in the ice's frame
  kIceDriftsThroughStillWater  ///< past a structure at rest: the water comes along with the structure
};
/// [field] kind
enum class FieldKind {
  kLevelIce,  ///< sheets, fast or drifting
  kFloes      ///< broken ice, afloat from the start
};
/// [field] shape: of the floes of a generated field, ice::make_floe_field().
enum class FloeShape { kVoronoi, kSquares, kDiscs };
/// [field.size] kind: how the sizes of generated floes are distributed.
enum class SizeLaw { kPowerLaw, kLogNormal, kList };
/// [field] border: how the borders of the level ice are held.
enum class Border {
  kFixed,  ///< by land, for ever: the paper's
  kFree    ///< by nothing: the sheet is a body afloat, which drifts and splits
};
/// [field] border, of floes: how the sides and the far end of the field are closed.
enum class FloeBorder {
  kFree,  ///< by nothing: floes may drift away
  kWalls  ///< by fixed walls
};
/// [failure] model: the criterion that says whether the ice fails in bending, failure::make_criterion().
enum class FailureModel { kNetwork, kDeepNetwork, kSuperposition, kPlate, kPlateOutline, kWedge };
/// [failure] order: which crack may come first.
enum class CrackOrder { kCircumferentialFirst, kRadialFirst };
/// [failure] judged: where the stress decides about failure.
enum class JudgedAt {
  kCentreLine,  ///< from B into the ice: the paper's
  kAnywhere     ///< all over the sheet around B
};
/// [failure] edge: whether the edge of the sheet gives way.
enum class EdgeMotion {
  kStatic,  ///< it is bent at once, and stays where it is: the paper's
  kDynamic  ///< it moves with inertia on moving water
};
/// [failure] pattern: the cracks of ice that fails in bending, ice::make_crack_pattern().
enum class CrackPattern {
  kDisc,   ///< a circle of the breaking length with radial cracks: the paper's
  kStress  ///< a crack along the stress to the free edge, with radial cracks
};
/// [failure] pressure: p of Eqs. 17 and 19.
enum class EdgePressure {
  kEdge,    ///< the in-plane force over contact length and thickness, N / (c h)
  kContact  ///< the normal force over the area A of Eqs. 15 and 16
};
/// [failure] length_density: rho of Eq. 18, the characteristic length.
enum class LengthDensity {
  kWater,  ///< of the foundation
  kIce
};
/// [failure] small_contact: the quantity that a contact keeps when it is widened to the smallest of the model.
enum class SmallContact {
  kKeepsForce,    ///< p c h
  kKeepsPressure  ///< p
};
/// [failure] crushed_ice: whether ice leaves that the structure has passed through.
enum class CrushedIce {
  kLeaves,  ///< it leaves the sheet, and pieces are born without it
  kStays    ///< only cracks change the sheet
};
/// [failure] pieces: whether floes break again.
enum class Pieces {
  kBreak,  ///< in the section where they bend most
  kWhole   ///< they stay as they were born
};
/// [contact] area: the area A of Eq. 15.
enum class ContactArea {
  kSurface,   ///< of the structure's surface inside the ice
  kProjected  ///< of the overlap in plan
};
/// [contact] engine: finds the contacts of the bodies and solves them.
enum class ContactEngine {
  kBrash,  ///< exact overlaps and a bounded solver, without a history
  kBullet  ///< Bullet as it is, with the crushing bound
};
/// [contact] crushing_bound: the contacts that Eq. 16 limits.
enum class CrushingBound {
  kAll,      ///< of all bodies: ice yields wherever it is pressed
  kLevelIce  ///< of the structure and level ice alone: floes are rigid
};
/// [contact] floe_stress: the stress that crushes a floe.
enum class FloeStress {
  kAveraged,  ///< the mean over the floe and over its collision time
  kStep,      ///< the mean over the floe in a step
  kContact    ///< the normal force of a contact over its area, in a step
};
/// [hydrodynamics] drag: where the velocity of Eq. 13 is taken.
enum class DragLaw {
  kSurface,  ///< on each element of the wetted surface; the same law brakes rotation
  kPaper     ///< at the centre of buoyancy for the whole floe; Eq. 14 brakes rotation
};
/// [hydrodynamics] form_drag_along: the direction of the form drag on a face.
enum class FormDragAlong {
  kVelocity,  ///< of the face against the water, as in Eq. 13
  kNormal     ///< of the face: a pressure, by the normal velocity
};
/// [hydrodynamics] added_mass_law: the water that moves with a floe.
enum class AddedMassLaw {
  kIsotropic,  ///< a share of the floe's mass in every direction, Eq. 12
  kPlate,      ///< of a plate in potential flow: by direction, on its wet faces
  kNone
};

/// One value of a choice and its name.
template <typename Choice>
struct Named {
  Choice value;
  std::string_view name;
};

/// All values of a choice, in the order of the schema.
template <typename Choice>
inline constexpr std::array<Named<Choice>, 0> kNames{};

template <>
inline constexpr auto kNames<Preset> = std::to_array<Named<Preset>>({{Preset::kBrash, "brash"},
                                                                     {Preset::kPaper, "paper"}});
template <>
inline constexpr auto kNames<Breaking> = std::to_array<Named<Breaking>>({{Breaking::kDownward, "downward"},
                                                                         {Breaking::kUpward, "upward"}});
template <>
inline constexpr auto kNames<MotionFrame> =
    std::to_array<Named<MotionFrame>>({{MotionFrame::kStructureMoves, "structure-moves"},
                                       {MotionFrame::kIceDrifts, "ice-drifts"},
                                       {MotionFrame::kIceDriftsThroughStillWater, "ice-drifts-through-still-water"}});
template <>
inline constexpr auto kNames<FieldKind> = std::to_array<Named<FieldKind>>({{FieldKind::kLevelIce, "level-ice"},
                                                                           {FieldKind::kFloes, "floes"}});
template <>
inline constexpr auto kNames<FloeShape> = std::to_array<Named<FloeShape>>({{FloeShape::kVoronoi, "voronoi"},
                                                                           {FloeShape::kSquares, "squares"},
                                                                           {FloeShape::kDiscs, "discs"}});
template <>
inline constexpr auto kNames<SizeLaw> = std::to_array<Named<SizeLaw>>({{SizeLaw::kPowerLaw, "power-law"},
                                                                       {SizeLaw::kLogNormal, "log-normal"},
                                                                       {SizeLaw::kList, "list"}});
template <>
inline constexpr auto kNames<Border> = std::to_array<Named<Border>>({{Border::kFixed, "fixed"},
                                                                     {Border::kFree, "free"}});
template <>
inline constexpr auto kNames<FloeBorder> = std::to_array<Named<FloeBorder>>({{FloeBorder::kFree, "free"},
                                                                             {FloeBorder::kWalls, "walls"}});
template <>
inline constexpr auto kNames<FailureModel> =
    std::to_array<Named<FailureModel>>({{FailureModel::kNetwork, "network"},
                                        {FailureModel::kDeepNetwork, "deep-network"},
                                        {FailureModel::kSuperposition, "superposition"},
                                        {FailureModel::kPlate, "plate"},
                                        {FailureModel::kPlateOutline, "plate-outline"},
                                        {FailureModel::kWedge, "wedge"}});
template <>
inline constexpr auto kNames<CrackOrder> = std::to_array<Named<CrackOrder>>(
    {{CrackOrder::kCircumferentialFirst, "circumferential-first"}, {CrackOrder::kRadialFirst, "radial-first"}});
template <>
inline constexpr auto kNames<JudgedAt> = std::to_array<Named<JudgedAt>>({{JudgedAt::kCentreLine, "centre-line"},
                                                                         {JudgedAt::kAnywhere, "anywhere"}});
template <>
inline constexpr auto kNames<EdgeMotion> = std::to_array<Named<EdgeMotion>>({{EdgeMotion::kStatic, "static"},
                                                                             {EdgeMotion::kDynamic, "dynamic"}});
template <>
inline constexpr auto kNames<CrackPattern> = std::to_array<Named<CrackPattern>>({{CrackPattern::kDisc, "disc"},
                                                                                 {CrackPattern::kStress, "stress"}});
template <>
inline constexpr auto kNames<EdgePressure> = std::to_array<Named<EdgePressure>>({{EdgePressure::kEdge, "edge"},
                                                                                 {EdgePressure::kContact, "contact"}});
template <>
inline constexpr auto kNames<LengthDensity> = std::to_array<Named<LengthDensity>>({{LengthDensity::kWater, "water"},
                                                                                   {LengthDensity::kIce, "ice"}});
template <>
inline constexpr auto kNames<SmallContact> = std::to_array<Named<SmallContact>>(
    {{SmallContact::kKeepsForce, "keeps-force"}, {SmallContact::kKeepsPressure, "keeps-pressure"}});
template <>
inline constexpr auto kNames<CrushedIce> = std::to_array<Named<CrushedIce>>({{CrushedIce::kLeaves, "leaves"},
                                                                             {CrushedIce::kStays, "stays"}});
template <>
inline constexpr auto kNames<Pieces> = std::to_array<Named<Pieces>>({{Pieces::kBreak, "break"},
                                                                     {Pieces::kWhole, "whole"}});
template <>
inline constexpr auto kNames<ContactArea> = std::to_array<Named<ContactArea>>({{ContactArea::kSurface, "surface"},
                                                                               {ContactArea::kProjected, "projected"}});
template <>
inline constexpr auto kNames<ContactEngine> = std::to_array<Named<ContactEngine>>({{ContactEngine::kBrash, "brash"},
                                                                                   {ContactEngine::kBullet, "bullet"}});
template <>
inline constexpr auto kNames<CrushingBound> =
    std::to_array<Named<CrushingBound>>({{CrushingBound::kAll, "all"}, {CrushingBound::kLevelIce, "level-ice"}});
template <>
inline constexpr auto kNames<FloeStress> = std::to_array<Named<FloeStress>>({{FloeStress::kAveraged, "averaged"},
                                                                             {FloeStress::kStep, "step"},
                                                                             {FloeStress::kContact, "contact"}});
template <>
inline constexpr auto kNames<DragLaw> = std::to_array<Named<DragLaw>>({{DragLaw::kSurface, "surface"},
                                                                       {DragLaw::kPaper, "paper"}});
template <>
inline constexpr auto kNames<FormDragAlong> =
    std::to_array<Named<FormDragAlong>>({{FormDragAlong::kVelocity, "velocity"}, {FormDragAlong::kNormal, "normal"}});
template <>
inline constexpr auto kNames<AddedMassLaw> = std::to_array<Named<AddedMassLaw>>(
    {{AddedMassLaw::kIsotropic, "isotropic"}, {AddedMassLaw::kPlate, "plate"}, {AddedMassLaw::kNone, "none"}});

template <typename T>
concept Choice = std::is_enum_v<T> &&(kNames<T>.size() > 0);

/// The name of a value in files.
template <Choice T>
constexpr std::string_view name_of(T value) {
  for (const Named<T>& entry : kNames<T>)
    if (entry.value == value) return entry.name;
  return {};
}

/// The value called `name`; nothing when there is none.
template <Choice T>
constexpr std::optional<T> named(std::string_view name) {
  for (const Named<T>& entry : kNames<T>)
    if (entry.name == name) return entry.value;
  return std::nullopt;
}

/// Which options a failure model takes: the one table that readers, the criterion and Python ask.
struct FailureOptions {
  bool file = false;        ///< it reads a model file
  bool meta_model = false;  ///< `pressure = "contact"` and `length_density = "ice"`: it is Eq. 17, without a foundation
  bool second_order = false;  ///< `second_order = true`: the in-plane force acts on the bent plate
  bool radial_first = false;  ///< `order = "radial-first"`: the sheet may split first
  bool knows_field = false;   ///< `pattern = "stress"` and `judged = "anywhere"`: it knows the stress as a field
  bool moving_edge = false;   ///< `edge = "dynamic"`: it knows an edge that moves
  bool joint_loads = false;   ///< `joint_loads = true`: it solves the sheet under several loads
};

/// @param own_file  the model file is not the one that comes with the program; only that one knows the split sheet.
constexpr FailureOptions options_of(FailureModel model, bool own_file) {
  switch (model) {
    case FailureModel::kNetwork:
    case FailureModel::kDeepNetwork:
      return {.file = true, .meta_model = true};
    case FailureModel::kSuperposition:
      return {.file = true, .second_order = true, .radial_first = !own_file};
    case FailureModel::kPlate:
      return {.second_order = true, .radial_first = true};
    case FailureModel::kPlateOutline:
      return {
          .second_order = true, .radial_first = true, .knows_field = true, .moving_edge = true, .joint_loads = true};
    case FailureModel::kWedge:
      return {};
  }
  return {};
}

}  // namespace brash::model
