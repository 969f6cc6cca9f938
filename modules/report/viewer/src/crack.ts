// SPDX-License-Identifier: GPL-3.0-or-later
// The line of a crack: edges of the pieces that it made which they share with the sheet it left, or with each other.
import type { Ring, Run } from "./data";

export type Point = [number, number];
export type Segment = [Point, Point];

export interface Crack {
  /** Between the pieces and the ice that stayed. */
  circumferential: Segment[];
  /** Between two pieces. */
  radial: Segment[];
  /** Whether the first is the circle of the breaking length about the trapezoid's tip. */
  isCircle: boolean;
  /** Whether a trapezoid describes the event. With the pattern "stress" there is none where no shape with a depth fits. */
  hasTrapezoid: boolean;
}

/** Sheets are rounded to a millimetre, and pieces to a tenth. */
const kTolerance = 2.5e-3;

const segmentsOf = (rings: Ring[]): Segment[] =>
  rings.flatMap((ring) => ring.map((a, i): Segment => [a, ring[(i + 1) % ring.length]]));

const middle = ([[a, b], [c, d]]: Segment): Point => [0.5 * (a + c), 0.5 * (b + d)];

function distance([x, y]: Point, [[ax, ay], [bx, by]]: Segment): number {
  const [ux, uy] = [bx - ax, by - ay];
  const length = ux * ux + uy * uy;
  const t = length > 0 ? Math.min(1, Math.max(0, ((x - ax) * ux + (y - ay) * uy) / length)) : 0;
  return Math.hypot(x - ax - t * ux, y - ay - t * uy);
}

const lies = (point: Point, on: Segment[]): boolean => on.some((segment) => distance(point, segment) < kTolerance);

export function crackOf(run: Run, event: number): Crack {
  // Cracks of one step come one after another: what a later one broke was still ice.
  const pieces = run.piecesOf[event].map((floe) => segmentsOf(run.bornAt(floe)));
  const time = run.column("event.time")[event];
  const others = run.piecesOf.flatMap((floes, i) =>
    i > event && run.column("event.time")[i] === time ? floes.flatMap((floe) => segmentsOf(run.bornAt(floe))) : []);
  const left = [...nearby(segmentsOf(run.sheetOf(event, true)), pieces.flat()), ...others];
  const crack: Crack = { circumferential: [], radial: [], isCircle: false, hasTrapezoid: true };
  pieces.forEach((edges, i) => {
    for (const edge of edges) {
      const at = middle(edge);
      if (lies(at, left)) crack.circumferential.push(edge);
      else if (pieces.slice(i + 1).some((later) => lies(at, later))) crack.radial.push(edge);
    }
  });
  const [x, y, reach] = ["tip_x", "tip_y", "l_break"].map((name) => run.column(`event.${name}`)[event]);
  // The circle is a polygon, on whose sides the crack ends.
  const inner = reach * Math.cos(Math.PI / kArcSides);
  crack.isCircle = crack.circumferential.length > 0 && crack.circumferential.flat().map(([u, v]) => Math.hypot(u - x, v - y))
    .every((distance) => distance > inner - kTolerance && distance < reach + kTolerance);
  crack.hasTrapezoid = run.column("event.b")[event] > 0 || run.inputs.failure?.pattern?.value !== "stress";
  return crack;
}

/** Chords of a full breaking circle, as in modules/ice/src/crack_pattern.cpp. */
const kArcSides = 16;

/** The segments of a large outline that can touch the pieces. */
function nearby(all: Segment[], pieces: Segment[]): Segment[] {
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [[x, y]] of pieces) {
    box[0] = Math.min(box[0], x - kTolerance);
    box[1] = Math.min(box[1], y - kTolerance);
    box[2] = Math.max(box[2], x + kTolerance);
    box[3] = Math.max(box[3], y + kTolerance);
  }
  return all.filter(([[a, b], [c, d]]) =>
    Math.max(a, c) >= box[0] && Math.min(a, c) <= box[2] && Math.max(b, d) >= box[1] && Math.min(b, d) <= box[3]);
}
