// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a campaign: results with intervals over what was varied, and every run.
import uPlot from "uplot";
import { axis, Chart } from "./charts";
import { css, el, section, table } from "./dom";
import { number } from "./format";
import { manifestTables } from "./inputs";
import type { CampaignData, CampaignSetting } from "./types";

/** Columns first to look at; the rest follows. */
const kFirst = ["horizontal.mean", "vertical.mean", "horizontal.standard_deviation", "horizontal.quantile_99", "horizontal.maximum", "breaking_frequency"];

function unitOf(column: string): [string, number] {
  if (/^(horizontal|vertical|mean_whole_history)\b/.test(column) && !/skewness|_time|size|long_enough/.test(column)) return ["kN", 1e-3];
  if (column.startsWith("energy.")) return ["kJ", 1e-3];
  if (column.startsWith("piece_area")) return ["m²", 1];
  if (column.startsWith("breaking_length")) return ["m", 1];
  if (column === "breaking_frequency") return ["Hz", 1];
  if (column.endsWith("_time")) return ["s", 1];
  return ["", 1];
}

/** An input as the reader knows it: angles in degrees. */
function inputOf(data: CampaignData, key: string): { label: string; scale: number } {
  const [sectionName, name] = key.split(".");
  const unit = data.schema.properties[sectionName]?.properties?.[name]?.["x-unit"] ?? "";
  if (unit === "rad") return { label: `${key} [°]`, scale: 180 / Math.PI };
  return { label: unit && unit !== "1" ? `${key} [${unit}]` : key, scale: 1 };
}

/** Keys that take more than one value. */
function variedKeys(settings: CampaignSetting[]): string[] {
  const keys = Object.keys(settings[0]?.values ?? {});
  return keys.filter((key) => new Set(settings.map((s) => JSON.stringify(s.values[key]))).size > 1);
}

const kLines = ["--accent", "--red", "--teal", "--ochre", "--muted", "--ink"];

/** Settings that differ in `key` alone, by the values of the other inputs; all as one when that makes too many lines. */
function groupsOf(data: CampaignData, others: string[]): { groups: Map<string, CampaignSetting[]>; scattered: boolean } {
  const groups = new Map<string, CampaignSetting[]>();
  for (const setting of data.summary.settings) {
    const name = others.map((other) => {
      const { label, scale } = inputOf(data, other);
      const value = setting.values[other];
      return `${label} ${typeof value === "number" ? number(value * scale, 3) : String(value)}`;
    }).join(", ");
    groups.set(name, [...(groups.get(name) ?? []), setting]);
  }
  if (groups.size <= kMostLines) return { groups, scattered: false };
  return { groups: new Map([["each setting", data.summary.settings]]), scattered: true };
}

const kMostLines = 6;

/** One number over one input: a line for each combination of the other inputs, bars for the 95 % intervals, a dot a run. */
function trend(data: CampaignData, runs: Runs, column: string, key: string, others: string[]): Chart {
  const [unit, scale] = unitOf(column);
  const input = inputOf(data, key);
  const { groups, scattered } = groupsOf(data, others);
  const at = (s: CampaignSetting) => (s.values[key] as number) * input.scale;
  const points = [...groups.values()].map((group) => group
    .map((s): Point => ({ x: at(s), mean: s.statistics[column]?.mean ?? null, interval: s.statistics[column]?.mean_95 ?? null, runs: runs(s.setting, column) }))
    .sort((a, b) => a.x - b.x));
  const xs = scattered ? points[0].map((p) => p.x) : [...new Set(points.flat().map((p) => p.x))].sort((a, b) => a - b);
  const means = points.map((list) => scattered ? list.map((p) => scaled(p.mean, scale)) : xs.map((x) => scaled(list.find((p) => p.x === x)?.mean, scale)));
  const span = xs[xs.length - 1] - xs[0] || 1;
  const ends = points.flat().flatMap((p) => [p.mean ?? NaN, ...(p.interval ?? []), ...p.runs]).filter(Number.isFinite).map((n) => n * scale);
  const [low, high] = [Math.min(0, ...ends), Math.max(0, ...ends)];
  return new Chart(`${column} over ${key}`, 260, () => ({
    data: [xs, ...means] as uPlot.AlignedData,
    options: {
      scales: { x: { time: false, range: [xs[0] - 0.06 * span, xs[xs.length - 1] + 0.06 * span] }, y: { range: [low, high * 1.06 || 1] } },
      axes: [axis(input.label), axis(unit ? `${column} [${unit}]` : column, { size: 58 })],
      series: [{ label: input.label }, ...[...groups.keys()].map((name, i) => ({
        label: name || column, stroke: css(kLines[i]), width: scattered ? 0 : 1.3, spanGaps: true,
        points: { show: true, size: 6, fill: css(kLines[i]) },
        value: (_: uPlot, n: number | null) => number(n, 4),
      }))],
      hooks: { draw: [(plot: uPlot) => points.forEach((list, i) => mark(plot, css(kLines[i]), list, scale))] },
    },
  }));
}

