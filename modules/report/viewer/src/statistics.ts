// SPDX-License-Identifier: GPL-3.0-or-later
// Moments, spectrum, exceedance and sizes.
import uPlot from "uplot";
import { axis, Chart } from "./charts";
import { kLoadNames, kLoads, shownUnit, type LoadChoice } from "./choice";
import type { Run } from "./data";
import { css, el, section, table } from "./dom";
import { kTooEarly } from "./extremes";
import { deviation, inLoadUnit, loadText, loadUnit, number, seconds, superscript } from "./format";
import type { LoadStatistics, RunData, RunSummary, Spectrum } from "./types";

/** Statistics of each load, and of a measured history beside Fx. */
function moments(run: Run, measured: RunData["measured"]): HTMLElement {
  const loads = run.data.loads;
  if (!loads) return el("p", {}, kTooEarly);
  const [first, ...rest] = kLoadNames.map((name): [string, LoadStatistics] => [`${name} [${shownUnit(name)}]`, loads[name]]);
  const columns = measured ? [first, [`Fx measured [${loadUnit()}]`, measured.statistics] as [string, LoadStatistics], ...rest] : [first, ...rest];
  const anyLower = columns.some(([, s]) => s.lower_end);
  const row = (name: string, value: (s: LoadStatistics) => string) => [name, ...columns.map(([, s]) => value(s))];
  const interval = ({ mean_95: [low, high], effective_sample_size }: LoadStatistics) => (low === null || high === null ? noInterval(effective_sample_size) : `${loadText(low)} to ${loadText(high)}`);
  return table(
    ["", ...columns.map(([name]) => name)],
    [
      row("mean", (s) => loadText(s.mean)),
      row("95 % interval of it", interval),
      row("standard deviation", (s) => loadText(s.standard_deviation)),
      ...(anyLower ? [row("end of the larger loads", (s) => (s.lower_end ? "lower" : "upper"))] : []),
      row("median", (s) => loadText(s.quantile_50)),
      row("95 % quantile", (s) => loadText(s.quantile_95)),
      row("99 % quantile", (s) => loadText(s.quantile_99)),
      row("largest", (s) => loadText(s.maximum)),
      row("smallest", (s) => loadText(s.minimum)),
      row("skewness", (s) => number(s.skewness, 3)),
      row("autocorrelation time [s]", (s) => number(s.autocorrelation_time, 3)),
      row("independent samples", (s) => number(s.effective_sample_size, 3)),
    ],
    { id: "moments" },
  );
}

/** Of loads whose mean is negative. */
const kLowerEnd = "A load whose larger end is the lower one has its quantiles, load events and extremes there: 99 % of the time it is above its 99 % quantile. ";

/** Below ten independent samples there is no interval, nor in a run that is too short or in which no ice broke or
 * pressed on the structure. */
const noInterval = (samples: number): string => (samples < 10 ? "too few samples" : "none: see the warnings");

function causes(run: Run): HTMLElement | false {
  const { horizontal: h, vertical: v } = run.data.summary;
  if (h.mean === null) return false;
  const row = (name: string, cause: string) => [name, loadText(h.mean_by_cause[cause]), loadText(v.mean_by_cause[cause])];
  return table(["mean by cause", `Fx [${loadUnit()}]`, `Fz [${loadUnit()}]`],
    [row("crushing at the edge", "crushing"), row("floes, normal", "floe_normal"), row("floes, friction", "floe_friction")], { id: "causes" });
}

/** Said in place of a chart that there is nothing to draw for. */
const kTooShort = "The history is too short for a spectrum.";

function spectrumChart(run: Run, choice: LoadChoice): Chart {
  const of = (): Spectrum | null => run.data.loads![choice.name].spectrum;
  return new Chart(
    "Spectrum of the load",
    240,
    () => {
      const { frequency, density } = of()!;
      return {
        data: [frequency.slice(1), density.slice(1).map((n) => inLoadUnit(inLoadUnit(n)))] as uPlot.AlignedData,
        heads: ["frequency [Hz]", `density of ${choice.name} [(${choice.unit})^2 / Hz]`],
        options: {
          scales: { x: { time: false, distr: 3 }, y: { distr: 3 } },
          axes: [axis("frequency [Hz]"), axis(`density of ${choice.name} [(${choice.unit})² / Hz]`, { size: 60, values: powers })],
          series: [{ label: "f [Hz]", value: shownOrNothing }, line(`density of ${choice.name}`, "--accent")],
        },
      };
    },
    () => {
      const { n_segments: n, n_lines: lines = 0, frequency, factors_95: [low, high] } = of()!;
      const drawn = frequency.length < lines ? ` Drawn: the lowest and the highest of ${lines} lines in narrow bands.` : "";
      return `Power spectral density (Welch, ${n} segments, Hann). 95 % interval: ${number(low, 2)} to ${number(high, 2)} times each value.${drawn}`;
    },
  );
}

