// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <limits>
#include <span>
#include <vector>

#include "brash/core/vec.hpp"
#include "brash/core/workers.hpp"
#include "overlap.hpp"
#include "strips.hpp"

namespace brash::rigid_body {

/// A body on its way through the solver.
struct SolverBody {
  Vec3 position{};            ///< of the centre of mass [m]
  Twist twist{};              ///< with the loads of the step, before contacts
  double inverse_mass = 0.0;  ///< [1/kg]; 0: contacts do not move it
  /// Principal axes of inertia, each divided by the root of its moment, world frame [1/(m kg^1/2)]; 0: contacts do not
  /// turn it.
  std::array<Vec3, 3> axes{};
  Vec3 normal{};         ///< unit axis along which it has more mass, world frame
  double stretch = 0.0;  ///< root of 1/inverse_mass over the mass along `normal`, less 1 [-]; in (-1, 0]

  /// S v with 1/mass = inverse_mass S S (docs/theory/contacts-and-bodies.md, (M2)).
  Vec3 stretched(Vec3 v) const { return stretch == 0.0 ? v : v + stretch * dot(normal, v) * normal; }
};

/// Where two bodies touch along one normal.
struct SolverContact {
  std::uint32_t first = 0;        ///< number that BoundedSolver::add gave it
  std::uint32_t second = 0;       ///< number that BoundedSolver::add gave it
  Vec3 normal{};                  ///< unit, from the second body into the first
  double friction = 0.0;          ///< [-]
  double crushing_impulse = 0.0;  ///< dt sigma_c R [N s/m2]: bound of a point per area, Eq. 16; infinite: none
  double parting_speed = 0.0;     ///< at which the positions part [m/s], to take an overlap back; 0: not at all
};

/// One direction in which a joint ties two bodies. The impulse P of the step obeys, within its limits,
///     of_first . v_first + of_second . v_second + softness P = velocity
/// with v the twists that all impulses leave.
struct SolverJoint {
  std::uint32_t first = 0;   ///< number that BoundedSolver::add gave it
  std::uint32_t second = 0;  ///< number that BoundedSolver::add gave it
  Twist of_first{};          ///< [-] and [m], or 0 and [-] for a row of angular velocities
  Twist of_second{};         ///< the same for the second body
  double velocity = 0.0;     ///< [m/s]
  double softness = 0.0;     ///< [1/kg], >= 0
  double least = 0.0;        ///< [N s]
  double most = 0.0;         ///< [N s]
};

/// The impulse of a contact point.
struct PointImpulse {
  double normal = 0.0;    ///< [N s], >= 0
  Vec3 friction{};        ///< on the first body [N s]
  bool at_bound = false;  ///< the crushing bound was reached
};

/// Sequential impulses (projected Gauss-Seidel) with an upper bound on each normal impulse (Eq. 16) and Coulomb's disc
/// for friction.
///
/// An iteration goes through the joints, then through the normal rows of all points, then through their friction, and
/// starts from beyond where the last one ended (docs/theory/contacts-and-bodies.md, (C3)). Joints come in the order in
/// which they were added. Contacts come by strips of bodies that follow each other as they were added: every second
/// strip, then the others, and several of them at a time. There is no warm start: the result is a function of the added
/// bodies, contacts and joints, and of their order.
///
/// Contacts obey Moreau's impact law with one coefficient of restitution e (docs/theory/contacts-and-bodies.md, (C5)).
/// So they never gain energy, if e is at most 1 (docs/theory/contacts-and-bodies.md, (C6)).
class BoundedSolver {
 public:
  /// A body that never moves, known from the start.
  static constexpr std::uint32_t kFixed = 0;

