// SPDX-License-Identifier: GPL-3.0-or-later
// The replay with its controls.
import type { Run } from "./data";
import { el } from "./dom";
import type { Colouring } from "./floe_mesh";
import { seconds } from "./format";
import type { Player } from "./player";
import { kViews, ReplayScene } from "./scene";

const kSpeeds = [0.1, 0.25, 0.5, 1, 2, 4];
const kLegends: Record<Colouring, [string, string][]> = {
  cause: [["floe", "broken off"], ["initial", "initial crack"], ["newborn", "just born"], ["crushed", "crushed later, or just now"]],
  age: [["young", "just born"], ["old", "old"]],
  force: [["calm", "no contact force"], ["loaded", "largest of the run, logarithmic"]],
};

export class Replay {
  readonly element: HTMLElement;
  readonly scene: ReplayScene | null;
  private readonly play = el("button", { type: "button", class: "primary", title: "Play or pause (space)" }, "▶");
  private readonly slider: HTMLInputElement;
  private readonly clock = el("output", { class: "clock" });
  private readonly legend = el("div", { class: "legend" });
  private readonly canvas = el("canvas", { tabindex: 0, role: "img", "aria-label": "Replay of the run in three dimensions" });

  constructor(
    private readonly run: Run,
    private readonly player: Player,
  ) {
    this.scene = this.makeScene();
    this.slider = el("input", {
      type: "range", min: 0, max: run.duration, step: "any", value: 0, "aria-label": "Time of the replay",
      input: () => player.seek(Number(this.slider.value)),
    });
    this.play.addEventListener("click", () => player.toggle());
    this.element = el("figure", { class: "replay" }, this.stage(), this.transport(), this.options());
    player.onChange(() => this.update());
    this.setColouring("cause");
    this.update();
  }

  setColouring(colouring: Colouring): void {
    if (!this.scene) return;
    this.scene.floes.colouring = colouring;
    this.legend.replaceChildren(
      ...kLegends[colouring].map(([name, text]) =>
        el("span", {}, el("i", { style: `background: var(--scene-${name})` }), text)),
    );
    this.scene.show(this.player.time);
  }

  /** Draws into an image, for print. */
  still(): string {
    this.scene?.drawNow();
    return this.canvas.toDataURL("image/png");
  }

  private makeScene(): ReplayScene | null {
    try {
      return new ReplayScene(this.canvas, this.run);
    } catch {
      return null;
    }
  }

  private stage(): HTMLElement {
    const stage = el("div", { class: "stage" });
    if (!this.scene) {
      stage.append(el("p", { class: "note" }, "This browser offers no WebGL, which the replay in three dimensions needs. Everything else is here."));
      return stage;
    }
    stage.append(this.canvas, this.legend);
    new ResizeObserver(() => this.scene?.resize(stage.clientWidth, stage.clientHeight)).observe(stage);
    return stage;
  }

  private transport(): HTMLElement {
    const speed = el(
      "select",
      { "aria-label": "Speed of the replay", change: () => this.player.setSpeed(Number(speed.value)) },
      ...kSpeeds.map((factor) => el("option", { value: factor, selected: factor === 1 }, `${factor} ×`)),
    );
    this.player.onChange(() => (speed.value = String(this.player.speed)));
    return el("div", { class: "transport" }, this.play, this.slider, this.clock, speed);
  }

  private options(): HTMLElement {
    const scene = this.scene;
    if (!scene) return el("div");
    const colour = el(
      "select",
      { id: "colouring", change: () => this.setColouring(colour.value as Colouring) },
      ...[["cause", "how it came about"], ["age", "age"], ["force", "contact force"]].map(([value, text]) =>
        el("option", { value }, text)),
    );
    const tick = (text: string, on: boolean, change: (on: boolean) => void) => {
      const box = el("input", { type: "checkbox", checked: on, change: () => change(box.checked) });
      return el("label", {}, box, text);
    };
    return el(
      "div",
      { class: "options" },
      el("span", { class: "views", role: "group", "aria-label": "Views" },
        ...Object.keys(kViews).map((name, i) =>
          el("button", { type: "button", title: `View (${i + 1})`, click: () => scene.look(name) }, name))),
      el("label", {}, "floes by ", colour),
      tick("follow", true, (on) => (scene.follow = on)),
      tick("see through", true, (on) => scene.setSeeThrough(on)),
    );
  }

  private update(): void {
    this.play.textContent = this.player.playing ? "❚❚" : "▶";
    this.slider.value = String(this.player.time);
    this.scene?.show(this.player.time);
    const n = this.scene ? ` · ${this.scene.floes.nVisible} floes` : "";
    this.clock.textContent = `${seconds(this.player.time)} s${n}`;
  }
}

/** Keys that work wherever the focus is, but in fields. */
export function bindKeys(player: Player, replay: Replay, frames: ArrayLike<number>): void {
  const names = Object.keys(kViews);
  const frame = (direction: 1 | -1) => {
    const times = Array.from(frames).filter((time) => direction * (time - player.time) > 1e-9);
    return times.length > 0 ? (direction > 0 ? times[0] : times[times.length - 1]) : player.time + direction * player.duration;
  };
  document.addEventListener("keydown", (event) => {
    const target = event.target as HTMLElement;
    if (event.ctrlKey || event.metaKey || event.altKey || target.closest("select, input:not([type=range])")) return;
    const onButton = target.closest("button, a, summary") !== null;
    const actions: Record<string, () => void> = {
      ArrowLeft: () => player.seek(event.shiftKey ? player.time - 1 : frame(-1)),
      ArrowRight: () => player.seek(event.shiftKey ? player.time + 1 : frame(1)),
      "[": () => player.setSpeed(kSpeeds[Math.max(0, kSpeeds.indexOf(player.speed) - 1)]),
      "]": () => player.setSpeed(kSpeeds[Math.min(kSpeeds.length - 1, kSpeeds.indexOf(player.speed) + 1)]),
      ",": () => player.seek(0),
      ".": () => player.seek(player.duration),
    };
    names.forEach((name, i) => (actions[String(i + 1)] = () => replay.scene?.look(name)));
    if (!onButton) actions[" "] = () => player.toggle();
    const action = actions[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  });
}
