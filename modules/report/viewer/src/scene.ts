// SPDX-License-Identifier: GPL-3.0-or-later
// The run in space: water, sheet, structure and floes at any time. Axes of the sheet: x along the track, y to port,
// z upwards from the waterplane.
import {
  AmbientLight, BufferAttribute, BufferGeometry, Color, DirectionalLight, EdgesGeometry, Fog, Group, HemisphereLight,
  LineBasicMaterial, LineLoop, LineSegments, Mesh, MeshLambertMaterial, PCFShadowMap, PerspectiveCamera, Quaternion, Scene,
  Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Run } from "./data";
import { css } from "./dom";
import { FloeMesh } from "./floe_mesh";
import { hullOf, partOf } from "./hull";
import { polygonsOf, Prisms } from "./prisms";
import { frameAt } from "./tracks";
import { furtherIn, kViews, sizeOf } from "./views";
import { kFloor, Water } from "./water";

/** A run of more floes is drawn with less around it. */
const kMany = 1000;

/** Height of land over the ice, in sizes of the scene. */
const kShore = 0.04;

/** From so many sizes of the scene on, its mist hides edges. */
const kLinesReach = 12;

/** Whether the browser draws on the processor. Smooth lines then cost more than all else. */
function drawsInSoftware(): boolean {
  const context = document.createElement("canvas").getContext("webgl2");
  const info = context?.getExtension("WEBGL_debug_renderer_info");
  const name = info ? String(context!.getParameter(info.UNMASKED_RENDERER_WEBGL)) : "";
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|softpipe|basic render/i.test(name);
}

export class ReplayScene {
  readonly renderer: WebGLRenderer;
  readonly camera: PerspectiveCamera;
  readonly controls: OrbitControls;
  floes: FloeMesh;
  readonly water: Water;
  follow = true;
  /** Called after each picture. */
  onDraw: () => void = () => {};
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
  private readonly materials: Record<string, MeshLambertMaterial | LineBasicMaterial> = {};
  private readonly size: number;
  private readonly top: number;
  private readonly bottom: number;
  private view = "Wake";
  private lastPlace = new Vector3();  // of the structure
  private pending = false;
  private readonly inSoftware = drawsInSoftware();
  private moving = false;

  constructor(
    readonly canvas: HTMLCanvasElement,
    private readonly run: Run,
  ) {
    this.renderer = new WebGLRenderer({ canvas, antialias: !this.inSoftware, powerPreference: "high-performance" });
    // Asking whether a shader compiled waits until it has: a quarter of a second at the start in software.
    this.renderer.debug.checkShaderErrors = false;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.size = sizeOf(run);
    this.camera = new PerspectiveCamera(36, 1, 0.015 * this.size, 140 * this.size);
    this.camera.up.set(0, 0, 1);
    const h = run.input("ice", "thickness");
    this.bottom = (-h * run.input("ice", "density")) / run.input("water", "density");
    this.top = h + this.bottom;
    this.water = new Water(this.size, run.input("water", "depth"));

    const floes = (this.materials.floes = new MeshLambertMaterial({ vertexColors: true, flatShading: true }));
    const edges = (this.materials.edges = new LineBasicMaterial({ transparent: true, opacity: 0.55 }));
    this.floes = new FloeMesh(run, this.palette, { floes, edges });
    this.materials.sheet = new MeshLambertMaterial({ flatShading: true });
    for (const material of [floes, this.materials.sheet]) this.water.fades(material);
    this.sheetMesh = new Mesh(new BufferGeometry(), this.materials.sheet);
    this.sheetLines = new LineSegments(new BufferGeometry(), edges);
    this.sheetMesh.frustumCulled = this.sheetLines.frustumCulled = false;
    this.sheetMesh.castShadow = this.sheetMesh.receiveShadow = true;
    this.scene.add(this.floes.solid, this.floes.lines, this.sheetMesh, this.sheetLines, this.water.group);

    this.addStructure();
    this.addLand();
    this.addLights();
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.maxDistance = 30 * this.size;
    this.controls.minDistance = Math.min(0.3 * this.size, 10 * h);
    this.controls.zoomSpeed = 0.8;
    this.controls.addEventListener("change", () => this.draw());
    this.controls.addEventListener("start", () => this.setMoving(true));
    this.controls.addEventListener("end", () => this.setMoving(false));
    this.lastPlace = this.structurePlace(0);
    this.setTheme();
    this.look("Wake");
    this.setSeeThrough(true);
  }

  /** Follows a run that has grown: its newest sheet, the floes that were born, and their forces. */
  renew(): void {
    this.sheetShown = -1;
    this.forgetSheets();
    const { colouring, nFloes } = this.floes;
    if (nFloes === this.run.nFloes) return this.floes.rescale();
    this.scene.remove(this.floes.solid, this.floes.lines);
    this.floes.dispose();
    this.floes = new FloeMesh(this.run, this.palette, { floes: this.materials.floes, edges: this.materials.edges });
    this.floes.colouring = colouring;
    this.scene.add(this.floes.solid, this.floes.lines);
  }

