// SPDX-License-Identifier: GPL-3.0-or-later
// The replay with its controls; several runs go by one clock.
import type { Run } from "./data";
import { el } from "./dom";
import { canFilm, Film, saveFilm } from "./film";
import type { Colouring } from "./floe_mesh";
import { seconds } from "./format";
import type { Player } from "./player";
import { pixels, save } from "./save";
import type { ReplayScene } from "./scene";
import { Stage } from "./stage";
import { kViews } from "./views";

const kSpeeds = [0.1, 0.25, 0.5, 1, 2, 4];
const kColourings: [Colouring, string][] = [["cause", "how it came about"], ["age", "age"], ["force", "contact force"]];

export class Replay {
  readonly element: HTMLElement;
  readonly stages: Stage[];
  private readonly play = el("button", { type: "button", class: "primary", title: "Play or pause (space)" }, "▶");
  private readonly slider: HTMLInputElement;
  private readonly clock = el("output", { class: "clock" });
  private film: Film | null = null;
  /** Called when a reader takes the replay to another time. */
  onTouch: () => void = () => {};

  /** @param titles of the runs, if there are several. */
  constructor(
    runs: Run[],
    private readonly player: Player,
    titles: string[] = [],
  ) {
    this.stages = runs.map((run, i) => new Stage(run, titles[i]));
    this.slider = el("input", {
      type: "range", min: 0, max: player.duration, step: "any", value: 0, "aria-label": "Time of the replay",
      input: () => {
        this.onTouch();
        player.seek(Number(this.slider.value));
      },
    });
    this.play.addEventListener("click", () => {
      this.onTouch();
      player.toggle();
    });
    this.element = el("figure", { class: "replay" }, el("div", { class: "stages" }, ...this.stages.map((stage) => stage.element)),
      this.transport(), this.options());
    player.onChange(() => this.update());
    this.setColouring("cause");
    this.update();
  }

  /** Of the first run; null without WebGL. */
  get scene(): ReplayScene | null {
    return this.stages[0].scene;
  }

  get scenes(): ReplayScene[] {
    return this.stages.flatMap(({ scene }) => (scene ? [scene] : []));
  }

  /** Follows runs that have grown. */
  renew(): void {
    this.slider.max = String(this.player.duration);
    for (const stage of this.stages) stage.renew();
  }

  /** Gives back what the browser holds for the pictures; the replay is of no further use. */
  dispose(): void {
    this.player.pause();
    for (const { renderer } of this.scenes) {
      renderer.dispose();
      renderer.forceContextLoss();
    }
  }

  setColouring(colouring: Colouring): void {
    for (const stage of this.stages) stage.setColouring(colouring);
    for (const scene of this.scenes) scene.show(this.player.time);
  }

  look(name: string): void {
    for (const scene of this.scenes) scene.look(name);
  }

  /** Draws the first run into an image. */
  still(): string {
    return this.stages[0].picture();
  }

  /** Makes a film of the run from its start, or ends the one that is being made. */
  async record(onEnd = saveFilm(this.stages[0].run.name)): Promise<void> {
    if (this.film) return this.film.stop();
    for (const scene of this.scenes) scene.setMoving(true);
    this.film = new Film(this.player, this.stages.map(({ canvas }) => canvas), () => this.scenes.forEach((scene) => scene.drawNow()));
    onEnd(await this.film.record().finally(() => (this.film = null)));
    this.update();
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
    if (this.scenes.length === 0) return el("div");
    const colour = el("select", { id: "colouring", change: () => this.setColouring(colour.value as Colouring) },
      ...kColourings.map(([value, text]) => el("option", { value }, text)));
    const tick = (text: string, change: (scene: ReplayScene, on: boolean) => void) => {
      const box = el("input", { type: "checkbox", checked: true, change: () => this.scenes.forEach((scene) => change(scene, box.checked)) });
      return el("label", {}, box, text);
    };
    return el(
      "div",
      { class: "options" },
      el("span", { class: "views", role: "group", "aria-label": "Views" },
        ...Object.keys(kViews).map((name, i) =>
          el("button", { type: "button", title: `View (${i + 1})`, click: () => this.look(name) }, name))),
      el("label", {}, "floes by ", colour),
      tick("follow", (scene, on) => (scene.follow = on)),
      tick("see through", (scene, on) => scene.setSeeThrough(on)),
      this.saves(),
    );
  }

  private saves(): HTMLElement {
    const picture = async () => {
      for (const { scene, canvas, run } of this.stages) {
        scene?.drawNow();
        save(`${run.name}-${seconds(this.player.time)}s.png`, await pixels(canvas));
      }
    };
    return el("span", { class: "saves", role: "group", "aria-label": "Save the replay" },
      el("button", { type: "button", title: "Save the picture as PNG", click: () => void picture() }, "PNG"),
      el("button", {
        type: "button", disabled: !canFilm(), click: () => void this.record(),
        title: canFilm() ? "Play the run once and save it as a film (WebM); again: end the film here" : "This browser makes no films",
      }, "film"));
  }

  private update(): void {
    const { time, playing } = this.player;
    this.play.textContent = playing ? "❚❚" : "▶";
    this.play.setAttribute("aria-label", playing ? "Pause" : "Play");
    this.slider.value = String(time);
    this.slider.setAttribute("aria-valuetext", `${seconds(time)} s`);
    for (const scene of this.scenes) {
      scene.show(time);
      scene.setMoving(playing || this.film !== null);
    }
    const n = this.scenes.map((scene) => scene.floes.nVisible).join(" and ");
    this.clock.textContent = `${this.film ? "● " : ""}${seconds(time)} s${n && ` · ${n} floes`}`;
  }
}

/** Keys that work wherever the focus is, but in fields; until `signal` ends them. */
export function bindKeys(player: Player, replay: Replay, frames: () => ArrayLike<number>, onUse = () => {}, signal?: AbortSignal): void {
  const frame = (direction: 1 | -1) => {
    const times = Array.from(frames()).filter((time) => direction * (time - player.time) > 1e-9);
    return times.length > 0 ? (direction > 0 ? times[0] : times[times.length - 1]) : player.time + direction * player.duration;
  };
  document.addEventListener("keydown", (event) => {
    const target = event.target as HTMLElement;
    if (event.ctrlKey || event.metaKey || event.altKey || target.closest("select, textarea, input:not([type=range])")) return;
    const onButton = target.closest("button, a, summary") !== null;
    const actions: Record<string, () => void> = {
      ArrowLeft: () => player.seek(event.shiftKey ? player.time - 1 : frame(-1)),
      ArrowRight: () => player.seek(event.shiftKey ? player.time + 1 : frame(1)),
      "[": () => player.setSpeed(kSpeeds[Math.max(0, kSpeeds.indexOf(player.speed) - 1)]),
      "]": () => player.setSpeed(kSpeeds[Math.min(kSpeeds.length - 1, kSpeeds.indexOf(player.speed) + 1)]),
      ",": () => player.seek(0),
      ".": () => player.seek(player.duration),
    };
    Object.keys(kViews).forEach((name, i) => (actions[String(i + 1)] = () => replay.look(name)));
    if (!onButton) actions[" "] = () => player.toggle();
    const action = actions[event.key];
    if (!action) return;
    event.preventDefault();
    if (!/^\d$/.test(event.key)) onUse();
    action();
  }, { signal });
}
