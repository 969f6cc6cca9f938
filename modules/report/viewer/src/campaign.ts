// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a campaign: results with intervals over what was varied, and every run.
import uPlot from "uplot";
import { axis, Chart } from "./charts";
import { css, el, section, table } from "./dom";
import { number } from "./format";
import { manifestTables } from "./inputs";
import type { CampaignColumn, CampaignData, CampaignSetting } from "./types";

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

/** One number over one input: a line for each combination of the other inputs, bars for the 95 % intervals. */
function trend(data: CampaignData, column: string, key: string, others: string[]): Chart {
  const [unit, scale] = unitOf(column);
  const input = inputOf(data, key);
  const groups = new Map<string, CampaignSetting[]>();
  for (const setting of data.summary.settings) {
    const name = others.map((other) => {
      const { label, scale: s } = inputOf(data, other);
      const value = setting.values[other];
      return `${label} ${typeof value === "number" ? number(value * s, 3) : String(value)}`;
    }).join(", ");
    groups.set(name, [...(groups.get(name) ?? []), setting]);
  }
  const at = (s: CampaignSetting) => (s.values[key] as number) * input.scale;
  const xs = [...new Set(data.summary.settings.map(at))].sort((a, b) => a - b);
  const cell = (group: CampaignSetting[], x: number): CampaignColumn | undefined => group.find((s) => at(s) === x)?.statistics[column];
  const lists = [...groups.values()];
  const means = lists.map((group) => xs.map((x) => scaled(cell(group, x)?.mean, scale)));
  const span = xs.length > 1 ? xs[xs.length - 1] - xs[0] : 1;
  const ends = lists.flatMap((group) => xs.flatMap((x) => {
    const c = cell(group, x);
    return [...(c?.mean_95 ?? []), c?.mean ?? NaN].map((n) => n * scale).filter(Number.isFinite);
  }));
  const [low, high] = [Math.min(0, ...ends), Math.max(...ends)];
  return new Chart(260, () => ({
    data: [xs, ...means] as uPlot.AlignedData,
    options: {
      scales: { x: { time: false, range: [xs[0] - 0.06 * span, xs[xs.length - 1] + 0.06 * span] }, y: { range: [low, high * 1.06] } },
      axes: [axis(input.label), axis(unit ? `${column} [${unit}]` : column, { size: 58 })],
      series: [{ label: input.label }, ...[...groups.keys()].map((name, i) => ({
        label: name || column, stroke: css(kLines[i % kLines.length]), width: 1.3, spanGaps: true,
        points: { show: true, size: 6, fill: css(kLines[i % kLines.length]) },
        value: (_: uPlot, n: number | null) => number(n, 4),
      }))],
      hooks: { draw: [(plot) => lists.forEach((group, i) => bars(plot, css(kLines[i % kLines.length]), xs.map((x) => [x, cell(group, x)?.mean_95 ?? null]), scale))] },
    },
  }));
}

const scaled = (value: number | null | undefined, scale: number): number | null =>
  value === null || value === undefined ? null : value * scale;

function bars(plot: uPlot, colour: string, intervals: [number, [number, number] | null][], scale: number): void {
  const { ctx } = plot;
  ctx.save();
  ctx.strokeStyle = colour;
  ctx.lineWidth = devicePixelRatio || 1;
  for (const [x, interval] of intervals) {
    if (!interval) continue;
    const px = plot.valToPos(x, "x", true);
    const [a, b] = interval.map((n) => plot.valToPos(n * scale, "y", true));
    ctx.beginPath();
    for (const y of [a, b]) {
      ctx.moveTo(px - 4, y);
      ctx.lineTo(px + 4, y);
    }
    ctx.moveTo(px, a);
    ctx.lineTo(px, b);
    ctx.stroke();
  }
  ctx.restore();
}

