// SPDX-License-Identifier: GPL-3.0-or-later
#include <Friction_cst.h>
#include <SolverOptions.h>

#include <BulletR.hpp>
#include <RigidBodyDS.hpp>
#include <SiconosBulletCollisionManager.hpp>
#include <SiconosContactor.hpp>
#include <SiconosKernel.hpp>
#include <cmath>

#include "pack.hpp"

// Debian's library checks its graph of all contacts at every change of it, which takes most of the time and grows with
// the square of their number. The check calls these functions, which here find no fault at once.
using ContactGraph = SiconosGraph<SP::Interaction, SP::DynamicalSystem, InteractionProperties,
                                  DynamicalSystemProperties, GraphProperties>;
template <>
bool ContactGraph::adjacent_vertices_ok() const {
  return true;
}
template <>
bool ContactGraph::state_assert() const {
  return true;
}

namespace pack {

namespace {

constexpr double kMargin = 0.01;  ///< rounds the boxes for Bullet; inside of them, as contacts take no notice of it [m]
constexpr double kActive = 5e-4;  ///< a contact acts when the floes will come nearer than this in a step [m]
constexpr double kTolerance = 1e-3;  ///< of the nonsmooth solver, over the size of its right-hand side
constexpr int kFloeGroup = 0;
constexpr int kFixedGroup = 1;

/// Moreau and Jean's time stepping, implicit; contacts from Bullet's hulls; nonsmooth Gauss-Seidel.
class SiconosEngine : public Engine {
 public:
  SiconosEngine(const Pack& pack, const Settings& settings) : dt_(settings.dt) {
    system_ = std::make_shared<NonSmoothDynamicalSystem>(0.0, 2.0 * kSeconds);
    for (const Floe& floe : pack.floes) add(floe);
    simulation_ = std::make_shared<TimeStepping>(system_, std::make_shared<TimeDiscretisation>(0.0, dt_));
    auto integrator = std::make_shared<MoreauJeanOSI>(1.0, 1.0);
    integrator->setConstraintActivationThreshold(kActive);
    simulation_->insertIntegrator(integrator);
    simulation_->insertNonSmoothProblem(friction_problem(settings.iterations));
    simulation_->setNewtonOptions(SICONOS_TS_LINEAR);
    simulation_->setCheckSolverFunction([](int, Simulation*) {});  // iterations may end first, which it would print
    add_contacts();
  }

  Loads step() override {
    simulation_->computeOneStep();
    Loads loads;
    if (system_->topology()->indexSetsSize() > 1) {
      const auto& active = *simulation_->indexSet(1);
      InteractionsGraph::VIterator i, end;
      for (std::tie(i, end) = active.vertices(); i != end; ++i) {
        const auto interaction = active.bundle(*i);
        const auto relation = std::dynamic_pointer_cast<BulletR>(interaction->relation());
        if (!relation || interaction->has2Bodies()) continue;
        const double force = (*interaction->lambda(1))(0) / dt_;
        loads.bed += force * std::abs((*relation->nc())(2));
        loads.wall += force * std::abs((*relation->nc())(0));
      }
    }
    simulation_->nextStep();
    return loads;
  }

  Vec3 centre(std::size_t floe) const override {
    const SiconosVector& q = *bodies_[floe]->q();
    return {q(0), q(1), q(2)};
  }

 private:
  static SP::FrictionContact friction_problem(int iterations) {
    auto problem = std::make_shared<FrictionContact>(3, SICONOS_FRICTION_3D_NSGS);
    SolverOptions& options = *problem->numericsSolverOptions();
    options.iparam[SICONOS_IPARAM_MAX_ITER] = iterations;
    options.dparam[SICONOS_DPARAM_TOL] = kTolerance;
    options.iparam[SICONOS_FRICTION_3D_IPARAM_ERROR_EVALUATION] = SICONOS_FRICTION_3D_NSGS_ERROR_EVALUATION_LIGHT;
    problem->setMaxSize(100000);
    problem->setMStorageType(NM_SPARSE_BLOCK);
    problem->setNumericsVerboseMode(false);
    problem->setKeepLambdaAndYState(true);
    return problem;
  }

  void add_contacts() {
    SiconosBulletOptions options;
    options.contactBreakingThreshold = 2.0 * kMargin;
    options.perturbationIterations = 0;
    contacts_ = std::make_shared<SiconosBulletCollisionManager>(options);
    contacts_->useEqualityConstraints(false);
    simulation_->insertInteractionManager(contacts_);
    const auto law = [](double friction) { return std::make_shared<NewtonImpactFrictionNSL>(0.0, 0.0, friction, 3); };
    contacts_->insertNonSmoothLaw(law(kFriction), kFloeGroup, kFloeGroup);
    contacts_->insertNonSmoothLaw(law(0.0), kFloeGroup, kFixedGroup);
    const double wide = 2.0 * kBedExtent;
    contacts_->insertStaticContactorSet(box({wide, wide, 1.0}, kFixedGroup), pose({0.0, 0.0, -0.5}));
    contacts_->insertStaticContactorSet(box({1.0, wide, wide}, kFixedGroup), pose({-0.5, 0.0, 0.0}));
  }

  static SP::SiconosVector pose(Vec3 centre) {
    auto q = std::make_shared<SiconosVector>(7);
    q->zero();
    (*q)(0) = centre.x;
    (*q)(1) = centre.y;
    (*q)(2) = centre.z;
    (*q)(3) = 1.0;
    return q;
  }

  static SP::SiconosContactorSet box(Vec3 size, int group) {
    auto shape = std::make_shared<SiconosBox>(size.x, size.y, size.z);
    shape->setInsideMargin(kMargin);
    shape->setOutsideMargin(0.0);
    auto set = std::make_shared<SiconosContactorSet>();
    set->push_back(std::make_shared<SiconosContactor>(shape, SP::SiconosVector(), group));
    return set;
  }

  void add(const Floe& floe) {
    auto velocity = std::make_shared<SiconosVector>(6);
    velocity->zero();
    auto inertia = std::make_shared<SimpleMatrix>(3, 3);
    inertia->zero();
    const Vec3 s = floe.size;
    (*inertia)(0, 0) = floe.mass / 12.0 * (s.y * s.y + s.z * s.z);
    (*inertia)(1, 1) = floe.mass / 12.0 * (s.x * s.x + s.z * s.z);
    (*inertia)(2, 2) = floe.mass / 12.0 * (s.x * s.x + s.y * s.y);
    auto body = std::make_shared<RigidBodyDS>(pose(floe.start), velocity, floe.mass, inertia);
    body->setContactors(box(s, kFloeGroup));
    auto load = std::make_shared<SiconosVector>(3);
    (*load)(0) = -kPush * floe.mass * kGravity;
    (*load)(1) = 0.0;
    (*load)(2) = -floe.mass * kGravity;
    body->setFExtPtr(load);
    system_->insertDynamicalSystem(body);
    bodies_.push_back(body);
  }

  double dt_;
  SP::NonSmoothDynamicalSystem system_;
  SP::TimeStepping simulation_;
  std::shared_ptr<SiconosBulletCollisionManager> contacts_;
  std::vector<SP::RigidBodyDS> bodies_;
};

}  // namespace

std::unique_ptr<Engine> make_engine(const Pack& pack, const Settings& settings) {
  return std::make_unique<SiconosEngine>(pack, settings);
}

}  // namespace pack
