// SPDX-License-Identifier: GPL-3.0-or-later
// The report of one run.
import { citeSection } from "./cite";
import { hasReplay, type Run } from "./data";
import { el, section } from "./dom";
import { EventCard } from "./events";
import { deviation, kN, number, seconds } from "./format";
import { closedFormsSection, inputsSection, ledgerSection } from "./inputs";
import { LoadHistory, type Peak } from "./loads";
import { PlanView } from "./plan";
import { Player } from "./player";
import { bindKeys, Replay } from "./replay";
import { statisticsSection } from "./statistics";

function figure(value: string, unit: string, name: string, note = ""): HTMLElement {
  return el("div", { class: "figure" }, el("b", {}, value, unit && el("small", {}, ` ${unit}`)), el("span", {}, name), note && el("em", {}, note));
}

/** What is to be known before the numbers are used; nothing where there is nothing. */
function warnings(run: Run): HTMLElement | null {
  const all = run.data.summary.warnings ?? [];
  if (all.length === 0) return null;
  return el("div", { class: "warnings", role: "note" }, el("b", {}, "Warnings"),
    el("ul", {}, ...all.map(({ id, text }) => el("li", {}, el("code", {}, id), ` ${text}`))));
}

/** An interval of a mean, or why there is none. */
function interval([lower, upper]: [number | null, number | null]): string {
  return lower === null || upper === null ? "no interval: see the warnings" : `95 %: ${kN(lower)} to ${kN(upper)}`;
}

function keyFigures(run: Run): HTMLElement {
  const s = run.data.summary;
  const measured = run.input("reference", "mean_horizontal");
  return el("div", { class: "figures" },
    figure(kN(s.horizontal.mean), "kN", "mean horizontal", interval(s.horizontal.mean_95)),
    figure(kN(s.vertical.mean), "kN", "mean vertical", interval(s.vertical.mean_95)),
    figure(kN(s.horizontal.maximum), "kN", "largest horizontal", `from ${seconds(s.statistics_from)} s on; deviation ${kN(s.horizontal.standard_deviation)}`),
    Number.isFinite(measured)
      ? figure(kN(measured), "kN", "reference mean", `this run: ${deviation(s.horizontal.mean, measured)}`)
      : figure(number(s.fastest_floe, 3), "m/s", "fastest floe"),
    figure(String(s.n_breaks), "", "breaks", `${number(s.breaking_frequency, 3)} a second`),
    figure(String(s.n_floes_born), "", "floes born", `${s.n_floes_present} present, ${s.n_floes_crushed} crushed, ${s.n_floes_broken} broken again`));
}

export interface RunReport {
  player: Player;
  /** Null where no frames were recorded. */
  replay: Replay | null;
  loads: LoadHistory;
  choose: (event: number) => void;
}

function makeReplay(run: Run, player: Player): Replay {
  const replay = new Replay(run, player);
  bindKeys(player, replay, run.column("frame.time"));
  const still = el("img", { class: "still", alt: "Replay at the time of printing" });
  replay.element.prepend(still);
  addEventListener("beforeprint", () => (still.src = replay.still()));
  return replay;
}

/** Says why there is no replay. Poses made up from the start alone would look like the run. */
function noReplay(run: Run): HTMLElement {
  const rate = number(run.input("output", "frames_per_second"));
  return el("p", { class: "note" }, `No frames recorded after the start (output.frames_per_second = ${rate}), so there is no replay. ` +
    "Loads, cracks and the places where floes broke off are complete.");
}

export function showRun(run: Run, parent: HTMLElement): RunReport {
  const player = new Player(run.duration);
  const choose = (event: number, peak?: Peak) => {
    card.show(event, peak);
    plan.select(event);
    if (!peak && event >= 0) player.seek(run.column("event.time")[event]);
  };
  const card = new EventCard(run, choose);
  const plan = new PlanView(run, choose);
  const replay = hasReplay(run.data) ? makeReplay(run, player) : null;
  const loads = new LoadHistory(run, player, (peak) => choose(peak.event, peak));

  const flagged = warnings(run);
  if (flagged) parent.append(flagged);
  parent.append(
    keyFigures(run),
    ...(replay
      ? [el("div", { class: "stage-row" }, replay.element, el("div", { class: "side" }, loads.element, card.element))]
      : [noReplay(run), el("div", { class: "stage-row" }, loads.element, card.element)]),
    section("channel", "Channel and cracks",
      plan.element,
      el("p", { class: "note" }, "Every floe where it broke off (darker: later), the sheet at the end, the structure's waterline at the end, " +
        "and the points where the ice broke. What lies open between floes and sheet was crushed. Click a point for its crack.")),
    statisticsSection(run),
    closedFormsSection(run.data),
    ledgerSection(run),
    inputsSection(run),
    citeSection(run),
  );
  if (run.column("load.time").length > 0) loads.chooseLargest();
  return { player, replay, loads, choose };
}
