// SPDX-License-Identifier: GPL-3.0-or-later
// A chart as a drawing that can be edited: the picture of uPlot's canvas as paths, and the names and words beside it.
import type uPlot from "uplot";
import { css, svg } from "./dom";
import { circle, type Mark, type Plane, shapesOf } from "./marks";

/** What uPlot keeps of an axis that it has drawn. */
interface DrawnAxis {
  _splits?: number[] | null;
  _values?: (string | number | null)[] | null;
}

/** uPlot's own form of the points of a series. */
interface DrawnPoints {
  show: (plot: uPlot, series: number, first: number, last: number) => boolean;
  filter: (plot: uPlot, series: number, show: boolean) => number[] | null;
  size: number;
}

export interface Drawn {
  plot: uPlot;
  title: string;
  /** The words below the chart. */
  caption: string;
  marks: Mark[];
  /** Width of columns over their distance, for a chart of columns. */
  columns?: number;
}

const kBorder = { left: 70, right: 20 };
const [kWidth, kHeight] = [900, 340];  // of the drawing, and of the lines in it
const kLetters = 13;
const kRow = 19;
const kFoot = 50;  // numbers and name of the axis

/** Width of a text in the drawing's letters. */
function widthOf(text: string): number {
  const context = document.createElement("canvas").getContext("2d")!;
  context.font = `${kLetters}px sans-serif`;
  return context.measureText(text).width;
}

export function chartSvg({ plot, title, caption, marks, columns }: Drawn): SVGSVGElement {
  const shown = plot.series.flatMap((series, i) => (i > 0 && series.show ? [i] : []));
  const hasNames = plot.root.querySelector(".u-legend") !== null;
  const { group: names, height: head } = namesOf([...(hasNames ? shown.map((i) => ofSeries(plot, i)) : []), ...ofMarks(marks)]);
  const words = lines(`${title}. ${caption}`);
  const plane = planeOf(plot, head + 10);
  const height = plane.bottom + kFoot + kRow * words.length;
  const frame = { x: plane.left, y: plane.top, width: plane.right - plane.left, height: plane.bottom - plane.top };
  return svg("svg", { viewBox: `0 0 ${kWidth} ${height}`, width: kWidth, height, "font-family": "sans-serif", "font-size": kLetters, fill: css("--ink") },
    svg("title", {}, title), svg("clipPath", { id: "frame" }, svg("rect", frame)), svg("rect", { width: kWidth, height, fill: css("--card") }),
    axes(plot, plane),
    svg("g", { "clip-path": "url(#frame)" }, ...shown.map((i) => seriesOf(plot, i, plane, columns)), ...markGroups(marks, plane)),
    names, ...words.map((text, i) => svg("text", { x: kBorder.left, y: plane.bottom + kFoot + kRow * i + 10 }, text)));
}

function planeOf(plot: uPlot, top: number): Plane {
  const [left, right, bottom] = [kBorder.left, kWidth - kBorder.right, top + kHeight];
  return {
    left, right, top, bottom, ratio: 1,
    x: (value) => left + (plot.valToPos(value, "x") / plot.over.clientWidth) * (right - left),
    y: (value) => top + (plot.valToPos(value, "y") / plot.over.clientHeight) * (bottom - top),
  };
}

/** A text in lines that the drawing holds. */
function lines(text: string): string[] {
  const out: string[] = [""];
  for (const word of text.trim().split(" ")) {
    const longer = `${out.at(-1)} ${word}`.trim();
    if (widthOf(longer) > kWidth - kBorder.left - kBorder.right && out.at(-1) !== "") out.push(word);
    else out[out.length - 1] = longer;
  }
  return out;
}

const seriesOf = (plot: uPlot, index: number, plane: Plane, columns?: number): SVGGElement =>
  svg("g", {}, svg("title", {}, String(plot.series[index].label ?? "")),
    columns === undefined ? line(plot, index, plane) : columnsOf(plot, index, plane, columns), points(plot, index, plane));

/** One series as a path; a missing value ends a stroke unless gaps are spanned. */
function line(plot: uPlot, index: number, plane: Plane): SVGPathElement {
  const series = plot.series[index];
  const [x, y] = [plot.data[0], plot.data[index]];
  let path = "";
  let pen = "M";
  for (let i = 0; i < x.length; ++i) {
    const value = y[i];
    if (value === null || value === undefined || !Number.isFinite(value)) {
      if (value === null && !series.spanGaps) pen = "M";
      continue;
    }
    path += `${pen}${plane.x(x[i]).toFixed(2)} ${plane.y(value).toFixed(2)}`;
    pen = "L";
  }
  return svg("path", { d: path, fill: "none", stroke: colourOf(plot, index), "stroke-width": series.width || 1, "stroke-linejoin": "round" });
}

function columnsOf(plot: uPlot, index: number, plane: Plane, share: number): SVGPathElement {
  const x = plot.data[0];
  const half = 0.5 * share * (plane.x(x[1]) - plane.x(x[0]));
  const path = Array.from(plot.data[index], (value, i) =>
    `M${(plane.x(x[i]) - half).toFixed(2)} ${plane.y(0).toFixed(2)}V${plane.y(value ?? 0).toFixed(2)}h${(2 * half).toFixed(2)}V${plane.y(0).toFixed(2)}Z`).join("");
  return svg("path", { d: path, ...filled(css("--bars")), stroke: colourOf(plot, index) });
}

