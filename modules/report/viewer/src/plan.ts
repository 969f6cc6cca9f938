// SPDX-License-Identifier: GPL-3.0-or-later
// The channel from above with every crack, and one crack event close by.
import type { Ring, Run } from "./data";
import { svg } from "./dom";

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
    if (y > box.y0 + 2 * size && y < box.y1 - size) group.append(text(box.x0 + 0.9 * size, -y + 0.35 * size, y, "start"));
  }
  group.append(svg("text", { x: box.x1 - 0.5 * size, y: -box.y0 - 0.8 * size, "text-anchor": "end" }, "x [m]"));
  group.append(svg("text", { x: box.x0 + 0.9 * size, y: -box.y1 + 1.2 * size, "text-anchor": "start" }, "y [m]"));
  return group;
}

/** The fitted trapezoid of an event: from the tip edge's ends to the base line. */
export function trapezoidOf(run: Run, event: number): Ring {
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

export class PlanView {
  readonly element: SVGSVGElement;
  private readonly overlay = svg("g");
  private readonly points: SVGCircleElement[] = [];

  constructor(
    private readonly run: Run,
    onChoose: (event: number) => void,
  ) {
    const pieces = run.offSheet.map((floe) => run.bornAt(floe));
    const last = run.sheets.at(-1)!;
    const structure = run.waterlineAtEnd();
    const nodes = [...pieces.flat(2), ...structure.flat()];
    const box = around(nodes, 2.5);
    const latest = Math.max(1e-9, run.duration);
    const floes = svg("g", { class: "floes" });
    pieces.forEach((rings, n) => {
      const i = run.offSheet[n];
      const share = (run.column("floe.birth")[i] as number) / latest;
      floes.append(svg("path", { d: path(rings), "fill-rule": "evenodd", style: `--age: ${share.toFixed(3)}` },
        svg("title", {}, `floe ${run.column("floe.id")[i]}, ${run.column("floe.area")[i].toFixed(2)} m², born at ${run.column("floe.birth")[i].toFixed(2)} s`)));
    });
    const marks = svg("g", { class: "breaks" });
    for (let i = 0; i < run.nEvents; ++i) {
      const point = svg(
        "circle",
        {
          cx: run.column("event.x")[i], cy: -run.column("event.y")[i], r: (box.x1 - box.x0) / 210, tabindex: 0, role: "button",
          "aria-label": `crack event ${i + 1} at ${run.column("event.time")[i].toFixed(2)} s`,
          click: () => onChoose(i),
          keydown: (event: KeyboardEvent) => {
            if (event.key === "Enter") onChoose(i);
          },
        },
      );
      this.points.push(point);
      marks.append(point);
    }
    this.element = drawing(
      box,
      "Plan of the channel with all cracks",
      svg("path", { class: "sheet", d: path(last), "fill-rule": "evenodd" }),
      floes,
      svg("path", { class: "structure", d: path(structure) }),
      this.overlay,
      marks,
      ruler(box, 62),
    );
  }

  select(event: number): void {
    this.points.forEach((point, i) => point.classList.toggle("chosen", i === event));
    this.overlay.replaceChildren(...(event < 0 ? [] : eventMarks(this.run, event)));
  }
}

/** The trapezoid, the circle of the breaking length and the collision point. */
function eventMarks(run: Run, event: number): SVGElement[] {
  const at = (name: string) => run.column(`event.${name}`)[event];
  return [
    svg("circle", { class: "reach", cx: at("x"), cy: -at("y"), r: at("l_break") }),
    svg("path", { class: "trapezoid", d: path([trapezoidOf(run, event)]) }),
    svg("circle", { class: "at", cx: at("x"), cy: -at("y"), r: 0.03 * at("l_break") }),
  ];
}

/** One crack event: the edge as it was, the pieces it made, trapezoid and breaking length. */
export function eventFigure(run: Run, event: number): SVGSVGElement {
  const at = (name: string) => run.column(`event.${name}`)[event];
  const reach = 1.35 * Math.max(at("l_break"), 1.2);
  const box = around([[at("x"), at("y")]], reach);
  box.y0 = at("y") - 0.8 * reach;
  box.y1 = at("y") + 0.8 * reach;
  const times = run.column("sheet.time");
  let before = 0;
  while (before + 2 < times.length && times[before + 1] < at("time") - 1e-9) ++before;
  const pieces = svg("g", { class: "pieces" });
  for (const floe of run.piecesOf[event])
    pieces.append(svg("path", { d: path(run.bornAt(floe)), "fill-rule": "evenodd" }));
  return drawing(
    box,
    `Crack event ${event + 1} from above`,
    svg("path", { class: "sheet", d: path(run.sheets[before]), "fill-rule": "evenodd" }),
    pieces,
    ...eventMarks(run, event),
    ruler(box, 24),
  );
}
