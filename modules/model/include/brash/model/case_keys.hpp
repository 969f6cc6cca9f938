// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "brash/core/contract.hpp"
#include "brash/model/case.hpp"

namespace brash::model {

template <typename Variant, std::size_t... I>
Variant alternative(std::size_t index, std::index_sequence<I...>) {
  Variant made;
  ((I == index ? void(made.template emplace<I>()) : void()), ...);
  return made;
}

/// Visits the kind of a variant. The visitor of a case that is being read gives it, and every member of that
/// alternative then has its default.
template <typename AnyVariant, typename Visitor>
void visit_kind(const char* section, AnyVariant& variant, Visitor&& visit) {
  auto kind = kind_of(variant);
  visit(section, "kind", kind);
  if constexpr (!std::is_const_v<AnyVariant>)
    variant = alternative<AnyVariant>(static_cast<std::size_t>(kind),
                                      std::make_index_sequence<std::variant_size_v<AnyVariant>>());
}

template <typename Any, typename Value>
concept Is = std::is_same_v<std::remove_const_t<Any>, Value>;

/// Keys of each shape and each motion of [structure].
void visit_sloping_keys(auto& shape, auto&& visit) {
  visit("structure", "angle", shape.angle);
  visit("structure", "waterline_width", shape.waterline_width);
  visit("structure", "height", shape.height);
  visit("structure", "height_under_water", shape.height_under_water);
  visit("structure", "breaking", shape.breaking);
}
void visit_keys_of(Is<Cone> auto& cone, auto&& visit) {
  visit_sloping_keys(cone, visit);
  visit("structure", "facets", cone.facets);
}
void visit_keys_of(Is<FacetedCone> auto& cone, auto&& visit) {
  visit_sloping_keys(cone, visit);
  visit("structure", "sides", cone.sides);
}
void visit_keys_of(Is<Plane> auto& plane, auto&& visit) {
  visit_sloping_keys(plane, visit);
  visit("structure", "length", plane.length);
}
void visit_keys_of(Is<WedgeBow> auto& bow, auto&& visit) {
  visit_sloping_keys(bow, visit);
  visit("structure", "length", bow.length);
  visit("structure", "entrance", bow.entrance);
}
/// A ship is made of the keys of [hull], which the case has.
void visit_keys_of(Is<Ship> auto&, auto&&) {}
void visit_keys_of(Is<Mesh> auto& mesh, auto&& visit) {
  visit("structure", "file", mesh.file);
  visit("structure", "scale", mesh.scale);
  visit("structure", "draught", mesh.draught);
  visit("structure", "heading", mesh.heading);
  visit("structure", "heel", mesh.heel);
  visit("structure", "trim", mesh.trim);
}
/// A path takes the place of the speed.
void visit_keys_of(Is<Towed> auto& towed, auto&& visit) {
  visit("structure.motion", "path", towed.path);
  if (towed.path.empty()) visit("structure", "speed", towed.speed);
}
void visit_keys_of(Is<Compliant> auto& compliant, auto&& visit) {
  visit("structure", "speed", compliant.speed);
  visit("structure.motion", "mass", compliant.mass);
  visit("structure.motion", "stiffness", compliant.stiffness);
  visit("structure.motion", "damping", compliant.damping);
}
void visit_body_keys(auto& body, auto&& visit) {
  visit("structure.motion", "mass", body.mass);
  visit("structure.motion", "centre_of_gravity", body.centre_of_gravity);
  visit("structure.motion", "radii_of_gyration", body.radii_of_gyration);
  visit("structure.motion", "added_mass", body.added_mass);
  visit("structure.motion", "added_inertia", body.added_inertia);
  visit("structure.motion", "linear_damping", body.linear_damping);
  visit("structure.motion", "quadratic_damping", body.quadratic_damping);
  visit("structure.motion", "angular_damping", body.angular_damping);
  visit("structure.motion", "quadratic_angular_damping", body.quadratic_angular_damping);
  visit("structure.motion", "thrust", body.thrust);
  visit("structure.motion", "open_water_speed", body.open_water_speed);
  visit("structure.motion", "thrust_arm", body.thrust_arm);
}
void visit_keys_of(Is<Free> auto& free, auto&& visit) {
  visit("structure", "speed", free.speed);
  visit_body_keys(free.body, visit);
}
void visit_keys_of(Is<Moored> auto& moored, auto&& visit) {
  visit("structure", "speed", moored.speed);
  visit_body_keys(moored.body, visit);
  visit("structure.motion", "stiffness_matrix", moored.stiffness);
  visit("structure.motion", "pretension", moored.pretension);
  visit("structure.motion", "lines", moored.lines);
}
void visit_keys_of(Is<Driven> auto& driven, auto&& visit) { visit("structure", "speed", driven.speed); }

/// Whether the structure goes along a path, which says where it starts.
inline bool has_path(const StructureSection& structure) {
  const auto* const towed = std::get_if<Towed>(&structure.motion);
  return towed != nullptr && !towed->path.empty();
}

/// The speed of a structure has two names in case files; cases are written with the short one.
inline constexpr const char* kSpeed = "structure.speed";
inline constexpr const char* kLongSpeed = "structure.motion.speed";

/// Calls `visit(section, key, value)` for every key of a case: the one list that joins names in files to members. The
/// keys of an alternative come after its name.
template <typename AnyCase, typename Visitor>
void visit_material_keys(AnyCase& c, Visitor&& visit) {
  visit("algorithm", "preset", c.algorithm.preset);
  visit("ice", "thickness", c.ice.thickness);
  visit("ice", "density", c.ice.density);
  visit("ice", "youngs_modulus", c.ice.youngs_modulus);
  visit("ice", "poisson_ratio", c.ice.poisson_ratio);
  visit("ice", "flexural_strength", c.ice.flexural_strength);
  visit("ice", "compressive_strength", c.ice.compressive_strength);
  visit("ice", "fracture_toughness", c.ice.fracture_toughness);
  visit("ice", "crushing_factor", c.ice.crushing_factor);
  visit("ice", "friction_structure", c.ice.friction_structure);
  visit("ice", "friction_ice", c.ice.friction_ice);
  visit("ice.variation", "thickness", c.ice.variation.thickness);
  visit("ice.variation", "flexural_strength", c.ice.variation.flexural_strength);
  visit("ice.variation", "correlation_length", c.ice.variation.correlation_length);
  visit("water", "density", c.water.density);
  visit("water", "current", c.water.current);
  visit("water", "depth", c.water.depth);
  visit("water", "bed_friction", c.water.bed_friction);
  visit("wind", "velocity", c.wind.velocity);
  visit("wind", "density", c.wind.density);
  visit("wind", "skin_friction", c.wind.skin_friction);
  visit_kind("structure", c.structure.shape, visit);
  std::visit([&](auto& shape) { visit_keys_of(shape, visit); }, c.structure.shape);
  if (!std::holds_alternative<Ship>(c.structure.shape)) visit("structure", "legs", c.structure.legs);
  visit_kind("structure.motion", c.structure.motion, visit);
  std::visit([&](auto& motion) { visit_keys_of(motion, visit); }, c.structure.motion);
  visit("structure.motion", "frame", c.structure.frame);
  if (!has_path(c.structure)) visit("structure", "start_distance", c.structure.start_distance);
}

/// Keys of each kind of field.
template <typename AnyField, typename Visitor>
void visit_keys_of_field(AnyField& field, Visitor&& visit) {
  if (has_level_ice(field)) {
    visit("field", "initial_crack", field.initial_crack);
    visit("field", "initial_crack_radius", field.initial_crack_radius);
    visit("field", "edge_roughness", field.edge_roughness);
    visit("field", "edge_correlation_length", field.edge_correlation_length);
    visit("field", "border", field.border);
    visit("field", "smallest_plate", field.smallest_plate);
    visit("field", "file", field.file);
    visit("field", "openings", field.openings);
    visit("field", "cracks", field.cracks);
    visit("field", "shore", field.shore);
    visit("field", "origin", field.origin);
    return;
  }
  auto& floes = field.floes;
  visit("field", "file", field.file);
  visit("field", "concentration", floes.concentration);
  visit("field", "shape", floes.shape);
  visit("field", "border", floes.border);
  visit("field", "smallest_plate", field.smallest_plate);
  visit("field", "shore", field.shore);
  visit("field", "origin", field.origin);
  auto& size = floes.size;
  visit("field.size", "kind", size.kind);
  switch (size.kind) {
    case SizeLaw::kPowerLaw:
      visit("field.size", "exponent", size.exponent);
      visit("field.size", "least", size.least);
      visit("field.size", "largest", size.largest);
      return;
    case SizeLaw::kLogNormal:
      visit("field.size", "median", size.median);
      visit("field.size", "deviation", size.deviation);
      return;
    case SizeLaw::kList:
      visit("field.size", "values", size.values);
      return;
  }
}

template <typename AnyCase, typename Visitor>
void visit_keys(AnyCase& c, Visitor&& visit) {
  visit_material_keys(c, visit);
  visit("field", "kind", c.field.kind);
  visit("field", "length", c.field.length);
  visit("field", "width", c.field.width);
  visit_keys_of_field(c.field, visit);
  visit("failure", "model", c.failure.model);
  visit("failure", "file", c.failure.file);
  visit("failure", "order", c.failure.order);
  visit("failure", "second_order", c.failure.second_order);
  visit("failure", "under_floes", c.failure.under_floes);
  visit("failure", "joint_loads", c.failure.joint_loads);
  visit("failure", "edge", c.failure.edge);
  visit("failure", "judged", c.failure.judged);
  visit("failure", "pattern", c.failure.pattern);
  visit("failure", "pressure", c.failure.pressure);
  visit("failure", "length_density", c.failure.length_density);
  visit("failure", "small_contact", c.failure.small_contact);
  visit("failure", "crushed_ice", c.failure.crushed_ice);
  visit("failure", "pieces", c.failure.pieces);
  visit("failure", "wedges", c.failure.wedges);
  visit("failure", "lateness", c.failure.lateness);
  visit("failure", "smallest_floe", c.failure.smallest_floe);
  visit("contact", "engine", c.contact.engine);
  visit("contact", "restitution", c.contact.restitution);
  visit("contact", "area", c.contact.area);
  visit("contact", "crushing_bound", c.contact.crushing_bound);
  visit("contact", "margin", c.contact.margin);
  visit("contact", "iterations", c.contact.iterations);
  visit("contact", "collision_stiffness", c.contact.stiffness);
  visit("contact", "floe_stress", c.contact.floe_stress);
  visit("hydrodynamics", "drag", c.hydrodynamics.drag);
  visit("hydrodynamics", "shading", c.hydrodynamics.shading);
  visit("hydrodynamics", "shading_gap", c.hydrodynamics.shading_gap);
  visit("hydrodynamics", "drag_travel", c.hydrodynamics.drag_travel);
  visit("hydrodynamics", "form_drag", c.hydrodynamics.form_drag);
  visit("hydrodynamics", "form_drag_along", c.hydrodynamics.form_drag_along);
  visit("hydrodynamics", "rotational_drag", c.hydrodynamics.rotational_drag);
  visit("hydrodynamics", "skin_friction", c.hydrodynamics.skin_friction);
  visit("hydrodynamics", "added_mass_law", c.hydrodynamics.added_mass_law);
  visit("hydrodynamics", "added_mass", c.hydrodynamics.added_mass);
  visit("hydrodynamics", "ventilation", c.hydrodynamics.ventilation);
  visit("hydrodynamics", "structure_flow", c.hydrodynamics.structure_flow);
  visit("time", "step", c.time.step);
  visit("time", "duration", c.time.duration);
  visit("time", "settle_speed", c.time.settle_speed);
  visit("random", "seed", c.random.seed);
  visit("random", "replicate", c.random.replicate);
  visit("output", "frames_per_second", c.output.frames_per_second);
  visit("output", "checkpoint_interval", c.output.checkpoint_interval);
  visit("output", "statistics_from", c.output.statistics_from);
  visit("reference", "mean_horizontal", c.reference.mean_horizontal);
  visit("reference", "source", c.reference.source);
  visit("hull", "length", c.hull.length);
  visit("hull", "breadth", c.hull.breadth);
  visit("hull", "draught", c.hull.draught);
  visit("hull", "stem_angle", c.hull.stem_angle);
  visit("hull", "waterline_angle", c.hull.waterline_angle);
  visit("hull", "depth", c.hull.depth);
  visit("hull", "bow_length", c.hull.bow_length);
  visit("hull", "flare", c.hull.flare);
  visit("hull", "midbody", c.hull.midbody);
  visit("hull", "stern_angle", c.hull.stern_angle);
}

/// Calls `visit(key, file)` for each file that [field] may name; an empty one names none.
template <typename AnyField, typename Visitor>
void visit_files_of_field(AnyField& field, Visitor&& visit) {
  visit("file", field.file);
  visit("openings", field.openings);
  visit("cracks", field.cracks);
  visit("shore", field.shore);
}

/// The members of a case that name files: the model of the failure, the mesh of the structure, the ice and the shore.
inline std::vector<std::string*> files_of(Case& c) {
  std::vector<std::string*> files{&c.failure.file};
  visit_files_of_field(c.field, [&](const char*, std::string& file) { files.push_back(&file); });
  if (auto* const mesh = std::get_if<Mesh>(&c.structure.shape)) files.push_back(&mesh->file);
  return files;
}

namespace detail {

/// The numbers of a row of a table in a case, in the order of case files.
inline std::array<double, 4> numbers_of(const Waypoint& w) { return {w.time, w.position.x, w.position.y, w.heading}; }
inline std::array<double, 9> numbers_of(const MooringLine& l) {
  return {l.anchor.x,   l.anchor.y, l.anchor.z, l.fairlead.x, l.fairlead.y,
          l.fairlead.z, l.length,   l.weight,   l.stiffness};
}
inline void take_numbers(Waypoint& w, const std::array<double, 4>& n) { w = {n[0], {n[1], n[2]}, n[3]}; }
inline void take_numbers(MooringLine& l, const std::array<double, 9>& n) {
  l = {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, n[6], n[7], n[8]};
}

template <typename Value>
concept Row = requires(const Value& value) {
  numbers_of(value);
};

template <typename Tree, typename Value>
Tree tree_of(const Value& value) {
  if constexpr (Choice<Value>)
    return std::string(name_of(value));
  else if constexpr (std::is_same_v<Value, Vec2>)
    return std::array{value.x, value.y};
  else if constexpr (std::is_same_v<Value, Vec3>)
    return std::array{value.x, value.y, value.z};
  else if constexpr (Row<Value>)
    return numbers_of(value);
  else
    return value;
}

/// Absent optional values and empty tables have no key.
template <typename Tree, typename Value>
void put(Tree& keys, const char* key, const Value& value) {
  keys[key] = tree_of<Tree>(value);
}
template <typename Tree, typename Value>
void put(Tree& keys, const char* key, const std::optional<Value>& value) {
  if (value) put(keys, key, *value);
}
template <typename Tree, typename Item>
void put(Tree& keys, const char* key, const std::vector<Item>& items) {
  for (const Item& item : items) keys[key].push_back(tree_of<Tree>(item));
}

template <typename Value>
void read(Value& value, const auto& tree) {
  if constexpr (Choice<Value>) {
    const auto text = tree.template get<std::string>();
    const auto known = named<Value>(text);
    BRASH_EXPECTS(known.has_value(), text);  // whoever checked the tree knows the same names
    value = *known;
  } else if constexpr (std::is_same_v<Value, Vec2>) {
    value = {tree.at(0).template get<double>(), tree.at(1).template get<double>()};
  } else if constexpr (std::is_same_v<Value, Vec3>) {
    value = {tree.at(0).template get<double>(), tree.at(1).template get<double>(), tree.at(2).template get<double>()};
  } else if constexpr (Row<Value>) {
    take_numbers(value, tree.template get<decltype(numbers_of(value))>());
  } else {
    tree.get_to(value);
  }
}

template <typename Value>
void take(Value& value, const auto& section, const char* key) {
  read(value, section.at(key));
}
template <typename Value>
void take(std::optional<Value>& value, const auto& section, const char* key) {
  if (section.contains(key)) read(value.emplace(), section.at(key));
}
template <typename Item>
void take(std::vector<Item>& items, const auto& section, const char* key) {
  if (!section.contains(key)) return;
  for (const auto& item : section.at(key)) read(items.emplace_back(), item);
}

}  // namespace detail

/// A case as a tree of sections and keys, and back: `tree["ice"]["thickness"]`, "ice.variation" a section of its own.
/// `Tree` is a JSON value of nlohmann's, or acts as one.
template <typename Tree>
Tree to_tree(const Case& c) {
  Tree tree;
  visit_keys(c,
             [&](const char* section, const char* key, const auto& value) { detail::put(tree[section], key, value); });
  return tree;
}

/// @throws ContractViolation when the tree has a key that no case has, or a choice without its name; what `Tree` throws
///         when a key is missing or its value has another type.
template <typename Tree>
Case from_tree(const Tree& tree) {
  Case c;
  std::set<std::pair<std::string, std::string>> known;
  visit_keys(c, [&](const char* section, const char* key, auto& value) {
    detail::take(value, tree.at(section), key);
    known.emplace(section, key);
  });
  for (const auto& [section, keys] : tree.items())
    for (const auto& [key, value] : keys.items()) BRASH_EXPECTS(known.contains({section, key}), section, key);
  if (auto* const ship = std::get_if<Ship>(&c.structure.shape)) ship->hull = c.hull;
  return c;
}

}  // namespace brash::model
