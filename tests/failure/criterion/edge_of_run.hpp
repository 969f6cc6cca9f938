// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "brash/edge/edge_contact.hpp"
#include "brash/edge/sheet_loads.hpp"
#include "brash/io/case.hpp"
#include "brash/simulation/simulation.hpp"

namespace brash::testing {

/// The validation case with the preset `brash`, and its ice edge as each step finds it.
class EdgeOfRun {
 public:
  explicit EdgeOfRun(int seed)
      : resolved(io::read_case(BRASH_SOURCE_DIR "/experiments/validation/cone.toml",
                               {"algorithm.preset=brash", "random.seed=" + std::to_string(seed)})),
        ice(edge::ice_properties(resolved)),
        hull(structure::make_hull(resolved.structure)),
        simulation(resolved),
        motion_(structure::make_motion(resolved, *hull)) {}

  bool is_over() const { return simulation.time() >= resolved.time.duration; }

  /// The sheet that the next step breaks: the structure has crushed the ice that it passes through.
  geometry::IceSheet next_sheet(const edge::EdgeModel& model) const {
    auto sheet = geometry::IceSheet::from_polygons(simulation.sheet());
    for (const geometry::Ring& outline : edge::trailing_outlines(model, motion_->after(1.0).pose))
      (void)sheet.value().cut(outline);
    return std::move(sheet.value());
  }
  std::vector<edge::EdgeContact> next_contacts(const edge::EdgeModel& model, const geometry::IceSheet& sheet) const {
    return edge::edge_contacts(model, sheet, motion_->after(1.0));
  }

  simulation::StepReport step() {
    motion_->advance(1.0);
    return simulation.step();
  }

  const model::Case resolved;
  const failure::IceProperties ice;
  const std::unique_ptr<const structure::Hull> hull;
  simulation::Simulation simulation;

 private:
  std::unique_ptr<structure::Motion> motion_;
};

}  // namespace brash::testing
