// SPDX-License-Identifier: GPL-3.0-or-later
#include "summarise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <type_traits>

#include "brash/simulation/warnings.hpp"
#include "brash/statistics/quantile.hpp"

namespace brash::simulation {
namespace {

/// Value of a quantity without data; null in JSON.
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<double, 5> kQuantiles{0.05, 0.25, 0.5, 0.75, 0.95};

statistics::Summary summarise_component(const std::vector<double>& samples, double step) {
  if (samples.size() >= 2) return statistics::summarise(samples, step);
  statistics::Summary unknown;
  statistics::Summary::visit([&](const statistics::Statistic&, auto member) {
    if constexpr (std::is_same_v<decltype(member), double statistics::Summary::*>) unknown.*member = kUnknown;
  });
  return unknown;
}

nlohmann::ordered_json json_of(const std::vector<RegionMean>& means) {
  const auto of = [](Vec3 force) { return nlohmann::ordered_json{{"Fx", force.x}, {"Fy", force.y}, {"Fz", force.z}}; };
  nlohmann::ordered_json json;
  for (const auto& [region, load] : means) {
    json[region] = {{"total", of(load.total)}, {"crushing", of(load.crushing)}};
    if (!region.starts_with("leg_")) json[region]["covered"] = load.covered;
  }
  return json;
}

/// Up to it the window reaches; half a step absorbs the rounding of step times [s].
double last_time(const model::Case& resolved, const StatisticsWindow& window) {
  return window.until + 0.5 * resolved.time.step;
}

/// An interval of a mean; null where there are too few samples for one.
nlohmann::ordered_json interval_of(const RunSummary& run, const statistics::Summary& s) {
  if (!bears_interval(run, s)) return {nullptr, nullptr};
  return {s.mean_95.lower, s.mean_95.upper};
}

nlohmann::ordered_json json_of(const RunSummary& run, const statistics::Summary& s, const LoadSplit& by_cause) {
  nlohmann::ordered_json json;
  statistics::Summary::visit([&](const statistics::Statistic& of, auto member) {
    if (!of.in_runs) return;
    if constexpr (std::is_same_v<decltype(member), statistics::Interval statistics::Summary::*>)
      json[of.name] = interval_of(run, s);
    else
      json[of.name] = s.*member;
  });
  json["mean_by_cause"] = {{"crushing", by_cause.crushing},
                           {"floe_normal", by_cause.floe_normal},
                           {"floe_friction", by_cause.floe_friction}};
  return json;
}

template <typename Counts>
nlohmann::ordered_json json_of_counts(const Counts& counts) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  Counts::visit(counts, [&](const char* name, const char*, const char*, auto count) { json[name] = count; });
  return json;
}

nlohmann::ordered_json json_of(const geometry::Ledger& ledger) {
  return {{"initial", ledger.initial.to_string()},
          {"sheet", ledger.sheet.to_string()},
          {"floes", ledger.floes.to_string()},
          {"crushed", ledger.crushed.to_string()},
          {"deleted", ledger.deleted.to_string()},
          {"brash", ledger.brash.to_string()},
          {"snap", ledger.snap.to_string()},
          {"n_rounded", ledger.n_rounded},
          {"closes", ledger.closes()}};
}

nlohmann::ordered_json json_of(const EnergyBalance& e) {
  nlohmann::ordered_json losses;
  const auto add = [&](const char* cause, const char*, double model::EnergyLosses::*loss) {
    losses[cause] = e.losses.*loss;
  };
  model::EnergyLosses::visit_without_bed(add);
  if (e.losses.bed_contact != 0.0 || e.losses.bed_friction != 0.0) model::EnergyLosses::visit_of_bed(add);
  return {{"work", e.work},
          {"birth_energy", e.birth_energy},
          {"kinetic_energy", e.kinetic_energy},
          {"potential_energy", e.potential_energy},
          {"removed_energy", e.removed_energy},
          {"losses", losses},
          {"energy_error", e.error},
          {"largest_step_error", e.largest_step_error}};
}

/// A field of floes at the start: all that were there before the first step.
/// Areas of the sheets at the start, whose outlines come each with its holes [m2].
std::vector<double> areas_of(std::span<const std::vector<Vec2>> rings) {
  std::vector<double> areas;
  for (const std::vector<Vec2>& ring : rings) {
    double area = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i)
      area += 0.5 * cross(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]);
    if (area > 0.0)
      areas.push_back(area);
    else if (!areas.empty())
      areas.back() += area;
  }
  return areas;
}

