// SPDX-License-Identifier: GPL-3.0-or-later
// The page of a run in progress: what the server streams becomes the same replay, loads and cracks as in a report.
import { LoadChoice } from "./choice";
import { type Blocks, Run } from "./data";
import { el, section } from "./dom";
import { EventCard } from "./events";
import { number, seconds } from "./format";
import { Growing, type Records } from "./growing";
import { LoadHistory } from "./loads";
import { PlanView } from "./plan";
import { Player } from "./player";
import { bindKeys, Replay } from "./replay";
import { splitsOf } from "./splits";
import type { LiveData } from "./types";

export interface LiveReport {
  player: Player;
  replay: Replay | null;
  loads: LoadHistory | null;
  run: Run;
}

/** Time between two pictures of a run in progress [ms]. A browser that draws all the time slows the run on its
 * machine. */
const kPause = 300;
/** Time without a picture over the time that one took: pictures of a long run take longer. */
const kRest = 2;

/** Asks the server for something. */
const wish = (what: "pause" | "resume" | "stop") => void fetch(what, { method: "POST" });

/** The state of the run in words, and what can be asked of it. */
class Controls {
  private readonly state = el("span", { role: "status" }, "waiting for the first step");
  private readonly pause = el("button", { type: "button", click: () => wish(this.paused ? "resume" : "pause") }, "Pause the run");
  private readonly stop = el("button", { type: "button", click: () => wish("stop") }, "Stop the run");
  private readonly newest = el("input", { type: "checkbox", checked: true });
  private paused = false;
  readonly element = el("div", { class: "live" }, this.pause, this.stop, el("label", {}, this.newest, "show the newest"), this.state);

  get followsNewest(): boolean {
    return this.newest.checked;
  }

  letGo(): void {
    this.newest.checked = false;
  }

  setPaused(paused: boolean): void {
    this.paused = paused;
    this.pause.textContent = paused ? "Continue the run" : "Pause the run";
  }

  tell(text: string): void {
    this.state.textContent = text;
  }

  end(text: string): void {
    this.tell(text);
    this.pause.disabled = this.stop.disabled = true;
  }
}

export function showLive(data: LiveData, blocks: Blocks, parent: HTMLElement): LiveReport {
  const growing = new Growing(blocks);
  const run = new Run(growing.files(data), growing.blocks());
  const player = new Player(0);
  const controls = new Controls();
  const report: LiveReport = { player, replay: null, loads: null, run };
  parent.append(controls.element);
  const duration = run.input("time", "duration");
  let view: LiveView | null = null;
  let renewing = false;
  let nextRenewal = 0;
  const renew = () => {
    renewing = false;
    const start = performance.now();
    run.take(growing.blocks());
    view ??= new LiveView(run, player, parent, () => controls.letGo(), report);
    view.renew(controls.followsNewest);
    controls.tell(`${seconds(run.duration)} of ${number(duration, 3)} s`);
    const end = performance.now();
    nextRenewal = end + Math.max(kPause, kRest * (end - start));
  };
  // One picture for all that has come, and none while nobody looks. The run has the processor first.
  const renewSoon = () => setTimeout(() => renewing && !document.hidden && renew(), Math.max(0, nextRenewal - performance.now()));
  document.addEventListener("visibilitychange", renewSoon);
  const events = new EventSource("events");
  events.addEventListener("records", ({ data: text }: MessageEvent<string>) => {
    growing.add(JSON.parse(text) as Records);
    if (!renewing) renewSoon();
    renewing = true;
  });
  events.addEventListener("paused", ({ data: text }: MessageEvent<string>) => controls.setPaused(text === "true"));
  events.addEventListener("end", ({ data: text }: MessageEvent<string>) => {
    events.close();
    if (renewing) renew();
    controls.end(JSON.parse(text) as string);
  });
  events.addEventListener("error", () => controls.tell("The run does not answer. The page tries again."));
  return report;
}

/** The drawings of a run in progress, made again as far as it has grown. */
export class LiveView {
  private readonly ended = new AbortController();
  private readonly choice = new LoadChoice();
  private readonly card: EventCard;
  private readonly replay: Replay;
  private readonly loads: LoadHistory;
  private readonly channel = el("div");
  private plan: PlanView;
  /** Cracks, floes and splits that the plan shows. */
  private drawn: number[] = [];

  constructor(private readonly run: Run, private readonly player: Player, parent: HTMLElement, private readonly onLook: () => void, report: LiveReport) {
    this.card = new EventCard(run, (event) => this.choose(event));
    this.replay = report.replay = new Replay([run], player);
    this.loads = report.loads = new LoadHistory(run, player, this.choice, [], (peak) => {
      onLook();
      this.card.show(peak.event, peak);
      this.plan.select(peak.event);
    });
    this.plan = this.makePlan();
    this.channel.append(this.plan.element);
    this.replay.onTouch = onLook;
    bindKeys(player, this.replay, () => run.column("frame.time"), onLook, this.ended.signal);
    parent.append(
      el("div", { class: "stage-row" }, this.replay.element, el("div", { class: "side" }, this.loads.element, this.card.element)),
      section("channel", "Channel and cracks", this.channel));
  }

  /** Takes the view out of the page's hands: another takes its place. */
  dispose(): void {
    this.ended.abort();
    this.replay.dispose();
  }

  renew(toNewest: boolean): void {
    this.player.duration = this.run.duration;
    this.replay.renew();
    this.loads.renew();
    this.renewPlan(toNewest);
    this.player.seek(toNewest ? this.run.duration : this.player.time);
  }

  private renewPlan(toNewest: boolean): void {
    const { nEvents, nFloes } = this.run;
    const now = [nEvents, nFloes, this.run.column("split.time").length];
    const isNewest = toNewest && nEvents !== this.drawn[0];
    if (now.some((n, i) => n !== this.drawn[i]) || !this.plan.follow()) {
      this.drawn = now;
      this.plan = this.makePlan();
      this.channel.replaceChildren(this.plan.element);
      if (!isNewest) this.plan.select(this.card.event);
    }
    if (isNewest) this.choose(nEvents - 1, false);
    else if (this.card.event < 0) this.card.show(-1);  // it shows whether the ice has broken
  }

  private makePlan(): PlanView {
    const splits = splitsOf(this.run);
    const plan = new PlanView(this.run, (event) => this.choose(event), (split) => {
      this.onLook();
      plan.selectSplit(split);
      this.player.seek(splits[split].time);
    }, "now");
    return plan;
  }

  /** @param byReader who then looks at this and not at the newest. */
  private choose(event: number, byReader = true): void {
    if (byReader) this.onLook();
    this.card.show(event);
    this.plan.select(event);
    if (byReader && event >= 0) this.player.seek(this.run.column("event.time")[event]);
  }
}
