// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "brash/core/ids.hpp"
#include "brash/core/plane.hpp"
#include "brash/core/prism.hpp"
#include "brash/core/vec.hpp"
#include "brash/core/workers.hpp"

namespace brash::rigid_body {

class BodyWorld;

/// How a pair of surfaces meets.
struct ContactLaw {
  double friction = 0.0;  ///< Coulomb coefficient of the pair [-], Eq. 6
  /// sigma_c R [Pa]: the normal force of a contact is at most this times the contact's own area (Eqs. 15, 16).
  /// Infinite: ice that does not break, an ordinary rigid contact whose overlap is taken back by split impulse.
  double crushing_pressure = std::numeric_limits<double>::infinity();
};

/// The bed of the water: level and rigid, without end, and solid below its surface. It has no body. Floes meet it as
/// they meet the sheet (docs/theory/contacts-and-bodies.md, (C9)).
struct Bed {
  double height = 0.0;  ///< of its surface [m]
  ContactLaw law{};     ///< of ice on the bed
  Vec2 velocity{};      ///< along the surface [m/s]
};

/// The engine that finds the contacts and solves them.
enum class Engine {
  kBrash,   ///< exact overlaps, a bounded solver, no history: a step is a function of the state
  kBullet,  ///< Bullet as it is: GJK and EPA, persistent manifolds, sequential impulses; the bound is ours
};

struct WorldSettings {
  ContactLaw ice_structure{};
  ContactLaw ice_ice{};
  std::optional<Bed> bed{};  ///< none: deep water. Engine::kBrash only
  /// e of Eq. 5 [-], 0 to 1: one for all contacts, so that they never gain energy (docs/theory/contacts-and-bodies.md,
  /// (C6)). Engine::kBullet knows 0 alone.
  double restitution = 0.0;
  int iterations = 30;  ///< sweeps of sequential impulses a step, at most
  /// [m], > 0; convex parts thinner than twice this have no contact. Bullet's hulls are inset by it and rounded.
  double collision_margin = 0.005;
  /// A floe that comes nearer faster than this releases a settled floe, before the contact acts [m/s]. The blow may
  /// drive the released floe on against others that touch it: Engine::kBrash releases those by the same rule.
  double release_speed = std::numeric_limits<double>::infinity();
  /// Bullet keeps contact points from step to step: a repeated run gives the same bytes, one from stored states does
  /// not.
  Engine engine = Engine::kBrash;
};

/// Inertia of a floe about its centre of mass in its principal axes.
/// With MassProperties::added_across the engine is kBrash.
struct MassProperties {
  double mass = 0.0;  ///< [kg]
  Vec3 inertia{};     ///< principal moments [kg m2]
  /// Mass along the body's z axis beyond `mass` [kg], >= 0: of water that moves with a plate along its normal.
  double added_across = 0.0;
};

/// Momentum of a body in `pose` that moves at `velocity`, world frame [N s] (docs/theory/contacts-and-bodies.md, (M1)).
constexpr Vec3 momentum(const MassProperties& mass, const Pose& pose, Vec3 velocity) {
  const Vec3 n = rotate(pose.rotation, {0.0, 0.0, 1.0});
  return mass.mass * velocity + mass.added_across * dot(n, velocity) * n;
}

/// The velocity at which a body has `momentum`, world frame [m/s].
constexpr Vec3 velocity_of(const MassProperties& mass, const Pose& pose, Vec3 momentum) {
  const Vec3 n = rotate(pose.rotation, {0.0, 0.0, 1.0});
  const double across = mass.added_across / (mass.mass + mass.added_across);
  return (1.0 / mass.mass) * (momentum - across * dot(n, momentum) * n);
}

/// Mass properties of the prism at uniform density, times (1 + added_mass) as inertia of the floe (Eq. 12).
MassProperties mass_properties(const Prism& prism, double density, double added_mass);

/// A prism placed in the world.
struct PlacedPrism {
  Prism prism;
  Pose pose;
};

/// Builds the body-frame prism of plan polygons given in the sheet frame, its mid-plane at height `mid_height` [m].
///
/// @param rings  outline counter-clockwise, holes clockwise [m].
/// @param parts  convex rings that tile the plan [m].
PlacedPrism place_prism(std::span<const std::vector<Vec2>> rings, std::span<const std::vector<Vec2>> parts,
                        double thickness, double mid_height);

enum class BodyKind { kFloe, kStructure, kSheet, kBed };

/// One contact point's load, as the solver left it. A pair of floes is reported once, with `body` < `other`.
struct ContactLoad {
  BodyId body;                            ///< the floe, or as it was given
  BodyId other;                           ///< structure, sheet or another floe; kNoBody of the bed
  BodyKind other_kind = BodyKind::kFloe;  ///< kind of `other`
  Vec3 point{};                           ///< where it was found, at the start of the step [m], world
  Vec3 normal{};                          ///< unit, from `other` into `body`
  double normal_force = 0.0;              ///< impulse / dt [N], >= 0
  Vec3 friction_force{};                  ///< on `body` [N]
  double area = 0.0;                      ///< the point's share of the overlap's area normal to `normal` [m2]
  double depth = 0.0;                     ///< extent of the overlap along the normal [m]
  bool at_bound = false;                  ///< the crushing bound was reached
  /// Velocities of the two bodies at the point, each the mean of those at the start and the end of the step [m/s]. A
  /// force of the step times such a mean is its share of the change of kinetic energy, exactly (contacts-and-bodies.md,
  /// E2).
  Vec3 body_velocity{};
  Vec3 other_velocity{};
  /// Kinetic energy that the point takes from the energy after the loads alone, P . (u* + u') / 2 with the relative
  /// velocities before and after the contacts' impulses [J]. All points together give none (contacts-and-bodies.md,
  /// E4).
  double loss = 0.0;
};

/// A sheet that drifts, as the next step finds it: a body of the plane, which moves in x, y and yaw.
struct SheetInPlane {
  double mass = 0.0;     ///< [kg]; 0: there is no ice left, and nothing moves it
  double inertia = 0.0;  ///< about the vertical axis through its centre [kg m2]
  Vec2 centre{};         ///< its centre of mass where its parts are now [m], world
  Vec2 velocity{};       ///< of the centre [m/s]
  double spin = 0.0;     ///< [rad/s]
  Vec2 force{};          ///< of all but contacts [N]
  double moment = 0.0;   ///< of all but contacts, about the centre [N m]
};

/// Force on `body` [N].
constexpr Vec3 force(const ContactLoad& c) { return c.normal_force * c.normal + c.friction_force; }

/// Power of the normal force on both bodies together [W]; negative: kinetic energy lost to crushing and impact.
constexpr double normal_power(const ContactLoad& c) {
  return c.normal_force * dot(c.normal, c.body_velocity - c.other_velocity);
}

/// Power of friction on both bodies together [W]; negative: kinetic energy lost to slip.
constexpr double friction_power(const ContactLoad& c) {
  return dot(c.friction_force, c.body_velocity - c.other_velocity);
}

/// Names no body: fixed ice or ground that has no body in the world.
inline constexpr BodyId kNoBody{std::numeric_limits<std::uint32_t>::max(), 0};

using LinkId = Id<struct LinkTag>;

/// How a link holds two points together.
struct LinkLaw {
  double stiffness = std::numeric_limits<double>::infinity();  ///< [N/m], > 0; infinite: the points stay together
  double damping = 0.0;                                        ///< of a finite stiffness [N s/m]
};

/// A point of a body, in its frame [m].
struct Anchor {
  BodyId body;
  Vec3 point{};
};

/// A link's load, as the solver left it.
struct LinkLoad {
  LinkId link;
  BodyId body;
  BodyId other = kNoBody;
  Vec3 point{};                 ///< of `body`, at the start of the step [m], world
  Vec3 force{};                 ///< on `body`, impulse / dt [N]
  Vec3 relative_velocity{};     ///< of the point of `body` to the point of `other`, as ContactLoad::body_velocity [m/s]
  double gap = 0.0;             ///< between the points, after the step [m]
  double elastic_energy = 0.0;  ///< of a finite stiffness, after the step [J]
  double loss = 0.0;            ///< as ContactLoad::loss [J]
};

/// Power of a link on both bodies together [W].
constexpr double power(const LinkLoad& l) { return dot(l.force, l.relative_velocity); }

/// The rigid-body world: floes, structures, the fixed sheet's collision shapes. Hides a btDiscreteDynamicsWorld.
///
/// Velocities and positions follow Eqs. 1 to 10 (semi-implicit Euler). With Engine::kBrash a step is a function of the
/// poses, velocities and loads alone: contacts carry no history, and bodies are handled in an order that their states
/// give. So neither the order of insertion nor a restart from stored states matters, to the last bit. Gravity, buoyancy
/// and drag come through apply(). An unknown or removed id, and a state that is not finite after a step, are broken
/// contracts.
///
/// Contacts of breakable ice act while the parts overlap: nothing at first touch, then up to the crushing pressure
/// times the area of the overlap (docs/theory/contacts-and-bodies.md, (C1)).
class World {
 public:
  explicit World(const WorldSettings& settings);
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;
  ~World();