/// The small floes, and the large ones, which are sheets.
InitialFloes floes_at_start(const model::RunResults& results, double open_water) {
  std::vector<double> areas, sizes;
  for (const model::FloeRecord& floe : results.floes)
    if (!(floe.birth > 0.0)) areas.push_back(floe.area);
  std::ranges::copy(areas_of(results.initial_sheet), std::back_inserter(areas));
  double area = 0.0;
  for (const double one : areas) {
    area += one;
    sizes.push_back(std::sqrt(one));
  }
  InitialFloes at_start{.n = static_cast<int>(sizes.size()), .concentration = area / open_water, .size_quantiles = {}};
  at_start.size_quantiles = statistics::quantiles(std::move(sizes), kQuantiles);
  return at_start;
}

}  // namespace

void LoadsSeen::add(const model::LoadRow& row) {
  ++n_steps_;
  if (row.total.force != Vec3{}) last_load_ = row.time;
  if (row.time <= from_ || row.time > until_) return;
  const std::size_t half = row.time <= 0.5 * (from_ + until_) ? 0 : 1;
  sums_.at(half) += row.regions[static_cast<std::size_t>(model::HullRegion::kBottom)].covered;
  rows_.at(half) += 1.0;
}

double Mean::value() const { return n == 0 ? kUnknown : sum / static_cast<double>(n); }

RowSummary::RowSummary(const model::Case& resolved, const StatisticsWindow& window)
    : from_(window.from), until_(last_time(resolved, window)), seen_(window) {}

void RowSummary::add(const model::RunResults& part) {
  for (const model::LoadRow& row : part.loads) add(row);
  for (const model::Frame& frame : part.frames) add(frame);
}

void RowSummary::Whole::add(double load) {
  mean.add(load);
  most = std::max(most.value_or(load), load);
  most_backwards = std::max(most_backwards.value_or(-load), -load);
}

void RowSummary::add(const model::LoadRow& row) {
  seen_.add(row);
  horizontal_.add(row.total.force.x);
  vertical_.add(row.total.force.z);
  largest_step_error_ = std::max(largest_step_error_, std::abs(row.energy_error - last_.energy_error));
  last_ = row;
  if (row.time > from_ && row.time <= until_) add_to_window(row);
}

void RowSummary::add_to_window(const model::LoadRow& row) {
  window_.horizontal.push_back(row.total.force.x);
  window_.vertical.push_back(row.total.force.z);
  window_.crushing += row.crushing.force;
  window_.floe_normal += row.floe_normal.force;
  window_.floe_friction += row.floe_friction.force;
  for (std::size_t i = 0; i < row.regions.size(); ++i) {
    window_.regions[i].total += row.regions[i].total;
    window_.regions[i].crushing += row.regions[i].crushing;
    window_.regions[i].covered += row.regions[i].covered;
  }
  window_.is_touched = window_.is_touched || row.total.force != Vec3{};
}

void RowSummary::add(const model::Frame& frame) {
  std::map<std::int64_t, Vec3> now;
  for (const model::FloePose& floe : frame.floes) {
    now[floe.floe] = floe.pose.position;
    if (const auto last = positions_.find(floe.floe); last != positions_.end())
      fastest_ = std::max(fastest_, norm(floe.pose.position - last->second) / (frame.time - frame_time_));
  }
  positions_ = std::move(now);
  frame_time_ = frame.time;
  ++n_frames_;
}

LoadSplit RowSummary::split(double Vec3::*axis) const {
  const auto mean = [&](Vec3 sum) { return Mean{sum.*axis, window_.horizontal.size()}.value(); };
  return {mean(window_.crushing), mean(window_.floe_normal), mean(window_.floe_friction)};
}

