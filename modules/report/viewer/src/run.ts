// SPDX-License-Identifier: GPL-3.0-or-later
// The report of one run, perhaps with another beside it.
import { LoadChoice } from "./choice";
import { citeSection } from "./cite";
import { Run } from "./data";
import { el, section } from "./dom";
import { EventCard } from "./events";
import { extremesSection } from "./extremes";
import { comparedFigures, differencesSection, keyFigures } from "./figures";
import { number } from "./format";
import { closedFormsSection, inputsSection, ledgerSection } from "./inputs";
import { LoadHistory, type Overlay, type Peak } from "./loads";
import { PlanView } from "./plan";
import { Player } from "./player";
import { bindKeys, Replay } from "./replay";
import { splitsOf, splitsSection } from "./splits";
import { statisticsSection } from "./statistics";
import type { RunData } from "./types";

/** What is to be known before the numbers are used; nothing where there is nothing. */
function warnings(run: Run, name = ""): HTMLElement | null {
  const all = run.data.summary.warnings ?? [];
  if (all.length === 0) return null;
  return el("div", { class: "warnings", role: "note" }, el("b", {}, name ? `Warnings of ${name}` : "Warnings"),
    el("ul", {}, ...all.map(({ id, text }) => el("li", {}, el("code", {}, id), ` ${text}`))));
}

export interface RunReport {
  player: Player;
  /** Null where no frames were recorded. */
  replay: Replay | null;
  loads: LoadHistory;
  choose: (event: number) => void;
}

function makeReplay(runs: Run[], player: Player, names: string[]): Replay {
  const replay = new Replay(runs, player, names);
  bindKeys(player, replay, () => runs[0].column("frame.time"));
  return replay;
}

/** Says why there is no replay. Poses made up from the start alone would look like the run.
 * @param name of the run, if there are several. */
function noReplay(run: Run, name = ""): HTMLElement {
  const rate = number(run.input("output", "frames_per_second"));
  return el("p", { class: "note" }, `No frames ${name && `of ${name} `}recorded after the start (output.frames_per_second = ${rate}), so there is no replay. ` +
    "Loads, cracks and the places where floes broke off are complete.");
}

/** Names that distinguish two runs. */
function namesOf(runs: Run[]): string[] {
  if (runs.length < 2) return [];
  const names = runs.map(({ name }) => name);
  if (names[0] !== names[1]) return names;
  const seeds = runs.map(({ data }) => data.manifest.seeds?.seed);
  return names.map((name, i) => (seeds[0] !== seeds[1] ? `${name}, seed ${seeds[i]}` : `${name} (${["first", "second"][i]})`));
}

function overlaysOf(run: Run, other: Run | null, names: string[], measured: RunData["measured"]): Overlay[] {
  const overlays: Overlay[] = [];
  if (measured)
    overlays.push({ label: measured.name, colour: "--ink", times: run.column("measured.time"), values: (load) => (load === "Fx" ? run.column("measured.value") : null) });
  if (other) overlays.push({ label: names[1], colour: "--violet", times: other.column("load.time"), values: (load) => other.column(`load.${load}`) });
  return overlays;
}

export function showRun(run: Run, other: Run | null, data: RunData, parent: HTMLElement): RunReport {
  const runs = other ? [run, other] : [run];
  const names = namesOf(runs);
  const player = new Player(Math.max(...runs.map(({ duration }) => duration)));
  const choice = new LoadChoice();
  const choose = (event: number, peak?: Peak) => {
    card.show(event, peak);
    plan.select(event);
    if (!peak && event >= 0) player.seek(run.column("event.time")[event]);
  };
  const splits = splitsOf(run);
  const chooseSplit = (split: number) => {
    plan.selectSplit(split);
    player.seek(splits[split].time);
  };
  const card = new EventCard(run, choose);
  const plan = new PlanView(run, choose, chooseSplit);
  const still = runs.findIndex(({ hasReplay }) => !hasReplay);
  const replay = still < 0 ? makeReplay(runs, player, names) : null;
  const loads = new LoadHistory(run, player, choice, overlaysOf(run, other, names, data.measured), (peak) => choose(peak.event, peak));

  parent.append(...runs.map((each, i) => warnings(each, names[i])).filter((flagged) => flagged !== null));
  const side = el("div", { class: "side" }, loads.element, card.element);
  const beside = replay !== null && !other;
  parent.append(
    other ? comparedFigures(runs, names) : keyFigures(run),
    replay ? el("div", { class: beside ? "stage-row" : "stage-column" }, replay.element, side) : noReplay(runs[still], names[still]),
    ...(replay ? [] : [el("div", { class: "stage-row" }, loads.element, card.element)]),
    ...(other ? [differencesSection(runs, names), el("p", { class: "note" }, `From here on: ${names[0]}.`)] : []),
    section("channel", "Channel and cracks",
      plan.element,
      el("p", { class: "note" }, `The ${run.isField ? "field" : "channel"} from above. `,
        run.nEvents > 0 && el("span", { class: "do" }, "Click a point, or press Enter on it, for its crack."))),
    ...[splitsSection(splits, chooseSplit)].filter((part) => part !== null),
    statisticsSection(run, choice, data.measured),
    extremesSection(run, choice, (time) => player.seek(time)),
    closedFormsSection(run),
    ledgerSection(run),
    inputsSection(run, data.schema),
    citeSection(run),
  );
  if (run.column("load.time").length > 0) loads.chooseLargest();
  return { player, replay, loads, choose };
}
