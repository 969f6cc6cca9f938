// SPDX-License-Identifier: GPL-3.0-or-later
// The channel from above with every crack, and one crack event close by.
import { type Crack, crackOf, type Segment } from "./crack";
import type { Ring, Run } from "./data";
import { el, svg } from "./dom";
import { kLand, legend, type Swatch } from "./legend";
import { onRefit } from "./paper";
import { drawingButtons } from "./save";
import { splitMarks, splitsOf } from "./splits";

interface Box {
  x0: number;
  y0: number;
  x1: number;
  y1: number;
}

const path = (rings: Ring[]): string =>
  rings.map((ring) => `M${ring.map(([x, y]) => `${x.toFixed(3)} ${(-y).toFixed(3)}`).join("L")}Z`).join("");

function around(points: Iterable<[number, number]>, border: number): Box {
  const box = { x0: Infinity, y0: Infinity, x1: -Infinity, y1: -Infinity };
  for (const [x, y] of points) {
    box.x0 = Math.min(box.x0, x - border);
    box.x1 = Math.max(box.x1, x + border);
    box.y0 = Math.min(box.y0, y - border);
    box.y1 = Math.max(box.y1, y + border);
  }
  return box;
}

/** y grows downwards on the page. */
function drawing(box: Box, label: string, ...children: (Node | false)[]): SVGSVGElement {
  const [width, height] = [box.x1 - box.x0, box.y1 - box.y0];
  return svg(
    "svg",
    { viewBox: `${box.x0} ${-box.y1} ${width} ${height}`, style: `--ratio: ${(width / height).toFixed(4)}`, role: "img", "aria-label": label, class: "plan" },
    svg("rect", { class: "open", x: box.x0, y: -box.y1, width, height }),
    ...children,
  );
}

/** Lines every so many metres along the frame, with numbers; about eight along x.
 * @param lettering width of the drawing over the height of its letters. */
function ruler(box: Box, lettering: number): SVGGElement {
  const step = [0.2, 0.5, 1, 2, 5, 10, 20, 50, 100].find((s) => (box.x1 - box.x0) / s <= 9) ?? 200;
  const size = (box.x1 - box.x0) / lettering;
  const group = svg("g", { class: "ruler", "font-size": size });
  const text = (x: number, y: number, n: number, anchor: string) =>
    svg("text", { x, y, "text-anchor": anchor }, String(Number(n.toFixed(1))).replace("-", "−"));
  for (let x = Math.ceil(box.x0 / step) * step; x <= box.x1; x += step) {
    group.append(svg("path", { d: `M${x} ${-box.y0}v${-0.6 * size}` }));
    if (x > box.x0 + size && x < box.x1 - 3.8 * size) group.append(text(x, -box.y0 - 0.8 * size, x, "middle"));
  }
  for (let y = Math.ceil(box.y0 / step) * step; y <= box.y1; y += step) {
    group.append(svg("path", { d: `M${box.x0} ${-y}h${0.6 * size}` }));
    if (y > box.y0 + 2 * size && y < box.y1 - 2.2 * size) group.append(text(box.x0 + 0.9 * size, -y + 0.35 * size, y, "start"));
  }
  group.append(svg("text", { x: box.x1 - 0.5 * size, y: -box.y0 - 0.8 * size, "text-anchor": "end" }, "x [m]"));
  group.append(svg("text", { x: box.x0 + 0.9 * size, y: -box.y1 + 1.2 * size, "text-anchor": "start" }, "y [m]"));
  return group;
}

/** Land that may lie in a drawing, which cuts it off at its border. */
function landIn(box: Box, run: Run): SVGGElement | false {
  const near = run.land.filter((rings) => {
    const of = around(rings[0], 0);
    return of.x0 < box.x1 && of.x1 > box.x0 && of.y0 < box.y1 && of.y1 > box.y0;
  });
  return near.length > 0 && svg("g", { class: "land" }, ...near.map((rings) => svg("path", { d: path(rings), "fill-rule": "evenodd" })));
}

/** Letters of a drawing [px], and the radius of a point that is clicked. */
const kLetters = 11;
const kPoint = 4;
const kFloePoint = 0.75;  // of that, for a floe that broke again

/** Calls back with the width [px] at which a drawing is shown, whenever that changes. */
function onWidth(picture: SVGSVGElement, change: (width: number) => void): void {
  let last = 0;
  const measure = () => {
    const { width } = picture.getBoundingClientRect();
    if (width === 0 || Math.abs(width - last) < 1) return;
    last = width;
    change(width);
  };
  new ResizeObserver(measure).observe(picture);
  onRefit(picture, measure);
}

/** Gives a drawing a ruler whose letters have one size, however wide the drawing is shown. */
function addRuler(picture: SVGSVGElement, box: Box, lettering: number): void {
  let shown = ruler(box, lettering);
  picture.append(shown);
  onWidth(picture, (width) => {
    const next = ruler(box, width / kLetters);
    shown.replaceWith(next);
    shown = next;
  });
}

