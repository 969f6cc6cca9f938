// SPDX-License-Identifier: GPL-3.0-or-later
// All floes as one solid that is drawn at once; their vertices move and change colour with time.
import { BufferAttribute, BufferGeometry, Color, LineSegments, type Material, Mesh } from "three";
import type { Run } from "./data";
import { Prisms } from "./prisms";
import { floePose, frameAt } from "./tracks";

export type Colouring = "cause" | "age" | "force";
/** How long a deleted floe stays visible, in red [s]. */
const kGhost = 0.5;
/** Values of `floe.end`. */
const [kAlive, kCrushed] = [0, 1];
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
  /** Of the run [N], for the colours; no less than 10 kN. */
  largestForce = 1e4;

  /** @param palette colours by name; may change afterwards. */
  constructor(
    private readonly run: Run,
    private readonly palette: Record<string, Color>,
    materials: { floes: Material; edges: Material },
  ) {
    const thickness = run.column("floe.thickness");
    const prisms = new Prisms();
    this.firstVertex = new Int32Array(run.nFloes + 1);
    run.outlines.forEach((rings, i) => {
      prisms.add(rings, -0.5 * thickness[i], 0.5 * thickness[i]);
      this.firstVertex[i + 1] = prisms.size;
    });
    this.body = prisms.positions();
    this.place = new BufferAttribute(new Float32Array(this.body.length), 3);
    this.colour = new BufferAttribute(new Float32Array(this.body.length), 3);
    this.cause = Int8Array.from(run.outlines, (_, i) => {
      if (run.column("floe.end")[i] === kCrushed) return 2;
      return run.eventOf(i) < 0 ? 1 : 0;
    });
    for (const force of run.column("track.force")) this.largestForce = Math.max(this.largestForce, force);
    const faces = new BufferGeometry().setIndex(prisms.triangles).setAttribute("position", this.place);
    this.solid = new Mesh(faces.setAttribute("color", this.colour), materials.floes);
    this.solid.castShadow = this.solid.receiveShadow = true;
    this.lines = new LineSegments(new BufferGeometry().setIndex(prisms.edges).setAttribute("position", this.place), materials.edges);
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

  /** Moves every floe to where it is at `time` [s]. */
  show(time: number): void {
    const { frame, share } = frameAt(this.run, time);
    this.nVisible = 0;
    for (let floe = 0, start = 0; floe < this.run.nFloes; ++floe) {
      const n = this.run.column("track.count")[floe];
      this.placeFloe(floe, start, n, time, frame, share);
      start += n;
    }
    this.place.needsUpdate = true;
    this.colour.needsUpdate = true;
  }

  private placeFloe(floe: number, start: number, n: number, time: number, frame: number, share: number): void {
    const birth = this.run.column("floe.birth")[floe];
    const death = this.run.column("floe.death")[floe];
    const end = this.run.column("floe.end")[floe];
    const visible = time >= birth && (end === kAlive || time < death + (end === kCrushed ? kGhost : 0));
    const [from, to] = [this.firstVertex[floe], this.firstVertex[floe + 1]];
    if (!visible) {
      // One point far below: triangles without area draw nothing.
      for (let i = from; i < to; ++i) this.place.setXYZ(i, 0, 0, -500);
      return;
    }
    const gone = end !== kAlive && time >= death;
    if (!gone) ++this.nVisible;
    const k = frame - this.run.column("track.first")[floe];
    this.transform(from, to, floePose(this.run, floe, start, n, k, share, time));
    const force = n === 0 || k < 0 ? 0 : this.run.column("track.force")[start + Math.min(n - 1, k)];
    this.paint(from, to, this.tint(floe, time - birth, gone, force));
  }

  private transform(from: number, to: number, [x, y, z, w, a, b, c]: number[]): void {
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
      return this.mixed.copy(p.calm).lerp(p.loaded, Math.min(1, Math.log1p(force / 1e3) / Math.log1p(this.largestForce / 1e3)));
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
