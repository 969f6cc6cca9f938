// SPDX-License-Identifier: GPL-3.0-or-later
// The coupled step against its floor: bench_coupled [seconds] [repetitions].
//
// The validation run goes step by step. Beside it Bullet's own world steps the same floes, sheet and structure, set to
// the run's state before each step, with the run's margin and iterations. Only the two steps are timed, in the
// process's own time, one after the other. Prints a JSON object.
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <btBulletDynamicsCommon.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <map>
#include <memory>
#include <vector>

#include "brash/io/case.hpp"
#include "brash/rigid_body/world.hpp"
#include "brash/simulation/scales.hpp"
#include "brash/simulation/simulation.hpp"
#include "brash/structure/cone.hpp"
#include "bullet_types.hpp"
#include "convex_part.hpp"
#include "plan.hpp"

namespace {

using namespace brash;
using rigid_body::to_bullet;

double process_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// A body with its shapes; shapes outlive it.
struct BulletBody {
  std::vector<std::unique_ptr<btConvexHullShape>> parts;
  std::unique_ptr<btCompoundShape> compound;
  std::unique_ptr<btRigidBody> body;
};

/// Bullet's world as its manual sets it up, with the case's margin and iterations.
class BulletWorld {
 public:
  explicit BulletWorld(const io::Case& c)
      : case_(c), dispatcher_(&configuration_), world_(&dispatcher_, &broad_phase_, &solver_, &configuration_) {
    world_.setGravity({0, 0, 0});  // the run's velocities are set before each step
    world_.getSolverInfo().m_numIterations = c.contact.iterations;
    world_.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
  }
  ~BulletWorld() {
    for (auto& [id, floe] : floes_) world_.removeRigidBody(floe.body.get());
    for (auto& [key, tiles] : sheet_)
      for (auto& tile : tiles) world_.removeRigidBody(tile.body.get());
    if (structure_.body) world_.removeRigidBody(structure_.body.get());
  }
  BulletWorld(const BulletWorld&) = delete;

  void add_structure(const std::vector<Vec3>& hull, const Pose& pose) {
    structure_ = make({rigid_body::convex_hull(hull)}, {0.0, {}}, pose, case_.ice.friction_structure);
    structure_.body->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
    world_.addRigidBody(structure_.body.get(), 2, 1);
  }
  void place_structure(const Pose& from, const Pose& to, Vec3 velocity) {
    structure_.body->setInterpolationWorldTransform(to_bullet(from));
    structure_.body->setWorldTransform(to_bullet(to));
    structure_.body->setLinearVelocity(to_bullet(velocity));
  }

  /// Floes as they are before a step; those that are gone leave.
  void set_floes(const std::vector<io::CheckpointFloe>& floes) {
    std::map<std::int64_t, BulletBody> now;
    for (const io::CheckpointFloe& floe : floes) {
      auto known = floes_.extract(floe.id);
      BulletBody body = known.empty() ? make_floe(floe) : std::move(known.mapped());
      body.body->setWorldTransform(to_bullet(floe.pose));
      body.body->setLinearVelocity(to_bullet(floe.twist.linear));
      body.body->setAngularVelocity(to_bullet(floe.twist.angular));
      body.body->activate(true);
      now.emplace(floe.id, std::move(body));
    }
    for (auto& [id, gone] : floes_) world_.removeRigidBody(gone.body.get());
    floes_ = std::move(now);
  }

  /// The sheet, in convex parts; those that are known stay.
  void set_sheet(const std::vector<io::GridRings>& sheet, double bottom, double top);

  void step(double dt) { world_.stepSimulation(dt, 0); }
  int n_points() {
    int n = 0;
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i)
      n += dispatcher_.getInternalManifoldPointer()[i]->getNumContacts();
    return n;
  }

 private:
  BulletBody make(const std::vector<rigid_body::ConvexPart>& solids, const rigid_body::MassProperties& mass,
                  const Pose& pose, double friction) const {
    BulletBody made;
    made.compound = std::make_unique<btCompoundShape>();
    for (const rigid_body::ConvexPart& solid : solids) {
      const std::vector<Vec3> corners = rigid_body::inset_vertices(solid, case_.contact.margin);
      if (corners.size() < 4) continue;
      made.parts.push_back(std::make_unique<btConvexHullShape>(&corners[0].x, static_cast<int>(corners.size()),
                                                               static_cast<int>(sizeof(Vec3))));
      made.parts.back()->setMargin(case_.contact.margin);
      made.compound->addChildShape(btTransform::getIdentity(), made.parts.back().get());
    }
    btCollisionShape* shape = made.compound.get();
    if (made.parts.size() == 1) shape = made.parts[0].get();
    const btRigidBody::btRigidBodyConstructionInfo info(mass.mass, nullptr, shape, to_bullet(mass.inertia));
    made.body = std::make_unique<btRigidBody>(info);
    made.body->setWorldTransform(to_bullet(pose));
    made.body->setFriction(friction);
    return made;
  }

