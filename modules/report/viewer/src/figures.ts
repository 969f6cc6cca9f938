// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers on top of the page: of one run, or of two beside each other.
import type { Run } from "./data";
import { el, section, table } from "./dom";
import { chooseUnits, deviation, loadText, loadUnit, number, seconds } from "./format";
import type { LoadSummary, RunSummary } from "./types";

function figure(value: string, unit: string, name: string, note = ""): HTMLElement {
  return el("div", { class: "figure" }, el("b", {}, value, unit && el("small", {}, ` ${unit}`)), el("span", {}, name), note && el("em", {}, note));
}

/** In place of a number that a run does not have, and why. */
function none(name: string, why: string): HTMLElement {
  return el("div", { class: "figure none" }, el("b", {}, "none"), el("span", {}, name), el("em", {}, why));
}

/** An interval of a mean, or why there is none. */
function interval([lower, upper]: [number | null, number | null]): string {
  return lower === null || upper === null ? "no interval: see the warnings" : `95 % interval: ${loadText(lower)} to ${loadText(upper)} ${loadUnit()}`;
}

/** The largest horizontal load of the curve, and when; null in a run without steps. */
function largest(run: Run): { value: number | null; time: number } {
  const loads = run.column("load.Fx");
  if (loads.length === 0) return { value: null, time: 0 };
  let at = 0;
  for (let i = 1; i < loads.length; ++i) if (loads[i] > loads[at]) at = i;
  return { value: loads[at], time: run.column("load.time")[at] };
}

/** Chooses the units of a page by the largest load and the largest energy of its runs. */
export function chooseUnitsFor(runs: Run[]): void {
  const largestOf = (values: Iterable<number>) => {
    let most = 0;
    for (const value of values) if (Number.isFinite(value)) most = Math.max(most, Math.abs(value));
    return most;
  };
  const loads = runs.flatMap((run) => ["Fx", "Fy", "Fz"].map((name) => largestOf(run.column(`load.${name}`))));
  const energies = runs.map(({ data }) => {
    const { losses, ...own } = data.summary.energy;
    return largestOf([...Object.values(losses as Record<string, number>), ...(Object.values(own) as number[])]);
  });
  chooseUnits(largestOf(loads), largestOf(energies));
}

function placeInStatistics({ statistics_from: from, statistics_until: until }: RunSummary, time: number): string {
  if (time <= from) return "before the statistics begin";
  return until !== undefined && time > until ? "after the statistics end" : "in the statistics";
}

export function keyFigures(run: Run): HTMLElement {
  const s = run.data.summary;
  const from = seconds(s.statistics_from);
  const tooEarly = `statistics begin at ${from} s, the run ends at ${seconds(run.duration)} s`;
  const mean = (of: LoadSummary, name: string) => (of.mean === null ? none(name, tooEarly) : figure(loadText(of.mean), loadUnit(), name, interval(of.mean_95)));
  const whole = largest(run);
  const measured = run.input("reference", "mean_horizontal");
  return el("div", { class: "figures" },
    mean(s.horizontal, "mean horizontal"),
    mean(s.vertical, "mean vertical"),
    s.horizontal.maximum === null
      ? none("largest horizontal", tooEarly)
      : figure(loadText(s.horizontal.maximum), loadUnit(), `largest horizontal from ${from} s on`, `standard deviation ${loadText(s.horizontal.standard_deviation)} ${loadUnit()}`),
    whole.value !== null && figure(loadText(whole.value), loadUnit(), "largest horizontal of the whole run", `at ${seconds(whole.time)} s, ${placeInStatistics(s, whole.time)}`),
    Number.isFinite(measured) && figure(loadText(measured), loadUnit(), "reference mean", s.horizontal.mean === null ? "" : `this run: ${deviation(s.horizontal.mean, measured)}`),
    !Number.isFinite(measured) && s.fastest_floe !== null && figure(number(s.fastest_floe, 3), "m/s", "fastest floe"),
    figure(String(s.n_breaks), "", "breaks", s.breaking_frequency ? `${number(s.breaking_frequency, 3)} a second` : ""),
    figure(String(s.n_floes_born), "", "floes", fatesOf(run)));
}

/** Where the floes come from and what became of them, as far as there are any. */
function fatesOf(run: Run): string {
  const s = run.data.summary;
  const birth = run.column("floe.birth");
  const atStart = run.outlines.filter((_, i) => run.eventOf(i) < 0 && birth[i] <= 0).length;
  const fates: [number, string][] = [[atStart, "at the start"], [s.n_floes_present, "at the end"], [s.n_floes_crushed, "crushed"], [s.n_floes_broken, "broken again"]];
  return fates.filter(([n]) => n > 0).map(([n, fate]) => `${n} ${fate}`).join(", ");
}

/** Inputs in which two runs differ. */
function differences(runs: Run[]): string[][] {
  const [a, b] = runs.map(({ inputs }) => inputs);
  const sections = [...new Set([...Object.keys(a), ...Object.keys(b)])];
  return sections.flatMap((section) => [...new Set([...Object.keys(a[section] ?? {}), ...Object.keys(b[section] ?? {})])].flatMap((key) => {
    const texts = [a, b].map((inputs) => inputs[section]?.[key]).map((input) => (input ? `${input.text} ${input.unit === "1" ? "" : input.unit}`.trim() : "not given"));
    return texts[0] === texts[1] ? [] : [[`${section}.${key}`, ...texts]];
  }));
}

/** Two runs in numbers. */
export function comparedFigures(runs: Run[], names: string[]): HTMLElement {
  const row = (name: string, value: (run: Run) => string) => [name, ...runs.map(value)];
  const range = ({ mean_95: [low, high] }: LoadSummary) => (low === null || high === null ? "none" : `${loadText(low)} to ${loadText(high)}`);
  const load = (value: number | null) => (value === null ? "none" : loadText(value));
  return table(["", ...names], [
    row("made with", ({ data }) => data.origin),
    row(`mean horizontal [${loadUnit()}]`, ({ data }) => load(data.summary.horizontal.mean)),
    row(`its 95 % interval [${loadUnit()}]`, ({ data }) => range(data.summary.horizontal)),
    row(`mean vertical [${loadUnit()}]`, ({ data }) => load(data.summary.vertical.mean)),
    row(`largest horizontal in its statistics [${loadUnit()}]`, ({ data }) => load(data.summary.horizontal.maximum)),
    row(`largest horizontal of the whole run [${loadUnit()}]`, (run) => load(largest(run).value)),
    row("breaks, floes", ({ data }) => `${data.summary.n_breaks}, ${data.summary.n_floes_born}`),
  ], { id: "compared" });
}

export function differencesSection(runs: Run[], names: string[]): HTMLElement {
  const differing = differences(runs);
  return section("differences", "Inputs that differ", differing.length === 0
    ? el("p", {}, "The two runs have the same inputs.")
    : table(["input", ...names], differing));
}
