// SPDX-License-Identifier: GPL-3.0-or-later
// Results over what was varied: small charts of one scale, a line for each value of a second input, bars for intervals.
import uPlot from "uplot";
import { axis, Chart } from "./charts";
import { inputOf, type Quantity, resultOf, titleOf, valueOf } from "./campaign_names";
import { css, el } from "./dom";
import { number } from "./format";
import type { Mark } from "./marks";
import type { CampaignData, CampaignSetting } from "./types";

/** Values of a column in the runs of a setting. */
export type Runs = (setting: string, column: string) => number[];

interface Point {
  x: number;
  mean: number | null;
  interval: [number, number] | null;
  /** Values of the single runs. */
  runs: number[];
}

const kLines = ["--accent", "--red", "--teal", "--ochre", "--violet", "--ink"];
const kMostCharts = 12;

/** What of a campaign one chart draws: over `x`, a line for each value of `lines`, and in `settings` alone. */
interface Facet {
  title: string;
  settings: CampaignSetting[];
}

const distinct = (settings: CampaignSetting[], key: string): number => new Set(settings.map((s) => JSON.stringify(s.values[key]))).size;

/** The input whose values become lines: the one with the fewest, if the lines can be distinguished. */
function linesOf(settings: CampaignSetting[], others: string[]): string | null {
  const sorted = others.map((key) => ({ key, n: distinct(settings, key) })).sort((a, b) => a.n - b.n);
  return sorted.length > 0 && sorted[0].n <= kLines.length ? sorted[0].key : null;
}

/** One for each combination of the inputs that are neither axis nor lines. */
function facetsOf(data: CampaignData, rest: string[]): Facet[] {
  const facets = new Map<string, CampaignSetting[]>();
  for (const setting of data.summary.settings) {
    const title = rest.map((key) => `${inputOf(data, key).name} ${valueOf(data, setting, key)}`).join(", ");
    facets.set(title, [...(facets.get(title) ?? []), setting]);
  }
  return [...facets].map(([title, settings]) => ({ title, settings }));
}

/** Charts of one result over one input. @param others the inputs that vary besides. */
export function multiples(data: CampaignData, runs: Runs, column: string, key: string, others: string[]): HTMLElement {
  const result = resultOf(column);
  const lines = linesOf(data.summary.settings, others);
  const facets = facetsOf(data, others.filter((other) => other !== lines));
  const range = rangeOf(data.summary.settings, runs, column, result);
  const drawn = facets.slice(0, kMostCharts);
  return el("div", { class: "multiples" },
    el("h3", {}, `${result.name} over ${inputOf(data, key).name}`),
    el("div", { class: "charts small" }, ...drawn.map((facet) =>
      el("div", {}, facet.title !== "" && el("h4", {}, facet.title), trend({ data, runs, column, key, lines, facet, range }).element))),
    facets.length > drawn.length && el("p", { class: "note" }, `${facets.length - drawn.length} more combinations are in the table.`));
}

/** One scale for all charts of a result, from 0. */
function rangeOf(settings: CampaignSetting[], runs: Runs, column: string, { scale }: Quantity): [number, number] {
  const all = settings.flatMap((s) => {
    const c = s.statistics[column];
    return [c?.mean ?? NaN, ...(c?.mean_95 ?? []), ...runs(s.setting, column)];
  }).filter(Number.isFinite).map((n) => n * scale);
  return [Math.min(0, ...all), 1.06 * Math.max(0, ...all) || 1];
}

interface Trend {
  data: CampaignData;
  runs: Runs;
  column: string;
  key: string;
  lines: string | null;
  facet: Facet;
  range: [number, number];
}

function trend({ data, runs, column, key, lines, facet, range }: Trend): Chart {
  const [result, input] = [resultOf(column), inputOf(data, key)];
  const groups = new Map<string, Point[]>();
  for (const s of facet.settings) {
    const name = lines ? `${inputOf(data, lines).name} ${valueOf(data, s, lines)}` : result.name;
    const c = s.statistics[column];
    const point = { x: (s.values[key] as number) * input.scale, mean: c?.mean ?? null, interval: c?.mean_95 ?? null, runs: runs(s.setting, column) };
    groups.set(name, [...(groups.get(name) ?? []), point]);
  }
  const points = [...groups.values()];
  const xs = [...new Set(points.flat().map((p) => p.x))].sort((a, b) => a - b);
  const means = points.map((list) => xs.map((x) => scaled(list.find((p) => p.x === x)?.mean, result.scale)));
  const span = xs[xs.length - 1] - xs[0] || 1;
  const name = `${titleOf(result)} over ${titleOf(input)}${facet.title && `: ${facet.title}`}`;
  return new Chart(name, 220, () => ({
    data: [xs, ...means] as uPlot.AlignedData,
    heads: [titleOf(input), ...[...groups.keys()].map((label) => `${label}: ${titleOf(result)}`)],
    options: {
      scales: { x: { time: false, range: [xs[0] - 0.06 * span, xs[xs.length - 1] + 0.06 * span] }, y: { range } },
      axes: [axis(titleOf(input)), axis(result.unit || result.name, { size: 58 })],
      series: [{ label: titleOf(input), value: shown }, ...[...groups.keys()].map((label, i) => ({
        label, stroke: css(kLines[i]), width: 1.3, spanGaps: true, points: { show: true, size: 6, fill: css(kLines[i]) }, value: shown,
      }))],
    },
    marks: () => points.flatMap((list, i) => marksOf(list, css(kLines[i]), result.scale)),
  }));
}

const shown = (_: uPlot, n: number | null): string => (n === null ? "" : number(n, 4));

const scaled = (value: number | null | undefined, scale: number): number | null =>
  value === null || value === undefined ? null : value * scale;

/** Intervals as bars, runs as pale dots. */
function marksOf(points: Point[], colour: string, scale: number): Mark[] {
  return points.flatMap(({ x, interval, runs }): Mark[] => [
    ...runs.map((value): Mark => ({ kind: "dot", name: "single run", colour, x, y: value * scale, radius: 2, opacity: 0.35 })),
    ...(interval ? [{ kind: "bar", name: "95 % interval of the mean", colour, x, low: interval[0] * scale, high: interval[1] * scale } as const] : []),
  ]);
}
