// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/rigid_body/world.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "body.hpp"
#include "bounded_solver.hpp"
#include "brash/core/contract.hpp"
#include "broad_phase.hpp"
#include "contact_set.hpp"

namespace brash::rigid_body {
namespace {

/// Iterations stop when no row changes a relative velocity by more than this [m/s]: 0.1 N on 10 t of ice at 0.01 s.
constexpr double kStill = 1e-8;
/// Share of the turn that a split impulse gives which a step takes [-]: floes that part shall not tumble.
constexpr double kPartingTurn = 0.1;

SolverBody to_solver(const Body& body) {
  if (!body.is_floe()) return {.position = body.pose.position, .twist = body.twist};
  const btRigidBody& b = *body.bullet;
  const btMatrix3x3 axes = b.getWorldTransform().getBasis().transpose();
  const btVector3& inverse_inertia = b.getInvInertiaDiagLocal();
  const auto axis = [&](int i) { return std::sqrt(inverse_inertia[i]) * from_bullet(axes[i]); };
  return {.position = body.pose.position,
          .twist = {from_bullet(b.getLinearVelocity()), from_bullet(b.getAngularVelocity())},
          .inverse_mass = b.getInvMass(),
          .axes = {axis(0), axis(1), axis(2)}};
}

}  // namespace

struct World::Impl {
  explicit Impl(const WorldSettings& s) : settings(s), contacts(s) {}

  WorldSettings settings;
  std::vector<std::unique_ptr<Body>> bodies;  ///< in the order of their ids
  std::vector<Body*> by_index;                ///< of every body there has been; null where it is gone
  std::vector<BodyId> moving;                 ///< floes that are not settled, sorted
  std::vector<Body*> order;                   ///< that of the last step; empty when bodies came or went since
  BroadPhase broad_phase;
  ContactSet contacts;
  BoundedSolver solver;
  std::vector<ContactLoad> loads;
  double last_change = 0.0;

