// SPDX-License-Identifier: GPL-3.0-or-later
// All floes as one solid that is drawn at once; their vertices move and change colour with time.
import { BufferAttribute, BufferGeometry, Color, LineSegments, type Material, Mesh } from "three";
import type { Run } from "./data";
import { inLoadUnit } from "./format";
import { Prisms } from "./prisms";
import { frameAt, Tracks } from "./tracks";

export type Colouring = "cause" | "age" | "force";
/** How long a deleted floe stays visible, in red [s]. */
const kGhost = 0.5;
/** Values of `floe.end`. */
const [kAlive, kCrushed] = [0, 1];
/** Places of no record: a floe that moves, and one that is not there. */
const [kMoves, kAway] = [-2, -3];
/** How long a newborn floe is tinted [s]. */
const kNewborn = 0.4;

export class FloeMesh {
  readonly solid: Mesh;
  readonly lines: LineSegments;
  colouring: Colouring = "cause";
  /** Floes drawn at the time shown, ghosts of deleted ones not counted. */
  nVisible = 0;
  private readonly body: Float32Array;
  private readonly place: BufferAttribute;
  private readonly colour: BufferAttribute;
  private readonly firstVertex: Int32Array;
  private readonly cause: Int8Array;
  /** Of each floe the record that its vertices show, if it lies still there; or why not. */
  private readonly drawn: Int32Array;
  /** The same of its colour. */
  private readonly painted: Int32Array;
  private paintedBy: Colouring = "cause";
  private readonly pose = new Float64Array(7);
  /** Edges of all floes, and where those of each begin. */
  private readonly edges: Uint32Array;
  private readonly firstEdge: Int32Array;
  private readonly centres: Float32Array;
  private readonly moved: Span;
  private readonly tinged: Span;
  /** Of the run [N], for the colours; no less than ten of the page's unit. */
  largestForce = 10 / inLoadUnit(1);

  /** @param palette colours by name; may change afterwards. */
  constructor(
    private readonly run: Run,
    private readonly palette: Record<string, Color>,
    materials: { floes: Material; edges: Material },
  ) {
    const thickness = run.column("floe.thickness");
    const prisms = new Prisms();
    this.firstVertex = new Int32Array(run.nFloes + 1);
    this.firstEdge = new Int32Array(run.nFloes + 1);
    this.centres = new Float32Array(2 * run.nFloes);
    run.outlines.forEach((rings, i) => {
      prisms.add(rings, -0.5 * thickness[i], 0.5 * thickness[i]);
      this.firstVertex[i + 1] = prisms.size;
      this.firstEdge[i + 1] = prisms.edges.length;
    });
    this.edges = Uint32Array.from(prisms.edges);
    this.body = prisms.positions();
    this.place = new BufferAttribute(new Float32Array(this.body.length), 3);
    this.colour = new BufferAttribute(new Float32Array(this.body.length), 3);
    [this.moved, this.tinged] = [new Span(this.place), new Span(this.colour)];
    this.drawn = new Int32Array(run.nFloes).fill(kMoves);
    this.painted = new Int32Array(run.nFloes).fill(kMoves);
    this.cause = Int8Array.from(run.outlines, (_, i) => {
      if (run.column("floe.end")[i] === kCrushed) return 2;
      return run.wasThere(i) ? 1 : 0;
    });
    this.rescale();
    const faces = new BufferGeometry().setIndex(prisms.triangles).setAttribute("position", this.place);
    this.solid = new Mesh(faces.setAttribute("color", this.colour), materials.floes);
    this.solid.castShadow = this.solid.receiveShadow = true;
    const drawnEdges = new BufferAttribute(this.edges.slice(), 1);
    this.lines = new LineSegments(new BufferGeometry().setIndex(drawnEdges).setAttribute("position", this.place), materials.edges);
    this.solid.frustumCulled = this.lines.frustumCulled = false;
  }

  /** How many floes it was made of. */
  get nFloes(): number {
    return this.cause.length;
  }

  dispose(): void {
    this.solid.geometry.dispose();
    this.lines.geometry.dispose();
  }

  /** Takes the largest force of all frames for the end of its colours. */
  rescale(): void {
    const before = this.largestForce;
    for (const force of this.run.column("track.force")) this.largestForce = Math.max(this.largestForce, force);
    if (this.largestForce !== before) this.repaint();
  }

  /** Paints every floe again at the next time: the palette has changed. */
  repaint(): void {
    this.painted.fill(kMoves);
  }

  /** Moves every floe to where it is at `time` [s]. A floe that lies still is left as it is. Edges are drawn within
   * `reach` [m] of a place, since lines take long to draw. */
  show(time: number, about: { x: number; y: number }, reach: number): void {
    const { frame } = frameAt(this.run, time);
    const tracks = new Tracks(this.run);
    const [birth, death, ends] = ["birth", "death", "end"].map((name) => this.run.column(`floe.${name}`));
    if (this.colouring === "age" || this.colouring !== this.paintedBy) this.repaint();
    this.paintedBy = this.colouring;
    this.nVisible = 0;
    for (let floe = 0; floe < this.run.nFloes; ++floe) {
      const end = ends[floe];
      if (time < birth[floe] || (end !== kAlive && time >= death[floe] + (end === kCrushed ? kGhost : 0))) {
        this.hide(floe);
        continue;
      }
      const gone = end !== kAlive && time >= death[floe];
      if (!gone) ++this.nVisible;
      const record = tracks.at(floe, frame);
      const rests = tracks.rests(floe, record);
      this.move(floe, tracks, record, rests, time);
      this.tinge(floe, tracks.forceAt(record), rests && !gone && time - birth[floe] >= kNewborn ? record : kMoves, time - birth[floe], gone);
    }
    this.showEdges(about, reach);
  }