interface Point {
  x: number;
  mean: number | null;
  interval: [number, number] | null;
  /** Values of the single runs. */
  runs: number[];
}

const scaled = (value: number | null | undefined, scale: number): number | null =>
  value === null || value === undefined ? null : value * scale;

function mark(plot: uPlot, colour: string, points: Point[], scale: number): void {
  const { ctx } = plot;
  const ratio = devicePixelRatio || 1;
  ctx.save();
  ctx.strokeStyle = ctx.fillStyle = colour;
  ctx.lineWidth = ratio;
  for (const { x, interval, runs } of points) {
    const px = plot.valToPos(x, "x", true);
    ctx.globalAlpha = 0.35;
    for (const value of runs) {
      ctx.beginPath();
      ctx.arc(px, plot.valToPos(value * scale, "y", true), 2 * ratio, 0, 2 * Math.PI);
      ctx.fill();
    }
    ctx.globalAlpha = 1;
    if (interval) bar(ctx, px, ...(interval.map((n) => plot.valToPos(n * scale, "y", true)) as [number, number]), 4 * ratio);
  }
  ctx.restore();
}

function bar(ctx: CanvasRenderingContext2D, x: number, a: number, b: number, half: number): void {
  ctx.beginPath();
  for (const y of [a, b]) {
    ctx.moveTo(x - half, y);
    ctx.lineTo(x + half, y);
  }
  ctx.moveTo(x, a);
  ctx.lineTo(x, b);
  ctx.stroke();
}

function settingRow(setting: CampaignSetting, columns: string[]): (string | HTMLElement)[] {
  const cells = columns.map((column) => {
    const c = setting.statistics[column];
    const scale = unitOf(column)[1];
    const interval = c?.mean_95 ? ` (${number(c.mean_95[0] * scale, 4)} to ${number(c.mean_95[1] * scale, 4)})` : "";
    return c?.mean === null || c?.mean === undefined ? "–" : `${number(c.mean * scale, 4)}${interval}`;
  });
  const warnings = Object.entries(setting.warnings ?? {}).map(([id, n]) => `${id} (${n})`).join(", ");
  return [setting.setting, String(setting.n_done), String(setting.n_failed), ...cells, warnings];
}

