// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>

#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "brash/io/case.hpp"
#include "simulation_impl.hpp"

namespace brash::simulation {
namespace {

using geometry::ExactArea;
using geometry::Int128;

std::string to_text(ExactArea area) {
  Int128 value = area.twice_in_grid_units();
  const bool negative = value < 0;
  std::string digits;
  do {
    const int digit = static_cast<int>(value % 10);
    digits += static_cast<char>('0' + (negative ? -digit : digit));
    value /= 10;
  } while (value != 0);
  if (negative) digits += '-';
  std::ranges::reverse(digits);
  return digits;
}

ExactArea from_text(const std::string& text) {
  Int128 value = 0;
  const bool negative = text.starts_with('-');
  for (const char digit : text.substr(negative ? 1 : 0)) {
    BRASH_EXPECTS(digit >= '0' && digit <= '9', text);
    value = 10 * value + (negative ? -(digit - '0') : digit - '0');
  }
  return ExactArea(value);
}

std::vector<model::GridPoint> to_grid(const geometry::Ring& ring) {
  std::vector<model::GridPoint> points;
  points.reserve(ring.size());
  for (const geometry::Point p : ring) points.push_back({p.x, p.y});
  return points;
}

model::GridRings to_grid(const geometry::Polygon& polygon) {
  model::GridRings rings{to_grid(polygon.outline)};
  for (const geometry::Ring& hole : polygon.holes) rings.push_back(to_grid(hole));
  return rings;
}

geometry::Polygon from_grid(const model::GridRings& rings) {
  BRASH_EXPECTS(!rings.empty());
  geometry::Polygon polygon;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    geometry::Ring ring;
    for (const model::GridPoint p : rings[i]) ring.push_back({p.x, p.y});
    if (i == 0)
      polygon.outline = std::move(ring);
    else
      polygon.holes.push_back(std::move(ring));
  }
  return polygon;
}

geometry::Ledger ledger_of(const model::Checkpoint& checkpoint) {
  const auto account = [&](const char* name) { return from_text(checkpoint.ledger.at(name)); };
  return {.initial = account("initial"),
          .sheet = account("sheet"),
          .floes = account("floes"),
          .crushed = account("crushed"),
          .deleted = account("deleted"),
          .brash = account("brash"),
          .snap = account("snap"),
          .n_rounded = checkpoint.counters.at("n_rounded")};
}

model::KeptDrag kept_drag(const KeptDrag& kept) {
  const auto& [form, skin, skin_power] = kept.drag;
  return {.left = kept.left,
          .sum = form.sum,
          .first = form.first,
          .squares = form.squares,
          .products = form.products,
          .rotation = form.rotation,
          .skin_force = skin.force,
          .skin_moment = skin.moment,
          .skin_power = skin_power,
          .velocity = kept.velocity};
}

KeptDrag kept_drag(const model::KeptDrag& saved) {
  return {{{.sum = saved.sum,
            .first = saved.first,
            .squares = saved.squares,
            .products = saved.products,
            .rotation = saved.rotation},
           {saved.skin_force, saved.skin_moment},
           saved.skin_power},
          saved.velocity,
          saved.left};
}

/// The ice of `checkpoint`, once it is known to be of this case.
IceField field_of(const model::Case& resolved, const model::Checkpoint& checkpoint) {
  if (checkpoint.case_name != resolved.name || checkpoint.case_toml != io::to_toml(resolved))
    throw InputError(Complaint{"the checkpoint",
                               "is of case \"" + checkpoint.case_name + "\" with other values than this one",
                               "a checkpoint of this case with the same values",
                               "resume with the case file and the --set options of the interrupted run, or start again "
                               "without --resume"});
  std::vector<geometry::Polygon> sheet;
  for (const model::GridRings& rings : checkpoint.sheet) sheet.push_back(from_grid(rings));
  return {sheet, ledger_of(checkpoint)};
}

}  // namespace

Simulation::Impl::Impl(const model::Case& c, const model::Checkpoint& checkpoint) : Impl(c, field_of(c, checkpoint)) {
  n_steps = checkpoint.counters.at("n_steps");
  n_breaks = static_cast<std::uint64_t>(checkpoint.counters.at("n_breaks"));
  EnergyLedger::visit(energy, [&](const std::string& name, double& sum) { sum = checkpoint.numbers.at(name); });
  centre = {checkpoint.numbers.at("centre_x"), checkpoint.numbers.at("centre_y")};
  world.set_state(structure_body, structure_pose(), {});
  for (const model::CheckpointFloe& floe : checkpoint.floes)
    floes.restore(world, from_grid(floe.rings),
                  {.id = floe.id,
                   .pose = floe.pose,
                   .twist = floe.twist,
                   .stress = floe.stress,
                   .peak_compression = floe.peak_stress,
                   .bearing = floe.bearing,
                   .rest = floe.rest,
                   .kept_drag = kept_drag(floe.kept_drag)});
  for (const model::FloePush& push : checkpoint.pushes) floes.restore_push(push.floe, push.other, push.force);
  floes.set_next_id(checkpoint.counters.at("next_floe"));
  for (const auto& [body, floe] : floes.floes()) lay_sheet_near(body);  // a settled one may be run into at once
  begin_watch();
}

model::Checkpoint Simulation::Impl::checkpoint() const {
  const geometry::Ledger& l = field.ledger();
  model::Checkpoint saved{.case_name = resolved.name,
                          .case_toml = resolved_toml,
                          .sheet = {},
                          .floes = {},
                          .pushes = {},
                          .ledger = {{"initial", to_text(l.initial)},
                                     {"sheet", to_text(l.sheet)},
                                     {"floes", to_text(l.floes)},
                                     {"crushed", to_text(l.crushed)},
                                     {"deleted", to_text(l.deleted)},
                                     {"brash", to_text(l.brash)},
                                     {"snap", to_text(l.snap)}},
                          .counters = {{"n_rounded", l.n_rounded},
                                       {"n_steps", n_steps},
                                       {"n_breaks", static_cast<std::int64_t>(n_breaks)},
                                       {"next_floe", floes.next_id()}},
                          .numbers = {{"centre_x", centre.x}, {"centre_y", centre.y}},
                          .results = {}};
  EnergyLedger::visit(energy, [&](const std::string& name, double sum) { saved.numbers[name] = sum; });
  for (const geometry::Polygon& polygon : field.sheet().polygons()) saved.sheet.push_back(to_grid(polygon));
  for (const auto& [body, floe] : floes.floes())
    saved.floes.push_back({.id = floe.id,
                           .body = BodyId{static_cast<std::uint32_t>(saved.floes.size()), 0},  // only the order counts
                           .rings = to_grid(floe.outline),
                           .thickness = floe.prism.thickness,
                           .pose = world.pose(body),
                           .twist = world.twist(body),
                           .stress = floe.stress,
                           .peak_stress = floe.peak_compression,
                           .bearing = floe.bearing,
                           .rest = floe.rest,
                           .kept_drag = kept_drag(floe.kept_drag)});
  for (const auto& [pair, force] : floes.pushes().pairs())
    saved.pushes.push_back({floes.floes().at(pair.first).id, floes.floes().at(pair.second).id, force});
  return saved;
}

}  // namespace brash::simulation
