// SPDX-License-Identifier: GPL-3.0-or-later
#include "body_world.hpp"

#include <BulletCollision/CollisionDispatch/btSimulationIslandManager.h>
#include <LinearMath/btAlignedAllocator.h>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <numeric>
#include <tuple>
#include <utility>

#include "brash/core/contract.hpp"

namespace brash::rigid_body {
namespace {

void* allocate(std::size_t n_bytes) {
  void* const memory = std::malloc(n_bytes);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

/// Bullet uses memory that it did not get, which ends the program.
[[maybe_unused]] const bool kMemoryIsChecked = (btAlignedAllocSetCustom(&allocate, &std::free), true);

constexpr int kMobile = 1;
constexpr int kFixed = 2;

Body& body_of(const btBroadphaseProxy& proxy) {
  return rigid_body::body_of(*static_cast<const btCollisionObject*>(proxy.m_clientObject));
}

/// Bullet's rule, and besides: parts of a sheet that drifts meet the parts of other sheets. Its own lie side by side.
struct PartsOfSheetsMeet final : btOverlapFilterCallback {
  bool needBroadphaseCollision(btBroadphaseProxy* one, btBroadphaseProxy* other) const override {
    const Body &a = body_of(*one), &b = body_of(*other);
    if (a.in_plane || b.in_plane) return false;
    if (a.kind == BodyKind::kSheet && b.kind == BodyKind::kSheet) return a.sheet != b.sheet;
    return (one->m_collisionFilterGroup & other->m_collisionFilterMask) != 0 &&
           (other->m_collisionFilterGroup & one->m_collisionFilterMask) != 0;
  }
};

/// Floes come before the bodies that they run into.
std::pair<bool, int> place(const Body& body) { return {!body.is_floe(), body.rank}; }

/// Parts of `other` within reach of the parts of `body` are near it.
void collect_near(Body& body, const Body& other, double reach) {
  for (const auto& near : other.parts)
    if (std::ranges::any_of(body.parts, [&](const auto& own) { return within_reach(box(*own), box(*near), reach); }))
      body.near.push_back(near.get());
}

/// By the places of their boxes, and so by state alone.
void sort_by_place(std::vector<const Part*>& parts) {
  const auto key = [](const Part* part) {
    const auto& [lower, upper] = std::tie(part->now.lower, part->now.upper);
    return std::tuple(lower.x, lower.y, lower.z, upper.x, upper.y, upper.z, part->body->id, part->number);
  };
  std::sort(parts.begin(), parts.end(), [&](const Part* a, const Part* b) {
    return a->now.lower.x != b->now.lower.x ? a->now.lower.x < b->now.lower.x : key(a) < key(b);
  });
}

}  // namespace

BodyWorld::BodyWorld(const WorldSettings& settings, std::unique_ptr<btCollisionConfiguration> rules,
                     std::unique_ptr<btConstraintSolver> rows)
    : BulletParts(std::move(rules), std::move(rows)),
      btDiscreteDynamicsWorld(&dispatcher, &tree, solver.get(), configuration.get()),
      settings_(settings) {
  setGravity({0, 0, 0});  // weight comes with the loads
  getSimulationIslandManager()->setSplitIslands(false);
  getSolverInfo().m_numIterations = settings.iterations;
}

/// Bullet's world would look through all pairs for each body that it still has.
BodyWorld::~BodyWorld() {
  btOverlappingPairCache& cache = *tree.getOverlappingPairCache();
  cache.setOverlapFilterCallback(nullptr);
  while (cache.getNumOverlappingPairs() > 0) {
    const btBroadphasePair last = cache.getOverlappingPairArray()[cache.getNumOverlappingPairs() - 1];
    cache.removeOverlappingPair(last.m_pProxy0, last.m_pProxy1, &dispatcher);
  }
}

bool BodyWorld::contains(BodyId id) const {
  return id.index < by_index_.size() && by_index_[id.index] != nullptr && by_index_[id.index]->id == id;
}

Body& BodyWorld::get(BodyId id) {
  BRASH_EXPECTS(contains(id), "no such body", id.index, id.generation);
  return *by_index_[id.index];
}

BodyId BodyWorld::insert(std::unique_ptr<Body> body) {
  order_.clear();
  if (body->in_plane && !filter_) {
    filter_ = std::make_unique<PartsOfSheetsMeet>();
    tree.getOverlappingPairCache()->setOverlapFilterCallback(filter_.get());
  }
  const BodyId id{static_cast<std::uint32_t>(by_index_.size()), 0};
  body->id = id;
  body->start_pose = body->next_pose = body->pose;
  body->make_bullet_body(hull_margin());
  body->place();
  add_to_bullet(*body);
  by_index_.push_back(body.get());
  bodies.push_back(std::move(body));
  list_as_moving(*bodies.back(), true);
  return id;
}

void BodyWorld::remove(BodyId id) {
  order_.clear();
  Body& body = get(id);
  if (body.in_plane)
    for (const auto& part : bodies) BRASH_EXPECTS(part->sheet != &body, "a sheet goes after its parts", id.index);
  links_.forget(body);
  removeRigidBody(body.bullet.get());
  list_as_moving(body, false);
  by_index_[id.index] = nullptr;
  bodies.erase(std::ranges::lower_bound(bodies, id, {}, [](const auto& other) { return other->id; }));
}

void BodyWorld::add_to_bullet(Body& body) {
  const bool mobile = body.is_floe() && body.is_free();
  addRigidBody(body.bullet.get(), mobile ? kMobile : kFixed, mobile ? kMobile | kFixed : kMobile);
  body.box_is_known = false;
}

void BodyWorld::list_as_moving(const Body& body, bool moves) {
  if (!body.is_floe()) return;
  const auto place = std::ranges::lower_bound(moving_, body.id);
  const bool listed = place != moving_.end() && *place == body.id;
  if (listed && !moves) moving_.erase(place);
  if (!listed && moves) moving_.insert(place, body.id);
}

/// Floes that move are of the group kMobile and meet both groups. All else is of the group kFixed and meets kMobile
/// alone: structures, sheets and settled floes do not meet each other (for sheets that drift see PartsOfSheetsMeet).
/// The broad phase seeks out a body that wakes again. One that settles stays where it is, and loses its pairs with
/// other fixed bodies in the next step: at once, each would cost a walk through the pairs of all.
void BodyWorld::set_settled(Body& body, bool settled) {
  if (body.settled == settled) return;
  btRigidBody& b = *body.bullet;
  if (settled) {
    m_nonStaticRigidBodies.remove(&b);
    body.set_settled(true);
    b.getBroadphaseHandle()->m_collisionFilterGroup = kFixed;
    b.getBroadphaseHandle()->m_collisionFilterMask = kMobile;
    has_settled_ = true;
  } else {
    removeRigidBody(&b);
    body.set_settled(false);
    add_to_bullet(body);
  }
  list_as_moving(body, body.is_free());
}

/// Two bodies of the group kFixed meet no more. Bullet asks for the groups only when a pair is new.
void BodyWorld::part_settled() {
  struct Fixed final : btOverlapCallback {
    bool processOverlap(btBroadphasePair& pair) override {
      const Body &a = body_of(*pair.m_pProxy0), &b = body_of(*pair.m_pProxy1);
      return (a.settled && (b.settled || !b.is_floe())) || (b.settled && !a.is_floe());
    }
  } fixed;
  if (std::exchange(has_settled_, false))
    tree.getOverlappingPairCache()->processAllOverlappingPairs(&fixed, &dispatcher);
}

/// All bodies in an order that depends on their states only; ranks are set. Few change places from step to step, so
/// that each is let sink to its own from the order of the step before.
void BodyWorld::bring_into_order() {
  if (order_.empty()) {
    for (const auto& body : bodies) order_.push_back(body.get());
    std::sort(order_.begin(), order_.end(), [](const Body* a, const Body* b) { return comes_before(*a, *b); });
  }
  for (std::size_t i = 1; i < order_.size(); ++i)
    for (std::size_t j = i; j > 0 && comes_before(*order_[j], *order_[j - 1]); --j) std::swap(order_[j], order_[j - 1]);
  for (std::size_t i = 0; i < order_.size(); ++i) order_[i]->rank = static_cast<int>(i);
  list_awake();
}

void BodyWorld::list_awake() {
  awake_.clear();
  for (Body* body : order_)
    if (!body->settled) awake_.push_back(body);
}

void BodyWorld::step(double dt) {
  part_settled();
  bring_into_order();
  links_.prepare(dt);
  stepSimulation(dt, 0);
  links_.measure();
}

namespace {

/// Share of its energy of rotation that the gyroscopic moment may seem to give a body [-]: rounding.
constexpr double kGyroscopicGain = 1e-9;

/// Angular velocity that the gyroscopic moment leaves a body in a step [rad/s]. Bullet takes one step of Newton's
/// method towards the implicit Euler step, which loses energy. It may gain some where the body turns by a radian in the
/// step. The step is then taken in so many parts that it does not.
Vec3 after_gyroscopic_moment(Body& body, double dt) {
  const auto energy = [&](Vec3 spin) { return dot(body.angular_momentum(spin), spin); };
  const Vec3 start = body.twist.angular;
  const double most = (1.0 + kGyroscopicGain) * energy(start);
  Vec3 spin;
  for (int parts = 1; parts <= 1024; parts *= 2) {
    spin = start;
    for (int i = 0; i < parts; ++i) {
      body.bullet->setAngularVelocity(to_bullet(spin));
      spin += from_bullet(body.bullet->computeGyroscopicImpulseImplicit_Body(dt / parts));
    }
    if (energy(spin) <= most) break;
  }
  return spin;
}

}  // namespace

void BodyWorld::predictUnconstraintMotion(btScalar dt) {
  each_body([dt](Body& body) {
    if (!body.is_floe() && !body.is_free() && !body.moved) body.twist = {};
    btRigidBody& b = *body.bullet;
    b.setLinearVelocity(to_bullet(body.twist.linear));
    b.setAngularVelocity(to_bullet(body.twist.angular));
    body.loaded_twist = body.twist;
    if (!body.is_free()) return;
    if (!body.in_plane) b.setAngularVelocity(to_bullet(after_gyroscopic_moment(body, dt)));
    body.gyration = from_bullet(b.getAngularVelocity()) - body.twist.angular;
    b.clearForces();
    b.applyCentralForce(to_bullet(body.load.force));
    b.applyTorque(to_bullet(body.load.moment));
    b.integrateVelocities(dt);
    b.clearForces();
    if (body.mass.added_across > 0.0)
      b.setLinearVelocity(to_bullet(body.twist.linear + dt * velocity_of(body.mass, body.pose, body.load.force)));
    body.loaded_twist = {from_bullet(b.getLinearVelocity()), from_bullet(b.getAngularVelocity())};
  });
  follow_sheets(&Body::loaded_twist);
}

void BodyWorld::follow_sheets(Twist Body::*twist) {
  if (!any_drifts()) return;
  each_body([twist](Body& part) {
    if (part.sheet == nullptr || !part.sheet->is_free()) return;
    const Twist& of_sheet = part.sheet->*twist;
    part.*twist = {velocity_at(of_sheet, part.pose.position - part.sheet->pose.position), of_sheet.angular};
  });
}

void BodyWorld::average_velocities() {
  each_body([](Body& body) {
    body.start_pose = body.pose;
    body.start_twist = body.twist;
    body.mean_twist = body.twist;
    if (!body.is_free()) return;
    const Vec3 linear = from_bullet(body.bullet->getLinearVelocity());
    const Vec3 angular = from_bullet(body.bullet->getAngularVelocity());
    body.mean_twist = {0.5 * (body.twist.linear + linear), 0.5 * (body.twist.angular + angular)};
    const Vec3 of_moment_alone = body.twist.angular + 0.5 * body.gyration;
    body.gyroscopic_share = dot(body.angular_momentum(body.gyration), body.mean_twist.angular - of_moment_alone);
  });
  follow_sheets(&Body::mean_twist);
}

void BodyWorld::finish(Body& body, const Pose& pose) {
  body.pose = pose;
  body.load = {};
  BRASH_EXPECTS(is_finite(body.pose, body.twist), "state of body", body.id.index, "is not finite");
  body.place();
}

void BodyWorld::move_as_told(Body& body) {
  if (!body.moved) return;
  body.pose = body.next_pose;
  body.moved = false;
  body.place();
}

void BodyWorld::updateAabbs() {
  const double margin = std::max(0.5 * reach_, least_margin());
  const Vec3 by{margin, margin, margin};
  for (const auto& body : bodies) {
    if (body->box_is_known) continue;
    body->box_is_known = true;
    const Box at = body->parts.empty() ? Box{body->pose.position, body->pose.position} : body->box;
    tree.setAabb(body->bullet->getBroadphaseHandle(), to_bullet(at.lower - by), to_bullet(at.upper + by), &dispatcher);
  }
}

/// @param task  takes the two bodies, and the list that its chunk of the pairs fills for the caller; lists come in the
///              order of the pairs.
template <typename Task>
void BodyWorld::each_known_pair(Task&& task) {
  constexpr std::size_t kPairs = 1024;  // at some 10 ns for each
  const btBroadphasePairArray& known = tree.getOverlappingPairCache()->getOverlappingPairArray();
  const auto n = static_cast<std::size_t>(known.size());
  some_pairs_.resize(n / kPairs + 1);
  for (std::vector<BodyPair>& list : some_pairs_) list.clear();
  workers_->chunks(n, kPairs, [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t i = begin; i < end; ++i) {
      const btBroadphasePair& pair = known[static_cast<int>(i)];
      task(body_of(*pair.m_pProxy0), body_of(*pair.m_pProxy1), some_pairs_[begin / kPairs]);
    }
  });
}

/// Pairs are dealt out to their first bodies and sorted there.
const std::vector<BodyPair>& BodyWorld::sorted_pairs() {
  each_known_pair([](Body& a, Body& b, std::vector<BodyPair>& pairs) {
    if (!within_reach(a.box, b.box, 0.0)) return;
    const bool turn = place(b) < place(a);
    pairs.push_back({turn ? &b : &a, turn ? &a : &b});
  });
  of_first_.assign(order_.size() + 1, 0);
  for (const std::vector<BodyPair>& list : some_pairs_)
    for (const BodyPair& pair : list) ++of_first_[static_cast<std::size_t>(pair.first->rank) + 1];
  std::partial_sum(of_first_.begin(), of_first_.end(), of_first_.begin());
  pairs_.resize(of_first_.back());
  for (const std::vector<BodyPair>& list : some_pairs_)
    for (const BodyPair& pair : list) pairs_[of_first_[static_cast<std::size_t>(pair.first->rank)]++] = pair;
  workers_->each(order_.size(), kBodies, [&](std::size_t rank) {
    const auto at = [&](std::size_t i) { return pairs_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::sort(at(rank == 0 ? 0 : of_first_[rank - 1]), at(of_first_[rank]),
              [](const BodyPair& p, const BodyPair& q) { return p.second->rank < q.second->rank; });
  });
  return pairs_;
}

void BodyWorld::find_near(std::span<const BodyId> floes, double reach) {
  if (reach != reach_)
    for (const auto& body : bodies) body->box_is_known = false;
  reach_ = reach;
  updateAabbs();
  for (const BodyId id : floes) {
    get(id).near.clear();
    get(id).sought = true;
  }
  each_known_pair([reach](Body& a, Body& b, std::vector<BodyPair>& pairs) {
    if ((a.sought || b.sought) && within_reach(a.box, b.box, reach)) pairs.push_back({&a, &b});
  });
  for (const std::vector<BodyPair>& list : some_pairs_)
    for (const auto& [a, b] : list) {
      if (a->sought) a->beside.push_back(b);
      if (b->sought) b->beside.push_back(a);
    }
  workers_->each(floes.size(), kBodies / 8, [&](std::size_t i) {
    Body& body = get(floes[i]);
    body.sought = false;
    for (const Body* other : body.beside) collect_near(body, *other, reach);
    body.beside.clear();
    sort_by_place(body.near);
  });
}

}  // namespace brash::rigid_body
