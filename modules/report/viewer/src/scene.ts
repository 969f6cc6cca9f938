// SPDX-License-Identifier: GPL-3.0-or-later
// The run in space: water, sheet, structure and floes at any time. Axes are those of the sheet: x along the track, y to
// port, z upwards from the waterplane.
import {
  AmbientLight, BufferAttribute, BufferGeometry, Color, DirectionalLight, DoubleSide, EdgesGeometry, Fog, Group,
  HemisphereLight, LineBasicMaterial, LineLoop, LineSegments, Mesh, MeshBasicMaterial, MeshLambertMaterial,
  PCFShadowMap, PerspectiveCamera, PlaneGeometry, Quaternion, Scene, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Run } from "./data";
import { css } from "./dom";
import { FloeMesh } from "./floe_mesh";
import { hullOf, partOf } from "./hull";
import { polygonsOf, Prisms } from "./prisms";
import { frameAt } from "./tracks";

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

export class ReplayScene {
  readonly renderer: WebGLRenderer;
  readonly camera = new PerspectiveCamera(36, 1, 0.1, 900);
  readonly controls: OrbitControls;
  readonly floes: FloeMesh;
  follow = true;
  private readonly scene = new Scene();
  private readonly structure = new Group();
  private readonly hull = new Group();
  private readonly aboveWater = new Group();
  private readonly belowWater = new Group();
  private readonly sheetMesh: Mesh;
  private readonly sheetLines: LineSegments;
  private readonly sheets = new Map<number, { solid: BufferGeometry; lines: BufferGeometry }>();
  private sheetShown = -1;
  private readonly palette: Record<string, Color> = {};
  private readonly materials: Record<string, MeshLambertMaterial | MeshBasicMaterial | LineBasicMaterial> = {};
  private readonly radius: number;
  private readonly top: number;
  private readonly bottom: number;
  private lastPlace = new Vector3();  // of the structure
  private pending = false;

  constructor(
    readonly canvas: HTMLCanvasElement,
    private readonly run: Run,
  ) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, powerPreference: "high-performance" });
    // Asking whether a shader compiled waits until it has: a quarter of a second at the start in software.
    this.renderer.debug.checkShaderErrors = false;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.camera.up.set(0, 0, 1);
    const h = run.input("ice", "thickness");
    this.bottom = (-h * run.input("ice", "density")) / run.input("water", "density");
    this.top = h + this.bottom;
    this.radius = run.radius;

    const floes = new MeshLambertMaterial({ vertexColors: true, flatShading: true });
    const edges = new LineBasicMaterial({ transparent: true, opacity: 0.55 });
    this.materials.edges = edges;
    this.floes = new FloeMesh(run, this.palette, { floes, edges });
    this.materials.sheet = new MeshLambertMaterial({ flatShading: true });
    this.sheetMesh = new Mesh(new BufferGeometry(), this.materials.sheet);
    this.sheetLines = new LineSegments(new BufferGeometry(), edges);
    this.sheetMesh.frustumCulled = this.sheetLines.frustumCulled = false;
    this.sheetMesh.castShadow = this.sheetMesh.receiveShadow = true;
    this.scene.add(this.floes.solid, this.floes.lines, this.sheetMesh, this.sheetLines);

    this.addWater();
    this.addStructure();
    this.addLights();
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.maxDistance = 160;
    this.controls.minDistance = 2;
    this.controls.zoomSpeed = 0.8;
    this.controls.addEventListener("change", () => this.draw());
    this.lastPlace = this.structurePlace(0);
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
    const centre = new Vector3(this.lastPlace.x, this.lastPlace.y, 0);
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
      const way = at.clone().sub(this.lastPlace).setZ(0);
      this.camera.position.add(way);
      this.controls.target.add(way);
    }
    this.lastPlace = at;
    this.structure.position.copy(at);
    this.hull.quaternion.copy(this.structureTurn(time));
    this.floes.show(time);
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

  /** A number of the structure's pose, between the frames around a time. */
  private structureAt(time: number, name: string): number {
    const { frame, share } = frameAt(this.run, time);
    const column = this.run.column(`frame.structure_${name}`);
    const next = Math.min(frame + 1, column.length - 1);
    return column[frame] + share * (column[next] - column[frame]);
  }

  private structurePlace(time: number): Vector3 {
    return new Vector3(this.structureAt(time, "x"), this.structureAt(time, "y"), this.structureAt(time, "z"));
  }

  private structureTurn(time: number): Quaternion {
    const at = (name: string) => this.structureAt(time, name);
    return new Quaternion(at("qx"), at("qy"), at("qz"), at("qw")).normalize();
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
    const whole = hullOf(this.run);
    this.materials.structure = new MeshLambertMaterial({});
    for (const [group, above] of [[this.aboveWater, true], [this.belowWater, false]] as const) {
      const mesh = new Mesh(partOf(whole, above), this.materials.structure);
      mesh.castShadow = mesh.receiveShadow = true;
      group.add(mesh);
    }
    this.materials.waterline = new LineBasicMaterial({});
    const kSharp = 30;  // degrees: the facets of a round surface meet at less
    const lines = new Group().add(new LineSegments(new EdgesGeometry(whole, kSharp), this.materials.waterline));
    for (const ring of this.run.waterline) {
      const nodes = ring.map(([x, y]) => new Vector3(x, y, 0));
      lines.add(new LineLoop(new BufferGeometry().setFromPoints(nodes), this.materials.waterline));
    }
    lines.scale.set(1.001, 1.001, 1);
    this.hull.add(this.aboveWater, this.belowWater, lines);
    this.structure.add(this.hull);
    this.scene.add(this.structure);
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
