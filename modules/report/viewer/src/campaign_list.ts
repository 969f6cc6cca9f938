// SPDX-License-Identifier: GPL-3.0-or-later
// One result of settings that only their names distinguish: a row for each, with its mean, interval and runs.
import { decimalsOf, meanText, resultOf, titleOf } from "./campaign_names";
import type { Runs } from "./campaign_trends";
import { el, svg } from "./dom";
import { number } from "./format";
import { csv, pngOf, save, saveButtons, saveText, svgText } from "./save";
import type { CampaignData, CampaignSetting } from "./types";

/** A chart of more rows is a wall; their table has them all. */
export const kMostRows = 60;
const kRow = 22;     // px
const kFoot = 40;    // px
const kLetter = 6.7; // px, about

interface Frame {
  x0: number;
  x1: number;
  bottom: number;
  place: (value: number) => number;
}

/** About `n` round numbers over a range. */
export function roundNumbers([low, high]: [number, number], n: number): number[] {
  const rough = (high - low) / Math.max(1, n);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 5].find((factor) => factor * power >= rough) ?? 10);
  const first = Math.ceil(low / step - 1e-9);
  return Array.from({ length: Math.floor(high / step + 1e-9) - first + 1 }, (_, i) => (first + i) * step);
}

/** All that is drawn of a result, with a border; from 0 if that is not far. A place needs no zero, unlike a length. */
function rangeOf(settings: CampaignSetting[], runs: Runs, column: string): [number, number] {
  const { scale } = resultOf(column);
  const all = settings.flatMap((s) => {
    const of = s.statistics[column];
    return [of?.mean ?? NaN, ...(of?.mean_95 ?? []), ...runs(s.setting, column)];
  }).filter(Number.isFinite).map((n) => n * scale);
  const [low, high] = [Math.min(...all), Math.max(...all)];
  const border = 0.05 * (high - low) || 0.1 * Math.abs(high) || 1;
  return [low >= 0 && low < 0.35 * high ? 0 : low - border, high + border];
}

/** A figure that fills its place's width. @param nameOf a setting as its row has it. */
export function listChart(data: CampaignData, runs: Runs, column: string, nameOf: (setting: CampaignSetting) => string): HTMLElement {
  const result = resultOf(column);
  const { settings } = data.summary;
  const label = `${titleOf(result)} of each setting`;
  const holder = el("div", { class: "plot" });
  let drawing = draw(900);
  function draw(width: number): SVGSVGElement {
    return chart({ settings, runs, column, nameOf, label, width, range: rangeOf(settings, runs, column) });
  }
  new ResizeObserver(() => {
    const width = holder.clientWidth;
    if (width === 0 || width === drawing.viewBox.baseVal.width) return;
    drawing = draw(width);
    holder.replaceChildren(drawing);
  }).observe(holder);
  holder.append(drawing);
  const file = label.toLowerCase().replace(/[^a-z0-9]+/g, "-");
  return el("figure", { class: "chart" }, el("h3", {}, titleOf(result)), holder, saveButtons(label, {
    SVG: () => saveText(`${file}.svg`, svgText(drawing), "image/svg+xml"),
    PNG: async () => save(`${file}.png`, await pngOf(svgText(drawing))),
    CSV: () => saveText(`${file}.csv`, table(settings, column, nameOf), "text/csv"),
  }));
}

/** Names, means and intervals in the unit of the chart. */
function table(settings: CampaignSetting[], column: string, nameOf: (setting: CampaignSetting) => string): string {
  const result = resultOf(column);
  const of = (value: (s: CampaignSetting) => number | null | undefined) => settings.map((s) => {
    const number = value(s);
    return typeof number === "number" ? number * result.scale : null;
  });
  return csv([
    ["setting", settings.map(nameOf)], [titleOf(result), of((s) => s.statistics[column]?.mean)], ["low_95", of((s) => s.statistics[column]?.mean_95?.[0])],
    ["high_95", of((s) => s.statistics[column]?.mean_95?.[1])], ["n", settings.map((s) => s.statistics[column]?.n)],
  ]);
}

interface Chart {
  settings: CampaignSetting[];
  runs: Runs;
  column: string;
  nameOf: (setting: CampaignSetting) => string;
  label: string;
  width: number;
  range: [number, number];
}

function chart(of: Chart): SVGSVGElement {
  const { settings, width, range, column, nameOf } = of;
  const result = resultOf(column);
  const letters = Math.max(...settings.map((s) => nameOf(s).length));
  const x0 = Math.min(kLetter * letters + 14, 0.45 * width);
  const x1 = width - 14;
  const bottom = kRow * settings.length + 4;
  const frame = { x0, x1, bottom, place: (value: number) => x0 + ((value - range[0]) / (range[1] - range[0])) * (x1 - x0) };
  const first = settings[0].statistics[column]?.mean;
  return svg("svg", { class: "list-chart", viewBox: `0 0 ${width} ${bottom + kFoot}`, width, height: bottom + kFoot, role: "img", "aria-label": of.label },
    svg("rect", { class: "paper", width, height: bottom + kFoot }),
    scaleOf(frame, range, titleOf(result)),
    typeof first === "number" && svg("path", { class: "first", d: upright(frame.place(first * result.scale), 0, bottom) }),
    ...settings.map((s, i) => row(of, s, (i + 0.5) * kRow, frame)));
}

const upright = (x: number, from: number, to: number): string => `M${x.toFixed(2)} ${from}V${to}`;

function scaleOf({ x0, x1, bottom, place }: Frame, range: [number, number], title: string): SVGGElement {
  // A scale of one number says nothing of lengths.
  const wanted = Math.max(2, Math.floor((x1 - x0) / 60));
  const numbers = [0, 1, 2, 3].map((more) => roundNumbers(range, wanted + more)).find(({ length }) => length > 1) ?? [];
  return svg("g", { class: "scale-lines" },
    ...numbers.flatMap((n) => [
      svg("path", { d: upright(place(n), 0, bottom) }),
      svg("text", { x: place(n), y: bottom + 14, "text-anchor": "middle" }, number(n, 4).replace(/(\.\d*?)0+$/, "$1").replace(/\.$/, "")),
    ]),
    svg("text", { x: x1, y: bottom + 32, "text-anchor": "end" }, title));
}

function row({ runs, column, nameOf }: Chart, setting: CampaignSetting, y: number, { x0, place }: Frame): SVGGElement {
  const { scale } = resultOf(column);
  const of = setting.statistics[column];
  const at = (value: number) => place(value * scale);
  const name = nameOf(setting);
  const most = Math.max(4, Math.floor((x0 - 14) / kLetter + 0.5));
  const bar = ([low, high]: [number, number]) =>
    svg("path", { class: "interval", d: `M${at(low)} ${y}H${at(high)}${upright(at(low), y - 5, y + 5)}${upright(at(high), y - 5, y + 5)}` });
  return svg("g", { class: "setting" },
    svg("title", {}, `${name}: ${meanText(of, scale, decimalsOf([of], scale))}, ${of?.n ?? 0} runs`),
    svg("text", { x: x0 - 9, y: y + 4, "text-anchor": "end" }, name.length > most ? `${name.slice(0, most - 1)}…` : name),
    ...runs(setting.setting, column).map((value) => svg("circle", { class: "single", cx: at(value), cy: y, r: 2.6 })),
    of?.mean_95 && bar(of.mean_95),
    typeof of?.mean === "number" && svg("circle", { class: "mean", cx: at(of.mean), cy: y, r: 4 }));
}
