// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/simulator/session.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "brash/advice/advice.hpp"
#include "brash/core/version.hpp"
#include "brash/io/case.hpp"
#include "brash/structure/hull.hpp"

namespace brash::simulator {
namespace {

using nlohmann::ordered_json;

/// Rings as a report's page stores them: nodes of each ring, then all coordinates.
void add_rings(ordered_json& arrays, const std::string& name, const std::vector<std::vector<Vec2>>& rings) {
  ordered_json nodes = ordered_json::array(), x = ordered_json::array(), y = ordered_json::array();
  for (const auto& ring : rings) {
    nodes.push_back(ring.size());
    for (const Vec2 node : ring) {
      x.push_back(node.x);
      y.push_back(node.y);
    }
  }
  arrays[name + ".rings"] = {rings.size()};
  arrays[name + ".nodes"] = std::move(nodes);
  arrays[name + ".x"] = std::move(x);
  arrays[name + ".y"] = std::move(y);
}

/// The structure's mesh and its waterline at rest, in its own frame.
ordered_json structure_arrays(const structure::Hull& hull) {
  ordered_json arrays;
  for (const auto& [name, part] : {std::pair("mesh.x", &Vec3::x), {"mesh.y", &Vec3::y}, {"mesh.z", &Vec3::z}}) {
    arrays[name] = ordered_json::array();
    for (const Vec3& vertex : hull.mesh().vertices) arrays[name].push_back(vertex.*part);
  }
  arrays["mesh.triangles"] = ordered_json::array();
  for (const auto& triangle : hull.mesh().triangles)
    for (const auto corner : triangle) arrays["mesh.triangles"].push_back(corner);
  add_rings(arrays, "waterline", hull.footprint({}, 0.0, 0.0).leading);
  arrays["structure.end"] = {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0};
  return arrays;
}

}  // namespace

Session::Session(model::Case resolved) : case_(std::move(resolved)), simulation_(case_), records_(case_) {}

std::string Session::head() const {
  return ordered_json{{"kind", "live"},
                      {"manifest",
                       {{"program", {{"name", "brash"}, {"version", kVersion}}},
                        {"seeds", {{"seed", case_.random.seed}}},
                        {"case", {{"name", case_.name}, {"toml", io::to_toml(case_)}}}}},
                      {"arrays", structure_arrays(*structure::make_hull(case_.structure))}}
      .dump();
}

std::string Session::start() {
  records_.add_frame(simulation_);
  return records_.next();
}

bool Session::is_done() const { return n_steps_ >= std::llround(case_.time.duration / case_.time.step); }

std::string Session::advance(int n_steps) {
  bool has_frame = true;
  for (int i = 0; i < n_steps && !is_done(); ++i) {
    const simulation::StepReport report = simulation_.step();
    ++n_steps_;
    has_frame = records_.take(simulation_, report);
  }
  if (!has_frame) records_.add_frame(simulation_);
  return records_.next();
}

std::string description(const model::Case& resolved) {
  const simulation::Setup setup(resolved);
  const simulation::DerivedScales& scales = setup.scales;
  ordered_json derived = ordered_json::array(), warnings = ordered_json::array();
  const auto add = [&](const char* name, double value, const char* unit) {
    derived.push_back({{"name", name}, {"value", value}, {"unit", unit}});
  };
  add("characteristic length l_c", scales.characteristic_length, "m");
  add("thickness / l_c", scales.thickness_over_lc, "1");
  add("mu1 straight ahead", scales.mu1, "1");
  add("freeboard", scales.freeboard, "m");
  add("draft", scales.draft, "m");
  add("T_col of a piece l_c x l_c / 4", scales.collision_time, "s");
  if (model::has_level_ice(resolved.field) && resolved.field.initial_crack)
    add("initial crack radius", scales.initial_crack_radius, "m");
  if (scales.correlation_length > 0.0) add("correlation length of the ice", scales.correlation_length, "m");
  for (const model::Warning& warning : advice::warnings_of(setup))
    warnings.push_back({{"id", warning.id}, {"text", warning.text}});
  return ordered_json{{"toml", io::to_toml(resolved)}, {"derived", derived}, {"warnings", warnings}}.dump();
}

}  // namespace brash::simulator
