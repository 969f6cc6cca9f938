// SPDX-License-Identifier: GPL-3.0-or-later
// Moments, spectrum, exceedance and sizes.
import uPlot from "uplot";
import { axis, Chart } from "./charts";
import type { Run } from "./data";
import { css, el, section, table } from "./dom";
import { deviation, kN, number, seconds } from "./format";
import type { AxisStatistics, LoadSummary, RunData } from "./types";

function moments(data: RunData): HTMLElement {
  const { horizontal: h, vertical: v } = data.summary;
  const row = (name: string, value: (s: LoadSummary) => string) => [name, value(h), value(v)];
  return table(
    ["", "horizontal [kN]", "vertical [kN]"],
    [
      row("mean", (s) => kN(s.mean)),
      row("95 % interval of the mean", (s) => s.mean_95[0] === null || s.mean_95[1] === null ? "no interval" : `${kN(s.mean_95[0])} to ${kN(s.mean_95[1])}`),
      row("standard deviation", (s) => kN(s.standard_deviation)),
      row("median", (s) => kN(s.quantile_50)),
      row("95 % quantile", (s) => kN(s.quantile_95)),
      row("99 % quantile", (s) => kN(s.quantile_99)),
      row("largest", (s) => kN(s.maximum)),
      row("smallest", (s) => kN(s.minimum)),
      row("from crushing at the edge", (s) => kN(s.mean_by_cause.crushing)),
      row("from floes, normal", (s) => kN(s.mean_by_cause.floe_normal)),
      row("from floes, friction", (s) => kN(s.mean_by_cause.floe_friction)),
      row("skewness", (s) => number(s.skewness, 3)),
      row("autocorrelation time [s]", (s) => number(s.autocorrelation_time, 3)),
      row("independent samples", (s) => number(s.effective_sample_size, 3)),
    ],
    { id: "moments" },
  );
}

function spectrumChart(horizontal: AxisStatistics, vertical: AxisStatistics): Chart | null {
  const [h, v] = [horizontal.spectrum, vertical.spectrum];
  if (!h || !v) return null;
  const kilo = (values: number[]) => values.slice(1).map((n) => n / 1e6);
  const data = [h.frequency.slice(1), kilo(h.density), kilo(v.density)] as uPlot.AlignedData;
  const [low, high] = h.factors_95;
  return new Chart(
    240,
    () => ({
      data,
      options: {
        scales: { x: { time: false, distr: 3 }, y: { distr: 3 } },
        axes: [axis("frequency [Hz]"), axis("density [kN² / Hz]", { size: 60, values: powers })],
        series: [{ label: "f [Hz]" }, line("horizontal", "--accent"), line("vertical", "--ochre")],
      },
    }),
    `Power spectral density (Welch, ${h.n_segments} segments, Hann). 95 % interval: ${number(low, 2)} to ${number(high, 2)} times each value.`,
  );
}

const powers = (_: uPlot, splits: number[]) =>
  splits.map((n) => (n > 0 && Math.abs(Math.log10(n) % 1) < 1e-9 ? (n >= 0.01 && n < 1e5 ? String(n) : n.toExponential(0)) : ""));

const line = (label: string, colour: string, width = 1.2): uPlot.Series => ({
  label,
  stroke: css(colour),
  width,
  points: { show: false },
  value: (_, n) => (n === null ? "–" : number(n, 3)),
});