  /// Lets `workers` share out the loops over bodies and contacts from now on; they must outlive the world. Results do
  /// not depend on their number. Without this call the calling thread does all. Not all of Engine::kBullet is shared.
  void share_work(Workers& workers);
  Workers& workers() const;

  /// Ids are given in ascending order and never again, so sorted ids are in order of birth. Parts of the prism thinner
  /// than twice the margin have mass but no collision shape.
  BodyId add_floe(const Prism& prism, const MassProperties& mass, const Pose& pose, const Twist& twist = {});
  /// A convex prism of the sheet, plan ring in the sheet's frame [m], between two heights [m]. It is fixed, or moves as
  /// move_sheet_part() says.
  /// @param frame  pose of the sheet's frame.
  /// @param sheet  which add_drifting_sheet() gave: contacts of the part act on it. Without it no contact moves the
  /// part.
  BodyId add_sheet_part(std::span<const Vec2> ring, double bottom, double top, const Pose& frame = {},
                        BodyId sheet = kNoBody);
  /// A sheet that drifts. It has no shape but its parts, and no mass until set_sheet(). Its parts meet floes, the parts
  /// of other sheets and fixed parts, each with the law of ice on ice; normals between parts lie in the plane.
  /// Engine::kBrash only.
  BodyId add_drifting_sheet();
  /// Sets the state that the next step begins with. The step changes its velocity, twist() then; its parts go where
  /// move_sheet_part() puts them.
  void set_sheet(BodyId sheet, const SheetInPlane& state);
  /// A structure of convex hulls, vertices in the structure's frame [m]; vertices form one face
  /// where they are coplanar to 1e-9 of the hull's size.
  ///
  /// Without `mass` it moves as move_structure() says. With it, loads and contacts move it like a floe; its frame then
  /// has its origin in the centre of mass and lies along the principal axes. Structures, sheet and settled floes do not
  /// meet each other.
  BodyId add_structure(std::span<const std::vector<Vec3>> hulls, const Pose& pose,
                       const std::optional<MassProperties>& mass = std::nullopt, const Twist& twist = {});
  /// Its links go with it. The parts of a drifting sheet go before it.
  void remove(BodyId id);

