// SPDX-License-Identifier: GPL-3.0-or-later
// Keys that differ from their defaults and that nothing in the case reads: most often another key was forgotten.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "brash/ice/variation.hpp"
#include "brash/model/case_keys.hpp"
#include "case_warnings.hpp"

namespace brash::advice {
namespace {

bool names_a_file(const model::FieldSection& field) {
  bool names = false;
  model::visit_files_of_field(field, [&](const char*, const std::string& file) { names |= !file.empty(); });
  return names;
}

class IdleKeys {
 public:
  /// @param acts   whether the case reads this key.
  /// @param needs  what would make it act.
  template <typename Value>
  void look_at(const char* key, const Value& value, const Value& by_default, bool acts, const char* needs) {
    if (value != by_default && !acts) idle_.push_back(fmt::format("{} needs {}", key, needs));
  }

  const std::vector<std::string>& all() const { return idle_; }

 private:
  std::vector<std::string> idle_;
};

void look_at_ice(const model::Case& c, const model::Case& usual, IdleKeys& keys) {
  const bool has_floes = c.field.kind == model::FieldKind::kFloes,
             may_drift = c.contact.engine == model::ContactEngine::kBrash;
  const bool drifts = may_drift && (has_floes || c.field.border == model::Border::kFree);
  const char* const drifting = "field.border = \"free\" or field.kind = \"floes\", and contact.engine = \"brash\"";
  keys.look_at("ice.fracture_toughness", c.ice.fracture_toughness, usual.ice.fracture_toughness, drifts, drifting);
  keys.look_at("field.smallest_plate", c.field.smallest_plate, usual.field.smallest_plate, drifts, drifting);
  keys.look_at("ice.variation.correlation_length", c.ice.variation.correlation_length,
               usual.ice.variation.correlation_length, ice::varies(c.ice),
               "ice.variation.thickness or ice.variation.flexural_strength");
  keys.look_at("field.initial_crack_radius", c.field.initial_crack_radius, usual.field.initial_crack_radius,
               c.field.initial_crack, "field.initial_crack = true");
  keys.look_at("field.edge_correlation_length", c.field.edge_correlation_length, usual.field.edge_correlation_length,
               c.field.edge_roughness > 0.0, "field.edge_roughness");
  keys.look_at("field.origin", c.field.origin, usual.field.origin, names_a_file(c.field),
               "field.file, openings, cracks or shore");
  keys.look_at("time.settle_speed", c.time.settle_speed, usual.time.settle_speed,
               has_floes || c.field.border != model::Border::kFree,
               "field.border = \"fixed\" or field.kind = \"floes\"");
  const char* const generated = "floes without field.file";
  keys.look_at("field.shape", c.field.floes.shape, usual.field.floes.shape, c.field.file.empty(), generated);
  keys.look_at("field.size", c.field.floes.size, usual.field.floes.size, c.field.file.empty(), generated);
}

void look_at_water_and_wind(const model::Case& c, const model::Case& usual, IdleKeys& keys) {
  const model::HydrodynamicsSection& h = c.hydrodynamics;
  const bool by_surface = h.drag == model::DragLaw::kSurface, blows = c.wind.velocity != Vec2{};
  keys.look_at("hydrodynamics.rotational_drag", h.rotational_drag, usual.hydrodynamics.rotational_drag, !by_surface,
               "hydrodynamics.drag = \"paper\"");
  keys.look_at("hydrodynamics.shading_gap", h.shading_gap, usual.hydrodynamics.shading_gap, by_surface && h.shading,
               "hydrodynamics.shading = true and drag = \"surface\"");
  keys.look_at("hydrodynamics.form_drag_along", h.form_drag_along, usual.hydrodynamics.form_drag_along,
               h.form_drag != 0.0, "hydrodynamics.form_drag");
  keys.look_at("water.bed_friction", c.water.bed_friction, usual.water.bed_friction, c.water.depth.has_value(),
               "water.depth");
  keys.look_at("wind.density", c.wind.density, usual.wind.density, blows, "wind.velocity");
  keys.look_at("wind.skin_friction", c.wind.skin_friction, usual.wind.skin_friction, blows, "wind.velocity");
}

/// The closed form of a ship beside another structure reads five keys of [hull], and these are not among them.
void look_at_hull(const model::Case& c, IdleKeys& keys) {
  const bool is_ship = std::holds_alternative<model::Ship>(c.structure.shape);
  const std::optional<double> absent;
  const char* const ship = "structure.kind = \"ship\"";
  keys.look_at("hull.depth", c.hull.depth, absent, is_ship, ship);
  keys.look_at("hull.bow_length", c.hull.bow_length, absent, is_ship, ship);
  keys.look_at("hull.flare", c.hull.flare, absent, is_ship, ship);
  keys.look_at("hull.midbody", c.hull.midbody, absent, is_ship, ship);
  keys.look_at("hull.stern_angle", c.hull.stern_angle, absent, is_ship, ship);
}

/// Replicates of a case that draws nothing are all alike.
void look_at_random(const model::Case& c, const model::Case& usual, IdleKeys& keys) {
  const bool is_generated = c.field.kind == model::FieldKind::kFloes && c.field.file.empty();
  const bool draws = is_generated || ice::varies(c.ice) || c.failure.wedges[0] != c.failure.wedges[1];
  const char* const drawn = "something random: failure.wedges, ice.variation or generated floes";
  keys.look_at("random.seed", c.random.seed, usual.random.seed, draws, drawn);
  keys.look_at("random.replicate", c.random.replicate, usual.random.replicate, draws, drawn);
}

}  // namespace

void add_idle_keys_warning(const model::Case& c, Warnings& warnings) {
  const model::Case usual;
  IdleKeys keys;
  look_at_ice(c, usual, keys);
  look_at_water_and_wind(c, usual, keys);
  look_at_hull(c, keys);
  look_at_random(c, usual, keys);
  const model::FailureOptions takes = model::options_of(c.failure.model, !c.failure.file.empty());
  keys.look_at("failure.small_contact", c.failure.small_contact, usual.failure.small_contact, takes.file,
               "failure.model = \"network\", \"deep-network\" or \"superposition\"");
  keys.look_at("failure.lateness", c.failure.lateness, 0.0, takes.knows_field, "failure.model = \"plate-outline\"");
  if (const model::FloatingBody* const body = afloat(c.structure.motion))
    keys.look_at("structure.motion.thrust_arm", body->thrust_arm, Vec3{}, body->thrust != Vec3{},
                 "structure.motion.thrust");
  keys.look_at("reference.source", c.reference.source, usual.reference.source,
               c.reference.mean_horizontal.has_value() || names_a_basin(c.reference.source),
               "reference.mean_horizontal");
  if (keys.all().empty()) return;
  warnings.push_back({"idle-keys", fmt::format("keys that do nothing in this case: {}; remove them, or write what they "
                                               "need",
                                               fmt::join(keys.all(), "; "))});
}

}  // namespace brash::advice
