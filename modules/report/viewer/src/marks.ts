// SPDX-License-Identifier: GPL-3.0-or-later
// The marks of a chart besides its lines: means, intervals, single runs and cracks; on the page and in a saved drawing alike.
import type uPlot from "uplot";

/** In the chart's numbers; lengths in pixels. Marks of one name are explained once. */
export type Mark = { name: string; colour: string } & (
  | { kind: "band"; from: number; to?: number; low: number; high: number }  // to the right edge, if no `to`
  | { kind: "level"; from: number; to?: number; at: number; dash: number[] }
  | { kind: "tick"; x: number; edge: "top" | "bottom"; length: number }
  | { kind: "upright"; x: number }
  | { kind: "dot"; x: number; y: number; radius: number; opacity: number }
  | { kind: "bar"; x: number; low: number; high: number });

/** A path in pixels, in the notation of SVG. */
export interface Shape {
  name: string;
  path: string;
  colour: string;
  filled: boolean;
  opacity: number;
  dash: number[];
}

/** The frame of a chart, where its numbers lie in it, and pixels of the picture for each pixel of a length. */
export interface Plane {
  left: number;
  top: number;
  right: number;
  bottom: number;
  ratio: number;
  x: (value: number) => number;
  y: (value: number) => number;
}

/** Half the width of the ends of an interval's bar [px]. */
const kHalfBar = 4;

const at = (...numbers: number[]): string => numbers.map((n) => n.toFixed(2)).join(" ");

/** A circle about a place. */
export const circle = (x: number, y: number, r: number): string => `M${at(x - r, y)}a${at(r, r)} 0 1 0 ${at(2 * r, 0)}a${at(r, r)} 0 1 0 ${at(-2 * r, 0)}Z`;

function pathOf(mark: Mark, { left, right, top, bottom, ratio, x, y }: Plane): string {
  const end = ({ to }: { to?: number }): number => (to === undefined ? right : Math.min(right, x(to)));
  switch (mark.kind) {
    case "band": {
      const from = Math.max(left, x(mark.from));
      return `M${at(from, y(mark.low))}H${at(end(mark))}V${at(y(mark.high))}H${at(from)}Z`;
    }
    case "level": return `M${at(Math.max(left, x(mark.from)), y(mark.at))}H${at(end(mark))}`;
    case "tick": return mark.edge === "top" ? `M${at(x(mark.x), top)}v${at(mark.length * ratio)}` : `M${at(x(mark.x), bottom)}v${at(-mark.length * ratio)}`;
    case "upright": return `M${at(x(mark.x), top)}V${at(bottom)}`;
    case "dot": return circle(x(mark.x), y(mark.y), mark.radius * ratio);
    case "bar": {
      const half = kHalfBar * ratio;
      const end = (value: number) => `M${at(x(mark.x) - half, y(value))}h${at(2 * half)}`;
      return `${end(mark.low)}${end(mark.high)}M${at(x(mark.x), y(mark.low))}V${at(y(mark.high))}`;
    }
  }
}

/** The marks as paths, in their order; those without a place are left out. */
export function shapesOf(marks: Mark[], plane: Plane): Shape[] {
  return marks.flatMap((mark) => {
    const path = pathOf(mark, plane);
    if (/NaN|Infinity/.test(path)) return [];
    return [{
      name: mark.name, path, colour: mark.colour, filled: mark.kind === "band" || mark.kind === "dot",
      opacity: mark.kind === "dot" ? mark.opacity : 1, dash: mark.kind === "level" ? mark.dash.map((n) => n * plane.ratio) : [],
    }];
  });
}

/** Draws marks over a chart. @param ratio pixels of its canvas for each pixel of the page. */
export function paintMarks(plot: uPlot, marks: Mark[], ratio: number): void {
  const { ctx, bbox: { left, top, width, height } } = plot;
  const plane = { left, top, right: left + width, bottom: top + height, ratio, x: (n: number) => plot.valToPos(n, "x", true), y: (n: number) => plot.valToPos(n, "y", true) };
  ctx.save();
  ctx.beginPath();
  ctx.rect(left, top, width, height);
  ctx.clip();
  ctx.lineWidth = ratio;
  for (const { path, colour, filled, opacity, dash } of shapesOf(marks, plane)) {
    ctx.globalAlpha = opacity;
    ctx.setLineDash(dash);
    ctx.fillStyle = ctx.strokeStyle = colour;
    ctx[filled ? "fill" : "stroke"](new Path2D(path));
  }
  ctx.restore();
}
