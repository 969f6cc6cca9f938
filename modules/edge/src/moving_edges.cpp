// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/edge/moving_edges.hpp"

#include <algorithm>
#include <cmath>

#include "brash/floes/plan.hpp"

namespace brash::edge {
namespace {

/// An edge in a checkpoint.
struct SavedEdge {
  std::int64_t level_ice = 0;
  double touched_at = 0.0;
  Vec2 tip{};
  double length = 0.0, thickness = 0.0, way = 0.0, deflection = 0.0, depth = 0.0, contact_length = 0.0, angle = 0.0;
  double spare = 0.0;
  failure::EdgeHistory::Settled settled;

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("level_ice", "1", "number of the level ice that it is the edge of", self.level_ice);
    visit("touched_at", "s", "time of the first touch", self.touched_at);
    visit("tip_", "m", "middle of the chord", self.tip);
    visit("length", "m", "of the chord", self.length);
    visit("thickness", "m", "of the ice at the first touch", self.thickness);
    visit("way", "1", "-1: pushed down, 1: up", self.way);
    visit("deflection", "m", "deflection of the tip", self.deflection);
    visit("depth", "m", "b of its trapezoid", self.depth);
    visit("contact_length", "m", "c of its trapezoid", self.contact_length);
    visit("angle", "rad", "theta of its trapezoid", self.angle);
    visit("spare", "J", "work on the edge that has not bent it", self.spare);
    visit("settled_slope", "N s-1", "sum of the load's old changes of slope", self.settled.slope);
    visit("settled_moment", "N", "sum of these, each times its time", self.settled.moment);
  }
};

/// A step of an edge's load in a checkpoint.
struct SavedKnot {
  std::int64_t edge = 0;
  failure::EdgeHistory::Knot knot;

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("edge", "1", "row of the table of moving edges", self.edge);
    visit("time", "s", "time", self.knot.time);
    visit("force", "N", "vertical force on the edge", self.knot.force);
  }
};

/// Spare work after a step as a function of the share of the force that the contact carries [J].
struct SpareWork {
  double square = 0.0, linear = 0.0, constant = 0.0;
};

/// The largest share in [0, 1) that leaves spare work; 0 if none does. The square is not positive.
double share_that_pays(const SpareWork& spare) {
  const auto& [a, b, c] = spare;
  if (a == 0.0) return b < 0.0 && c > 0.0 ? std::min(1.0, -c / b) : 0.0;
  const double discriminant = b * b - 4.0 * a * c;
  if (discriminant < 0.0) return 0.0;
  return std::clamp((-b - std::sqrt(discriminant)) / (2.0 * a), 0.0, 1.0);
}

/// Leaves a contact a share of its force.
void scale(EdgeContact& contact, double share) {
  contact.on_ice = share * contact.on_ice;
  contact.load.pressure *= share;
  contact.bound *= share;
  contact.spread *= share;
}

}  // namespace

/// The nearest edge, if the middle of one chord lies beside the other chord.
const MovingEdges::Edge* MovingEdges::edge_at(int level_ice, const Touch& touched) const {
  const Edge* nearest = nullptr;
  double least = 0.0;
  for (const Edge& edge : edges_) {
    const double distance = norm(edge.touched.tip - touched.tip);
    const bool is_same = edge.level_ice == level_ice && distance < 0.5 * std::max(edge.touched.length, touched.length);
    if (!is_same || (nearest != nullptr && distance >= least)) continue;
    nearest = &edge;
    least = distance;
  }
  return nearest;
}

double MovingEdges::shift(int level_ice, const Touch& touched, double time) const {
  const Edge* const edge = edge_at(level_ice, touched);
  if (edge == nullptr || edge->history.knots().size() < 2) return 0.0;
  return edge->way * std::max(0.0, edge->dynamics.deflection(edge->shape, edge->history, time));
}

double MovingEdges::largest_shift(int level_ice, double time) const {
  double largest = 0.0;
  for (const Edge& edge : edges_) {
    if (edge.level_ice != level_ice || edge.history.knots().size() < 2) continue;
    const double here = edge.way * std::max(0.0, edge.dynamics.deflection(edge.shape, edge.history, time));
    if (std::abs(here) > std::abs(largest)) largest = here;
  }
  return largest;
}

/// The edge of a contact so far. Its spare work goes to one contact alone, where a contact has parted.
MovingEdges::Edge MovingEdges::take_over(const EdgeContact& contact, double from) {
  const Edge* const before = edge_at(contact.level_ice, contact.touched);
  if (before == nullptr)
    return {.level_ice = contact.level_ice,
            .touched_at = from,
            .history = failure::EdgeHistory(from),
            .thickness = contact.ice.thickness,
            .dynamics = dynamics(contact.level_ice, contact.ice.thickness)};
  const Edge edge = *before;
  edges_[static_cast<std::size_t>(before - edges_.data())].spare = 0.0;
  return edge;
}

/// Moves an edge under a contact to a time [s]. Its deflection is linear in the force at the end of the step, so the
/// largest share of the force that leaves the spare work positive is a root of a quadratic.
/// @return the work that bent it [J].
double MovingEdges::load(Edge& edge, EdgeContact& contact, double work, double to) {
  const double before = edge.history.force(), force = std::abs(contact.on_ice.z), start = edge.deflection;
  const auto deflection_under = [&](double share) {
    failure::EdgeHistory history = edge.history;
    history.extend(to, share * force, edge.dynamics.memory());
    return edge.dynamics.deflection(edge.shape, history, to);
  };
  const double whole = deflection_under(1.0);
  double share = 1.0, bent = 0.5 * (before + force) * (whole - start);
  if (edge.spare + work < bent) {
    const double none = deflection_under(0.0);
    share = share_that_pays({.square = -0.5 * force * (whole - none),
                             .linear = work - 0.5 * (before * (whole - none) + force * (none - start)),
                             .constant = edge.spare - 0.5 * before * (none - start)});
    // An edge that swings on under no force at all has had its work before.
    bent =
        std::min(edge.spare + share * work, 0.5 * (before + share * force) * (none + share * (whole - none) - start));
    scale(contact, share);
  }
  edge.spare += share * work - bent;
  edge.history.extend(to, share * force, edge.dynamics.memory());
  edge.deflection = share == 1.0 ? whole : edge.dynamics.deflection(edge.shape, edge.history, to);
  return bent;
}

