// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "brash/analysis/closed_forms.hpp"
#include "brash/analysis/history_statistics.hpp"
#include "brash/analysis/summary_tables.hpp"
#include "brash/analysis/tables.hpp"
#include "brash/io/origin.hpp"
#include "brash/simulation/warnings.hpp"

namespace brash::analysis {
namespace {

/// The unit of a run's loads.
TableUnit load_unit(const simulation::RunSummary& s) {
  const std::array loads{s.mean_horizontal_whole,  s.mean_vertical_whole,      s.maximum_horizontal_whole,
                         s.maximum_vertical_whole, s.minimum_horizontal_whole, s.minimum_vertical_whole};
  return unit_for(loads, "N");
}

std::string load_row(const simulation::RunSummary& run, const char* name, const statistics::Summary& s,
                     const simulation::LoadSplit& split, const TableUnit& unit) {
  const std::string interval =
      !simulation::bears_interval(run, s)
          ? "[no interval]"
          : fmt::format("[{:.1f}, {:.1f}]", s.mean_95.lower / unit.one, s.mean_95.upper / unit.one);
  const bool is_lower = acts_downwards(s);
  return fmt::format("  {:<11}{:>8.1f}  {:<16}{:>8.1f}{:>9.1f}{:>9.1f}{:>10.1f}  {:>9.1f}{:>9.1f}{:>10.1f}\n", name,
                     s.mean / unit.one, interval, s.effective_sample_size, s.standard_deviation / unit.one,
                     (is_lower ? s.quantile_1 : s.quantile_99) / unit.one,
                     (is_lower ? s.minimum : s.maximum) / unit.one, split.crushing / unit.one,
                     split.floe_normal / unit.one, split.floe_friction / unit.one);
}

/// The largest load in magnitude.
double largest(double least, double most) { return -least > std::abs(most) ? least : most; }

std::string loads(const simulation::RunSummary& s) {
  const TableUnit unit = load_unit(s);
  const std::string whole = fmt::format(
      "  over the whole run: mean {:.1f} horizontal, {:.1f} vertical; largest {:.1f} horizontal, {:.1f} vertical\n",
      s.mean_horizontal_whole / unit.one, s.mean_vertical_whole / unit.one,
      largest(s.minimum_horizontal_whole, s.maximum_horizontal_whole) / unit.one,
      largest(s.minimum_vertical_whole, s.maximum_vertical_whole) / unit.one);
  if (std::isnan(s.horizontal.mean))
    return fmt::format(
               "loads on the structure [{}]\n  none from t = {:.2f} s on: the run is over before its statistics begin "
               "(output.statistics_from)\n",
               unit.name, s.window.from) +
           whole;
  std::string text = fmt::format(
      "loads on the structure [{}], from t = {:.2f} s on, up to {:.2f} s\n  begins when {}\n  ends when {}\n",
      unit.name, s.window.from, s.window.until, s.window.begins, s.window.ends);
  text += "                 mean  95 % interval    samples     dev.     99 %       max   crushing  contact  friction\n";
  text += load_row(s, "horizontal", s.horizontal, s.horizontal_split, unit);
  text += load_row(s, "vertical", s.vertical, s.vertical_split, unit);
  if (acts_downwards(s.horizontal) || acts_downwards(s.vertical))
    text += "  note: 99 % and max of a negative load are of its lower end\n";
  if (!s.horizontal.long_enough && simulation::bears_interval(s, s.horizontal))
    text += fmt::format("  note: the history is {}\n", kTooShort);
  return text + whole;
}

/// Where a ship, a mesh or a structure with legs takes the load.
std::string regions(const simulation::RunSummary& s) {
  if (s.regions.empty()) return "";
  const TableUnit unit = load_unit(s);
  const bool are_legs = s.regions.front().region.starts_with("leg_");
  std::string text = fmt::format(
      "mean load by region of the structure [{}]\n                 horizontal  vertical   crushing, horizontal{}\n",
      unit.name, are_legs ? "" : "   under floes");
  for (const auto& [region, load] : s.regions) {
    text += fmt::format("  {:<13}{:>12.1f}{:>10.1f}{:>12.1f}", region, load.total.x / unit.one, load.total.z / unit.one,
                        load.crushing.x / unit.one);
    text += are_legs ? "\n" : fmt::format("{:>20.0f} %\n", 100.0 * load.covered);
  }
  return text;
}

/// The mean of the run beside the measured one [N].
std::string difference(const simulation::RunSummary& s, double measured, const TableUnit& unit) {
  if (std::isnan(s.horizontal.mean) || measured <= 0.0) return "";
  const double percent = 100.0 * (s.horizontal.mean / measured - 1.0);
  return fmt::format("  {:<43}{:>7.1f}  {:.1f} % {} the measured mean\n",
                     fmt::format("this run, mean over {:.1f} s", s.window.until - s.window.from),
                     s.horizontal.mean / unit.one, std::abs(percent), percent < 0.0 ? "below" : "above") +
         "  note: the mean of one run is weak evidence, because each seed gives another mean\n";
}

/// Other people's numbers for the same structure and ice. A ship's regression gives a mean, as a run does, the other
/// closed forms give peaks and are of fixed structures.
std::string comparison(const model::Case& resolved, const simulation::RunSummary& s) {
  const auto lindqvist = lindqvist_of(resolved);
  const bool is_ship = lindqvist && *lindqvist;
  const auto croasdale = croasdale_of(resolved);
  const auto ralston = ralston_of(resolved, standards::Yield::kTresca);
  const std::array largest{is_ship ? (*lindqvist)->total : 0.0, croasdale && !is_ship ? croasdale->horizontal : 0.0,
                           ralston && !is_ship ? ralston->horizontal : 0.0,
                           resolved.reference.mean_horizontal.value_or(0.0)};
  const TableUnit unit = unit_for(largest, "N");
  std::string text = fmt::format("for comparison, horizontal{} [{}]\n",
                                 resolved.structure.legs.size() < 2 ? "" : ", on one leg alone", unit.name);
  if (is_ship)
    text += fmt::format("  Lindqvist (regression of a ship), mean     {:>7.1f}\n", (*lindqvist)->total / unit.one);
  if (croasdale && !is_ship)
    text += fmt::format("  Croasdale (ISO 19906, elastic beam), peak  {:>7.1f}\n", croasdale->horizontal / unit.one);
  if (ralston && !is_ship)
    text += fmt::format("  Ralston (plastic, Tresca), peak            {:>7.1f}\n", ralston->horizontal / unit.one);
  if (const auto measured = resolved.reference.mean_horizontal)
    text += fmt::format("  {:<43}{:>7.1f}\n", resolved.reference.source, *measured / unit.one) +
            difference(s, *measured, unit);
  return text;
}

std::string quantile_row(const char* name, const std::vector<double>& q) {
  if (q.empty()) return fmt::format("  {:<24}none\n", name);
  return fmt::format("  {:<24}{:.3g}  {:.3g}  {:.3g}  {:.3g}  {:.3g}\n", name, q[0], q[1], q[2], q[3], q[4]);
}

/// Solutions of sheets, and the verdicts that they could not give, by reason.
std::string sheets(const model::SheetSolves& s) {
  if (s.coarse + s.cubic + s.without_edge == 0) return "";
  std::string text =
      fmt::format("  sheets solved: {} coarse, {} fine; {} split by a radial crack\n", s.coarse, s.cubic, s.split);
  const auto row = [&](int n, const char* what) {
    if (n > 0) text += fmt::format("  {:>10} {}\n", n, what);
  };
  row(s.without_edge, "contacts without an edge that faces them: the trapezoid was used");
  row(s.unsolved, "sheets could not be solved: the trapezoid was used");
  row(s.split_unsolved, "split sheets could not be solved: the whole sheet was used");
  row(s.holding_together, "verdicts above the strength, but no crack cut the ice off: no break yet");
  return text;
}

std::string verdicts(const model::KeptCounts& v) {
  if (v.kept == 0) return "";
  const std::string latest = v.late == 0 ? "" : fmt::format(", by {:.3g} s at most", v.latest);
  return fmt::format("  verdicts kept from an earlier step: {}; {} of {} controls failed late{}\n", v.kept, v.late,
                     v.controls, latest);
}

std::string ice(const simulation::RunSummary& s) {
  std::string text = "ice\n";
  const std::string rate = std::isnan(s.breaking_frequency) ? ""
                                                            : fmt::format(" ({:.2f} a second from {:.2f} s on)",
                                                                          s.breaking_frequency, s.window.from);
  text += fmt::format("  {} breaks{}, {} floes born, {} present, {} crushed, {} broken again", s.n_breaks, rate,
                      s.n_floes_born, s.n_floes_present, s.n_floes_crushed, s.n_floes_broken);
  text += s.fastest_floe ? fmt::format("; fastest floe {:.2f} m/s\n", *s.fastest_floe) : "\n";
  text += "  quantiles               5 %  25 %  50 %  75 %  95 %\n";
  text += quantile_row("piece area [m2]", s.piece_area_quantiles);
  text += quantile_row("breaking length [m]", s.breaking_length_quantiles);
  if (!s.overload_quantiles.empty()) {
    text += quantile_row("load / breaking load", s.overload_quantiles);
    text += quantile_row("stress / strength", s.stress_quantiles);
  }
  text +=
      fmt::format("  of the breaks {} under floes, {} after a radial crack, {} on the true edge, {} along the stress\n",
                  s.breaks.under_floes, s.breaks.radial_first, s.breaks.true_edge, s.breaks.along_stress);
  text += fmt::format("  failure model: {} steps shortened, {} inputs clamped below its range, {} above\n",
                      s.n_substepped, s.n_below_range, s.n_above_range);
  return text + sheets(s.sheets) + verdicts(s.verdicts);
}

std::string ledger(const geometry::Ledger& l) {
  return fmt::format(
      "ledger [m2]\n  {:.6f} initial = {:.6f} sheet + {:.6f} floes + {:.6f} crushed + {:.6f} deleted + {:.6f} brash"
      " + {:.3g} snap ({} roundings): {}\n",
      l.initial.square_metres(), l.sheet.square_metres(), l.floes.square_metres(), l.crushed.square_metres(),
      l.deleted.square_metres(), l.brash.square_metres(), l.snap.square_metres(), l.n_rounded,
      l.closes() ? "closes exactly" : "DOES NOT CLOSE");
}

std::string energy(const simulation::EnergyBalance& e) {
  const model::EnergyLosses& l = e.losses;
  const double share = e.work != 0.0 ? 100.0 * e.error / e.work : 0.0;
  const std::array energies{e.work,    e.kinetic_energy,    e.potential_energy, e.removed_energy, l.edge,
                            l.bending, l.structure_contact, l.sheet_contact,    l.floe_contact,   l.drag};
  const TableUnit unit = unit_for(energies, "J");
  std::string text = fmt::format(
      "energy [{}]\n  {:.1f} work of the structure = {:.1f} in the floes' motion + {:.1f} in their height + {:.1f} "
      "crushing the\n    sheet's edge + {:.1f} bending it + contacts and water below + {:.1f} with ice that was "
      "deleted, broke or\n    fell asleep; error {:.2f} ({:.3f} %), births {:.2g}\n",
      unit.name, e.work / unit.one, e.kinetic_energy / unit.one, e.potential_energy / unit.one, l.edge / unit.one,
      l.bending / unit.one, e.removed_energy / unit.one, e.error / unit.one, share, e.birth_energy / unit.one);
  const bool grounds = l.bed_contact != 0.0 || l.bed_friction != 0.0;
  const auto of_bed = [&](double loss) { return grounds ? fmt::format("{:>10.1f}\n", loss / unit.one) : "\n"; };
  text += "  floes against          structure     sheet     floes     water";
  text += grounds ? "       bed\n" : "\n";
  text += fmt::format("  crushing, impact, drag {:>9.1f}{:>10.1f}{:>10.1f}{:>10.1f}", l.structure_contact / unit.one,
                      l.sheet_contact / unit.one, l.floe_contact / unit.one, l.drag / unit.one);
  text += of_bed(l.bed_contact);
  text += fmt::format("  friction               {:>9.1f}{:>10.1f}{:>10.1f}{:>10.1f}", l.structure_friction / unit.one,
                      l.sheet_friction / unit.one, l.floe_friction / unit.one, l.skin_friction / unit.one);
  return text + of_bed(l.bed_friction);
}

std::string residual(const simulation::RunSummary& s) {
  return fmt::format(
      "contacts\n  residual of a step (last change of a relative velocity): {:.2g} m/s in the mean, {:.2g} m/s at "
      "most; {} steps unsettled\n",
      s.mean_last_change, s.largest_last_change, s.n_unsettled_steps);
}

std::string speed(const model::Case& resolved, const simulation::Run& run) {
  std::string text = fmt::format("speed\n  {:.2f} simulated s per wall s ({:.1f} s, {} thread{}):",
                                 (resolved.time.duration - run.resumed_from) / run.wall_seconds, run.wall_seconds,
                                 run.threads, run.threads == 1 ? "" : "s");
  simulation::visit_stages(run.stage_times, [&](const char* name, double seconds) {
    text += fmt::format(" {} {:.0f} %", name, 100.0 * seconds / run.wall_seconds);
  });
  return text + "\n";
}

/// The warnings that a user must know before using the numbers.
std::string warnings_text(const std::vector<model::Warning>& warnings) {
  std::string text;
  for (const model::Warning& warning : warnings) text += fmt::format("  {}: {}\n", warning.id, warning.text);
  return text.empty() ? "" : "warnings\n" + text;
}

}  // namespace

std::string run_table(const model::Case& resolved, const simulation::Run& run) {
  return fmt::format("{}: {} s in steps of {} s, seed {}\n{}\n\n", resolved.name, resolved.time.duration,
                     resolved.time.step, resolved.random.seed, io::origin_line(io::origin_of(resolved))) +
         warnings_text(run.summary.warnings) + loads(run.summary) + regions(run.summary) +
         comparison(resolved, run.summary) + ice(run.summary) + ledger(run.summary.ledger) +
         energy(run.summary.energy) + residual(run.summary) + speed(resolved, run);
}

}  // namespace brash::analysis
