// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of one run in space, with its legend and scale.
import type { Run } from "./data";
import { el } from "./dom";
import type { Colouring } from "./floe_mesh";
import { loadText, loadUnit } from "./format";
import { kLand, legend, type Swatch } from "./legend";
import { isOnPaper, onRefit } from "./paper";
import { ReplayScene } from "./scene";
import { scaleLength } from "./views";

/** Keys that move the camera: around, up [rad], nearer. */
const kMoves: Record<string, [number, number, number]> = {
  a: [-0.1, 0, 1], d: [0.1, 0, 1], w: [0, 0.1, 1], s: [0, -0.1, 1], "+": [0, 0, 1.15], "-": [0, 0, 1 / 1.15],
};

export class Stage {
  readonly element = el("div", { class: "stage" });
  readonly scene: ReplayScene | null;
  readonly canvas: HTMLCanvasElement;
  private legend = legend([]);
  private readonly scale = el("div", { class: "scale" });
  /** The picture on paper: a canvas may be empty there. */
  private readonly still = el("img", { class: "still", alt: "Replay at the time of printing", hidden: true });

  /** @param title of the run, if there are several. */
  constructor(readonly run: Run, title = "") {
    this.canvas = el("canvas", { tabindex: 0, role: "img", "aria-label": `Replay of the run in three dimensions${title && `: ${title}`}` });
    this.scene = this.makeScene();
    if (!this.scene) {
      this.element.append(el("p", { class: "note" }, "This browser offers no WebGL, which the replay in three dimensions needs. Everything else is here."));
      return;
    }
    if (title) this.element.append(el("p", { class: "stage-title" }, title));
    this.element.append(this.still, this.canvas, this.scale, this.legend);
    onRefit(this.element, () => isOnPaper() && this.takeStill());
    this.canvas.addEventListener("keydown", (event) => kMoves[event.key] && this.scene!.move(...kMoves[event.key]));
    this.scene.onDraw = () => this.showScale(this.scene!);
    new ResizeObserver(() => this.scene?.resize(this.element.clientWidth, this.element.clientHeight)).observe(this.element);
  }

  setColouring(colouring: Colouring): void {
    if (!this.scene) return;
    this.scene.floes.colouring = colouring;
    const always: Swatch[] = [
      ...(this.run.sheets.at(-1)!.length > 0 ? [{ colour: "--scene-ice", text: "level ice" }] : []),
      ...(this.run.land.length > 0 ? [kLand] : []), { colour: "--scene-structure", text: "structure" },
    ];
    const next = legend([...this.swatches(colouring), ...always, { colour: "--scene-ripple", text: `lines on the water: ${this.scene.water.spacing} m apart`, kind: "line" }]);
    this.legend.replaceWith(next);
    this.legend = next;
  }

  /** Follows a run that has grown. */
  renew(): void {
    this.scene?.renew();
    if (this.scene) this.setColouring(this.scene.floes.colouring);  // its legend has the largest force
  }

  /** Draws into an image. */
  picture(): string {
    this.scene?.drawNow();
    return this.canvas.toDataURL("image/png");
  }

  private takeStill(): void {
    this.still.src = this.picture();
    this.still.hidden = false;
  }

  private makeScene(): ReplayScene | null {
    try {
      return new ReplayScene(this.canvas, this.run);
    } catch {
      return null;
    }
  }

  private swatches(colouring: Colouring): Swatch[] {
    if (colouring === "age") return [{ colour: ["--scene-young", "--scene-old"], text: "just born to old" }];
    if (colouring === "force")
      return [{ colour: ["--scene-calm", "--scene-loaded"], text: `contact force, 0 to ${loadText(this.scene!.floes.largestForce)} ${loadUnit()}, logarithmic` }];
    return [
      { colour: "--scene-floe", text: "broken off" }, { colour: "--scene-initial", text: "there at the start" },
      { colour: ["--scene-newborn", "--scene-floe"], text: "just born" }, { colour: "--scene-crushed", text: "crushed later, or just now" },
    ];
  }

  /** A bar of a round length. In perspective it holds at the point that the camera turns about. */
  private showScale(scene: ReplayScene): void {
    const perMetre = scene.pixelsPerMetre;
    if (!(perMetre > 0)) return;  // the stage has left the page
    const length = scaleLength(perMetre);
    this.scale.style.width = `${(length * perMetre).toFixed(1)}px`;
    const text = `${Number(length.toPrecision(1))} m at the structure`;
    if (this.scale.textContent !== text) this.scale.textContent = text;
  }
}