/** The points of a series, where the chart has any. */
function points(plot: uPlot, index: number, plane: Plane): SVGPathElement | false {
  const { show, filter, size } = plot.series[index].points as unknown as DrawnPoints;
  const [first, last] = (plot.series[0] as { idxs?: [number, number] }).idxs ?? [0, plot.data[0].length - 1];
  const all = show(plot, index, first, last);
  const some = filter(plot, index, all) ?? (all ? Array.from({ length: last - first + 1 }, (_, i) => first + i) : []);
  const path = some.map((i) => {
    const value = plot.data[index][i];
    return value === null || value === undefined ? "" : circle(plane.x(plot.data[0][i]), plane.y(value), 0.5 * size);
  }).join("");
  return path !== "" && svg("path", { d: path, fill: colourOf(plot, index) });
}

function colourOf(plot: uPlot, index: number): string {
  const { stroke } = plot.series[index];
  const colour = typeof stroke === "function" ? stroke(plot, index) : stroke;
  return typeof colour === "string" ? colour : css("--ink");
}

/** A colour that lets through as an attribute of its own, which every program for drawings reads. */
function filled(colour: string): Record<string, string> {
  const parts = /^rgba\(([^,]*,[^,]*,[^,]*),([^)]*)\)$/.exec(colour);
  return parts ? { fill: `rgb(${parts[1]})`, "fill-opacity": parts[2].trim() } : { fill: colour };
}

/** The marks of each name together, under their name. */
function markGroups(marks: Mark[], plane: Plane): SVGGElement[] {
  const groups = new Map<string, SVGGElement>();
  for (const { name, path, colour, filled: area, opacity, dash } of shapesOf(marks, plane)) {
    const group = groups.get(name) ?? svg("g", {}, svg("title", {}, name));
    groups.set(name, group);
    group.append(svg("path", { d: path, ...(area ? filled(colour) : { fill: "none", stroke: colour }), ...(opacity < 1 && { "fill-opacity": opacity }),
      ...(dash.length > 0 && { "stroke-dasharray": dash.join(" ") }) }));
  }
  return [...groups.values()];
}

function axes(plot: uPlot, { left, right, top, bottom, x, y }: Plane): SVGGElement {
  const group = svg("g", {});
  const [middle, centre] = [0.5 * (left + right), 0.5 * (top + bottom)];
  plot.axes.forEach((axis, i) => {
    const { _splits: splits, _values: texts } = axis as DrawnAxis;
    const across = i === 0;
    (splits ?? []).forEach((split, k) => {
      const place = across ? x(split) : y(split);
      group.append(svg("path", { d: across ? `M${place} ${top}V${bottom}` : `M${left} ${place}H${right}`, stroke: css("--rule") }));
      const text = String(texts?.[k] ?? "");
      group.append(across
        ? svg("text", { x: place, y: bottom + 18, "text-anchor": "middle" }, text)
        : svg("text", { x: left - 8, y: place + 4, "text-anchor": "end" }, text));
    });
    const label = String(axis.label ?? "");
    group.append(across
      ? svg("text", { x: middle, y: bottom + 38, "text-anchor": "middle" }, label)
      : svg("text", { transform: `translate(16 ${centre}) rotate(-90)`, "text-anchor": "middle" }, label));
  });
  return group;
}

/** A name with a sample of its colour, 18 wide. */
interface Named {
  name: string;
  sample: SVGElement;
}

const ofSeries = (plot: uPlot, i: number): Named =>
  ({ name: String(plot.series[i].label ?? ""), sample: svg("path", { d: "M0 0h18", stroke: colourOf(plot, i), "stroke-width": 3 }) });

/** Samples of the marks that have a name, each name once. */
function ofMarks(marks: Mark[]): Named[] {
  const firsts = new Map<string, Mark>();
  for (const mark of marks) if (!firsts.has(mark.name)) firsts.set(mark.name, mark);
  const sampleOf = (mark: Mark): Mark => {
    switch (mark.kind) {
      case "band": return { ...mark, from: 0, to: undefined, low: -6, high: 6 };
      case "level": return { ...mark, from: 0, to: undefined, at: 0 };
      case "dot": return { ...mark, x: 9, y: 0 };
      case "bar": return { ...mark, x: 9, low: -6, high: 6 };
      default: return { ...mark, x: 9 };
    }
  };
  const plane: Plane = { left: 0, right: 18, top: -6, bottom: 4, ratio: 1, x: (n) => n, y: (n) => n };
  return [...firsts].map(([name, mark]) => ({ name, sample: markGroups([sampleOf(mark)], plane)[0] }));
}

/** Names in rows, from the top. */
function namesOf(all: Named[]): { group: SVGGElement; height: number } {
  const group = svg("g", {});
  let [x, y] = [kBorder.left, 16];
  for (const { name, sample } of all) {
    const width = 24 + widthOf(name);
    if (x > kBorder.left && x + width > kWidth - kBorder.right) [x, y] = [kBorder.left, y + kRow];
    sample.setAttribute("transform", `translate(${x.toFixed(1)} ${y})`);
    group.append(sample, svg("text", { x: (x + 24).toFixed(1), y: y + 4 }, name));
    x += width + 20;
  }
  return { group, height: all.length > 0 ? y + 10 : 0 };
}
