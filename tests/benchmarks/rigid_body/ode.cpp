// SPDX-License-Identifier: GPL-3.0-or-later
#include <ode/ode.h>

#include <array>
#include <deque>

#include "pack.hpp"

namespace pack {

namespace {

constexpr int kMostPoints = 8;  ///< of two boxes
constexpr double kErp = 0.2;    ///< share of the overlap that a step takes back: ODE's default

class OdeEngine : public Engine {
 public:
  OdeEngine(const Pack& pack, const Settings& settings) : pack_(pack), dt_(settings.dt) {
    dInitODE2(0);
    world_ = dWorldCreate();
    space_ = dHashSpaceCreate(nullptr);
    joints_ = dJointGroupCreate(0);
    dWorldSetQuickStepNumIterations(world_, settings.iterations);
    dWorldSetCFM(world_, 0.0);
    dWorldSetERP(world_, kErp);
    dWorldSetContactSurfaceLayer(world_, kLayer);
    bed_ = dCreatePlane(space_, 0, 0, 1, 0);
    wall_ = dCreatePlane(space_, 1, 0, 0, 0);
    for (const Floe& floe : pack.floes) {
      dMass mass;
      dMassSetBoxTotal(&mass, floe.mass, floe.size.x, floe.size.y, floe.size.z);
      bodies_.push_back(dBodyCreate(world_));
      dBodySetMass(bodies_.back(), &mass);
      dBodySetPosition(bodies_.back(), floe.start.x, floe.start.y, floe.start.z);
      dGeomSetBody(dCreateBox(space_, floe.size.x, floe.size.y, floe.size.z), bodies_.back());
    }
  }
  ~OdeEngine() override {
    dJointGroupDestroy(joints_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
    dCloseODE();
  }
  OdeEngine(const OdeEngine&) = delete;

  Loads step() override {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const double weight = pack_.floes[i].mass * kGravity;
      dBodyAddForce(bodies_[i], -kPush * weight, 0.0, -weight);
    }
    dJointGroupEmpty(joints_);
    on_bed_.clear();
    on_wall_.clear();
    dSpaceCollide(space_, this, [](void* self, dGeomID a, dGeomID b) { static_cast<OdeEngine*>(self)->meet(a, b); });
    dWorldQuickStep(world_, dt_);
    Loads loads;
    for (const dJointFeedback& feedback : on_bed_) loads.bed += feedback.f1[2];
    for (const dJointFeedback& feedback : on_wall_) loads.wall += feedback.f1[0];
    return loads;
  }

  Vec3 centre(std::size_t floe) const override {
    const dReal* p = dBodyGetPosition(bodies_[floe]);
    return {p[0], p[1], p[2]};
  }

 private:
  static constexpr double kLayer = 1e-5;  ///< depth that is left, so that contacts last [m]

  void meet(dGeomID a, dGeomID b) {
    if (dGeomGetBody(a) == nullptr) std::swap(a, b);
    if (dGeomGetBody(a) == nullptr) return;
    std::array<dContactGeom, kMostPoints> points;
    const int n = dCollide(a, b, kMostPoints, points.data(), sizeof(dContactGeom));
    const bool is_fixed = b == bed_ || b == wall_;
    for (int i = 0; i < n; ++i) {
      dContact contact{};
      contact.surface.mode = dContactApprox1;
      contact.surface.mu = is_fixed ? 0.0 : kFriction;
      contact.geom = points[static_cast<std::size_t>(i)];
      const dJointID joint = dJointCreateContact(world_, joints_, &contact);
      dJointAttach(joint, dGeomGetBody(a), dGeomGetBody(b));
      if (is_fixed) dJointSetFeedback(joint, &(b == bed_ ? on_bed_ : on_wall_).emplace_back());
    }
  }

  const Pack& pack_;
  double dt_;
  dWorldID world_;
  dSpaceID space_;
  dJointGroupID joints_;
  dGeomID bed_;
  dGeomID wall_;
  std::vector<dBodyID> bodies_;
  std::deque<dJointFeedback> on_bed_;
  std::deque<dJointFeedback> on_wall_;
};

}  // namespace

std::unique_ptr<Engine> make_engine(const Pack& pack, const Settings& settings) {
  return std::make_unique<OdeEngine>(pack, settings);
}

}  // namespace pack