double MovingEdges::follow(std::vector<EdgeContact>& contacts, std::span<const double> work, double from, double to) {
  if (dynamics_.empty()) return 0.0;
  double bent = 0.0;
  std::vector<Edge> now;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    EdgeContact& contact = contacts[i];
    const bool is_new = edge_at(contact.level_ice, contact.touched) == nullptr;
    if (is_new && !(contact.load.pressure > 0.0)) continue;
    Edge edge = take_over(contact, from);
    edge.touched = contact.touched;
    if (contact.load.pressure > 0.0) {
      edge.way = contact.on_ice.z > 0.0 ? 1.0 : -1.0;
      edge.shape = {
          .depth = contact.load.depth, .contact_length = contact.load.contact_length, .angle = contact.load.angle};
    }
    bent += load(edge, contact, work[i], to);
    now.push_back(std::move(edge));
  }
  edges_ = std::move(now);
  return bent;
}

std::optional<MovingEdges::Life> MovingEdges::life(const EdgeContact& contact) const {
  const Edge* const edge = contact.floe == model::kNoFloe ? edge_at(contact.level_ice, contact.touched) : nullptr;
  if (edge == nullptr) return std::nullopt;
  return Life{edge->history.time() - edge->touched_at, edge->deflection};
}

failure::EdgeMotion MovingEdges::motion(const EdgeContact& contact) const {
  const bool of_structure = contact.floe == model::kNoFloe;
  const Edge* const edge = of_structure && !dynamics_.empty() ? edge_at(contact.level_ice, contact.touched) : nullptr;
  if (edge == nullptr || !(edge->history.force() > 0.0)) return {};
  return edge->dynamics.motion(contact.load, edge->history);
}

void MovingEdges::forget(const EdgeContact& contact) {
  if (contact.floe != model::kNoFloe) return;
  const Edge* const edge = edge_at(contact.level_ice, contact.touched);
  if (edge != nullptr) edges_.erase(edges_.begin() + (edge - edges_.data()));
}

void MovingEdges::forget_within(int level_ice, Vec2 at, double radius) {
  std::erase_if(edges_,
                [&](const Edge& edge) { return edge.level_ice == level_ice && norm(edge.touched.tip - at) < radius; });
}

void MovingEdges::forget_within(int level_ice, const geometry::Extent& box) {
  std::erase_if(edges_,
                [&](const Edge& edge) { return edge.level_ice == level_ice && floes::is_on(box, edge.touched.tip); });
}

void MovingEdges::save(model::Checkpoint& checkpoint) const {
  model::Table edges{"moving_edge", {}}, knots{"edge_load", {}};
  for (const Edge& edge : edges_) {
    const SavedEdge saved{.level_ice = edge.level_ice,
                          .touched_at = edge.touched_at,
                          .tip = edge.touched.tip,
                          .length = edge.touched.length,
                          .thickness = edge.thickness,
                          .way = edge.way,
                          .deflection = edge.deflection,
                          .depth = edge.shape.depth,
                          .contact_length = edge.shape.contact_length,
                          .angle = edge.shape.angle,
                          .spare = edge.spare,
                          .settled = edge.history.settled()};
    const auto number = static_cast<std::int64_t>(edges.n_rows());
    model::SavedRow row(edges);
    SavedEdge::visit(saved, row);
    for (const failure::EdgeHistory::Knot& knot : edge.history.knots()) {
      const SavedKnot saved_knot{number, knot};
      model::SavedRow knot_row(knots);
      SavedKnot::visit(saved_knot, knot_row);
    }
  }
  checkpoint.tables.push_back(std::move(edges));
  checkpoint.tables.push_back(std::move(knots));
}

void MovingEdges::restore(const model::Checkpoint& checkpoint) {
  const model::Table& edges = checkpoint.table("moving_edge");
  const model::Table& knots = checkpoint.table("edge_load");
  std::vector<std::vector<failure::EdgeHistory::Knot>> loads(edges.n_rows());
  for (std::size_t i = 0; i < knots.n_rows(); ++i) {
    SavedKnot saved;
    model::RestoredRow row(knots, i);
    SavedKnot::visit(saved, row);
    loads.at(static_cast<std::size_t>(saved.edge)).push_back(saved.knot);
  }
  edges_.clear();
  for (std::size_t i = 0; i < edges.n_rows(); ++i) {
    SavedEdge saved;
    model::RestoredRow row(edges, i);
    SavedEdge::visit(saved, row);
    edges_.push_back({.level_ice = static_cast<int>(saved.level_ice),
                      .touched_at = saved.touched_at,
                      .touched = {saved.tip, saved.length},
                      .way = saved.way,
                      .deflection = saved.deflection,
                      .spare = saved.spare,
                      .shape = {.depth = saved.depth, .contact_length = saved.contact_length, .angle = saved.angle},
                      .history = {std::move(loads[i]), saved.settled},
                      .thickness = saved.thickness,
                      .dynamics = dynamics(static_cast<int>(saved.level_ice), saved.thickness)});
  }
}

}  // namespace brash::edge
