// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "brash/core/ids.hpp"
#include "brash/core/plane.hpp"
#include "brash/core/prism.hpp"
#include "brash/core/vec.hpp"

namespace brash::rigid_body {

class BodyWorld;

/// How a pair of surfaces meets.
struct ContactLaw {
  double friction = 0.0;     ///< Coulomb coefficient of the pair [-], Eq. 6
  double restitution = 0.0;  ///< Newton's e [-], Eq. 5
  /// sigma_c R [Pa]: the normal force of a contact is at most this times the contact's own area (Eqs. 15, 16).
  /// Infinite: ice that does not break, an ordinary rigid contact whose overlap is taken back by split impulse.
  double crushing_pressure = std::numeric_limits<double>::infinity();
};

struct WorldSettings {
  ContactLaw ice_structure;
  ContactLaw ice_ice;
  int iterations = 30;              ///< sweeps of sequential impulses a step, at most
  double collision_margin = 0.005;  ///< [m], > 0; convex parts thinner than twice this have no contact
  /// A settled floe is let go, before the contact acts, by a floe that comes nearer faster than this [m/s].
  double release_speed = std::numeric_limits<double>::infinity();
};

/// Inertia of a floe about its centre of mass in its principal axes.
struct MassProperties {
  double mass = 0.0;  ///< [kg]
  Vec3 inertia{};     ///< principal moments [kg m2]
};

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

enum class BodyKind { kFloe, kStructure, kSheet };

/// One contact point's load, as the solver left it. A pair of floes is reported once, with `body` < `other`.
struct ContactLoad {
  BodyId body;                            ///< the floe
  BodyId other;                           ///< structure, sheet or another floe
  BodyKind other_kind = BodyKind::kFloe;  ///< what that is
  Vec3 point{};                           ///< [m], world
  Vec3 normal{};                          ///< unit, from `other` into `body`
  double normal_force = 0.0;              ///< impulse / dt [N], >= 0
  Vec3 friction_force{};                  ///< on `body` [N]
  double area = 0.0;                      ///< the point's share of the overlap's area normal to `normal` [m2]
  double depth = 0.0;                     ///< extent of the overlap along the normal [m]
  bool at_bound = false;                  ///< the crushing bound was reached
  /// Velocities of the two bodies at the point, each the mean of those at the start and the end of the step [m/s]. A
  /// force of the step times such a mean is its share of the change of kinetic energy, exactly (dynamics.md, E2).
  Vec3 body_velocity{};
  Vec3 other_velocity{};
  /// Kinetic energy that the point takes from what loads alone would have left, P . (u* + u') / 2 with the relative
  /// velocities before and after the contacts' impulses [J]. All points together give none (dynamics.md, E4).
  double loss = 0.0;
};

/// Power of the normal force on both bodies together [W]; negative: kinetic energy lost to crushing and impact.
constexpr double normal_power(const ContactLoad& c) {
  return c.normal_force * dot(c.normal, c.body_velocity - c.other_velocity);
}

/// Power of friction on both bodies together [W]; negative: kinetic energy lost to slip.
constexpr double friction_power(const ContactLoad& c) {
  return dot(c.friction_force, c.body_velocity - c.other_velocity);
}

/// The rigid-body world: floes, one structure, the fixed sheet's collision shapes. Hides Bullet.
///
/// Velocities and positions follow Eqs. 1 to 10 (semi-implicit Euler). A step is a function of the poses, velocities
/// and loads alone: contacts carry no history, and bodies are handled in an order that their states give. So neither
/// the order of insertion nor a restart from stored states matters, to the last bit. Gravity, buoyancy and drag come
/// through apply(). An unknown or removed id, and a state that is not finite after a step, are broken contracts.
///
/// Contacts of breakable ice act while the parts overlap: nothing at first touch, then up to the crushing pressure
/// times the area of the overlap (docs/theory/dynamics.md, (C1)).
class World {
 public:
  explicit World(const WorldSettings& settings);
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;
  ~World();

  /// Ids are given in ascending order and never again, so sorted ids are in order of birth. Parts of the prism thinner
  /// than twice the margin have mass but no collision shape.
  BodyId add_floe(const Prism& prism, const MassProperties& mass, const Pose& pose, const Twist& twist = {});
  /// A fixed convex prism of the sheet, plan ring in the sheet frame [m], between two heights [m].
  BodyId add_sheet_part(std::span<const Vec2> ring, double bottom, double top);
  /// A kinematic structure of convex hulls, vertices in the structure's frame [m]; vertices form one face
  /// where they are coplanar to 1e-9 of the hull's size.
  BodyId add_structure(std::span<const std::vector<Vec3>> hulls, const Pose& pose);
  void remove(BodyId id);

  /// Fixes a floe where it is, without velocity, or lets it go again. A settled floe takes no loads and costs next to
  /// nothing; to those that move it is what the sheet is, and contacts with them are reported.
  /// WorldSettings::release_speed ends it too.
  void set_settled(BodyId id, bool settled);
  bool is_settled(BodyId id) const;
  /// The floes that are not settled, sorted; holds until one comes, goes, settles or is let go.
  const std::vector<BodyId>& moving() const;

  /// Sets where the structure is at the end of the next step and its velocity during it (of its frame's origin, and
  /// angular). Without a call it stands still.
  void move_structure(BodyId id, const Pose& pose, const Twist& twist);
  /// Adds a force and a moment about the centre of mass for the next step only.
  void apply(BodyId id, const Wrench& wrench);

  /// Advances all floes by `dt` [s].
  void step(double dt);

  /// What contact points bore in the last step, sorted by (body, other, point). Points that touch and bear nothing are
  /// left out: most are of floes that drift apart.
  const std::vector<ContactLoad>& contacts() const;
  /// By how much the last iteration of the last step changed the relative velocity of a contact point at most [m/s];
  /// how far the contacts are from solved is more than that.
  double last_change() const;

  using VisitNeighbours = std::function<void(BodyId, std::span<const Solid>)>;
  /// Calls `visit` for each of `floes`, which are not settled, with the convex parts of other bodies whose boxes come
  /// within `reach` [m] of those of its own, where they are now; in an order that their places give. Ask for one reach:
  /// the search is made anew for another.
  void visit_neighbours(std::span<const BodyId> floes, double reach, const VisitNeighbours& visit);

  BodyKind kind(BodyId id) const;
  bool contains(BodyId id) const;
  std::vector<BodyId> floes() const;  ///< sorted
  Pose pose(BodyId id) const;
  /// Least and largest coordinates of the body's parts where it is now [m].
  std::pair<Vec3, Vec3> bounds(BodyId id) const;
  Twist twist(BodyId id) const;
  /// Mean of the velocities at the start and the end of the last step; at rest before the first.
  Twist mean_twist(BodyId id) const;
  void set_state(BodyId id, const Pose& pose, const Twist& twist);
  /// What the loads of the last step alone made of a floe's velocity, before contacts; at rest before the first.
  Twist loaded_twist(BodyId id) const;
  /// Kinetic energy of all floes, added mass included [J].
  double kinetic_energy() const;
  /// Kinetic energy of one floe, added mass included [J].
  double kinetic_energy(BodyId id) const;

 private:
  std::unique_ptr<BodyWorld> world_;
};

}  // namespace brash::rigid_body
