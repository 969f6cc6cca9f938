// SPDX-License-Identifier: GPL-3.0-or-later
// Load events of the chosen load, and its extremes.
import { kLoads, type LoadChoice } from "./choice";
import type { Run } from "./data";
import { el, section, table } from "./dom";
import { loadText, number, seconds } from "./format";
import { csv, saveButtons, saveText } from "./save";
import type { ExtremeLaw, LoadStatistics } from "./types";

const kShown = 10;

export function extremesSection(run: Run, choice: LoadChoice, onSeek: (time: number) => void): HTMLElement {
  const holder = el("div", { class: "columns even" });
  const show = () => {
    const loads = run.data.loads;
    holder.replaceChildren(...(loads ? [eventsOf(loads[choice.name], choice, onSeek), lawsOf(loads[choice.name], choice)] : [el("p", {}, kTooEarly)]));
  };
  choice.onChange(show);
  show();
  return section("extremes", "Load events and extremes", holder);
}

export const kTooEarly = "The run is over before its statistics begin (output.statistics_from), so it has none.";

/** The largest load events; a click takes the replay there. */
function eventsOf({ events, mean, lower_end }: LoadStatistics, choice: LoadChoice, onSeek: (time: number) => void): HTMLElement {
  const { short, unit: force } = kLoads[choice.name];
  const { unit } = choice;
  const largest = [...events].sort((a, b) => Math.abs(b.peak) - Math.abs(a.peak)).slice(0, kShown);
  const rows = largest.map(({ start, end, peak_time: at, peak, impulse }) => [
    el("button", { type: "button", class: "link", title: "Show this moment", click: () => onSeek(at) }, seconds(at)),
    loadText(peak), seconds(at - start), seconds(end - at), loadText(impulse),
  ]);
  const save = () => saveText(`load-events-${choice.name}.csv`,
    csv(([["start", "s"], ["end", "s"], ["peak_time", "s"], ["peak", force], ["impulse", `${force} s`]] as const).map(([key, of]) =>
      [`${key} [${of}]`, events.map((event) => event[key])])), "text/csv");
  return el("div", {},
    el("h3", {}, `Load events of ${short}`, " ", saveButtons("load events", { CSV: save })),
    events.length === 0 ? el("p", {}, `The load ${lower_end ? "falls through its mean and rises" : "rises through its mean and falls"} back nowhere.`) : el("div", {},
      el("p", { class: "note" }, `${events.length} times the load ${lower_end ? "falls" : "rises"} through its mean of ${loadText(mean)} ${unit} and ${lower_end ? "rises" : "falls"} back, noise left out. ` +
        (events.length > kShown ? `The ${kShown} largest:` : "All, the largest first:")),
      table(["peak at [s]", `peak [${unit}]`, "rise [s]", "fall [s]", `impulse [${unit} s]`], rows, { id: "load-events" })));
}

function lawsOf(s: LoadStatistics, choice: LoadChoice): HTMLElement {
  const { unit } = choice;
  const period = duration(s.extremes.return_period);
  const level = ({ level: value, level_95: range, not_fitted: why }: ExtremeLaw): string =>
    value === undefined ? `none: ${why ?? ""}` : `${loadText(value)} ${unit}` + (range ? `, 95 %: ${range.map((end) => (end === null ? "no bound" : loadText(end))).join(" to ")}` : "");
  const same = s.laws.every((law) => law.level === undefined && law.not_fitted === s.laws[0].not_fitted);
  const { law, reason } = s.recommended;
  return el("div", {},
    el("h3", {}, `Load that is ${s.lower_end ? "undershot" : "exceeded"} once in ${period} on average`),
    law === null
      ? el("p", { class: "note" }, `No level: ${reason ?? ""}.`)
      : el("p", {}, el("b", {}, level(s.recommended)), ` by ${law}: ${reason ?? ""}.`),
    !same && table(["law", "level"], s.laws.map((each) => [each.law ?? "", level(each)]), { id: "laws" }),
    ...s.warnings.map((warning) => el("p", { class: "note" }, `${warning}.`.replace(/\.\.$/, "."))));
}

/** Without the zeros that end a fraction. */
export const duration = (time: number): string =>
  (time >= 3600 ? `${number(time / 3600, 3)} h` : `${number(time, 3)} s`).replace(/(\.\d*?)0+ /, "$1 ").replace(". ", " ");