  bool contains(BodyId id) const {
    return id.index < by_index.size() && by_index[id.index] != nullptr && by_index[id.index]->id == id;
  }
  Body& get(BodyId id);
  BodyId insert(std::unique_ptr<Body> body);
  void bring_into_order();
  void set_reach(double reach);
  void find_near(std::span<const BodyId> floes);
  void list_as_moving(BodyId id, bool moves);
  void place(Body& body);
  void predict(double dt);
  void find_contacts();
  void set_settled(Body& body, bool settled);
  void solve(double dt);
  void average_velocities();
  void advance(double dt);
};

Body& World::Impl::get(BodyId id) {
  BRASH_EXPECTS(contains(id), "no such body", id.index, id.generation);
  return *by_index[id.index];
}

BodyId World::Impl::insert(std::unique_ptr<Body> body) {
  order.clear();
  const BodyId id{static_cast<std::uint32_t>(by_index.size()), 0};
  body->id = id;
  body->next_pose = body->pose;
  if (body->is_floe()) body->make_bullet_body();
  for (const auto& part : body->parts) broad_phase.add(*part);
  by_index.push_back(body.get());
  bodies.push_back(std::move(body));
  list_as_moving(id, bodies.back()->is_free());
  return id;
}

void World::Impl::list_as_moving(BodyId id, bool moves) {
  const auto place = std::ranges::lower_bound(moving, id);
  const bool listed = place != moving.end() && *place == id;
  if (listed && !moves) moving.erase(place);
  if (!listed && moves) moving.insert(place, id);
}

/// All bodies in an order that depends on their states only; ranks are set. Few change places from step to step, so
/// that each is let sink to its own from the order of the step before.
void World::Impl::bring_into_order() {
  if (order.empty()) {
    for (const auto& body : bodies) order.push_back(body.get());
    std::sort(order.begin(), order.end(), [](const Body* a, const Body* b) { return comes_before(*a, *b); });
  }
  for (std::size_t i = 1; i < order.size(); ++i)
    for (std::size_t j = i; j > 0 && comes_before(*order[j], *order[j - 1]); --j) std::swap(order[j], order[j - 1]);
  for (std::size_t i = 0; i < order.size(); ++i) order[i]->rank = static_cast<int>(i);
}

/// Parts and their boxes follow a new pose.
void World::Impl::place(Body& body) {
  body.place_parts();
  for (const auto& part : body.parts) broad_phase.move(*part);
}

void World::Impl::set_settled(Body& body, bool settled) {
  if (body.settled == settled) return;
  for (const auto& part : body.parts) broad_phase.remove(*part);
  body.set_settled(settled);
  for (const auto& part : body.parts) broad_phase.add(*part);
  list_as_moving(body.id, body.is_free());
}

void World::Impl::set_reach(double reach) {
  if (reach == broad_phase.reach) return;
  broad_phase.reach = reach;
  for (const auto& body : bodies)
    for (const auto& part : body->parts) broad_phase.move(*part);
}

/// Parts of other bodies within reach of each of the floes, in the order of their boxes and so by state alone.
void World::Impl::find_near(std::span<const BodyId> floes) {
  const auto seek = [&](bool sought) {
    for (const BodyId id : floes)
      for (const auto& part : get(id).parts) part->sought = sought;
  };
  for (const BodyId id : floes) get(id).near.clear();
  seek(true);
  for (const auto& [one, other, overlap] : broad_phase.near_pairs()) {
    if (one->sought) one->body->near.push_back(other);
    if (other->sought) other->body->near.push_back(one);
  }
  seek(false);
  const auto key = [](const Part* part) {
    const auto& [lower, upper] = std::tie(part->now.lower, part->now.upper);
    return std::tuple(lower.x, lower.y, lower.z, upper.x, upper.y, upper.z, part->body->id, part->number);
  };
  for (const BodyId id : floes) {
    std::vector<const Part*>& near = get(id).near;
    std::sort(near.begin(), near.end(), [&](const Part* a, const Part* b) {
      return a->now.lower.x != b->now.lower.x ? a->now.lower.x < b->now.lower.x : key(a) < key(b);
    });
    near.erase(std::unique(near.begin(), near.end()), near.end());  // near several parts of the floe
  }
}

/// Velocities with the applied loads and the gyroscopic moment, before contacts.
void World::Impl::predict(double dt) {
  for (Body* body : order) {
    if (body->kind == BodyKind::kStructure && !body->moved) body->twist = {};
    if (!body->is_free()) continue;
    body->update_bullet();
    btRigidBody& b = *body->bullet;
    b.setAngularVelocity(b.getAngularVelocity() + b.computeGyroscopicImpulseImplicit_Body(dt));
    b.clearForces();
    b.applyCentralForce(to_bullet(body->load.force));
    b.applyTorque(to_bullet(body->load.moment));
    b.integrateVelocities(dt);
    b.clearForces();
  }
}

/// Settled floes that are run into are let go first, so that they take the blow as what they are.
void World::Impl::find_contacts() {
  contacts.find(broad_phase.pairs());
  const std::vector<Body*> hit = contacts.settled_and_hit(settings.release_speed);
  for (Body* body : hit) set_settled(*body, false);
  if (!hit.empty()) contacts.find(broad_phase.pairs());
}

void World::Impl::solve(double dt) {
  solver.clear();
  for (Body* body : order) {
    const bool fixed = body->kind == BodyKind::kSheet || body->settled;
    body->in_solver = fixed ? BoundedSolver::kFixed : solver.add(to_solver(*body));
  }
  contacts.add_to(solver, dt);
  last_change = solver.solve(settings.iterations, kStill);
}

/// Twists still hold the velocities from before the step.
void World::Impl::average_velocities() {
  for (Body* body : order) {
    body->mean_twist = body->loaded_twist = body->twist;
    if (!body->is_free()) continue;
    body->loaded_twist = solver.twist_before(body->in_solver);
    const Twist after = solver.twist(body->in_solver);
    body->mean_twist = {0.5 * (body->twist.linear + after.linear), 0.5 * (body->twist.angular + after.angular)};
  }
}

/// New velocities from the solver, then Eqs. 9 and 10.
void World::Impl::advance(double dt) {
  for (Body* body : order) {
    if (body->kind == BodyKind::kStructure) {
      body->pose = body->next_pose;
      if (body->moved) place(*body);
      body->moved = false;
    }
    if (!body->is_free()) continue;
    body->twist = solver.twist(body->in_solver);
    const Twist parting = solver.parting(body->in_solver);
    if (parting != Twist{}) body->pose = advanced(body->pose, {parting.linear, kPartingTurn * parting.angular}, dt);
    body->pose = advanced(body->pose, body->twist, dt);
    body->load = {};
    BRASH_EXPECTS(is_finite(body->pose, body->twist), "state of body", body->id.index, "is not finite");
    place(*body);
  }
}

World::World(const WorldSettings& settings) : impl_(std::make_unique<Impl>(settings)) {
  BRASH_EXPECTS(settings.iterations > 0 && settings.collision_margin > 0.0, settings.iterations,
                settings.collision_margin);
  for (const ContactLaw& law : {settings.ice_structure, settings.ice_ice})
    BRASH_EXPECTS(
        law.friction >= 0.0 && law.restitution >= 0.0 && law.restitution <= 1.0 && law.crushing_pressure > 0.0,
        law.friction, law.restitution, law.crushing_pressure);
}
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

BodyId World::add_floe(const Prism& prism, const MassProperties& mass, const Pose& pose, const Twist& twist) {
  BRASH_EXPECTS(mass.mass > 0.0 && mass.inertia.x > 0.0 && mass.inertia.y > 0.0 && mass.inertia.z > 0.0, mass.mass,
                mass.inertia.x, mass.inertia.y, mass.inertia.z);
  BRASH_EXPECTS(is_finite(pose, twist), "state of a new floe is not finite");
  auto body = std::make_unique<Body>();
  body->pose = pose;
  body->twist = twist;
  body->mass = mass;
  const double half = 0.5 * prism.thickness;
  for (const auto& ring : prism.parts)
    body->add_part(convex_prism(ring, -half, half), impl_->settings.collision_margin);
  return impl_->insert(std::move(body));
}

BodyId World::add_sheet_part(std::span<const Vec2> ring, double bottom, double top) {
  auto body = std::make_unique<Body>();
  body->kind = BodyKind::kSheet;
  body->add_part(convex_prism(ring, bottom, top), impl_->settings.collision_margin);
  return impl_->insert(std::move(body));
}

BodyId World::add_structure(std::span<const std::vector<Vec3>> hulls, const Pose& pose) {
  auto body = std::make_unique<Body>();
  body->kind = BodyKind::kStructure;
  body->pose = pose;
  for (const auto& points : hulls) {
    const bool added = body->add_part(convex_hull(points), impl_->settings.collision_margin);
    BRASH_EXPECTS(added, "a hull of the structure is thinner than twice the collision margin");
  }
  return impl_->insert(std::move(body));
}

void World::remove(BodyId id) {
  impl_->order.clear();
  for (const auto& part : impl_->get(id).parts) impl_->broad_phase.remove(*part);
  impl_->list_as_moving(id, false);
  impl_->by_index[id.index] = nullptr;
  impl_->bodies.erase(std::ranges::lower_bound(impl_->bodies, id, {}, [](const auto& body) { return body->id; }));
}

void World::set_settled(BodyId id, bool settled) {
  Body& body = impl_->get(id);
  BRASH_EXPECTS(body.is_floe(), id.index);
  impl_->set_settled(body, settled);
}

bool World::is_settled(BodyId id) const { return impl_->get(id).settled; }
const std::vector<BodyId>& World::moving() const { return impl_->moving; }

void World::move_structure(BodyId id, const Pose& pose, const Twist& twist) {
  Body& body = impl_->get(id);
  BRASH_EXPECTS(body.kind == BodyKind::kStructure && is_finite(pose, twist), id.index);
  body.next_pose = pose;
  body.twist = twist;
  body.moved = true;
}

void World::apply(BodyId id, const Wrench& wrench) {
  Body& body = impl_->get(id);
  BRASH_EXPECTS(body.is_free(), id.index);
  BRASH_EXPECTS(is_finite({}, {wrench.force, wrench.moment}), "load on body is not finite", id.index);
  body.load += wrench;
}

void World::step(double dt) {
  BRASH_EXPECTS(dt > 0.0 && std::isfinite(dt), dt);
  impl_->bring_into_order();
  impl_->predict(dt);
  impl_->find_contacts();
  impl_->solve(dt);
  impl_->average_velocities();
  impl_->contacts.report(impl_->solver, dt, impl_->loads);
  impl_->advance(dt);
}

const std::vector<ContactLoad>& World::contacts() const { return impl_->loads; }
double World::last_change() const { return impl_->last_change; }

void World::visit_neighbours(std::span<const BodyId> floes, double reach, const VisitNeighbours& visit) {
  BRASH_EXPECTS(reach >= 0.0, reach);
  for (const BodyId id : floes) BRASH_EXPECTS(impl_->get(id).is_free(), id.index);
  impl_->set_reach(reach);
  impl_->find_near(floes);
  std::vector<Solid> solids;
  for (const BodyId id : floes) {
    solids.clear();
    for (const Part* part : impl_->get(id).near) solids.emplace_back(part->now.planes);
    visit(id, solids);
  }
}

BodyKind World::kind(BodyId id) const { return impl_->get(id).kind; }
bool World::contains(BodyId id) const { return impl_->contains(id); }

std::vector<BodyId> World::floes() const {
  std::vector<BodyId> ids;
  for (const auto& body : impl_->bodies)
    if (body->is_floe()) ids.push_back(body->id);
  return ids;
}

Pose World::pose(BodyId id) const { return impl_->get(id).pose; }

std::pair<Vec3, Vec3> World::bounds(BodyId id) const {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::pair<Vec3, Vec3> bounds{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
  auto& [lower, upper] = bounds;
  for (const auto& part : impl_->get(id).parts) {
    const auto& [low, up] = std::tie(part->now.lower, part->now.upper);
    lower = {std::min(lower.x, low.x), std::min(lower.y, low.y), std::min(lower.z, low.z)};
    upper = {std::max(upper.x, up.x), std::max(upper.y, up.y), std::max(upper.z, up.z)};
  }
  return bounds;
}

Twist World::twist(BodyId id) const { return impl_->get(id).twist; }
Twist World::mean_twist(BodyId id) const { return impl_->get(id).mean_twist; }
Twist World::loaded_twist(BodyId id) const { return impl_->get(id).loaded_twist; }

void World::set_state(BodyId id, const Pose& pose, const Twist& twist) {
  Body& body = impl_->get(id);
  BRASH_EXPECTS(body.kind != BodyKind::kSheet && !body.settled && is_finite(pose, twist), id.index);
  body.pose = pose;
  body.next_pose = pose;
  body.twist = twist;
  impl_->place(body);
}

double World::kinetic_energy() const {
  double sum = 0.0;
  for (const BodyId id : impl_->moving) sum += kinetic_energy(id);
  return sum;
}

double World::kinetic_energy(BodyId id) const { return impl_->get(id).kinetic_energy(); }

}  // namespace brash::rigid_body
