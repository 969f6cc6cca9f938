// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "brash/rigid_body/world.hpp"
#include "pack.hpp"

namespace pack {

namespace {

using brash::BodyId;
using brash::Vec2;
namespace rigid_body = brash::rigid_body;

std::vector<brash::Vec3> box(brash::Vec3 from, brash::Vec3 to) {
  std::vector<brash::Vec3> corners;
  for (const double x : {from.x, to.x})
    for (const double y : {from.y, to.y})
      for (const double z : {from.z, to.z}) corners.push_back({x, y, z});
  return corners;
}

class BrashEngine : public Engine {
 public:
  BrashEngine(const Pack& pack, const Settings& settings)
      : pack_(pack),
        dt_(settings.dt),
        world_({.ice_structure = {0.0, settings.crushing},
                .ice_ice = {kFriction, settings.crushing},
                .iterations = settings.iterations}) {
    for (const Floe& floe : pack.floes) {
      const double x = 0.5 * floe.size.x, y = 0.5 * floe.size.y;
      const std::vector<std::vector<Vec2>> ring{{{-x, -y}, {x, -y}, {x, y}, {-x, y}}};
      auto placed = rigid_body::place_prism(ring, ring, floe.size.z, 0.0);
      placed.pose.position = {floe.start.x, floe.start.y, floe.start.z};
      const double density = floe.mass / (floe.size.x * floe.size.y * floe.size.z);
      ids_.push_back(
          world_.add_floe(placed.prism, rigid_body::mass_properties(placed.prism, density, 0.0), placed.pose));
    }
    constexpr double e = kBedExtent;
    structure_ =
        world_.add_structure(std::array{box({-1.0, -e, -1.0}, {e, e, 0.0}), box({-1.0, -e, 0.0}, {0.0, e, e})}, {});
  }

  Loads step() override {
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      const double weight = pack_.floes[i].mass * kGravity;
      world_.apply(ids_[i], {{-kPush * weight, 0.0, -weight}, {}});
    }
    world_.step(dt_);
    Loads loads;
    for (const auto& contact : world_.contacts()) {
      if (contact.other != structure_) continue;
      loads.bed += contact.normal_force * contact.normal.z;
      loads.wall += contact.normal_force * contact.normal.x;
    }
    return loads;
  }

  Vec3 centre(std::size_t floe) const override {
    const brash::Vec3 at = world_.pose(ids_[floe]).position;
    return {at.x, at.y, at.z};
  }

 private:
  const Pack& pack_;
  double dt_;
  rigid_body::World world_;
  std::vector<BodyId> ids_;
  BodyId structure_;
};

}  // namespace

std::unique_ptr<Engine> make_engine(const Pack& pack, const Settings& settings) {
  return std::make_unique<BrashEngine>(pack, settings);
}

}  // namespace pack