  /** Takes the colours of the page's theme. */
  setTheme(): void {
    for (const name of [
      "sky", "water", "deep", "ice", "floe", "initial", "crushed", "newborn", "structure", "line", "young", "old", "calm", "loaded",
      "ripple", "land",
    ])
      this.palette[name] = new Color(css(`--scene-${name}`));
    this.scene.background = this.palette.sky;
    this.scene.fog = new Fog(this.palette.sky, 11 * this.size, 40 * this.size);
    this.materials.sheet.color = this.palette.ice;
    this.materials.land.color = this.palette.land;
    this.water.setTheme(this.palette);
    this.floes.repaint();
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
    this.view = name;
    const { from, at } = kViews[name];
    const centre = new Vector3(this.lastPlace.x, this.lastPlace.y, 0);
    this.controls.target.set(...at).multiplyScalar(this.run.radius).add(centre);
    this.camera.position.set(...from).multiplyScalar(this.size * furtherIn(this.camera.aspect)).add(this.controls.target);
    this.controls.update();
    this.draw();
  }

  /** Turns the camera about the point that it looks at: `around` the vertical and `up` [rad], `nearer` by a factor. */
  move(around: number, up: number, nearer: number): void {
    const { target, minDistance, maxDistance } = this.controls;
    const offset = this.camera.position.clone().sub(target);
    const level = Math.hypot(offset.x, offset.y);
    const heading = Math.atan2(offset.y, offset.x) + around;
    const height = Math.min(1.5, Math.max(-1.5, Math.atan2(offset.z, level) + up));
    const distance = Math.min(maxDistance, Math.max(minDistance, offset.length() / nearer));
    offset.set(Math.cos(heading) * Math.cos(height), Math.sin(heading) * Math.cos(height), Math.sin(height)).multiplyScalar(distance);
    this.camera.position.copy(target).add(offset);
    this.draw();
  }

  /** Draws at once: a canvas of a new size is empty until then. */
  resize(width: number, height: number): void {
    if (width === 0 || height === 0) return;
    const before = furtherIn(this.camera.aspect);
    this.renderer.setPixelRatio(this.pixelRatio);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (before !== furtherIn(this.camera.aspect)) this.look(this.view);
    this.drawNow();
  }

  /** On the processor: coarse pictures while they follow each other, and one drawn twice as fine where it stops. */
  private get pixelRatio(): number {
    return this.inSoftware ? (this.moving ? 1 : 2) : Math.min(2, window.devicePixelRatio);
  }

  /** Whether pictures follow each other, as while the replay plays. */
  setMoving(moving: boolean): void {
    if (moving === this.moving) return;
    this.moving = moving;
    this.renderer.setPixelRatio(this.pixelRatio);
    this.drawNow();
  }

  /** Pixels of a metre at the point that the camera looks at. */
  get pixelsPerMetre(): number {
    const distance = this.camera.position.distanceTo(this.controls.target);
    return this.canvas.clientHeight / (2 * distance * Math.tan((0.5 * this.camera.fov * Math.PI) / 180));
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
    this.water.follow(at.x, at.y);
    this.hull.quaternion.copy(this.structureTurn(time));
    this.floes.show(time, at, kLinesReach * this.size);
    this.draw();
  }

  /** Draws soon, at most once a frame. */
  draw(): void {
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame(() => {
      if (this.pending) this.drawNow();
    });
  }

  drawNow(): void {
    this.pending = false;
    this.controls.update();
    // What is transparent is drawn from the far side of the water to the near one.
    const over = this.camera.position.z > 0;
    for (const mesh of this.aboveWater.children) mesh.renderOrder = over ? 3 : 1;
    for (const mesh of this.belowWater.children) mesh.renderOrder = over ? 1 : 3;
    this.renderer.render(this.scene, this.camera);
    this.onDraw();
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

  /** Land from the floor of the water to a little above the ice. */
  private addLand(): void {
    const prisms = new Prisms();
    for (const polygon of this.run.land) prisms.add(polygon, -kFloor * this.size, this.top + kShore * this.size);
    this.materials.land = new MeshLambertMaterial({ flatShading: true });
    this.water.fades(this.materials.land);
    const land = new Mesh(new BufferGeometry().setIndex(prisms.triangles).setAttribute("position", new BufferAttribute(prisms.positions(), 3)), this.materials.land);
    land.receiveShadow = true;
    if (this.run.land.length > 0) this.scene.add(land);
  }

  /** A level surface in the sun has its own colour, as the legend shows it: sun, sky and the rest add up to pi there. */
  private addLights(): void {
    const sun = new DirectionalLight(0xffffff, 1.75);
    sun.position.set(-2.1, -3.8, 5).multiplyScalar(this.size);
    sun.castShadow = !(this.inSoftware && this.run.nFloes > kMany);
    const height = sun.position.z / sun.position.length();
    const reach = 3.4 * Math.max(this.size, this.run.radius);
    Object.assign(sun.shadow.camera, { left: -reach, right: reach, top: reach, bottom: -reach, near: 0.1 * this.size, far: 20 * this.size });
    sun.shadow.mapSize.set(2048, 2048);
    sun.shadow.bias = -0.0006;
    sun.shadow.normalBias = 0.003 * this.size;
    // The sun goes with the structure: its shadow covers what happens.
    this.structure.add(sun, sun.target);
    const sky = new HemisphereLight(0xffffff, 0x9db4c3, 1.25);
    sky.position.set(0, 0, 1);
    this.scene.add(sky, new AmbientLight(0xffffff, Math.PI - sky.intensity - sun.intensity * height));
  }
}