  BulletBody make_floe(const io::CheckpointFloe& floe) {
    const geometry::Polygon polygon = simulation_polygon(floe.rings);
    std::vector<std::vector<Vec2>> parts;
    for (const geometry::Ring& part : geometry::convex_parts(polygon)) parts.push_back(simulation::to_metres(part));
    const auto placed =
        rigid_body::place_prism(simulation::rings_in_metres(polygon), parts, floe.thickness, floe.pose.position.z);
    const auto mass = rigid_body::mass_properties(placed.prism, case_.ice.density, case_.hydrodynamics.added_mass);
    std::vector<rigid_body::ConvexPart> solids;
    for (const auto& ring : placed.prism.parts)
      solids.push_back(rigid_body::convex_prism(ring, -0.5 * floe.thickness, 0.5 * floe.thickness));
    BulletBody made = make(solids, mass, floe.pose, std::sqrt(case_.ice.friction_ice));
    world_.addRigidBody(made.body.get(), 1, 3);
    return made;
  }

  static geometry::Polygon simulation_polygon(const io::GridRings& rings) {
    geometry::Polygon polygon;
    for (std::size_t i = 0; i < rings.size(); ++i) {
      geometry::Ring ring;
      for (const io::GridPoint p : rings[i]) ring.push_back({p.x, p.y});
      if (i == 0)
        polygon.outline = std::move(ring);
      else
        polygon.holes.push_back(std::move(ring));
    }
    return polygon;
  }

  using Outline = std::vector<std::pair<double, double>>;

  const io::Case& case_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broad_phase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  std::map<std::int64_t, BulletBody> floes_;
  std::map<Outline, std::vector<BulletBody>> sheet_;
  BulletBody structure_;
};

void BulletWorld::set_sheet(const std::vector<io::GridRings>& sheet, double bottom, double top) {
  std::map<Outline, std::vector<BulletBody>> now;
  for (const io::GridRings& rings : sheet)
    for (const geometry::Ring& part : geometry::convex_parts(simulation_polygon(rings))) {
      const std::vector<Vec2> ring = simulation::to_metres(part);
      Outline key;
      for (const Vec2 v : ring) key.emplace_back(v.x, v.y);
      auto known = sheet_.extract(key);
      if (known.empty()) {
        BulletBody tile =
            make({rigid_body::convex_prism(ring, bottom, top)}, {0.0, {}}, {}, std::sqrt(case_.ice.friction_ice));
        if (tile.parts.empty()) continue;
        world_.addRigidBody(tile.body.get(), 2, 1);
        now[key].push_back(std::move(tile));
      } else {
        now[key] = std::move(known.mapped());
      }
    }
  for (auto& [key, tiles] : sheet_)
    for (auto& tile : tiles) world_.removeRigidBody(tile.body.get());
  sheet_ = std::move(now);
}

struct Times {
  double coupled = 0.0;
  double bullet = 0.0;
  double n_bullet_points = 0.0;
  std::size_t n_floes = 0;
};

Times run(const io::Case& c, double seconds) {
  simulation::Simulation simulation(c);
  BulletWorld bullet(c);
  const double dt = c.time.step;
  const auto structure_at = [&](int step) {
    return Pose{{-c.structure.start_distance + step * dt * c.structure.speed, 0.0, 0.0}, {}};
  };
  const structure::Cone cone{.angle = c.structure.angle,
                             .waterline_width = c.structure.waterline_width,
                             .height = c.structure.height,
                             .height_under_water = c.structure.height_under_water,
                             .downward_breaking = c.structure.breaking == "downward",
                             .facets = c.structure.facets};
  bullet.add_structure(structure::hull(cone), structure_at(0));
  const simulation::DerivedScales slab = simulation::derived_scales(c);
  Times times;
  const int n_steps = static_cast<int>(std::lround(seconds / dt));
  std::vector<io::GridRings> sheet;
  for (int i = 0; i < n_steps; ++i) {
    io::Checkpoint state = simulation.checkpoint();
    const double before = process_seconds();
    static_cast<void>(simulation.step());
    times.coupled += process_seconds() - before;

    if (state.sheet != sheet) bullet.set_sheet(sheet = state.sheet, -slab.draft, slab.freeboard);
    bullet.set_floes(state.floes);
    bullet.place_structure(structure_at(i), structure_at(i + 1), {c.structure.speed, 0.0, 0.0});
    const double ready = process_seconds();
    bullet.step(dt);
    times.bullet += process_seconds() - ready;
    times.n_bullet_points += bullet.n_points();
    times.n_floes = state.floes.size();
  }
  times.n_bullet_points /= n_steps;
  return times;
}

}  // namespace

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 10.0;
  const int repetitions = argc > 2 ? std::atoi(argv[2]) : 5;
  const io::Case c = io::read_case(BRASH_SOURCE_DIR "/experiments/validation/cone.toml", {});
  std::string rows;
  for (int i = 0; i < repetitions; ++i) {
    const Times t = run(c, seconds);
    rows += fmt::format("{}{{\"coupled_s\": {:.4f}, \"bullet_s\": {:.4f}, \"bullet_points\": {:.0f}, \"floes\": {}}}",
                        i == 0 ? "" : ", ", t.coupled, t.bullet, t.n_bullet_points, t.n_floes);
  }
  fmt::print("{{\"simulated_s\": {}, \"runs\": [{}]}}\n", seconds, rows);
}
