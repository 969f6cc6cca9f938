// SPDX-License-Identifier: GPL-3.0-or-later
// The simulation in the page: its buttons and its drawings, as on the page of a live run.
import { Run } from "../../../report/viewer/src/data";
import { el } from "../../../report/viewer/src/dom";
import { number, seconds } from "../../../report/viewer/src/format";
import { Growing } from "../../../report/viewer/src/growing";
import { type LiveReport, LiveView } from "../../../report/viewer/src/live";
import { Player } from "../../../report/viewer/src/player";
import type { LiveData, Numbers } from "../../../report/viewer/src/types";
import type { Made } from "./core";
import type { CaseStore } from "./store";

/** Wall time between two pictures while it runs [ms]. */
const kPicture = 60;

export class Simulation {
  readonly controls: HTMLElement;
  readonly view = el("div", { class: "simulation" });
  report: LiveReport | null = null;
  running = false;
  done = false;
  /** Simulated seconds per second of the core, since the simulation was begun. */
  speed = NaN;
  private readonly play = el("button", { type: "button", class: "primary wide", click: () => this.toggle() }, "Run");
  private readonly once = el("button", { type: "button", click: () => void this.step() }, "Step");
  private readonly again = el("button", { type: "button", click: () => void this.reset() }, "Reset");
  private readonly newest = el("input", { type: "checkbox", checked: true });
  private readonly state = el("span", { role: "status" });
  private growing: Growing | null = null;
  private shown: LiveView | null = null;
  private made = "";
  private busy = false;
  /** The last act met an error: of the case where it cannot be begun, else of the run. */
  private failed = false;
  private wall = 0;
  private steps = 1;

  constructor(private readonly store: CaseStore) {
    this.controls = el("div", { class: "live" }, this.play, this.once, this.again, el("label", {}, this.newest, "show the newest"), this.state);
    store.onChange(() => this.tell());
    this.tell();
  }

  /** Whether the case has changed since the simulation was begun. */
  get isStale(): boolean {
    return this.made !== "" && this.made !== this.store.text;
  }

  /** Begins anew with the case of the page. */
  async reset(): Promise<void> {
    this.running = false;
    await this.once_at_a_time(async () => {
      const text = this.store.text;
      const made = await this.store.core!.make(text, this.store.name);
      this.made = text;
      this.wall = 0;
      this.speed = NaN;
      this.done = false;
      this.begin(made);
      await this.store.check();  // the message of a run that failed goes
    });
  }

  toggle(): void {
    this.running = !this.running && !this.done;
    this.tell();
    if (this.running) void this.loop();
  }

  /** One time step. */
  async step(): Promise<void> {
    this.running = false;
    await this.once_at_a_time(async () => {
      if (this.isStale || !this.growing) return;
      await this.advance(1);
      this.draw();
    });
  }

  private async loop(): Promise<void> {
    if (this.isStale) await this.reset().then(() => (this.running = this.store.error === ""));
    await this.once_at_a_time(async () => {
      let drawn = performance.now();
      while (this.running && !this.done) {
        const start = performance.now();
        await this.advance(this.steps);
        const took = performance.now() - start;
        this.steps = Math.max(1, Math.min(50, Math.round((this.steps * kPicture) / Math.max(took, 1))));
        if (performance.now() - drawn > kPicture || this.done) {
          drawn = performance.now();
          this.draw();
          await new Promise(requestAnimationFrame);
        }
      }
      this.draw();
    });
    this.running = false;
    this.tell();
  }

  private async once_at_a_time(act: () => Promise<void>): Promise<void> {
    while (this.busy) await new Promise((done) => setTimeout(done, 5));
    this.busy = true;
    this.tell();
    try {
      await act();
      this.failed = false;
    } catch (error) {
      this.running = false;
      this.failed = true;
      this.store.fail(error);
    } finally {
      this.busy = false;
      this.tell();
    }
  }

  private async advance(steps: number): Promise<void> {
    const start = performance.now();
    const { records, time, done } = await this.store.core!.advance(steps);
    this.wall += performance.now() - start;
    this.speed = (1000 * time) / this.wall;
    this.done = done;
    this.growing!.add(records);
  }

  private begin({ head, start }: Made): void {
    this.shown?.dispose();
    const fixed = new Map<string, Numbers>(Object.entries(head.arrays).map(([name, values]) =>
      [name, /triangles|rings|nodes/.test(name) ? Int32Array.from(values) : Float64Array.from(values)]));
    this.growing = new Growing(fixed);
    this.growing.add(start);
    const run = new Run(this.growing.files({ kind: "live", manifest: head.manifest } as LiveData), this.growing.blocks());
    const player = new Player(0);
    this.report = { player, replay: null, loads: null, run };
    this.view.replaceChildren();
    this.shown = new LiveView(run, player, this.view, () => (this.newest.checked = false), this.report);
    this.shown.renew(true);
  }

  private draw(): void {
    if (!this.report || !this.growing || !this.shown) return;
    this.report.run.take(this.growing.blocks());
    this.shown.renew(this.newest.checked);
    this.tell();
  }

  private tell(): void {
    const refused = this.store.error !== "";
    this.play.textContent = this.running ? "Pause" : this.isStale ? "Run again" : "Run";
    this.play.disabled = (refused && !this.running) || (this.done && !this.isStale);
    this.once.disabled = refused || this.busy || this.done || this.isStale;
    this.again.disabled = (refused && !this.failed) || (this.busy && !this.running);
    const run = this.report?.run;
    if (!run) return;
    const pace = Number.isFinite(this.speed) && this.speed > 0 ? ` · ${number(this.speed, 2)} × real time` : "";
    this.state.textContent = `${seconds(run.duration)} of ${number(run.input("time", "duration"), 3)} s · ${run.nEvents} breaks${pace}${this.done ? " · done" : ""}${this.isStale ? " · the case has changed" : ""}`;
  }
}