/** The fitted trapezoid of an event: from the tip edge's ends to the base line. */
function trapezoidOf(run: Run, event: number): Ring {
  const at = (name: string) => run.column(`event.${name}`)[event];
  const [ux, uy] = [at("towards_x"), at("towards_y")];
  const tip = 0.5 * at("c");
  const base = tip + at("b") * Math.tan(0.5 * at("theta"));
  const place = (along: number, across: number): [number, number] => [
    at("tip_x") + along * ux - across * uy,
    at("tip_y") + along * uy + across * ux,
  ];
  return [place(0, -tip), place(at("b"), -base), place(at("b"), base), place(0, tip)];
}

/** More floes of the start than this are one drawing: each alone would make a page slow. */
const kMostApart = 1500;

const kAtCrack: Swatch = { colour: "--red", text: "the ice failed here", kind: "dot" };
const kTrapezoid: Swatch = { colour: "--ochre", text: "trapezoid fitted to the edge" };
const kCrackLine: Swatch = { colour: "--red", text: "crack", kind: "line" };
const kSheetSplit: Swatch = { colour: "--violet", text: "a drifting sheet split here, along the line", kind: "dot" };
const kFloeSplit: Swatch = { colour: "--teal", text: "a floe broke again", kind: "dot" };
const kCircle: Swatch = { colour: "--red", text: "breaking length", kind: "dashes" };

export class PlanView {
  readonly element: HTMLElement;
  private readonly drawing: SVGSVGElement;
  private readonly box: Box;
  private readonly sheet: SVGPathElement;
  private readonly structure: SVGPathElement;
  private readonly overlay = svg("g");
  private readonly chosen = el("span", { class: "chosen-crack" });
  private readonly points: SVGCircleElement[] = [];
  private readonly splits: SVGGElement;

  constructor(
    private readonly run: Run,
    private readonly onChoose: (event: number) => void,
    onSplit: (split: number) => void,
    private readonly moment = "at the end",
  ) {
    const structure = run.waterlineAtEnd();
    const splits = splitsOf(run);
    const places = splits.map(({ x, y }): Ring => [[x, y]]);
    const box = this.box = around([...run.offSheet.flatMap((floe) => run.bornAt(floe)), ...structure, ...places].flat(), 2.5);
    const point = (box.x1 - box.x0) / 210;
    const land = landIn(box, run);
    this.splits = splitMarks(splits, point, onSplit);
    this.drawing = drawing(
      box,
      "Plan of the channel with all cracks",
      land,
      this.sheet = svg("path", { class: "sheet", d: path(run.sheets.at(-1)!), "fill-rule": "evenodd" }),
      this.floes(),
      this.structure = svg("path", { class: "structure", d: path(structure) }),
      this.overlay,
      this.splits,
      this.breaks(point),
    );
    addRuler(this.drawing, box, 62);
    onWidth(this.drawing, (width) => this.sizePoints((kPoint * (box.x1 - box.x0)) / width));
    // A picture has no buttons for its reader; this one is a group of buttons.
    this.drawing.setAttribute("role", "group");
    this.element = el("figure", { class: "plan-view" }, this.drawing,
      el("div", { class: "under" },
        legend([
          ...(land ? [kLand] : []), ...this.swatches(),
          ...(splits.some(({ of }) => of === "sheet") ? [kSheetSplit] : []), ...(splits.some(({ of }) => of === "floe") ? [kFloeSplit] : []),
        ]),
        drawingButtons("the plan", "channel", () => this.drawing)),
      this.chosen);
  }

  /** Follows a run that has grown by no floe, crack or split; false where the structure leaves the drawing. */
  follow(): boolean {
    const structure = this.run.waterlineAtEnd();
    const { x0, x1, y0, y1 } = this.box;
    if (structure.flat().some(([x, y]) => x < x0 || x > x1 || y < y0 || y > y1)) return false;
    this.structure.setAttribute("d", path(structure));
    this.sheet.setAttribute("d", path(this.run.sheets.at(-1)!));
    return true;
  }

  select(event: number): void {
    this.points.forEach((point, i) => point.classList.toggle("chosen", i === event));
    if (event < 0) return;
    const crack = crackOf(this.run, event);
    this.overlay.replaceChildren(...eventMarks(this.run, event, crack));
    this.chosen.replaceChildren(`Crack ${event + 1}: `, legend(marksOf(crack)));
  }

  /** Marks a split; -1: none. */
  selectSplit(split: number): void {
    [...this.splits.children].forEach((mark, i) => mark.classList.toggle("chosen", i === split));
  }

  /** What is there of the floes, the sheet and the structure. */
  private swatches(): Swatch[] {
    const { run } = this;
    const brokeOff: Swatch = { colour: ["--plan-young", "--plan-old"], text: "floe where it broke off: first to last of the run" };
    const ofStart: Swatch = { colour: "--plan-young", text: "floe where it was at the start" };
    return [
      ...(run.offSheet.some((floe) => run.wasThere(floe)) ? [ofStart] : []),
      ...(run.offSheet.some((floe) => !run.wasThere(floe)) ? [brokeOff] : []),
      ...(run.sheets.at(-1)!.length > 0 ? [{ colour: "--plan-sheet", text: `sheet ${this.moment}` }] : []),
      { colour: "--plan-open", text: "open water, or crushed" },
      { colour: "--scene-structure", text: `structure's waterline ${this.moment}` }, ...(run.nEvents > 0 ? [kAtCrack] : []),
    ];
  }

