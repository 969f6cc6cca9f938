// SPDX-License-Identifier: GPL-3.0-or-later
// The run in space: water, sheet, structure and floes at any time. Axes are those of the sheet: x along the track, y to
// port, z upwards from the waterplane.
import {
  AmbientLight, BufferAttribute, BufferGeometry, CircleGeometry, Color, CylinderGeometry, DirectionalLight, DoubleSide, Fog, Group,
  HemisphereLight, LineBasicMaterial, LineLoop, LineSegments, Mesh, MeshBasicMaterial, MeshLambertMaterial,
  PCFShadowMap, PerspectiveCamera, PlaneGeometry, Scene, ShapeUtils, Vector2, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Ring, Run } from "./data";
import { css } from "./dom";

export type Colouring = "cause" | "age" | "force";
/** How long a deleted floe stays visible, in red [s]. */
const kGhost = 0.5;
/** How long a newborn floe is tinted [s]. */
const kNewborn = 0.4;

export interface View {
  /** Where the camera stands, from the structure's centre at the waterline, in radii of the waterline. */
  from: [number, number, number];
  at: [number, number, number];
}

export const kViews: Record<string, View> = {
  Bow: { from: [4.1, -3.0, 2.5], at: [0.45, 0, -0.1] },
  Wake: { from: [-3.7, -2.7, 2.9], at: [-0.15, 0.05, -0.2] },
  Above: { from: [0.35, -0.01, 6.2], at: [0.35, 0, 0] },
  Side: { from: [0.5, -4.6, 0.42], at: [0.5, 0, -0.1] },
  Below: { from: [3.1, -2.7, -1.9], at: [0.1, 0, -0.3] },
};

/** Triangles and edges of plan polygons between two heights, every ring once at the top and once at the bottom. */
class Prisms {
  readonly x: number[] = [];
  readonly y: number[] = [];
  readonly z: number[] = [];
  readonly triangles: number[] = [];
  readonly edges: number[] = [];

  /** @param rings outline counter-clockwise, holes clockwise. */
  add(rings: Ring[], bottom: number, top: number): void {
    const start = this.x.length;
    const nodes = rings.flat();
    const contour = rings[0].map(([x, y]) => new Vector2(x, y));
    const holes = rings.slice(1).map((ring) => ring.map(([x, y]) => new Vector2(x, y)));
    for (const z of [top, bottom])
      for (const [x, y] of nodes) {
        this.x.push(x);
        this.y.push(y);
        this.z.push(z);
      }
    const n = nodes.length;
    for (const [a, b, c] of ShapeUtils.triangulateShape(contour, holes)) {
      this.triangles.push(start + a, start + b, start + c);
      this.triangles.push(start + n + c, start + n + b, start + n + a);
    }
    let first = start;
    for (const ring of rings) {
      for (let i = 0; i < ring.length; ++i) {
        const a = first + i;
        const b = first + ((i + 1) % ring.length);
        this.triangles.push(a, a + n, b, b, a + n, b + n);
        this.edges.push(a, b, a + n, b + n);
      }
      first += ring.length;
    }
  }

  get size(): number {
    return this.x.length;
  }

  positions(): Float32Array {
    const out = new Float32Array(3 * this.size);
    for (let i = 0; i < this.size; ++i) out.set([this.x[i], this.y[i], this.z[i]], 3 * i);
    return out;
  }
}

/** Rings of one sheet as polygons: a counter-clockwise ring begins one, clockwise rings are its holes. */
export function polygonsOf(rings: Ring[]): Ring[][] {
  const polygons: Ring[][] = [];
  for (const ring of rings) {
    const area = ring.reduce((sum, [x, y], i) => {
      const [u, v] = ring[(i + 1) % ring.length];
      return sum + x * v - u * y;
    }, 0);
    if (area > 0 || polygons.length === 0) polygons.push([ring]);
    else polygons.at(-1)!.push(ring);
  }
  return polygons;
}