  /// Forgets bodies, contacts and joints.
  /// @param restitution  e of all contacts to come [-], 0 to 1.
  void clear(double restitution = 0.0);
  /// @return the number of the body.
  std::uint32_t add(const SolverBody& body);
  std::size_t n_points() const;  ///< of the contacts so far
  /// Points are numbered as they come.
  void add(const SolverContact& contact, std::span<const PatchPoint> points);
  /// A contact whose points stay where they are until the step has been reported.
  struct Given {
    SolverContact contact;
    std::span<const PatchPoint> points;
  };
  /// Adds many at a time.
  /// @param body, contact  give body or contact i, called for several at a time.
  template <typename Get>
  void add_bodies(std::size_t n, Workers& workers, Get&& body) {
    const std::size_t before = bodies_.size();
    bodies_.resize(before + n);
    workers.each(n, kAtATime, [&](std::size_t i) { bodies_[before + i] = body(i); });
  }
  template <typename Get>
  void add_contacts(std::size_t n, Workers& workers, Get&& contact) {
    const std::size_t before = given_.size();
    given_.resize(before + n);
    workers.each(n, kAtATime, [&](std::size_t i) { given_[before + i] = contact(i); });
  }
  /// Joints are numbered as they come.
  void add(const SolverJoint& joint);
  /// Iterates until no row changes a relative velocity by more than `still` [m/s], or `iterations` times.
  /// @return by how much the last iteration changed one at most [m/s].
  double solve(int iterations, double still, Workers& workers);
  double solve(int iterations, double still) {
    Workers alone(1);
    return solve(iterations, still, alone);
  }

  Twist twist(std::uint32_t body) const;
  /// Velocity of the position alone, in this step, that takes overlaps back (split impulse).
  Twist parting(std::uint32_t body) const;
  PointImpulse impulse(std::size_t point) const;
  double joint_impulse(std::size_t joint) const { return joints_[joint].impulse.now; }  ///< [N s]

 private:
  static constexpr std::size_t kAtATime = 256;  ///< bodies or contacts that a thread takes, at some 50 ns for each

  /// A linear and an angular number side by side.
  using Pair = double __attribute__((vector_size(16)));
  /// A linear and an angular vector: x, y, z.
  using Spatial = std::array<Pair, 3>;
  using Triple = std::array<double, 3>;

  /// One constraint, an impulse that makes a relative velocity vanish. The relative velocity is the velocity of the
  /// first body along the row's direction less the velocity of the second. Bodies turn by their spins: angular velocity
  /// along each principal axis times the root of its moment of inertia [m kg^1/2/s]. An impulse changes the spins by
  /// the same numbers by which they change the relative velocity.
  struct Row {
    Triple turn_a{};        ///< relative velocity per spin of the first body, spin per impulse [kg^-1/2]
    Triple turn_b{};        ///< and of the second
    double velocity = 0.0;  ///< relative velocity before contacts, which is to vanish [m/s]
    double mass = 0.0;      ///< impulse per relative velocity [kg]
  };
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  /// Two bodies by their numbers in `moved_`.
  struct Bodies {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
  };
  /// The points of a contact follow the points of the contact before.
  struct Contact {
    Vec3 direction_a{};  ///< the normal as the first body's velocities take it, (M2)
    Vec3 direction_b{};  ///< and its opposite as the second's
    double friction = 0.0;
    Bodies bodies;
    std::uint32_t n_points = 0;
    std::uint32_t number = 0;        ///< as it was added
    std::uint32_t tangents = kNone;  ///< number in Strip::tangents
  };
  /// Two directions of a contact that carries load, at right angles to the normal and to each other.
  struct Tangents {
    std::array<Vec3, 2> directions_a{};  ///< as Contact::direction_a
    std::array<Vec3, 2> directions_b{};
    Bodies bodies;
  };
  /// Of one row [N s].
  struct Impulse {
    double now = 0.0;
    double before = 0.0;  ///< at the end of the last sweep but one