const shownOrNothing = (_: uPlot, n: number | null): string => (n === null ? "" : number(n, 3));

const power = (n: number): string => `10${superscript(Math.round(Math.log10(n)))}`;
const powers = (_: uPlot, splits: number[]) =>
  splits.map((n) => (n > 0 && Math.abs(Math.log10(n) % 1) < 1e-9 ? (n >= 0.001 && n < 1e5 ? String(n) : power(n)) : ""));

const line = (label: string, colour: string, width = 1.2): uPlot.Series => ({
  label,
  stroke: css(colour),
  width,
  points: { show: false },
  value: shownOrNothing,
});

/** Width of the columns of a histogram over their distance. */
const kColumns = 0.96;

/** Steps of an axis that counts. */
const kWhole = [1, 2, 5].flatMap((n) => [n, 10 * n, 100 * n, 1000 * n, 10000 * n]).sort((a, b) => a - b);

/** Share of the time that the load, and share of the load events that the peak, is above a level; below it at the lower end. */
function exceedanceChart(run: Run, choice: LoadChoice): Chart {
  const ofLoad = () => run.data.loads![choice.name];
  const isLower = () => ofLoad().lower_end;
  return new Chart(
    "Exceedance of the load",
    240,
    () => ({
      data: exceedance(run, choice, ofLoad()),
      heads: [`${choice.name} [${choice.unit}]`, ...["time", "peaks"].map((of) => `share of the ${of} ${isLower() ? "below" : "above"}`)],
      options: {
        scales: { x: { time: false }, y: { distr: 3 } },
        axes: [axis(`${choice.name} [${choice.unit}]`), axis(isLower() ? "share below" : "share above", { size: 60, values: powers })],
        series: [
          { label: `${choice.name} [${choice.unit}]`, value: shownOrNothing },
          { ...line("of the time", "--accent"), spanGaps: true },
          { ...line("of the peaks", "--red"), spanGaps: true, points: { show: true, size: 5, fill: css("--red") } },
        ],
      },
    }),
    () => `Exceedance of ${kLoads[choice.name].short} ${spanOf(run)}; peaks of ${ofLoad().events.length} load events.`,
  );
}

/** The part of the run that the statistics cover. */
function spanOf(run: Run): string {
  const { statistics_from: from, statistics_until: until } = run.data.summary;
  return `from ${seconds(from)} s ${until === undefined ? "on" : `to ${seconds(until)} s`}`;
}

/** Why they begin and end there. */
function reasonsOf(run: Run): string {
  const reasons = run.data.summary.statistics_window;
  return reasons ? `They begin when ${reasons.begins}, and end when ${reasons.ends}. ` : "";
}

function exceedance(run: Run, choice: LoadChoice, { events, lower_end }: LoadStatistics): uPlot.AlignedData {
  const values = run.column(`exceedance.${choice.name}.value`);
  const ranks = run.column(`exceedance.${choice.name}.rank`);
  const peaks = events.map(({ peak }) => peak).sort((a, b) => (lower_end ? a - b : b - a));
  const points = new Map<number, [number | null, number | null]>();
  for (let i = 0; i < values.length; ++i) points.set(inLoadUnit(values[i]), [ranks[i] / (ranks.at(-1)! + 1), null]);
  peaks.forEach((value, i) => {
    const share = (i + 1) / (peaks.length + 1);
    points.set(inLoadUnit(value), [points.get(inLoadUnit(value))?.[0] ?? null, share]);
  });
  const sorted = [...points].sort((a, b) => a[0] - b[0]);
  return [sorted.map((p) => p[0]), sorted.map((p) => p[1][0]), sorted.map((p) => p[1][1])];
}

/** How many of the values are in each column of a histogram, from 0 to the largest. */
export function countsOf(values: ArrayLike<number>): { counts: number[]; width: number; largest: number } {
  let largest = 0;
  for (let i = 0; i < values.length; ++i) largest = Math.max(largest, values[i]);
  const n = Math.max(6, Math.min(24, Math.round(2 * Math.sqrt(values.length))));
  const width = largest / n || 1;
  const counts = new Array<number>(n).fill(0);
  for (let i = 0; i < values.length; ++i) ++counts[Math.min(n - 1, Math.floor(values[i] / width))];
  return { counts, width, largest };
}