/// Of the legs, or of the regions of a ship or a mesh. Where no ice touches a hull, its regions carry zero; a hull that
/// carries a load on none of its regions has no regions.
std::vector<RegionMean> RowSummary::mean_by_region(const model::StructureSection& structure) const {
  const std::size_t n_legs = structure.legs.size();
  const std::size_t first = n_legs > 0 ? model::kHullRegions : 0;
  const std::size_t end = n_legs > 0 ? first + n_legs : model::kHullRegions;
  std::vector<RegionMean> means;
  const bool is_long =
      std::holds_alternative<model::Ship>(structure.shape) || std::holds_alternative<model::Mesh>(structure.shape);
  bool any = n_legs > 0 || (is_long && !window_.is_touched);
  const std::size_t n = window_.horizontal.size();
  const auto mean_of = [n](Vec3 sum) {
    return Vec3{Mean{sum.x, n}.value(), Mean{sum.y, n}.value(), Mean{sum.z, n}.value()};
  };
  model::RegionLoads::visit([&](const char* region, const char*, std::size_t i) {
    if (i < first || i >= end) return;
    const model::RegionLoad& sums = window_.regions[i];
    means.push_back({region, {mean_of(sums.total), mean_of(sums.crushing), Mean{sums.covered, n}.value()}});
    any = any || means.back().load != model::RegionLoad{};
  });
  if (n == 0 || !any) means.clear();
  return means;
}

/// The largest speed of a floe between two frames [m/s]; nothing without them.
std::optional<double> RowSummary::fastest() const {
  if (n_frames_ < 2) return std::nullopt;
  return fastest_;
}

EnergyBalance RowSummary::energy_balance() const {
  return {.work = last_.work,
          .birth_energy = last_.birth_energy,
          .kinetic_energy = last_.kinetic_energy,
          .potential_energy = last_.potential_energy,
          .removed_energy = last_.removed_energy,
          .losses = last_.losses,
          .error = last_.energy_error,
          .largest_step_error = largest_step_error_};
}

void RowSummary::write_to(const model::Case& resolved, RunSummary& s) const {
  s.horizontal = summarise_component(window_.horizontal, resolved.time.step);
  s.vertical = summarise_component(window_.vertical, resolved.time.step);
  s.horizontal_split = split(&Vec3::x);
  s.vertical_split = split(&Vec3::z);
  s.regions = mean_by_region(resolved.structure);
  s.mean_horizontal_whole = horizontal_.mean.value();
  s.mean_vertical_whole = vertical_.mean.value();
  s.maximum_horizontal_whole = horizontal_.most.value_or(kUnknown);
  s.maximum_vertical_whole = vertical_.most.value_or(kUnknown);
  s.minimum_horizontal_whole = -horizontal_.most_backwards.value_or(kUnknown);
  s.minimum_vertical_whole = -vertical_.most_backwards.value_or(kUnknown);
  s.mean_last_change = Mean{s.sum_of_last_changes, seen_.n_steps()}.value();
  s.fastest_floe = fastest();
  s.energy = energy_balance();
}

RunSummary summarise(const model::Case& resolved, const model::RunResults& results, const RowSummary& rows,
                     double open_water, RunSummary s) {
  rows.write_to(resolved, s);
  s.n_breaks = static_cast<int>(results.events.size());
  std::vector<double> lengths, overloads, stresses;
  int n_in_window = 0;
  for (const model::CrackEvent& event : results.events) {
    lengths.push_back(event.breaking_length);
    n_in_window += event.time > s.window.from && event.time <= last_time(resolved, s.window) ? 1 : 0;
    if (event.overload == 0.0 || event.pressing_floe != model::kNoFloe) continue;
    overloads.push_back(event.overload);
    stresses.push_back(event.sigma_max / event.flexural_strength);
  }
  const double window_length = s.window.until - s.window.from;
  s.breaking_frequency = window_length > 0.0 ? n_in_window / window_length : kUnknown;
  s.breaking_length_quantiles = statistics::quantiles(std::move(lengths), kQuantiles);
  s.overload_quantiles = statistics::quantiles(std::move(overloads), kQuantiles);
  s.stress_quantiles = statistics::quantiles(std::move(stresses), kQuantiles);

  std::vector<double> areas;
  for (const model::FloeRecord& floe : results.floes) {
    areas.push_back(floe.area);
    s.n_floes_crushed += floe.end == model::FloeEnd::kCrushed ? 1 : 0;
    s.n_floes_broken += floe.end == model::FloeEnd::kBroken ? 1 : 0;
    s.n_floes_present += floe.end == model::FloeEnd::kAlive ? 1 : 0;
  }
  s.n_floes_born = static_cast<int>(results.floes.size());
  if (resolved.field.kind == model::FieldKind::kFloes) s.initial_floes = floes_at_start(results, open_water);
  s.piece_area_quantiles = statistics::quantiles(std::move(areas), kQuantiles);
  return s;
}

