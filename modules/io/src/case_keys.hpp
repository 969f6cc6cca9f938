// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>
#include <variant>

#include "brash/io/case.hpp"

namespace brash::io {

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
  auto kind = model::kind_of(variant);
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
void visit_keys_of(Is<model::Cone> auto& cone, auto&& visit) {
  visit_sloping_keys(cone, visit);
  visit("structure", "facets", cone.facets);
}
void visit_keys_of(Is<model::FacetedCone> auto& cone, auto&& visit) {
  visit_sloping_keys(cone, visit);
  visit("structure", "sides", cone.sides);
}
void visit_keys_of(Is<model::Plane> auto& plane, auto&& visit) {
  visit_sloping_keys(plane, visit);
  visit("structure", "length", plane.length);
}
void visit_keys_of(Is<model::WedgeBow> auto& bow, auto&& visit) {
  visit_sloping_keys(bow, visit);
  visit("structure", "length", bow.length);
  visit("structure", "entrance", bow.entrance);
}
/// A path takes the place of the speed.
void visit_keys_of(Is<model::Towed> auto& towed, auto&& visit) {
  visit("structure.motion", "path", towed.path);
  if (towed.path.empty()) visit("structure", "speed", towed.speed);
}
void visit_keys_of(Is<model::Compliant> auto& compliant, auto&& visit) {
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
  visit("structure.motion", "thrust_arm", body.thrust_arm);
}
void visit_keys_of(Is<model::Free> auto& free, auto&& visit) {
  visit("structure", "speed", free.speed);
  visit_body_keys(free.body, visit);
}
void visit_keys_of(Is<model::Moored> auto& moored, auto&& visit) {
  visit("structure", "speed", moored.speed);
  visit_body_keys(moored.body, visit);
  visit("structure.motion", "stiffness_matrix", moored.stiffness);
  visit("structure.motion", "pretension", moored.pretension);
  visit("structure.motion", "lines", moored.lines);
}
void visit_keys_of(Is<model::Driven> auto& driven, auto&& visit) { visit("structure", "speed", driven.speed); }

/// Whether the structure goes along a path, which says where it starts.
inline bool has_path(const model::StructureSection& structure) {
  const auto* const towed = std::get_if<model::Towed>(&structure.motion);
  return towed != nullptr && !towed->path.empty();
}

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
  if (!has_path(c.structure)) visit("structure", "start_distance", c.structure.start_distance);
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
}

}  // namespace brash::io