  private showEdges({ x, y }: { x: number; y: number }, reach: number): void {
    const index = this.lines.geometry.index!;
    let n = 0;
    for (let floe = 0; floe < this.run.nFloes; ++floe) {
      if (this.drawn[floe] === kAway || Math.hypot(this.centres[2 * floe] - x, this.centres[2 * floe + 1] - y) > reach) continue;
      const [from, to] = [this.firstEdge[floe], this.firstEdge[floe + 1]];
      (index.array as Uint32Array).set(this.edges.subarray(from, to), n);
      n += to - from;
    }
    this.lines.geometry.setDrawRange(0, n);
    index.clearUpdateRanges();
    index.addUpdateRange(0, n);
    index.needsUpdate = true;
  }

  private hide(floe: number): void {
    if (this.drawn[floe] === kAway) return;
    this.drawn[floe] = kAway;
    const [from, to] = [this.firstVertex[floe], this.firstVertex[floe + 1]];
    // One point far below: triangles without area draw nothing.
    for (let i = from; i < to; ++i) this.place.setXYZ(i, 0, 0, -500);
    this.moved.take(from, to);
  }

  private move(floe: number, tracks: Tracks, record: number, rests: boolean, time: number): void {
    if (rests && this.drawn[floe] === record) return;
    this.drawn[floe] = rests ? record : kMoves;
    const [from, to] = [this.firstVertex[floe], this.firstVertex[floe + 1]];
    tracks.pose(floe, record, time, this.pose);
    this.centres.set([this.pose[0], this.pose[1]], 2 * floe);
    this.transform(from, to, this.pose);
    this.moved.take(from, to);
  }

  private tinge(floe: number, force: number, record: number, age: number, gone: boolean): void {
    if (record !== kMoves && this.painted[floe] === record) return;
    this.painted[floe] = record;
    const [from, to] = [this.firstVertex[floe], this.firstVertex[floe + 1]];
    this.paint(from, to, this.tint(floe, age, gone, force));
    this.tinged.take(from, to);
  }

  private transform(from: number, to: number, [x, y, z, w, a, b, c]: Float64Array): void {
    const r = [
      1 - 2 * (b * b + c * c), 2 * (a * b - c * w), 2 * (a * c + b * w),
      2 * (a * b + c * w), 1 - 2 * (a * a + c * c), 2 * (b * c - a * w),
      2 * (a * c - b * w), 2 * (b * c + a * w), 1 - 2 * (a * a + b * b),
    ];
    const out = this.place.array as Float32Array;
    for (let i = 3 * from; i < 3 * to; i += 3) {
      const [u, v, t] = [this.body[i], this.body[i + 1], this.body[i + 2]];
      out[i] = x + r[0] * u + r[1] * v + r[2] * t;
      out[i + 1] = y + r[3] * u + r[4] * v + r[5] * t;
      out[i + 2] = z + r[6] * u + r[7] * v + r[8] * t;
    }
  }

  private readonly mixed = new Color();
  private tint(floe: number, age: number, gone: boolean, force: number): Color {
    const p = this.palette;
    if (gone) return p.crushed;
    if (this.colouring === "age") return this.mixed.copy(p.young).lerp(p.old, Math.min(1, age / Math.max(1, 0.5 * this.run.duration)));
    if (this.colouring === "force")
      return this.mixed.copy(p.calm).lerp(p.loaded, Math.min(1, Math.log1p(inLoadUnit(force)) / Math.log1p(inLoadUnit(this.largestForce))));
    this.mixed.copy([p.floe, p.initial, p.crushed][this.cause[floe]]);
    return age < kNewborn ? this.mixed.lerp(p.newborn, 0.75 * (1 - age / kNewborn)) : this.mixed;
  }

  private paint(from: number, to: number, { r, g, b }: Color): void {
    const out = this.colour.array as Float32Array;
    for (let i = 3 * from; i < 3 * to; i += 3) {
      out[i] = r;
      out[i + 1] = g;
      out[i + 2] = b;
    }
  }
}

/** The vertices from the first to the last that changed since they were sent to the graphics card. */
class Span {
  private from = Infinity;
  private to = 0;

  constructor(private readonly attribute: BufferAttribute) {
    attribute.onUpload(() => [this.from, this.to] = [Infinity, 0]);
  }

  take(from: number, to: number): void {
    this.from = Math.min(this.from, from);
    this.to = Math.max(this.to, to);
    this.attribute.clearUpdateRanges();
    this.attribute.addUpdateRange(3 * this.from, 3 * (this.to - this.from));
    this.attribute.needsUpdate = true;
  }
}