double settled_residual(Vec2 velocity, Vec2 current) {
  constexpr double kSinking = 8e-5, kShareOfSpeed = 0.03;
  return std::max(kSinking, kShareOfSpeed * norm(velocity - current));
}

bool bear_interval(std::span<const model::Warning> warnings) {
  return std::ranges::none_of(warnings, [](const model::Warning& w) {
    return w.id == "short-run" || w.id == "no-breaks" || w.id == "no-load";
  });
}

bool bears_interval(const RunSummary& summary, const statistics::Summary& load) {
  return load.effective_sample_size >= kFewSamples && bear_interval(summary.warnings);
}

std::string to_json(const RunSummary& s) {
  nlohmann::ordered_json warnings = nlohmann::ordered_json::array();
  for (const model::Warning& warning : s.warnings) warnings.push_back({{"id", warning.id}, {"text", warning.text}});
  nlohmann::ordered_json json{
      {"warnings", std::move(warnings)},
      {"origin", s.origin},
      {"units", "SI; Fx positive against the structure's heading, Fz positive upwards on the structure"},
      {"statistics_from", s.window.from},
      {"statistics_until", s.window.until},
      {"statistics_window", {{"begins", s.window.begins}, {"ends", s.window.ends}}},
      {"horizontal", json_of(s, s.horizontal, s.horizontal_split)},
      {"vertical", json_of(s, s.vertical, s.vertical_split)},
      {"mean_whole_history", {{"horizontal", s.mean_horizontal_whole}, {"vertical", s.mean_vertical_whole}}},
      {"maximum_whole_history", {{"horizontal", s.maximum_horizontal_whole}, {"vertical", s.maximum_vertical_whole}}},
      {"minimum_whole_history", {{"horizontal", s.minimum_horizontal_whole}, {"vertical", s.minimum_vertical_whole}}},
      {"n_breaks", s.n_breaks},
      {"breaks_decided", json_of_counts(s.breaks)},
      {"breaking_frequency", s.breaking_frequency},
      {"breaking_length_quantiles", s.breaking_length_quantiles},
      {"overload_quantiles", s.overload_quantiles},
      {"stress_over_strength_quantiles", s.stress_quantiles},
      {"n_floes_born", s.n_floes_born},
      {"n_floes_present", s.n_floes_present},
      {"n_floes_crushed", s.n_floes_crushed},
      {"n_floes_broken", s.n_floes_broken},
      {"piece_area_quantiles", s.piece_area_quantiles},
      {"quantile_levels", kQuantiles},
      {"failure_model_range",
       {{"n_substepped", s.n_substepped}, {"n_below", s.n_below_range}, {"n_above", s.n_above_range}}},
      {"n_outlines_refused", s.sheets.without_edge + s.sheets.unsolved},
      {"sheets", json_of_counts(s.sheets)},
      {"verdicts", json_of_counts(s.verdicts)},
      {"n_steps_too_long", s.n_steps_too_long},
      {"n_unsettled_steps", s.n_unsettled_steps},
      {"contact_iterations",
       {{"mean_last_change", s.mean_last_change}, {"largest_last_change", s.largest_last_change}}},
      {"fastest_floe", s.fastest_floe ? nlohmann::ordered_json(*s.fastest_floe) : nlohmann::ordered_json()},
      {"ledger", json_of(s.ledger)},
      {"energy", json_of(s.energy)}};
  if (s.initial_floes)
    json["initial_floes"] = {{"n", s.initial_floes->n},
                             {"concentration", s.initial_floes->concentration},
                             {"size_quantiles", s.initial_floes->size_quantiles}};
  if (!s.regions.empty()) json["mean_by_region"] = json_of(s.regions);
  return json.dump(2) + "\n";
}

}  // namespace brash::simulation
