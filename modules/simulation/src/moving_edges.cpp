// SPDX-License-Identifier: GPL-3.0-or-later
#include "moving_edges.hpp"

#include <algorithm>
#include <cmath>

#include "plan.hpp"

namespace brash::simulation {
namespace {

/// An edge in a checkpoint.
struct SavedEdge {
  std::int64_t level_ice = 0;
  double touched_at = 0.0;
  Vec2 tip{};
  double length = 0.0, thickness = 0.0, way = 0.0, deflection = 0.0, depth = 0.0, contact_length = 0.0, angle = 0.0;
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

double MovingEdges::follow(const std::vector<EdgeContact>& contacts, double from, double to) {
  if (dynamics_.empty()) return 0.0;
  double work = 0.0;
  std::vector<Edge> now;
  for (const EdgeContact& contact : contacts) {
    const Edge* const before = edge_at(contact.level_ice, contact.touched);
    Edge edge = before != nullptr ? *before
                                  : Edge{.level_ice = contact.level_ice,
                                         .touched_at = from,
                                         .history = failure::EdgeHistory(from),
                                         .thickness = contact.ice.thickness,
                                         .dynamics = dynamics(contact.level_ice, contact.ice.thickness)};
    edge.touched = contact.touched;
    if (contact.load.pressure > 0.0) {
      edge.way = contact.on_ice.z > 0.0 ? 1.0 : -1.0;
      edge.shape = {
          .depth = contact.load.depth, .contact_length = contact.load.contact_length, .angle = contact.load.angle};
    } else if (before == nullptr) {
      continue;
    }
    const double force = std::abs(contact.on_ice.z), mean_force = 0.5 * (edge.history.force() + force);
    edge.history.extend(to, force, edge.dynamics.memory());
    const double deflection = edge.dynamics.deflection(edge.shape, edge.history, to);
    work += mean_force * (deflection - edge.deflection);
    edge.deflection = deflection;
    now.push_back(std::move(edge));
  }
  edges_ = std::move(now);
  return work;
}

MovingEdges::Life MovingEdges::life(const EdgeContact& contact) const {
  const Edge* const edge = contact.floe == model::kNoFloe ? edge_at(contact.level_ice, contact.touched) : nullptr;
  return edge != nullptr ? Life{edge->history.time() - edge->touched_at, edge->deflection} : Life{};
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
  std::erase_if(edges_, [&](const Edge& edge) { return edge.level_ice == level_ice && is_on(box, edge.touched.tip); });
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
                      .shape = {.depth = saved.depth, .contact_length = saved.contact_length, .angle = saved.angle},
                      .history = {std::move(loads[i]), saved.settled},
                      .thickness = saved.thickness,
                      .dynamics = dynamics(static_cast<int>(saved.level_ice), saved.thickness)});
  }
}

}  // namespace brash::simulation