function histogram(values: ArrayLike<number>, unit: string, name: string, quantiles: number[]): Chart | null {
  if (values.length === 0) return null;
  const { counts, width, largest } = countsOf(values);
  const data = [counts.map((_, i) => (i + 0.5) * width), counts] as uPlot.AlignedData;
  return new Chart(
    `Histogram: ${name}`,
    200,
    () => ({
      data,
      columns: kColumns,
      heads: [`${name} [${unit}]`, "count"],
      options: {
        scales: { x: { time: false, range: [0, largest * 1.02] }, y: { range: [0, Math.max(...counts) * 1.08] } },
        legend: { show: false },
        cursor: { show: false },
        axes: [axis(`${name} [${unit}]`), axis("count", { size: 46, incrs: kWhole })],
        series: [
          {},
          {
            label: "count", stroke: css("--accent"), fill: css("--bars"), width: 1, points: { show: false },
            paths: uPlot.paths.bars!({ size: [kColumns, Infinity], align: 0 }),
          },
        ],
      },
    }),
    () => `${values.length} values. Quantiles 5, 25, 50, 75, 95 %: ${quantiles.map((q) => number(q, 3)).join(", ")} ${unit}.`,
  );
}

/** The reference of the case beside the mean of the run. */
function referenceNote(run: Run): string {
  const measured = run.input("reference", "mean_horizontal");
  if (!Number.isFinite(measured)) return "";
  const source = String(run.inputs.reference?.source?.value ?? "");
  const { mean } = run.data.summary.horizontal;
  return ` Reference (${source}): ${loadText(measured)} ${loadUnit()}` + (mean === null ? "." : `; the mean of this run is ${deviation(mean, measured)} away.`);
}

/** By how much the load at each break of the structure was above the load at which the ice just fails, in per cent. */
function lateness(run: Run): Chart | null {
  const quantiles = run.data.summary.overload_quantiles ?? [];
  if (quantiles.length === 0) return null;
  const excess = (overload: number) => Math.max(0, 100 * (overload - 1));
  const floe = run.column("event.pressing_floe");
  const known = [...run.column("event.overload")].filter((overload, i) => overload > 0 && floe[i] < 0);
  return histogram(known.map(excess), "%", "load above the breaking load at breaks of the structure", quantiles.map(excess));
}

/** What the run knows about the error of its verdicts. */
function verdictNote({ sheets, verdicts }: RunSummary): string {
  if (!verdicts?.kept) return "";
  const { kept, controls, late, latest } = verdicts;
  return ` ${(sheets?.solved_coarse ?? 0) + (sheets?.solved_cubic ?? 0)} sheets were solved and ${kept} verdicts kept from an earlier step. Of ${controls} kept verdicts that were solved all the same, ` +
    (late === 0 ? "none failed late." : `${late} failed late, by ${number(latest, 3)} s at most.`);
}

export function statisticsSection(run: Run, choice: LoadChoice, measured: RunData["measured"]): HTMLElement {
  const { data } = run;
  const s = data.summary;
  const hasSpectrum = data.loads?.Fx.spectrum != null;
  const ofLoads = data.loads ? [hasSpectrum ? spectrumChart(run, choice) : null, exceedanceChart(run, choice)] : [];
  choice.onChange(() => ofLoads.forEach((chart) => chart?.redraw()));
  const charts = [
    ...ofLoads,
    histogram(run.column("floe.area"), "m²", "piece area", s.piece_area_quantiles),
    histogram(run.column("event.l_break"), "m", "breaking length", s.breaking_length_quantiles),
    lateness(run),
  ];
  const hasInterval = Object.values(data.loads ?? {}).some(({ mean_95: [low] }) => low !== null);
  const short = s.horizontal.mean !== null && !s.horizontal.long_enough;
  return section(
    "statistics",
    "Statistics",
    moments(run, measured),
    el("p", { class: "note" },
      `Statistics ${spanOf(run)}. ${reasonsOf(run)}` +
        (Object.values(data.loads ?? {}).some(({ lower_end }) => lower_end) ? kLowerEnd : "") +
        (short && hasInterval ? "The history is shorter than 50 autocorrelation times: the intervals are themselves uncertain." : "") + referenceNote(run) + verdictNote(s) +
        (measured ? ` Measured: ${measured.name}, the whole history.` : "")),
    el("div", { class: "charts" }, causes(run), data.loads && !hasSpectrum && el("p", { class: "note" }, kTooShort),
      ...charts.map((chart) => chart && chart.element)),
  );
}