export class ReplayScene {
  readonly renderer: WebGLRenderer;
  readonly camera = new PerspectiveCamera(36, 1, 0.1, 900);
  readonly controls: OrbitControls;
  colouring: Colouring = "cause";
  follow = true;
  /** Floes drawn at the time shown, ghosts of deleted ones not counted. */
  nVisible = 0;
  private readonly scene = new Scene();
  private readonly structure = new Group();
  private readonly aboveWater = new Group();
  private readonly belowWater = new Group();
  private readonly sheetGroup = new Group();
  private readonly sheets = new Map<number, { solid: BufferGeometry; lines: BufferGeometry }>();
  private sheetShown = -1;
  private readonly solid: Mesh;
  private readonly sheetMesh: Mesh;
  private readonly sheetLines: LineSegments;
  private readonly body: Float32Array;
  private readonly place: BufferAttribute;
  private readonly colour: BufferAttribute;
  private readonly firstVertex: Int32Array;
  private readonly cause: Int8Array;
  private readonly palette: Record<string, Color> = {};
  private readonly materials: Record<string, MeshLambertMaterial | MeshBasicMaterial | LineBasicMaterial> = {};
  private readonly radius: number;
  private readonly top: number;
  private readonly bottom: number;
  private largestForce: number;
  private structureX = 0;
  private pending = false;