  /// Ties points of two bodies together: a joint that turns freely, or a spring with a damper. The step moves at
  /// least one of the bodies, and neither is a sheet that drifts or a part of one. The two do not collide with each
  /// other any more.
  /// @return ids are given in ascending order and never again.
  LinkId link(const Anchor& one, const Anchor& other, const LinkLaw& law = {});
  /// Moors a point of a body to a place in the world [m]. The body is not a sheet that drifts.
  LinkId moor(const Anchor& anchor, Vec3 place, const LinkLaw& law = {});
  void unlink(LinkId id);
  /// The loads of the links in the last step, sorted by id.
  const std::vector<LinkLoad>& links() const;

  /// Fixes a floe where it is, without velocity, or releases it. A settled floe takes no loads and costs next to
  /// nothing. To moving floes it is like the sheet, and contacts with them are reported. A linked floe cannot settle.
  /// WorldSettings::release_speed ends it too.
  void set_settled(BodyId id, bool settled);
  bool is_settled(BodyId id) const;
  /// The floes that are not settled, sorted; holds until one comes, goes, settles or is released.
  const std::vector<BodyId>& moving() const;

  /// Sets where a structure without mass is at the end of the next step and its velocity during it (of its frame's
  /// origin, and angular). Without a call it stands still.
  void move_structure(BodyId id, const Pose& pose, const Twist& twist);
  /// The same for a part of a sheet that drifts; `pose` is of the sheet's frame. Engine::kBrash only.
  void move_sheet_part(BodyId id, const Pose& pose, const Twist& twist);
  /// Adds a force and a moment about the centre of mass for the next step only.
  void apply(BodyId id, const Wrench& wrench);
  /// Sets the velocity of the water around a body [m/s], until the next call: MassProperties::added_across has its
  /// momentum against it.
  void set_stream(BodyId id, Vec3 velocity);
  /// Advances all bodies by `dt` [s].
  void step(double dt);

