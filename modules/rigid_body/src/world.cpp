// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/rigid_body/world.hpp"

#include <cmath>

#include "body_world.hpp"
#include "brash/core/contract.hpp"
#include "exact_world.hpp"
#include "stock_world.hpp"

namespace brash::rigid_body {
namespace {

void expect_positive(const MassProperties& mass) {
  BRASH_EXPECTS(mass.mass > 0.0 && mass.inertia.x > 0.0 && mass.inertia.y > 0.0 && mass.inertia.z > 0.0, mass.mass,
                mass.inertia.x, mass.inertia.y, mass.inertia.z);
  BRASH_EXPECTS(mass.added_across >= 0.0, mass.added_across);
}

std::unique_ptr<BodyWorld> make(const WorldSettings& settings) {
  if (settings.engine == Engine::kBullet) return std::make_unique<StockWorld>(settings);
  return std::make_unique<ExactWorld>(settings);
}

}  // namespace

World::World(const WorldSettings& settings) : world_(make(settings)) {
  BRASH_EXPECTS(settings.iterations > 0 && settings.collision_margin > 0.0, settings.iterations,
                settings.collision_margin);
  const Bed bed = settings.bed.value_or(Bed{});
  BRASH_EXPECTS(!settings.bed || settings.engine == Engine::kBrash, "a bed needs the engine kBrash");
  BRASH_EXPECTS(std::isfinite(bed.height + bed.velocity.x + bed.velocity.y), bed.height, bed.velocity.x,
                bed.velocity.y);
  for (const ContactLaw& law : {settings.ice_structure, settings.ice_ice, bed.law})
    BRASH_EXPECTS(law.friction >= 0.0 && law.crushing_pressure > 0.0, law.friction, law.crushing_pressure);
  const double most_restitution = settings.engine == Engine::kBullet ? 0.0 : 1.0;
  BRASH_EXPECTS(settings.restitution >= 0.0 && settings.restitution <= most_restitution, settings.restitution);
}
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

void World::share_work(Workers& workers) { world_->share_work(workers); }
Workers& World::workers() const { return world_->workers(); }

BodyId World::add_floe(const Prism& prism, const MassProperties& mass, const Pose& pose, const Twist& twist) {
  expect_positive(mass);
  BRASH_EXPECTS(mass.added_across == 0.0 || world_->settings().engine == Engine::kBrash,
                "mass by direction needs the engine kBrash");
  BRASH_EXPECTS(is_finite(pose, twist), "state of a new floe is not finite");
  auto body = std::make_unique<Body>();
  body->pose = pose;
  body->twist = twist;
  body->mass = mass;
  const double half = 0.5 * prism.thickness;
  for (const auto& ring : prism.parts)
    body->add_part(convex_prism(ring, -half, half), world_->settings().collision_margin);
  return world_->insert(std::move(body));
}

BodyId World::add_sheet_part(std::span<const Vec2> ring, double bottom, double top, const Pose& frame, BodyId sheet) {
  BRASH_EXPECTS(is_finite(frame, {}), "place of a part of a sheet is not finite");
  auto body = std::make_unique<Body>();
  body->kind = BodyKind::kSheet;
  body->pose = frame;
  if (sheet != kNoBody) {
    body->sheet = &world_->get(sheet);
    BRASH_EXPECTS(body->sheet->in_plane, sheet.index);
  }
  body->add_part(convex_prism(ring, bottom, top), world_->settings().collision_margin);
  return world_->insert(std::move(body));
}

BodyId World::add_drifting_sheet() {
  BRASH_EXPECTS(world_->settings().engine == Engine::kBrash, "sheets drift with the engine kBrash");
  auto body = std::make_unique<Body>();
  body->kind = BodyKind::kSheet;
  body->in_plane = true;
  return world_->insert(std::move(body));
}

void World::set_sheet(BodyId sheet, const SheetInPlane& state) {
  Body& body = world_->get(sheet);
  const Twist twist{{state.velocity.x, state.velocity.y, 0.0}, {0.0, 0.0, state.spin}};
  const Pose pose{{state.centre.x, state.centre.y, 0.0}, {}};
  const Wrench load{{state.force.x, state.force.y, 0.0}, {0.0, 0.0, state.moment}};
  BRASH_EXPECTS(body.in_plane && is_finite(pose, twist) && is_finite({}, {load.force, load.moment}), sheet.index);
  BRASH_EXPECTS(state.mass == 0.0 || (state.mass > 0.0 && state.inertia > 0.0), state.mass, state.inertia);
  body.pose = pose;
  body.twist = twist;
  body.load = load;
  body.set_mass({.mass = state.mass, .inertia = {0.0, 0.0, state.inertia}});
  body.place();
}

BodyId World::add_structure(std::span<const std::vector<Vec3>> hulls, const Pose& pose,
                            const std::optional<MassProperties>& mass, const Twist& twist) {
  BRASH_EXPECTS(is_finite(pose, twist), "state of a new structure is not finite");
  auto body = std::make_unique<Body>();
  body->kind = BodyKind::kStructure;
  body->pose = pose;
  if (mass) {
    expect_positive(*mass);
    body->mass = *mass;
    body->twist = twist;
  }
  for (const auto& points : hulls) {
    const bool added = body->add_part(convex_hull(points), world_->settings().collision_margin);
    BRASH_EXPECTS(added, "a hull of the structure is thinner than twice the collision margin");
  }
  return world_->insert(std::move(body));
}

LinkId World::link(const Anchor& one, const Anchor& other, const LinkLaw& law) {
  Body &a = world_->get(one.body), &b = world_->get(other.body);
  BRASH_EXPECTS(&a != &b && !a.settled && !b.settled && (a.is_free() || b.is_free()), one.body.index, other.body.index);
  BRASH_EXPECTS(!a.drifts() && !b.drifts(), "a sheet that drifts takes no links", one.body.index, other.body.index);
  return world_->links().add(a, one.point, &b, other.point, law);
}

LinkId World::moor(const Anchor& anchor, Vec3 place, const LinkLaw& law) {
  Body& body = world_->get(anchor.body);
  BRASH_EXPECTS(body.is_free() && !body.drifts(), anchor.body.index);
  return world_->links().add(body, anchor.point, nullptr, place, law);
}

void World::unlink(LinkId id) { world_->links().remove(id); }
const std::vector<LinkLoad>& World::links() const { return world_->links().loads(); }

void World::remove(BodyId id) { world_->remove(id); }

void World::set_settled(BodyId id, bool settled) {
  Body& body = world_->get(id);
  BRASH_EXPECTS(body.is_floe() && !(settled && world_->links().hold(body)), id.index);
  world_->set_settled(body, settled);
}

bool World::is_settled(BodyId id) const { return world_->get(id).settled; }
const std::vector<BodyId>& World::moving() const { return world_->moving(); }

void World::move_structure(BodyId id, const Pose& pose, const Twist& twist) {
  Body& body = world_->get(id);
  BRASH_EXPECTS(body.kind == BodyKind::kStructure && !body.is_free() && is_finite(pose, twist), id.index);
  body.next_pose = pose;
  body.twist = twist;
  body.moved = true;
}

void World::move_sheet_part(BodyId id, const Pose& pose, const Twist& twist) {
  Body& body = world_->get(id);
  BRASH_EXPECTS(world_->settings().engine == Engine::kBrash, "sheets drift with the engine kBrash");
  BRASH_EXPECTS(body.kind == BodyKind::kSheet && is_finite(pose, twist), id.index);
  body.next_pose = pose;
  body.twist = twist;
  body.moved = true;
}

void World::apply(BodyId id, const Wrench& wrench) {
  Body& body = world_->get(id);
  BRASH_EXPECTS(body.is_free(), id.index);
  BRASH_EXPECTS(is_finite({}, {wrench.force, wrench.moment}), "load on body is not finite", id.index);
  body.load += wrench;
}

void World::set_stream(BodyId id, Vec3 velocity) { world_->get(id).stream = velocity; }
double World::gained_by_turning(BodyId id) const { return world_->get(id).gained_by_turning; }
std::optional<Pose> World::unparted_pose(BodyId id) const { return world_->get(id).unparted; }
double World::gyroscopic_share(BodyId id) const { return world_->get(id).gyroscopic_share; }

void World::step(double dt) {
  BRASH_EXPECTS(dt > 0.0 && std::isfinite(dt), dt);
  world_->step(dt);
}

const std::vector<ContactLoad>& World::contacts() const { return world_->loads(); }
const std::vector<ContactLoad>& World::contacts_of_sheets() const { return world_->loads_of_sheets(); }
double World::last_change() const { return world_->last_change(); }

void World::visit_neighbours(std::span<const BodyId> floes, double reach, const VisitNeighbours& visit) {
  BRASH_EXPECTS(reach >= 0.0, reach);
  for (const BodyId id : floes) BRASH_EXPECTS(world_->get(id).is_free(), id.index);
  world_->find_near(floes, reach);
  constexpr std::size_t kFloes = 8;  // of some 10 us each
  world_->workers().chunks(floes.size(), kFloes, [&](std::size_t begin, std::size_t end, int) {
    std::vector<Solid> solids;
    for (const BodyId id : floes.subspan(begin, end - begin)) {
      solids.clear();
      for (const Part* part : world_->get(id).near) solids.emplace_back(part->now.planes);
      visit(id, solids);
    }
  });
}

BodyKind World::kind(BodyId id) const { return world_->get(id).kind; }
bool World::contains(BodyId id) const { return world_->contains(id); }

std::vector<BodyId> World::floes() const {
  std::vector<BodyId> ids;
  for (const auto& body : world_->all())
    if (body->is_floe()) ids.push_back(body->id);
  return ids;
}

Pose World::pose(BodyId id) const { return world_->get(id).pose; }
Pose World::start_pose(BodyId id) const { return world_->get(id).start_pose; }

std::pair<Vec3, Vec3> World::bounds(BodyId id) const {
  const auto& [lower, upper] = world_->get(id).box;
  return {lower, upper};
}

Twist World::twist(BodyId id) const { return world_->get(id).twist; }
Twist World::mean_twist(BodyId id) const { return world_->get(id).mean_twist; }
Twist World::start_twist(BodyId id) const { return world_->get(id).start_twist; }
Twist World::loaded_twist(BodyId id) const { return world_->get(id).loaded_twist; }

void World::set_state(BodyId id, const Pose& pose, const Twist& twist) {
  Body& body = world_->get(id);
  BRASH_EXPECTS(body.kind != BodyKind::kSheet && !body.settled && is_finite(pose, twist), id.index);
  body.pose = pose;
  body.start_pose = pose;
  body.next_pose = pose;
  body.twist = twist;
  body.place();
}

void World::set_mass(BodyId id, const MassProperties& mass, const Twist& twist) {
  Body& body = world_->get(id);
  BRASH_EXPECTS(body.is_free() && is_finite({}, twist), id.index);
  expect_positive(mass);
  BRASH_EXPECTS(mass.added_across == 0.0 || world_->settings().engine == Engine::kBrash,
                "mass by direction needs the engine kBrash");
  body.set_mass(mass);
  body.twist = twist;
}

double World::kinetic_energy() const {
  const std::vector<BodyId>& moving = world_->moving();
  constexpr std::size_t kFloes = 128;  // of some 0.1 us each
  return world_->workers().sum(0.0, moving.size(), kFloes, [&](std::size_t i) { return kinetic_energy(moving[i]); });
}

double World::kinetic_energy(BodyId id) const { return world_->get(id).kinetic_energy(); }

}  // namespace brash::rigid_body
