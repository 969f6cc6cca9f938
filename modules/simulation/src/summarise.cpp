// SPDX-License-Identifier: GPL-3.0-or-later
#include "summarise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "brash/simulation/warnings.hpp"
#include "brash/statistics/quantile.hpp"

namespace brash::simulation {
namespace {

/// Value of a quantity without data; null in JSON.
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<double, 5> kQuantiles{0.05, 0.25, 0.5, 0.75, 0.95};

/// Mean over the window of one component of the loads.
template <typename Component>
double mean(std::span<const model::LoadRow> rows, Component component) {
  double sum = 0.0;
  for (const model::LoadRow& row : rows) sum += component(row);
  return rows.empty() ? kUnknown : sum / static_cast<double>(rows.size());
}

template <typename Component>
double maximum(std::span<const model::LoadRow> rows, Component component) {
  double most = rows.empty() ? kUnknown : component(rows.front());
  for (const model::LoadRow& row : rows) most = std::max(most, component(row));
  return most;
}

template <typename Component>
statistics::Summary summarise_component(std::span<const model::LoadRow> rows, double step, Component component) {
  if (rows.size() < 2)
    return {.mean = kUnknown,
            .standard_deviation = kUnknown,
            .minimum = kUnknown,
            .maximum = kUnknown,
            .skewness = kUnknown,
            .quantile_1 = kUnknown,
            .quantile_50 = kUnknown,
            .quantile_95 = kUnknown,
            .quantile_99 = kUnknown,
            .autocorrelation_time = kUnknown,
            .effective_sample_size = kUnknown,
            .mean_95 = {kUnknown, kUnknown}};
  std::vector<double> samples;
  for (const model::LoadRow& row : rows) samples.push_back(component(row));
  return statistics::summarise(samples, step);
}

template <typename Axis>
LoadSplit split(std::span<const model::LoadRow> rows, Axis axis) {
  return {mean(rows, [&](const model::LoadRow& r) { return axis(r.crushing.force); }),
          mean(rows, [&](const model::LoadRow& r) { return axis(r.floe_normal.force); }),
          mean(rows, [&](const model::LoadRow& r) { return axis(r.floe_friction.force); })};
}

/// Of the legs, or of the regions of a ship or a mesh. Where no ice touches a hull, its regions carry zero; a hull that
/// carries a load on none of its regions has no regions.
std::vector<RegionMean> mean_by_region(std::span<const model::LoadRow> rows, const model::StructureSection& structure) {
  const std::size_t n_legs = structure.legs.size();
  const std::size_t first = n_legs > 0 ? model::kHullRegions : 0;
  const std::size_t end = n_legs > 0 ? first + n_legs : model::kHullRegions;
  std::vector<RegionMean> means;
  const bool is_long =
      std::holds_alternative<model::Ship>(structure.shape) || std::holds_alternative<model::Mesh>(structure.shape);
  const auto is_touched = [](const model::LoadRow& row) { return row.total.force != Vec3{}; };
  bool any = n_legs > 0 || (is_long && std::ranges::none_of(rows, is_touched));
  model::RegionLoads::visit([&](const char* region, const char*, std::size_t i) {
    if (i < first || i >= end) return;
    const auto mean_of = [&](Vec3 model::RegionLoad::*force) {
      const auto along = [&](double Vec3::*axis) {
        return mean(rows, [&](const model::LoadRow& row) { return row.regions[i].*force.*axis; });
      };
      return Vec3{along(&Vec3::x), along(&Vec3::y), along(&Vec3::z)};
    };
    means.push_back({region,
                     {mean_of(&model::RegionLoad::total), mean_of(&model::RegionLoad::crushing),
                      mean(rows, [&](const model::LoadRow& row) { return row.regions[i].covered; })}});
    any = any || means.back().load != model::RegionLoad{};
  });
  if (rows.empty() || !any) means.clear();
  return means;
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

/// The largest speed of a floe between two frames [m/s]; nothing without them.
std::optional<double> fastest(std::span<const model::Frame> frames) {
  if (frames.size() < 2) return std::nullopt;
  double speed = 0.0;
  std::map<std::int64_t, Vec3> before;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    std::map<std::int64_t, Vec3> now;
    for (const model::FloePose& floe : frames[i].floes) {
      now[floe.floe] = floe.pose.position;
      if (const auto last = before.find(floe.floe); last != before.end())
        speed = std::max(speed, norm(floe.pose.position - last->second) / (frames[i].time - frames[i - 1].time));
    }
    before = std::move(now);
  }
  return speed;
}

/// An interval of a mean; null where there are too few samples for one.
nlohmann::ordered_json interval_of(const RunSummary& run, const statistics::Summary& s) {
  if (!bears_interval(run, s)) return {nullptr, nullptr};
  return {s.mean_95.lower, s.mean_95.upper};
}

nlohmann::ordered_json json_of(const RunSummary& run, const statistics::Summary& s, const LoadSplit& by_cause) {
  return {{"mean", s.mean},
          {"mean_95", interval_of(run, s)},
          {"standard_deviation", s.standard_deviation},
          {"minimum", s.minimum},
          {"maximum", s.maximum},
          {"skewness", s.skewness},
          {"quantile_1", s.quantile_1},
          {"quantile_50", s.quantile_50},
          {"quantile_95", s.quantile_95},
          {"quantile_99", s.quantile_99},
          {"autocorrelation_time", s.autocorrelation_time},
          {"effective_sample_size", s.effective_sample_size},
          {"long_enough", s.long_enough},
          {"mean_by_cause",
           {{"crushing", by_cause.crushing},
            {"floe_normal", by_cause.floe_normal},
            {"floe_friction", by_cause.floe_friction}}}};
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

EnergyBalance energy_balance(std::span<const model::LoadRow> rows) {
  if (rows.empty()) return {};
  double largest = 0.0;
  double before = 0.0;
  for (const model::LoadRow& row : rows) {
    largest = std::max(largest, std::abs(row.energy_error - before));
    before = row.energy_error;
  }
  const model::LoadRow& end = rows.back();
  return {.work = end.work,
          .birth_energy = end.birth_energy,
          .kinetic_energy = end.kinetic_energy,
          .potential_energy = end.potential_energy,
          .removed_energy = end.removed_energy,
          .losses = end.losses,
          .error = end.energy_error,
          .largest_step_error = largest};
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

RunSummary summarise(const model::Case& resolved, const model::RunResults& results, double open_water, RunSummary s) {
  const double last_time = s.window.until + 0.5 * resolved.time.step;
  const auto first = std::ranges::upper_bound(results.loads, s.window.from, {}, &model::LoadRow::time);
  const auto end = std::ranges::upper_bound(first, results.loads.end(), last_time, {}, &model::LoadRow::time);
  const std::span<const model::LoadRow> window(first, end);
  const auto x = [](Vec3 v) { return v.x; };
  const auto z = [](Vec3 v) { return v.z; };
  const auto total_x = [](const model::LoadRow& r) { return r.total.force.x; };
  const auto total_z = [](const model::LoadRow& r) { return r.total.force.z; };
  s.horizontal = summarise_component(window, resolved.time.step, total_x);
  s.vertical = summarise_component(window, resolved.time.step, total_z);
  s.horizontal_split = split(window, x);
  s.vertical_split = split(window, z);
  s.regions = mean_by_region(window, resolved.structure);
  s.mean_horizontal_whole = mean(results.loads, total_x);
  s.mean_vertical_whole = mean(results.loads, total_z);
  s.maximum_horizontal_whole = maximum(results.loads, total_x);
  s.maximum_vertical_whole = maximum(results.loads, total_z);
  s.minimum_horizontal_whole = -maximum(results.loads, [&](const auto& row) { return -total_x(row); });
  s.minimum_vertical_whole = -maximum(results.loads, [&](const auto& row) { return -total_z(row); });

  s.n_breaks = static_cast<int>(results.events.size());
  std::vector<double> lengths, overloads, stresses;
  int n_in_window = 0;
  for (const model::CrackEvent& event : results.events) {
    lengths.push_back(event.breaking_length);
    n_in_window += event.time > s.window.from && event.time <= last_time ? 1 : 0;
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
  s.mean_last_change =
      results.loads.empty() ? kUnknown : s.sum_of_last_changes / static_cast<double>(results.loads.size());
  s.piece_area_quantiles = statistics::quantiles(std::move(areas), kQuantiles);
  s.fastest_floe = fastest(results.frames);
  s.energy = energy_balance(results.loads);
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