  /// The loads of the contact points in the last step, sorted by (body, other, point). With Engine::kBrash parts of the
  /// sheet are one and come last. Points that touch and carry nothing are left out: most are of floes that drift
  /// apart.
  const std::vector<ContactLoad>& contacts() const;
  /// The same between parts of sheets that drift, and of one with a fixed part: `body` and `other` are the parts, and
  /// `body` is of a sheet that drifts. In the order of the step.
  const std::vector<ContactLoad>& contacts_of_sheets() const;
  /// By how much the last iteration of the last step changed the relative velocity of a contact point at most [m/s];
  /// how far the contacts are from solved is more than that. Bullet does not report it: 0.
  double last_change() const;

  using VisitNeighbours = std::function<void(BodyId, std::span<const Solid>)>;
  /// Calls `visit` for each of `floes`, which are not settled, with the convex parts of other bodies whose boxes come
  /// within `reach` [m] of the boxes of its own parts, where they are now; in an order that their places give.
  /// Workers call it for several floes at a time. Ask for one reach: another reach repeats the search.
  void visit_neighbours(std::span<const BodyId> floes, double reach, const VisitNeighbours& visit);

  BodyKind kind(BodyId id) const;
  bool contains(BodyId id) const;
  std::vector<BodyId> floes() const;  ///< sorted
  Pose pose(BodyId id) const;
  /// Where it was at the start of the last step, when its contacts were found; of a settled floe, where it lies.
  Pose start_pose(BodyId id) const;
  /// Least and largest coordinates of the body's parts where it is now [m].
  std::pair<Vec3, Vec3> bounds(BodyId id) const;
  Twist twist(BodyId id) const;
  /// Mean of the velocities at the start and the end of the last step; at rest before the first.
  Twist mean_twist(BodyId id) const;
  /// The velocity at the start of the last step; at rest before the first.
  Twist start_twist(BodyId id) const;
  void set_state(BodyId id, const Pose& pose, const Twist& twist);
  /// Changes the mass of a body that the step moves, between two steps. Its velocity becomes `twist`.
  void set_mass(BodyId id, const MassProperties& mass, const Twist& twist);
  /// A floe's velocity after the loads of the last step alone, before contacts; at rest before the first.
  Twist loaded_twist(BodyId id) const;
  /// Kinetic energy that the stream gave a body in the last step, because the body turned (M3) [J]; 0 in water at rest.
  double gained_by_turning(BodyId id) const;
  /// Where a floe would be after the last step, had the engine not parted it from bodies that it overlapped (split
  /// impulse); nothing if it did not. Only contacts without a crushing pressure are parted.
  std::optional<Pose> unparted_pose(BodyId id) const;
  /// What loads and contacts of the last step gave a floe through its gyroscopic moment [J]: they change the spin
  /// within the step, so the moment works at the mean spin of (E2). It is large where a floe turns by a radian in a
  /// step.
  double gyroscopic_share(BodyId id) const;
  /// Kinetic energy of all floes, added mass included [J].
  double kinetic_energy() const;
  /// Kinetic energy of one floe, added mass included [J].
  double kinetic_energy(BodyId id) const;

 private:
  std::unique_ptr<BodyWorld> world_;
};

}  // namespace brash::rigid_body
