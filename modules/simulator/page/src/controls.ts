// SPDX-License-Identifier: GPL-3.0-or-later
// The few inputs that change a simulation most. They write into the text of the case.
import { el } from "../../../report/viewer/src/dom";
import { number } from "../../../report/viewer/src/format";
import { valueIn } from "./case_text";
import type { CaseStore } from "./store";

interface Control {
  section: string;
  key: string;
  /** Section in which a case may write the key instead. */
  longForm?: string;
  label: string;
  unit: string;
  /** SI of one unit. */
  size: number;
  least: number;
  most: number;
  step: number;
}

const kControls: Control[] = [
  { section: "ice", key: "thickness", label: "Thickness of the ice", unit: "m", size: 1, least: 0.05, most: 2, step: 0.01 },
  { section: "ice", key: "flexural_strength", label: "Flexural strength", unit: "kPa", size: 1e3, least: 50, most: 1500, step: 1 },
  { section: "structure", key: "angle", label: "Angle of the structure", unit: "deg", size: Math.PI / 180, least: 20, most: 85, step: 0.1 },
  { section: "structure", key: "waterline_width", label: "Width at the waterline", unit: "m", size: 1, least: 1, most: 30, step: 0.1 },
  { section: "structure", key: "speed", longForm: "structure.motion", label: "Speed", unit: "m/s", size: 1, least: 0.05, most: 4, step: 0.001 },
  { section: "ice", key: "friction_structure", label: "Friction, ice on structure", unit: "", size: 1, least: 0, most: 1, step: 0.001 },
];

/** One choice of a few names. */
function choice(store: CaseStore, section: string, key: string, label: string, names: string[]): HTMLElement {
  const select = el("select", { change: () => store.setKey(section, key, JSON.stringify(select.value)) },
    ...names.map((name) => el("option", { value: name }, name)));
  store.onChange(() => {
    const value = store.resolved[section]?.[key]?.value;
    if (typeof value === "string" && store.error === "") select.value = value;
  });
  return el("label", { class: "control" }, el("span", {}, label), select);
}

function slider(store: CaseStore, control: Control): HTMLElement {
  const { section, key, longForm, label, unit, size, least, most, step } = control;
  const name = `${label}${unit && ` [${unit}]`}`;
  const place = () => (longForm && valueIn(store.text, longForm, key) !== null ? longForm : section);
  const write = (typed: string) => store.setKey(place(), key, unit === "" ? typed : JSON.stringify(`${typed} ${unit}`));
  const range = el("input", { type: "range", min: least, max: most, step, "aria-label": name, input: () => {
    field.value = range.value;
    write(range.value);
  } });
  const field = el("input", { type: "number", step: "any", "aria-label": `${name}, as a number`, change: () => {
    range.value = field.value;
    write(field.value);
  } });
  const row = el("div", { class: "control", role: "group", "aria-label": label }, el("span", {}, label, unit && el("small", {}, ` [${unit}]`)), range, field);
  store.onChange(() => {
    const value = store.resolved[section]?.[key]?.value;
    row.hidden = store.error === "" && typeof value !== "number";
    if (typeof value !== "number" || store.error !== "" || document.activeElement === field) return;
    const shown = String(Number((value / size).toPrecision(9)));
    field.value = shown;
    if (document.activeElement !== range) range.value = shown;
  });
  return row;
}

/** Offers a case file for loading. */
function loader(store: CaseStore): HTMLElement {
  const file = el("input", { type: "file", accept: ".toml,text/plain", class: "hidden-file", tabindex: -1, "aria-hidden": "true", change: async () => {
    const chosen = file.files?.[0];
    if (chosen) store.set(await chosen.text(), chosen.name);
    file.value = "";
  } });
  return el("span", {}, el("button", { type: "button", click: () => file.click() }, "Load a case file…"), file);
}

/** The errors of the case, in the program's words, and its warnings. */
export function messages(store: CaseStore): HTMLElement {
  const error = el("pre", { class: "complaint", role: "alert", hidden: true });
  const warnings = el("ul");
  const box = el("div", { class: "warnings", role: "note", hidden: true }, el("b", {}, "Warnings"), warnings);
  store.onChange(() => {
    if (error.textContent !== store.error) error.textContent = store.error;
    error.hidden = store.error === "";
    const all = store.error === "" ? store.warnings : [];
    box.hidden = all.length === 0;
    warnings.replaceChildren(...all.map(({ id, text }) => el("li", {}, el("code", {}, id), ` ${text}`)));
  });
  return el("div", {}, error, box);
}

export function controlPanel(store: CaseStore, copy: HTMLElement): HTMLElement {
  return el("div", { class: "controls", role: "group", "aria-label": "The case" },
    choice(store, "structure", "kind", "Structure", ["cone", "faceted-cone", "plane", "wedge-bow"]),
    choice(store, "algorithm", "preset", "Laws", ["brash", "paper"]),
    ...kControls.map((control) => slider(store, control)),
    el("div", { class: "bar" }, loader(store), copy));
}

/** Derived lengths, and the loads of standards and textbooks. */
export function besides(store: CaseStore): HTMLElement {
  const derived = el("tbody");
  const loads = el("tbody");
  store.onChange(() => {
    const { description } = store;
    if (!description) return;
    derived.replaceChildren(...description.derived.map(({ name, value, unit }) =>
      el("tr", {}, el("th", { scope: "row" }, name), el("td", { class: "number" }, `${number(value)}${unit === "1" ? "" : ` ${unit}`}`))));
    const kN = (value: number | undefined) => (value === undefined ? "–" : (value / 1e3).toFixed(1));
    loads.replaceChildren(...description.loads.loads.map(({ source, method, horizontal, vertical, not_applicable }) =>
      el("tr", {}, el("th", { scope: "row" }, `${source}: ${method}`), el("td", { class: "number" }, kN(horizontal)), el("td", { class: "number" }, kN(vertical)), el("td", {}, not_applicable ?? ""))));
  });
  const scrolls = { class: "table", tabindex: 0, role: "group" };
  return el("div", { class: "columns" },
    el("div", {}, el("h3", {}, "Derived"), el("div", { ...scrolls, "aria-label": "Derived lengths and times" }, el("table", {}, derived))),
    el("div", {}, el("h3", {}, "Closed forms"), el("div", { ...scrolls, "aria-label": "Closed-form loads" }, el("table", {},
      el("thead", {}, el("tr", {}, ...["method", "horizontal [kN]", "vertical [kN]", "note"].map((name) => el("th", { scope: "col" }, name)))), loads))));
}