function settingRow(setting: CampaignSetting, columns: string[]): (string | HTMLElement)[] {
  const cells = columns.map((column) => {
    const c = setting.statistics[column];
    const scale = unitOf(column)[1];
    const interval = c?.mean_95 ? ` (${number(c.mean_95[0] * scale, 4)} to ${number(c.mean_95[1] * scale, 4)})` : "";
    return c?.mean === null || c?.mean === undefined ? "–" : `${number(c.mean * scale, 4)}${interval}`;
  });
  return [setting.setting, String(setting.n_done), String(setting.n_failed), ...cells];
}

/** Rows of a CSV file as the campaign writes it; cells may be in quotes. */
export function parseCsv(text: string): string[][] {
  const cells = (line: string) =>
    [...line.matchAll(/("(?:[^"]|"")*"|[^,]*)(?:,|$)/g)].slice(0, -1).map((m) => m[1].replace(/^"|"$/g, "").replace(/""/g, '"'));
  return text.split("\n").filter((line) => line !== "").map((line) => cells(line + ","));
}

function runsTable(data: CampaignData, columns: string[]): HTMLElement {
  const [head, ...rows] = parseCsv(data.table);
  const reports = new Set(data.reports);
  const shown = ["setting", "replicate", "status", ...columns].map((name) => head.indexOf(name)).filter((i) => i >= 0);
  return table(["run", ...shown.map((i) => [head[i], unitOf(head[i])[0]].filter(Boolean).join(" ").replace(/ (\S+)$/, unitOf(head[i])[0] ? " [$1]" : " $1"))],
    rows.map((row) => {
      const name = row[0];
      const link = reports.has(name)
        ? el("a", { href: `cases/${encodeURIComponent(name)}/report.html` }, name)
        : row[head.indexOf("status")] === "done" ? el("a", { href: `cases/${encodeURIComponent(name)}/summary.json` }, name) : name;
      return [link, ...shown.map((i) => {
        const value = Number(row[i]);
        return row[i] !== "" && Number.isFinite(value) && columns.includes(head[i]) ? number(value * unitOf(head[i])[1], 4) : row[i] || "–";
      })];
    }), { id: "runs" });
}

export function showCampaign(data: CampaignData, parent: HTMLElement): void {
  const { settings, n_cases, n_done, n_failed } = data.summary;
  const known = Object.keys(settings[0]?.statistics ?? {});
  const columns = [...kFirst.filter((name) => known.includes(name)), ...known.filter((name) => !kFirst.includes(name))];
  const shown = columns.slice(0, 6);
  const keys = variedKeys(settings);
  const numeric = keys.filter((key) => settings.every((s) => typeof s.values[key] === "number"));
  // Keys that change together are one input: the first stands for them.
  const axes = numeric.filter((key, i) => !numeric.slice(0, i).some((other) =>
    new Set(settings.map((s) => `${s.values[key]}|${s.values[other]}`)).size === new Set(settings.map((s) => s.values[other])).size));
  parent.append(
    el("div", { class: "figures" }, ...[[n_cases, "runs"], [n_done, "done"], [n_failed, "failed"], [settings.length, "settings"]].map(([n, name]) =>
      el("div", { class: "figure" }, el("b", {}, String(n)), el("span", {}, String(name))))),
  );
  const charts = axes.flatMap((key) => shown.slice(0, 4).map((column) => trend(data, column, key, axes.filter((other) => other !== key)).element));
  if (charts.length > 0)
    parent.append(section("trends", "Trends", el("p", {}, "Means over the replicates with Student's 95 % intervals."), el("div", { class: "charts wide" }, ...charts)));
  parent.append(
    section("settings", "Settings",
      table(["setting", "done", "failed", ...shown.map((name) => (unitOf(name)[0] ? `${name} [${unitOf(name)[0]}]` : name))], settings.map((s) => settingRow(s, shown)), { id: "settings-table" })),
    section("all-runs", "Every run", runsTable(data, shown)),
    section("inputs", "Manifest", manifestTables(data.manifest)),
  );
}