    /// On from the end of a sweep to where the next begins. @return the impulse there.
    double go_on(double momentum) {
      if (now == before) return now;
      const double start = now + momentum * (now - before);
      before = now;
      now = start;
      return start;
    }
    double last_change() const { return now - before; }
    double beyond(double stride) const { return now + stride * last_change(); }
  };
  /// The impulse of a point so far, and its bound.
  struct Bearing {
    Impulse impulse;
    double bound = std::numeric_limits<double>::infinity();  ///< of the impulse [N s]
    std::uint32_t friction = kNone;                          ///< its number in Strip::frictions
  };
  /// The friction of a point that carries load, or did in this step: two rows whose masses are the diagonal of the
  /// matrix [kg] that gives the impulse from the slip.
  struct Friction {
    std::array<Row, 2> rows;
    double coupling = 0.0;    ///< off the diagonal [kg]
    double least_mass = 0.0;  ///< impulse per slip in the direction in which the bodies give way most [kg]
    std::array<Impulse, 2> impulses;
    std::uint32_t tangents = 0;  ///< number in Strip::tangents
  };
  /// Friction on its way from the normals' half of a sweep to its own.
  struct Rubbing {
    std::uint32_t friction = kNone;
    double radius = 0.0;  ///< of the disc [N s]
  };
  /// The numbers of a body that an iteration changes, in a line of the cache.
  struct alignas(64) Moved {
    Spatial velocity{};         ///< y of the velocity S y (M2), and spins, change so far
    double inverse_mass = 0.0;  ///< [1/kg]

    /// As Impulse::go_on(); `before` is the velocity at the end of the last sweep but one, then of the last.
    void go_on(double momentum, Spatial& before);
    Twist twist(const SolverBody& body) const;
  };
  /// A point whose bodies' positions are to part.
  struct Parting {
    Vec3 direction_a{};
    Vec3 direction_b{};
    Row row;
    Impulse impulse;
    Bodies bodies;
  };
  /// A joint's row. Its bodies may move in different directions.
  struct Joint {
    Vec3 direction_a{};
    Vec3 direction_b{};
    Row row;
    double softness = 0.0;  ///< [1/kg]
    double least = 0.0;     ///< [N s]
    double most = 0.0;      ///< [N s]
    Impulse impulse;
    std::uint32_t first = kFixed;
    std::uint32_t second = kFixed;
  };
  /// How far a sweep starts beyond the last one, and how much it changes.
  struct Sweep {
    double momentum = 0.0;  ///< share of the way from the last sweep but one to the last by which it starts beyond it
    double largest = 0.0;   ///< change of a relative velocity [m/s]
    double change = 0.0;    ///< sum over rows of change of impulse times change of relative velocity [J]

    void add(double velocity, double impulse);
    void add(const Sweep& part);
  };
  /// Contacts that one thread solves one after the other. Most points carry nothing; an iteration reads only their
  /// normal rows. A point gets its friction when it first carries something, and frictions lie side by side.
  struct alignas(64) Strip {
    std::size_t first_contact = 0;
    std::size_t first_point = 0;
    std::size_t n_contacts = 0;
    std::vector<Tangents> tangents;
    std::vector<Friction> frictions;
    std::vector<Rubbing> rubbing;  ///< in the order of the points
    std::vector<Parting> partings;
    Sweep sweep;
  };
  /// Of a point as it was added.
  struct Place {
    std::uint32_t point = 0;    ///< among the points strip by strip
    std::uint32_t strip = 0;    ///< its number
    std::uint32_t contact = 0;  ///< as it was added
  };
  /// Bodies that contacts connect, and a stride of their impulses beyond the end of a sweep.
  struct Group {
    double stride = 0.0;     ///< how many times the last sweep's change; 0: none
    double slope = 0.0;      ///< of the energy of the impulses over the stride [J]
    double curvature = 0.0;  ///< [J]
    double change = 0.0;     ///< of that energy by the stride, within the bounds of the impulses [J]
  };
  /// Impulses of a point after a stride [N s].
  struct Stridden {
    double normal = 0.0;
    Vec2 friction{};
  };
  struct Limits {
    double lower = 0.0;  ///< [N s]
    double upper = 0.0;  ///< [N s]
  };
  /// A point's bodies and its place from their centres of mass.
  struct Arms {
    const SolverBody& first;
    const SolverBody& second;
    Vec3 first_arm;
    Vec3 second_arm;
  };
  /// A row's direction and turns side by side.
  struct Jacobian {
    Jacobian(Vec3 direction_a, Vec3 direction_b, const Row& row);
    double velocity(const Moved& first, const Moved& second) const;
    void push(Moved& first, Moved& second, double impulse) const;