  constructor(
    readonly canvas: HTMLCanvasElement,
    private readonly run: Run,
  ) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, powerPreference: "high-performance" });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.camera.up.set(0, 0, 1);
    const h = run.input("ice", "thickness");
    this.bottom = (-h * run.input("ice", "density")) / run.input("water", "density");
    this.top = h + this.bottom;
    this.radius = 0.5 * run.input("structure", "waterline_width");

    const floes = new Prisms();
    this.firstVertex = new Int32Array(run.nFloes + 1);
    run.outlines.forEach((rings, i) => {
      floes.add(rings, -0.5 * h, 0.5 * h);
      this.firstVertex[i + 1] = floes.size;
    });
    this.body = floes.positions();
    this.place = new BufferAttribute(new Float32Array(this.body.length), 3);
    this.colour = new BufferAttribute(new Float32Array(this.body.length), 3);
    this.cause = Int8Array.from(run.outlines, (_, i) => {
      if (run.column("floe.end")[i] === 1) return 2;
      return run.eventOf(i) < 0 ? 1 : 0;
    });
    this.largestForce = 1e4;
    for (const force of run.column("track.force")) this.largestForce = Math.max(this.largestForce, force);

    const ice = new BufferGeometry();
    ice.setIndex(floes.triangles);
    ice.setAttribute("position", this.place);
    ice.setAttribute("color", this.colour);
    this.materials.floes = new MeshLambertMaterial({ vertexColors: true, flatShading: true });
    this.solid = new Mesh(ice, this.materials.floes);
    const edges = new BufferGeometry();
    edges.setIndex(floes.edges);
    edges.setAttribute("position", this.place);
    this.materials.edges = new LineBasicMaterial({ transparent: true, opacity: 0.55 });
    const lines = new LineSegments(edges, this.materials.edges);
    this.materials.sheet = new MeshLambertMaterial({ flatShading: true });
    this.sheetMesh = new Mesh(new BufferGeometry(), this.materials.sheet);
    this.sheetLines = new LineSegments(new BufferGeometry(), this.materials.edges);
    this.sheetGroup.add(this.sheetMesh, this.sheetLines);
    for (const mesh of [this.solid, lines, this.sheetMesh, this.sheetLines]) mesh.frustumCulled = false;
    for (const mesh of [this.solid, this.sheetMesh]) mesh.castShadow = mesh.receiveShadow = true;
    this.scene.add(this.solid, lines, this.sheetGroup);

    this.addWater();
    this.addStructure();
    this.addLights();
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.maxDistance = 160;
    this.controls.minDistance = 2;
    this.controls.zoomSpeed = 0.8;
    this.controls.addEventListener("change", () => this.draw());
    this.structureX = this.structurePlace(0).x;
    this.setTheme();
    this.look("Wake");
    this.setSeeThrough(true);
  }

  /** Takes the colours of the page's theme. */
  setTheme(): void {
    for (const name of [
      "sky", "water", "deep", "ice", "floe", "initial", "crushed", "newborn", "structure", "line", "young", "old", "calm", "loaded",
    ])
      this.palette[name] = new Color(css(`--scene-${name}`));
    this.scene.background = this.palette.sky;
    this.scene.fog = new Fog(this.palette.sky, 70, 260);
    this.materials.sheet.color = this.palette.ice;
    this.materials.water.color = this.palette.water;
    this.materials.deep.color = this.palette.deep;
    this.materials.structure.color = this.palette.structure;
    this.materials.edges.color = this.palette.line;
    this.materials.waterline.color = this.palette.line;
    this.draw();
  }

  setSeeThrough(on: boolean): void {
    const material = this.materials.structure;
    material.transparent = on;
    material.opacity = on ? 0.4 : 1;
    material.depthWrite = !on;
    material.needsUpdate = true;
    this.draw();
  }

  look(name: string): void {
    const view = kViews[name];
    const centre = new Vector3(this.structureX, 0, 0);
    this.camera.position.set(...view.from).multiplyScalar(this.radius).add(centre);
    this.controls.target.set(...view.at).multiplyScalar(this.radius).add(centre);
    this.controls.update();
    this.draw();
  }

  resize(width: number, height: number): void {
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  /** Moves everything to where it is at `time` [s]. */
  show(time: number): void {
    this.showSheet(this.run.sheetAt(time));
    const at = this.structurePlace(time);
    if (this.follow) {
      this.camera.position.x += at.x - this.structureX;
      this.controls.target.x += at.x - this.structureX;
    }
    this.structureX = at.x;
    this.structure.position.copy(at);
    this.showFloes(time);
    this.draw();
  }

  /** Draws soon, at most once a frame. */
  draw(): void {
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame(() => {
      this.pending = false;
      this.drawNow();
    });
  }

  drawNow(): void {
    this.controls.update();
    // What is transparent is drawn from the far side of the water to the near one.
    const over = this.camera.position.z > 0;
    for (const mesh of this.aboveWater.children) mesh.renderOrder = over ? 3 : 1;
    for (const mesh of this.belowWater.children) mesh.renderOrder = over ? 1 : 3;
    this.renderer.render(this.scene, this.camera);
  }

  private structurePlace(time: number): Vector3 {
    const { frame, share } = this.frameAt(time);
    const at = (name: string) => {
      const column = this.run.column(`frame.structure_${name}`);
      const next = Math.min(frame + 1, column.length - 1);
      return column[frame] + share * (column[next] - column[frame]);
    };
    return new Vector3(at("x"), at("y"), at("z"));
  }

  /** The frame at or before a time, and how far it is to the next one. */
  private frameAt(time: number): { frame: number; share: number } {
    const times = this.run.column("frame.time");
    let low = 0;
    let high = times.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (times[middle] <= time + 1e-9) low = middle;
      else high = middle - 1;
    }
    const next = times[low + 1];
    return { frame: low, share: next === undefined ? 0 : Math.max(0, (time - times[low]) / (next - times[low])) };
  }

  private showSheet(index: number): void {
    if (index === this.sheetShown) return;
    this.sheetShown = index;
    let made = this.sheets.get(index);
    if (!made) {
      const prisms = new Prisms();
      for (const polygon of polygonsOf(this.run.sheets[index])) prisms.add(polygon, this.bottom, this.top);
      const position = new BufferAttribute(prisms.positions(), 3);
      const solid = new BufferGeometry().setIndex(prisms.triangles).setAttribute("position", position);
      const lines = new BufferGeometry().setIndex(prisms.edges).setAttribute("position", position);
      made = { solid, lines };
      if (this.sheets.size > 40) this.forgetSheets();
      this.sheets.set(index, made);
    }
    this.sheetMesh.geometry = made.solid;
    this.sheetLines.geometry = made.lines;
  }

  private forgetSheets(): void {
    for (const { solid, lines } of this.sheets.values()) {
      solid.dispose();
      lines.dispose();
    }
    this.sheets.clear();
  }

  private showFloes(time: number): void {
    const { frame, share } = this.frameAt(time);
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
    const dies = this.run.column("floe.end")[floe] !== 0;
    const visible = time >= birth && (!dies || time < death + kGhost);
    const [from, to] = [this.firstVertex[floe], this.firstVertex[floe + 1]];
    if (!visible) {
      // One point far below: triangles without area draw nothing.
      for (let i = from; i < to; ++i) this.place.setXYZ(i, 0, 0, -500);
      return;
    }
    const gone = dies && time >= death;
    if (!gone) ++this.nVisible;
    const k = frame - this.run.column("track.first")[floe];
    this.transform(from, to, this.pose(floe, start, n, k, share, time));
    const force = n === 0 || k < 0 ? 0 : this.run.column("track.force")[start + Math.min(n - 1, k)];
    this.paint(from, to, this.tint(floe, time - birth, gone, force));
  }

  /** Place and attitude (x, y, z, qw, qx, qy, qz) between the two recorded poses around a time. */
  private pose(floe: number, start: number, n: number, k: number, share: number, time: number): number[] {
    const recorded = (i: number) =>
      kPose.map((name) => this.run.column(`track.${name}`)[start + Math.min(n - 1, Math.max(0, i))]);
    if (n > 0 && k >= 0) return between(recorded(k), recorded(k + 1), k + 1 < n ? share : 0);
    const born = kPose.map((name) => this.run.column(`floe.birth_${name}`)[floe]);
    if (n === 0) return born;
    const birth = this.run.column("floe.birth")[floe];
    const first = this.run.column("frame.time")[this.run.column("track.first")[floe]];
    return between(born, recorded(0), first > birth ? Math.min(1, (time - birth) / (first - birth)) : 1);
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

  /** A tinted surface over the dark of the deep, which is seen from above only. */
  private addWater(): void {
    this.materials.water = new MeshBasicMaterial({ transparent: true, opacity: 0.5, side: DoubleSide, depthWrite: false });
    this.materials.deep = new MeshBasicMaterial({});
    const deep = new Mesh(new PlaneGeometry(1200, 1200), this.materials.deep);
    deep.position.z = -30;
    const surface = new Mesh(new PlaneGeometry(1200, 1200), this.materials.water);
    surface.renderOrder = 2;
    this.scene.add(deep, surface);
  }

  private addStructure(): void {
    const input = (key: string) => this.run.input("structure", key);
    const below = input("height_under_water");
    const above = input("height") - below;
    const downward = this.run.inputs.structure?.breaking?.value !== "upward";
    const slope = (downward ? 1 : -1) / Math.tan(input("angle"));
    const [keel, deck] = [Math.max(0.02, this.radius - below * slope), Math.max(0.02, this.radius + above * slope)];
    this.materials.structure = new MeshLambertMaterial({});
    this.aboveWater.add(...this.frustum(this.radius, deck, 0, above, above));
    this.belowWater.add(...this.frustum(keel, this.radius, -below, 0, -below));
    this.structure.add(this.aboveWater, this.belowWater);
    this.materials.waterline = new LineBasicMaterial({});
    for (const [radius, z] of [[this.radius, 0], [deck, above], [keel, -below]]) {
      const ring = Array.from({ length: 129 }, (_, i) => {
        const angle = (i * Math.PI) / 64;
        return new Vector3(1.001 * radius * Math.cos(angle), 1.001 * radius * Math.sin(angle), z);
      });
      this.structure.add(new LineLoop(new BufferGeometry().setFromPoints(ring), this.materials.waterline));
    }
    this.scene.add(this.structure);
  }

  /** The structure's surface between two heights, closed at the height `lid`. */
  private frustum(lower: number, upper: number, bottom: number, top: number, lid: number): Mesh[] {
    const side = new CylinderGeometry(upper, lower, top - bottom, 128, 1, true).rotateX(Math.PI / 2).translate(0, 0, 0.5 * (bottom + top));
    const cover = new CircleGeometry(lid === top ? upper : lower, 128);
    if (lid === bottom) cover.rotateX(Math.PI);
    return [side, cover.translate(0, 0, lid)].map((geometry) => {
      const mesh = new Mesh(geometry, this.materials.structure);
      mesh.castShadow = mesh.receiveShadow = true;
      return mesh;
    });
  }

  private addLights(): void {
    const sun = new DirectionalLight(0xffffff, 1.85);
    sun.position.set(-14, -26, 34);
    sun.castShadow = true;
    const reach = 3.4 * this.radius;
    Object.assign(sun.shadow.camera, { left: -reach, right: reach, top: reach, bottom: -reach, near: 1, far: 130 });
    sun.shadow.mapSize.set(2048, 2048);
    sun.shadow.bias = -0.0006;
    sun.shadow.normalBias = 0.02;
    // The sun goes with the structure: its shadow covers what happens.
    this.structure.add(sun, sun.target);
    this.scene.add(new HemisphereLight(0xffffff, 0x9db4c3, 1.3), new AmbientLight(0xffffff, 0.55));
  }
}

const kPose = ["x", "y", "z", "qw", "qx", "qy", "qz"];

/** Between two poses: straight in place, along the shorter way in attitude. */
function between(a: number[], b: number[], share: number): number[] {
  const sign = a[3] * b[3] + a[4] * b[4] + a[5] * b[5] + a[6] * b[6] < 0 ? -1 : 1;
  const out = a.map((value, i) => value + share * ((i < 3 ? 1 : sign) * b[i] - value));
  const norm = Math.hypot(out[3], out[4], out[5], out[6]);
  for (let i = 3; i < 7; ++i) out[i] /= norm;
  return out;
}