  private sizePoints(radius: number): void {
    for (const point of this.points) point.setAttribute("r", String(radius));
    for (const mark of this.splits.children) mark.querySelector("circle")!.setAttribute("r", String(mark.classList.contains("of-floe") ? kFloePoint * radius : radius));
  }

  private floes(): SVGGElement {
    const { run } = this;
    const latest = Math.max(1e-9, run.duration);
    const initial = run.offSheet.filter((i) => run.wasThere(i));
    const together = initial.length > kMostApart ? new Set(initial) : new Set<number>();
    const field = together.size > 0 && svg("path", { d: initial.map((i) => path(run.bornAt(i))).join(""), "fill-rule": "evenodd", style: "--age: 0" },
      svg("title", {}, `${together.size} floes that were there at the start`));
    return svg("g", { class: "floes" }, field, ...run.offSheet.filter((i) => !together.has(i)).map((i) => {
      const [id, area, birth] = ["id", "area", "birth"].map((name) => run.column(`floe.${name}`)[i]);
      return svg("path", { d: path(run.bornAt(i)), "fill-rule": "evenodd", style: `--age: ${(birth / latest).toFixed(3)}` },
        svg("title", {}, `floe ${id}, ${area.toFixed(2)} m², ${run.wasThere(i) ? "there at the start" : `born at ${birth.toFixed(2)} s`}`));
    }));
  }

  private breaks(radius: number): SVGGElement {
    const marks = svg("g", { class: "breaks" });
    for (let i = 0; i < this.run.nEvents; ++i) {
      const at = (name: string) => this.run.column(`event.${name}`)[i];
      const choose = () => this.onChoose(i);
      const point = svg("circle", {
        cx: at("x"), cy: -at("y"), r: radius, tabindex: 0, role: "button",
        "aria-label": `Crack ${i + 1} at ${at("time").toFixed(2)} s`,
        click: choose,
        keydown: (event: KeyboardEvent) => {
          if (event.key !== "Enter" && event.key !== " ") return;
          event.preventDefault();
          event.stopPropagation();
          choose();
        },
      });
      this.points.push(point);
      marks.append(point);
    }
    return marks;
  }
}

const strokes = (segments: Segment[]): string =>
  segments.map(([[a, b], [c, d]]) => `M${a.toFixed(3)} ${(-b).toFixed(3)}L${c.toFixed(3)} ${(-d).toFixed(3)}`).join("");

/** The crack as it went, and what describes it: the trapezoid, and the circle only where the crack follows it. */
function eventMarks(run: Run, event: number, crack: Crack): SVGElement[] {
  const at = (name: string) => run.column(`event.${name}`)[event];
  return [
    ...(crack.hasTrapezoid ? [svg("path", { class: "trapezoid", d: path([trapezoidOf(run, event)]) })] : []),
    ...(crack.isCircle ? [svg("circle", { class: "reach", cx: at("tip_x"), cy: -at("tip_y"), r: at("l_break") })] : []),
    svg("path", { class: "crack", d: strokes([...crack.circumferential, ...crack.radial]) }),
    svg("circle", { class: "at", cx: at("x"), cy: -at("y"), r: 0.03 * at("l_break") }),
  ];
}

const marksOf = (crack: Crack): Swatch[] =>
  [kCrackLine, ...(crack.isCircle ? [kCircle] : []), ...(crack.hasTrapezoid ? [kTrapezoid] : []), kAtCrack];

/** One crack event: the edge as it was, the pieces it made, its crack, and the trapezoid. */
export function eventFigure(run: Run, event: number, crack: Crack): HTMLElement {
  const at = (name: string) => run.column(`event.${name}`)[event];
  const nodes = crack.circumferential.flat();
  const reach = 1.35 * Math.max(at("l_break"), 1e-3, ...nodes.map(([x, y]) => Math.hypot(x - at("x"), y - at("y"))));
  const box = around([[at("x"), at("y")]], reach);
  box.y0 = at("y") - 0.8 * reach;
  box.y1 = at("y") + 0.8 * reach;
  const pieces = svg("g", { class: "pieces" });
  for (const floe of run.piecesOf[event])
    pieces.append(svg("path", { d: path(run.bornAt(floe)), "fill-rule": "evenodd" }));
  const picture = drawing(
    box,
    `Crack ${event + 1} from above`,
    landIn(box, run),
    svg("path", { class: "sheet", d: path(run.sheetOf(event, false)), "fill-rule": "evenodd" }),
    pieces,
    ...eventMarks(run, event, crack),
  );
  addRuler(picture, box, 24);
  return el("figure", {}, picture, legend(marksOf(crack)), drawingButtons("the crack", `crack-${event + 1}`, () => picture));
}
