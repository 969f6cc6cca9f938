// SPDX-License-Identifier: GPL-3.0-or-later
// A chart as a drawing: the lines of uPlot's canvas as paths that can be edited.
import type uPlot from "uplot";
import { svg } from "./dom";

/** What uPlot keeps of an axis that it has drawn. */
interface DrawnAxis {
  _splits?: number[] | null;
  _values?: (string | number | null)[] | null;
}

const kBorder = { left: 70, right: 20, top: 30, bottom: 50 };
const kSize = { width: 900, height: 420 };

export function chartSvg(plot: uPlot, title: string): SVGSVGElement {
  const { width, height } = kSize;
  const box = { x: kBorder.left, y: kBorder.top, w: width - kBorder.left - kBorder.right, h: height - kBorder.top - kBorder.bottom };
  const share = (value: number, scale: string) => {
    const position = plot.valToPos(value, scale);
    return scale === "x" ? box.x + (position / plot.over.clientWidth) * box.w : box.y + (position / plot.over.clientHeight) * box.h;
  };
  const lines = plot.series.flatMap((series, i) => (i > 0 && series.show ? [line(plot, i, share)] : []));
  const clip = svg("clipPath", { id: "frame" }, svg("rect", { x: box.x, y: box.y, width: box.w, height: box.h }));
  return svg("svg", { viewBox: `0 0 ${width} ${height}`, width, height, "font-family": "sans-serif", "font-size": 13, fill: "#222" },
    svg("title", {}, title), clip, svg("rect", { width, height, fill: "#fff" }),
    axes(plot, box, share), svg("g", { "clip-path": "url(#frame)" }, ...lines), names(plot, box));
}

type Place = (value: number, scale: string) => number;
interface Frame { x: number; y: number; w: number; h: number }

/** One series as a path; a missing value ends a stroke unless gaps are spanned. */
function line(plot: uPlot, index: number, place: Place): SVGPathElement {
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
    path += `${pen}${place(x[i], "x").toFixed(2)} ${place(value, series.scale ?? "y").toFixed(2)}`;
    pen = "L";
  }
  return svg("path", { d: path, fill: "none", stroke: colourOf(plot, index), "stroke-width": series.width || 1, "stroke-linejoin": "round" });
}

function colourOf(plot: uPlot, index: number): string {
  const { stroke } = plot.series[index];
  const colour = typeof stroke === "function" ? stroke(plot, index) : stroke;
  return typeof colour === "string" ? colour : "#222";
}

function axes(plot: uPlot, box: Frame, place: Place): SVGGElement {
  const group = svg("g", {});
  plot.axes.forEach((axis, i) => {
    const { _splits: splits, _values: texts } = axis as DrawnAxis;
    const across = i === 0;
    (splits ?? []).forEach((split, k) => {
      const at = place(split, axis.scale ?? (across ? "x" : "y"));
      group.append(svg("path", { d: across ? `M${at} ${box.y}v${box.h}` : `M${box.x} ${at}h${box.w}`, stroke: "#dde4e9" }));
      const text = String(texts?.[k] ?? "");
      group.append(across
        ? svg("text", { x: at, y: box.y + box.h + 18, "text-anchor": "middle" }, text)
        : svg("text", { x: box.x - 8, y: at + 4, "text-anchor": "end" }, text));
    });
    const label = String(axis.label ?? "");
    group.append(across
      ? svg("text", { x: box.x + box.w / 2, y: box.y + box.h + 40, "text-anchor": "middle" }, label)
      : svg("text", { transform: `translate(16 ${box.y + box.h / 2}) rotate(-90)`, "text-anchor": "middle" }, label));
  });
  return group;
}

function names(plot: uPlot, box: Frame): SVGGElement {
  const group = svg("g", {});
  let x = box.x;
  plot.series.forEach((series, i) => {
    if (i === 0 || !series.show) return;
    const name = String(series.label ?? "");
    group.append(svg("path", { d: `M${x} 16h18`, stroke: colourOf(plot, i), "stroke-width": 3 }), svg("text", { x: x + 24, y: 20 }, name));
    x += 44 + 7.5 * name.length;
  });
  return group;
}