/** Share of the time that the load, and share of the peaks that the peak, is above a level. */
function exceedanceChart(run: Run, statistics: NonNullable<RunData["statistics"]>): Chart {
  const times = run.column("load.time");
  const samples: number[] = [];
  const fx = run.column("load.Fx");
  for (let i = 0; i < fx.length; ++i) if (times[i] > run.data.summary.statistics_from) samples.push(fx[i]);
  samples.sort((a, b) => b - a);
  const peaks = statistics.horizontal.peaks.value;
  const points = new Map<number, [number | null, number | null]>();
  samples.forEach((value, i) => points.set(value / 1e3, [(i + 1) / (samples.length + 1), null]));
  peaks.forEach((value, i) => {
    const share = (i + 1) / (peaks.length + 1);
    points.set(value / 1e3, [points.get(value / 1e3)?.[0] ?? null, share]);
  });
  const sorted = [...points].sort((a, b) => a[0] - b[0]);
  const data = [sorted.map((p) => p[0]), sorted.map((p) => p[1][0]), sorted.map((p) => p[1][1])] as uPlot.AlignedData;
  return new Chart(
    240,
    () => ({
      data,
      options: {
        scales: { x: { time: false }, y: { distr: 3 } },
        axes: [axis("horizontal load [kN]"), axis("share above", { size: 60, values: powers })],
        series: [
          { label: "load [kN]" },
          { ...line("of the time", "--accent"), spanGaps: true },
          { ...line("of the peaks", "--red"), spanGaps: true, points: { show: true, size: 5, fill: css("--red") } },
        ],
      },
    }),
    `Exceedance of the horizontal load from ${seconds(run.data.summary.statistics_from)} s on; ${peaks.length} peaks between upward crossings of the mean.`,
  );
}

function histogram(values: ArrayLike<number>, unit: string, name: string, quantiles: number[]): Chart | null {
  if (values.length === 0) return null;
  const list = Array.from(values);
  const largest = Math.max(...list);
  const n = Math.max(6, Math.min(24, Math.round(2 * Math.sqrt(list.length))));
  const width = largest / n || 1;
  const counts = new Array<number>(n).fill(0);
  for (const value of list) ++counts[Math.min(n - 1, Math.floor(value / width))];
  const data = [counts.map((_, i) => (i + 0.5) * width), counts] as uPlot.AlignedData;
  return new Chart(
    200,
    () => ({
      data,
      options: {
        scales: { x: { time: false, range: [0, largest * 1.02] }, y: { range: [0, Math.max(...counts) * 1.08] } },
        legend: { show: false },
        cursor: { show: false },
        axes: [axis(`${name} [${unit}]`), axis("count", { size: 46 })],
        series: [
          {},
          {
            label: "count", stroke: css("--accent"), fill: css("--bars"), width: 1, points: { show: false },
            paths: uPlot.paths.bars!({ size: [0.96, Infinity], align: 0 }),
          },
        ],
      },
    }),
    `${list.length} of them. Quantiles 5, 25, 50, 75, 95 %: ${quantiles.map((q) => number(q, 3)).join(", ")} ${unit}.`,
  );
}

export function statisticsSection(run: Run): HTMLElement {
  const { data } = run;
  const s = data.summary;
  const charts = [
    data.statistics && spectrumChart(data.statistics.horizontal, data.statistics.vertical),
    data.statistics && exceedanceChart(run, data.statistics),
    histogram(run.column("floe.area"), "m²", "piece area", s.piece_area_quantiles),
    histogram(run.column("event.l_break"), "m", "breaking length", s.breaking_length_quantiles),
  ];
  const measured = run.input("reference", "mean_horizontal");
  return section(
    "statistics",
    "Statistics",
    el("div", { class: "columns" },
      el("div", {},
        moments(data),
        el("p", { class: "note" },
          `From ${seconds(s.statistics_from)} s on. ` +
            (s.horizontal.mean === null ? "The run is over before. " : s.horizontal.long_enough ? "" : "The history is shorter than 50 autocorrelation times: the intervals are themselves uncertain. ") +
            (Number.isFinite(measured) ? `Reference (${String(run.inputs.reference?.source?.value ?? "")}): ${kN(measured)} kN; the mean of this run is ${deviation(s.horizontal.mean, measured)} away.` : ""))),
      el("div", { class: "charts" }, ...charts.map((chart) => chart && chart.element))),
  );
}
