// SPDX-License-Identifier: GPL-3.0-or-later
#include "region_loads.hpp"

namespace brash::simulation {

model::RegionLoad& RegionLoadSums::at(const Pose& structure, Vec3 point, Vec3 outward) {
  return sums_[(*regions_)->at(to_body(structure, point), rotate(conjugate(structure.rotation), outward))];
}

void RegionLoadSums::add_crushing(const Pose& structure, Vec3 point, Vec3 outward, Vec3 force) {
  if (!*regions_) return;
  model::RegionLoad& load = at(structure, point, outward);
  load.total = load.total + force;
  load.crushing = load.crushing + force;
}

void RegionLoadSums::add_floe(const Pose& structure, Vec3 point, Vec3 outward, Vec3 force) {
  if (!*regions_) return;
  model::RegionLoad& load = at(structure, point, outward);
  load.total = load.total + force;
}

model::RegionLoads RegionLoadSums::in(const LoadAxes& axes) const {
  model::RegionLoads loads;
  if (!*regions_) return loads;
  for (std::size_t i = 0; i < loads.size(); ++i)
    loads[i] = {axes({sums_[i].total, {}}).force, axes({sums_[i].crushing, {}}).force};
  return loads;
}

}  // namespace brash::simulation
