// SPDX-License-Identifier: GPL-3.0-or-later
// Ice that splits besides the level ice that breaks: drifting sheets in their plane, and floes that bend too far.
import type { Run } from "./data";
import { el, section, svg, table } from "./dom";
import { loadText, loadUnit, number, seconds } from "./format";

/** A `split` or a `broken` of events.csv. */
export interface Split {
  of: "sheet" | "floe";
  time: number;
  x: number;
  y: number;
  /** Unit vector along the crack, and its length at most [m]; of a sheet. */
  towards: [number, number] | null;
  length: number;
  parts: number;
  /** What else is known of it. */
  more: string;
}

/** Value of `floe.end`. */
const kBroken = 2;

function sheetSplits(run: Run): Split[] {
  const at = (name: string, i: number) => run.column(`split.${name}`)[i];
  return Array.from(run.column("split.time"), (time, i): Split => ({
    of: "sheet", time, x: at("x", i), y: at("y", i), towards: [at("towards_x", i), at("towards_y", i)], length: at("length", i), parts: at("pieces", i),
    more: `${loadText(at("opening", i))} ${loadUnit()} across the crack, ${loadText(at("push", i))} ${loadUnit()} along it, K_I of ${number(at("stress_intensity", i) / 1e3, 4)} kPa √m`,
  }));
}

/** A floe that broke lies about where its parts began. */
function floeSplits(run: Run): Split[] {
  const parts = new Map<number, number[]>();
  run.column("floe.parent").forEach((parent, floe) => {
    if (parent >= 0) parts.set(parent, [...(parts.get(parent) ?? []), floe]);
  });
  return [...parts].filter(([floe]) => run.column("floe.end")[floe] === kBroken).map(([floe, made]): Split => {
    const mean = (name: string) => made.reduce((sum, part) => sum + run.column(`floe.birth_${name}`)[part], 0) / made.length;
    return {
      of: "floe", time: run.column("floe.death")[floe], x: mean("x"), y: mean("y"), towards: null, length: 0, parts: made.length,
      more: `floe ${run.column("floe.id")[floe]}, ${number(run.column("floe.area")[floe], 3)} m²`,
    };
  });
}

/** All splits in the order of their times. */
export const splitsOf = (run: Run): Split[] => [...sheetSplits(run), ...floeSplits(run)].sort((a, b) => a.time - b.time);

const nameOf = ({ of, time, more }: Split): string => `${of === "sheet" ? "sheet split" : "floe broke again"} at ${seconds(time)} s: ${more}`;

/** Marks in a plan [m]: a line of the length that a sheet's crack can have at most, a point for a floe. */
export function splitMarks(splits: Split[], radius: number, onChoose: (split: number) => void): SVGGElement {
  return svg("g", { class: "splits" }, ...splits.map((split, i) => {
    const { x, y, towards, length } = split;
    const mark = svg("g", { class: `of-${split.of}`, click: () => onChoose(i) }, svg("title", {}, nameOf(split)));
    if (towards) mark.append(svg("path", { d: `M${x} ${-y}l${length * towards[0]} ${-length * towards[1]}` }));
    mark.append(svg("circle", { cx: x, cy: -y, r: towards ? radius : 0.6 * radius }));
    return mark;
  }));
}

/** The list of all splits; a time in it shows that moment. Null without any. */
export function splitsSection(splits: Split[], onChoose: (split: number) => void): HTMLElement | null {
  if (splits.length === 0) return null;
  const rows = (of: Split["of"]) => splits.flatMap((split, i) => (split.of !== of ? [] : [[
    el("button", { type: "button", class: "link", title: "Show this moment", click: () => onChoose(i) }, seconds(split.time)),
    number(split.x, 4), number(split.y, 4), String(split.parts), split.more,
  ]]));
  const list = (title: string, of: Split["of"]) => {
    const found = rows(of);
    return found.length > 0 && el("details", { open: found.length <= kOpen }, el("summary", {}, `${found.length} ${title}`),
      table(["time [s]", "x [m]", "y [m]", "parts", of === "sheet" ? "forces, stress intensity" : "floe"], found, { id: `splits-of-${of}s` }));
  };
  return section("splits", "Splits", list("splits of drifting sheets in their plane", "sheet"), list("floes that broke again, bent too far by their contacts", "floe"));
}

/** A longer list is folded at first. */
const kOpen = 12;