    Spatial a;
    Spatial b;
  };

  static Row row(const Arms& arms, Vec3 direction);
  Arms arms(const SolverContact& contact, Vec3 position) const;
  bool is_moved(std::uint32_t body) const;
  void divide_into_strips();
  void fill(std::size_t number);
  void fill_point(std::size_t point, Strip& strip, const SolverContact& contact, Bodies bodies, const PatchPoint& at);
  std::uint32_t add_friction(Strip& strip, Contact& contact, std::size_t point) const;
  static void resolve(Moved& a, Moved& b, const Jacobian& jacobian, const Row& row, Limits limits, Impulse& impulse,
                      Sweep& sweep);
  static void resolve_friction(Moved& a, Moved& b, double radius, const Tangents& tangents, Friction& friction,
                               Sweep& sweep);
  void sweep_joints(Sweep& sweep);
  void sweep_normals(Strip& strip);
  void sweep_frictions(Strip& strip);
  void sweep_partings(Strip& strip);
  template <typename Task>
  void each_strip(Workers& workers, Task&& task);
  template <typename Rows, typename After>
  double iterate(std::vector<Moved>& bodies, int iterations, double still, Workers& workers, Rows&& rows,
                 After&& after_sweep);
  void find_groups();
  template <typename Visit>
  void each_point_of_groups(Visit&& visit);
  template <typename Visit>
  void each_body_of_groups(Visit&& visit);
  static double energy(const Moved& body, const Spatial& first, const Spatial& second);
  void aim_strides();
  void stop_strides_at_bounds();
  Stridden stridden(const Group& group, const Strip& strip, const Contact& contact, std::size_t point) const;
  void try_strides();
  void take_strides();

  // Four numberings. Bodies keep theirs, from 1 on: `bodies_`, `moved_`, `parted_`, `velocities_before_`. Contacts and
  // points have two. As they were added: `given_`, `first_points_` and `ends_` by contact, `places_` by point. Strip by
  // strip: `contacts_` by contact, `normals_`, `borne_` and `bearings_` by point; a strip says where its own begin.
  // Frictions and tangents are numbered within their strip. `places_` leads from a point as added to its place among
  // the strips.
  double restitution_ = 0.0;
  // As they were added.
  std::vector<SolverBody> bodies_{1};
  std::vector<Joint> joints_;
  std::vector<Given> given_;
  std::deque<std::vector<PatchPoint>> copies_;  ///< of the points of contacts that were added one by one
  std::vector<std::size_t> first_points_;       ///< of each contact
  /// The bodies, and behind them one for each strip that represents all that its contacts do not move.
  std::vector<Moved> moved_;
  std::vector<Moved> parted_;               ///< the same, as far as their positions part
  std::vector<Spatial> velocities_before_;  ///< at the end of the last sweep but one
  std::vector<Group> groups_;               ///< where a heavy body touches a light one
  std::vector<std::uint32_t> group_of_;     ///< number of each body's group, or kNone; unset where there are no groups
  std::vector<Moved> strides_;              ///< the bodies after a stride
  // Strip by strip. The cost of an iteration is the memory that it goes through.
  std::vector<Ends> ends_;
  Strips order_;
  std::vector<Strip> strips_;  ///< the last is of the contacts that are left for the end
  std::vector<Contact> contacts_;
  std::vector<Row> normals_;
  std::vector<std::uint8_t> borne_;  ///< for each point: 1 once it has borne something
  std::vector<Bearing> bearings_;
  std::vector<Place> places_;  ///< of each point as added
};

}  // namespace brash::rigid_body