/** Rows of a CSV file as the campaign writes it; cells may be in quotes. */
export function parseCsv(text: string): string[][] {
  const cells = (line: string) =>
    [...line.matchAll(/("(?:[^"]|"")*"|[^,]*)(?:,|$)/g)].slice(0, -1).map((m) => m[1].replace(/^"|"$/g, "").replace(/""/g, '"'));
  return text.split("\n").filter((line) => line !== "").map((line) => cells(line + ","));
}

/** Values of a column in the runs of a setting. */
type Runs = (setting: string, column: string) => number[];

function runsOf(rows: string[][]): Runs {
  const [head, ...body] = rows;
  const values = new Map<string, string[][]>();
  const setting = head.indexOf("setting");
  for (const row of body) values.set(row[setting], [...(values.get(row[setting]) ?? []), row]);
  return (name, column) => {
    const i = head.indexOf(column);
    return i < 0 ? [] : (values.get(name) ?? []).filter((row) => row[i] !== "").map((row) => Number(row[i]));
  };
}

const titleOf = (column: string): string => (unitOf(column)[0] ? `${column} [${unitOf(column)[0]}]` : column);

function runsTable(data: CampaignData, rows: string[][], columns: string[]): HTMLElement {
  const [head, ...body] = rows;
  const reports = new Set(data.reports);
  const status = head.indexOf("status");
  const shown = ["status", ...columns].map((name) => head.indexOf(name)).filter((i) => i >= 0);
  const link = (row: string[]) => {
    const folder = `cases/${encodeURIComponent(row[0])}`;
    if (row[status] !== "done") return row[0];
    return el("a", { href: `${folder}/${reports.has(row[0]) ? "report.html" : "summary.json"}` }, row[0]);
  };
  const cell = (row: string[], i: number) =>
    columns.includes(head[i]) && row[i] !== "" ? number(Number(row[i]) * unitOf(head[i])[1], 4) : row[i] || "–";
  return table(["run", ...shown.map((i) => titleOf(head[i]))], body.map((row) => [link(row), ...shown.map((i) => cell(row, i))]), { id: "runs" });
}

/** Says which settings have cases without a mean load, and why. */
function withoutMean(settings: CampaignSetting[]): HTMLElement | false {
  const lacking = settings
    .map((s) => ({ s, n: s.n_done - (s.statistics["horizontal.mean"] ?? s.statistics["vertical.mean"] ?? { n: s.n_done }).n }))
    .filter(({ n }) => n > 0);
  if (lacking.length === 0) return false;
  const names = lacking.map(({ s, n }) => `${s.setting} (${n} of ${s.n_done})`).join(", ");
  return el("p", { class: "note" }, `Cases that were over before their statistics begin (output.statistics_from) have no mean load: ${names}.`);
}

export function showCampaign(data: CampaignData, parent: HTMLElement): void {
  const { settings, n_cases, n_done, n_failed } = data.summary;
  const known = Object.keys(settings[0]?.statistics ?? {});
  const columns = [...kFirst.filter((name) => known.includes(name)), ...known.filter((name) => !kFirst.includes(name))];
  const shown = columns.slice(0, 6);
  const keys = variedKeys(settings);
  const numeric = keys.filter((key) => settings.every((s) => typeof s.values[key] === "number"));
  // Keys that change together are one input: the first stands for them.
  const n_values = (...of: string[]) => new Set(settings.map((s) => JSON.stringify(of.map((key) => s.values[key])))).size;
  const together = (key: string, other: string) => n_values(key, other) === n_values(other);
  const axes = numeric.filter((key, i) => !numeric.slice(0, i).some((other) => together(key, other)));
  parent.append(
    el("div", { class: "figures" }, ...[[n_cases, "runs"], [n_done, "done"], [n_failed, "failed"], [settings.length, "settings"]].map(([n, name]) =>
      el("div", { class: "figure" }, el("b", {}, String(n)), el("span", {}, String(name))))),
  );
  const rows = parseCsv(data.table);
  const runs = runsOf(rows);
  const hasMeans = (column: string) => settings.some((s) => typeof s.statistics[column]?.mean === "number");
  const drawn = shown.filter(hasMeans).slice(0, axes.length > 3 ? 1 : 4);
  const charts = axes.flatMap((key) => drawn.map((column) => trend(data, runs, column, key, keys.filter((other) => other !== key && !together(other, key))).element));
  if (charts.length > 0)
    parent.append(section("trends", "Trends", el("p", {}, "Means over the replicates with Student's 95 % intervals; pale dots are single runs."), el("div", { class: "charts wide" }, ...charts)));
  parent.append(
    section("settings", "Settings",
      withoutMean(settings),
      table(["setting", "done", "failed", ...shown.map(titleOf), "warnings"], settings.map((s) => settingRow(s, shown)), { id: "settings-table" })),
    section("all-runs", "Every run", runsTable(data, rows, shown)),
    section("inputs", "Origin", manifestTables(data.manifest)),
  );
}
