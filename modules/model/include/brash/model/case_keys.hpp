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
void visit_keys_of(Is<Towed> auto& towed, auto&& visit) { visit("structure", "speed", towed.speed); }
void visit_keys_of(Is<Compliant> auto& compliant, auto&& visit) {
  visit("structure", "speed", compliant.speed);
  visit("structure.motion", "mass", compliant.mass);
  visit("structure.motion", "stiffness", compliant.stiffness);
  visit("structure.motion", "damping", compliant.damping);
}
void visit_keys_of(Is<model::Driven> auto& driven, auto&& visit) { visit("structure", "speed", driven.speed); }

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
  visit("ice", "crushing_factor", c.ice.crushing_factor);
  visit("ice", "friction_structure", c.ice.friction_structure);
  visit("ice", "friction_ice", c.ice.friction_ice);
  visit("ice.variation", "thickness", c.ice.variation.thickness);
  visit("ice.variation", "flexural_strength", c.ice.variation.flexural_strength);
  visit("ice.variation", "correlation_length", c.ice.variation.correlation_length);
  visit("water", "density", c.water.density);
  visit("water", "current", c.water.current);
  visit_kind("structure", c.structure.shape, visit);
  std::visit([&](auto& shape) { visit_keys_of(shape, visit); }, c.structure.shape);
  visit_kind("structure.motion", c.structure.motion, visit);
  std::visit([&](auto& motion) { visit_keys_of(motion, visit); }, c.structure.motion);
  visit("structure.motion", "frame", c.structure.frame);
  visit("structure", "start_distance", c.structure.start_distance);
}

template <typename AnyCase, typename Visitor>
void visit_keys(AnyCase& c, Visitor&& visit) {
  visit_material_keys(c, visit);
  visit("field", "kind", c.field.kind);
  visit("field", "length", c.field.length);
  visit("field", "width", c.field.width);
  visit("field", "initial_crack", c.field.initial_crack);
  visit("field", "initial_crack_radius", c.field.initial_crack_radius);
  visit("failure", "model", c.failure.model);
  visit("failure", "file", c.failure.file);
  visit("failure", "order", c.failure.order);
  visit("failure", "second_order", c.failure.second_order);
  visit("failure", "under_floes", c.failure.under_floes);
  visit("failure", "joint_loads", c.failure.joint_loads);
  visit("failure", "edge", c.failure.edge);
  visit("failure", "judged", c.failure.judged);
  visit("failure", "pattern", c.failure.pattern);
  visit("failure", "pieces", c.failure.pieces);
  visit("failure", "wedges", c.failure.wedges);
  visit("failure", "arc_sides", c.failure.arc_sides);
  visit("failure", "max_substeps", c.failure.max_substeps);
  visit("failure", "smallest_floe", c.failure.smallest_floe);
  visit("contact", "engine", c.contact.engine);
  visit("contact", "restitution", c.contact.restitution);
  visit("contact", "area", c.contact.area);
  visit("contact", "margin", c.contact.margin);
  visit("contact", "iterations", c.contact.iterations);
  visit("contact", "stiffness", c.contact.stiffness);
  visit("contact", "delete_crushed", c.contact.delete_crushed);
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

/// The members of a case that name files: the model of the failure, and the mesh of the structure.
inline std::vector<std::string*> files_of(Case& c) {
  std::vector<std::string*> files{&c.failure.file};
  if (auto* const mesh = std::get_if<Mesh>(&c.structure.shape)) files.push_back(&mesh->file);
  return files;
}

/// A case as a tree of sections and keys, and back: `tree["ice"]["thickness"]`, "ice.variation" a section of its own.
/// `Tree` is a JSON value of nlohmann's, or acts as one. Absent optional numbers have no key.
template <typename Tree>
Tree to_tree(const Case& c) {
  Tree tree;
  const auto add = [&](const char* section, const char* key, const auto& value) {
    using Value = std::remove_cvref_t<decltype(value)>;
    auto& keys = tree[section];
    if constexpr (Choice<Value>)
      keys[key] = std::string(name_of(value));
    else if constexpr (std::is_same_v<Value, Vec2>)
      keys[key] = std::array{value.x, value.y};
    else if constexpr (!std::is_same_v<Value, std::optional<double>>)
      keys[key] = value;
    else if (value)
      keys[key] = *value;
  };
  visit_keys(c, add);
  return tree;
}

namespace detail {

template <typename Value>
void take(Value& value, const auto& section, const char* key) {
  section.at(key).get_to(value);
}
template <Choice Value>
void take(Value& value, const auto& section, const char* key) {
  const auto text = section.at(key).template get<std::string>();
  const auto known = named<Value>(text);
  BRASH_EXPECTS(known.has_value(), key, text);  // whoever checked the tree knows the same names
  value = *known;
}
inline void take(Vec2& value, const auto& section, const char* key) {
  value = {section.at(key).at(0).template get<double>(), section.at(key).at(1).template get<double>()};
}
inline void take(std::optional<double>& value, const auto& section, const char* key) {
  if (section.contains(key)) value = section.at(key).template get<double>();
}

}  // namespace detail

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
