// SPDX-License-Identifier: GPL-3.0-or-later
// Closed forms, ledger, energy, inputs and manifest: the tables.
import uPlot from "uplot";
import { axis, Chart } from "./charts";
import type { InputValue, Run } from "./data";
import { css, el, section, table } from "./dom";
import { schemaOf } from "./campaign_names";
import { bytes, degrees, energyText, energyUnit, loadText, loadUnit, number, percent, seconds, unitText } from "./format";
import type { Manifest, RunFiles, Schema } from "./types";

/** Symbols of the closed forms, as docs/theory/standards.md has them. */
const kSymbols: Record<string, string> = {
  H_B: "breaking the sheet", H_P: "pushing the sheet through rubble", H_R: "ice that rides up the slope", H_L: "lifting the rubble",
  H_T: "turning blocks at the top of the slope", V_B: "vertical part of the breaking", V_R: "vertical part of the ride",
  "P of one wedge": "vertical load that breaks one wedge", "p w h": "pressure times width times thickness",
  R_c: "crushing at the stem", R_b: "bending", R_s: "ice pressed under the hull",
};

/** Only those that the table shows. */
function symbolsOf({ loads }: RunFiles["closed_forms"]): string {
  const used = new Set(loads.flatMap((load) => Object.keys(load.components ?? {})));
  return Object.entries(kSymbols).filter(([name]) => used.has(name)).map(([name, meaning]) => `${name}: ${meaning}`).join(" · ");
}

export function closedFormsSection({ data, isField }: Run): HTMLElement {
  const rows = data.closed_forms.loads.map((load) => {
    const components = Object.entries(load.components ?? {}).map(([name, value]) => `${name} ${loadText(value)}`);
    const note = load.not_applicable ?? components.join(", ") + (load.in_range === false ? "; outside the formula's range" : "");
    return [load.source, load.method, loadText(load.horizontal), loadText(load.vertical), note];
  });
  const { horizontal, vertical } = data.summary;
  const high = (name: "Fx" | "Fz") => data.loads?.[name].quantile_99;
  const lower = ([["horizontal", "Fx"], ["vertical", "Fz"]] as const).filter(([, name]) => data.loads?.[name].lower_end);
  const note = lower.length > 0 ? `${lower.map(([way]) => way).join(" and ")}: above it 99 % of the time` : "";
  rows.push(["this run", "mean", loadText(horizontal.mean), loadText(vertical.mean), ""]);
  rows.push(["this run", "99 % quantile", loadText(high("Fx")), loadText(high("Fz")), note]);
  return section("closed-forms", "Closed forms",
    el("p", {}, `Loads of standards and textbooks for the same structure and ice: ${data.closed_forms.kind}.${isField ? " They are for level ice, not for a field of floes." : ""}`),
    table(["source", "method", `horizontal [${loadUnit()}]`, `vertical [${loadUnit()}]`, `components [${loadUnit()}]`], rows),
    el("p", { class: "note" }, symbolsOf(data.closed_forms)));
}

const kAccounts = ["sheet", "floes", "crushed", "deleted", "brash"] as const;

const shown = (_: uPlot, n: number | null): string => (n === null ? "" : number(n, 4));

function ledgerChart(run: Run): Chart {
  const times = Array.from(run.column("load.time"));
  const colours: Record<string, string> = { floes: "--teal", crushed: "--red", deleted: "--ochre", brash: "--muted" };
  const names = Object.keys(colours);
  const data = [times, ...names.map((name) => Array.from(run.column(`load.area_${name}`)))] as uPlot.AlignedData;
  return new Chart("Ledger of the area", 200, () => ({
    data,
    heads: ["time [s]", ...names.map((name) => `${name} [m2]`)],
    options: {
      scales: { x: { time: false } },
      axes: [axis("time [s]"), axis("area [m²]", { size: 50 })],
      series: [{ label: "time", value: shown }, ...names.map((name) => ({ label: name, stroke: css(colours[name]), width: 1.3, points: { show: false }, value: shown }))],
    },
  }), () => "Where the ice has gone.");
}

/** What became of the ice in each account. */
const kMeanings: Record<typeof kAccounts[number], string> = {
  sheet: "not broken yet", floes: "afloat in pieces", crushed: "at the edges of sheets", deleted: "with floes that were crushed",
  brash: "in pieces too small to be floes",
};

/** Loss name, what it is, in the order of the summary. */
const kLosses: Record<string, string> = {
  edge: "crushing and its friction at the sheet's edge",
  bending: "bending of the sheet's edge, where it moves",
  structure_contact: "crushing and impact, floes against structure",
  structure_friction: "friction, floes against structure",
  sheet_contact: "crushing and impact, floes against sheet",
  sheet_friction: "friction, floes against sheet",
  bed_contact: "crushing and impact, floes against bed",
  bed_friction: "friction, floes against bed",
  floe_contact: "crushing and impact between floes",
  floe_friction: "friction between floes",
  drag: "form and rotational drag of the water",
  skin_friction: "skin friction of the water",
};

function energyTable(data: RunFiles): HTMLElement {
  const { losses, ...energy } = data.summary.energy;
  const work = energy.work as number;
  const row = (name: string, value: number) => [name, energyText(value), work !== 0 ? percent(value / work) : "–"];
  return table(["energy at the end", energyUnit(), "of the work"], [
    row("work of the structure", work),
    ...Object.entries(losses as Record<string, number>).map(([name, value]) => row(kLosses[name] ?? name, value)),
    row("motion of the floes", energy.kinetic_energy as number),
    row("height of the floes", energy.potential_energy as number),
    row("left with ice that was deleted, broke or fell asleep", energy.removed_energy as number),
    row("births (added to the work)", energy.birth_energy as number),
    row("error of the integration in time", energy.energy_error as number),
  ], { id: "energy-table" });
}

export function ledgerSection(run: Run): HTMLElement {
  const { ledger } = run.data.summary;
  const area = (name: string) => Number(ledger[name]);
  return section("ledger", "Ledger and energy",
    el("div", { class: "columns even" },
      el("div", {},
        table(["area", "m²", "of the ice"], [
          ["initial", area("initial").toFixed(4), "100.0 %"],
          ...kAccounts.map((name) => [el("span", {}, name, " ", el("small", {}, kMeanings[name])), area(name).toFixed(4), percent(area(name) / area("initial"))]),
          [`rounding (${ledger.n_rounded} crossings)`, number(area("snap"), 3), ""],
        ]),
        el("p", { class: ledger.closes ? "note good" : "note bad" },
          ledger.closes ? "The accounts add up to the initial area exactly." : "THE LEDGER DOES NOT CLOSE."),
        ledgerChart(run).element),
      el("div", {}, energyTable(run.data))));
}

/** Letters of a text that may continue in the next line. */
const kLong = 24;

/** A value as text: numbers rounded for the eye, angles in degrees as well; the exact text is its tooltip. */
function valueOf({ value, text, unit }: InputValue): HTMLElement {
  const rounded = typeof value === "number" ? number(value, 6).replace(/(\.\d*?)0+$/, "$1").replace(/\.$/, "") : text;
  const angle = unit === "rad" && typeof value === "number" ? ` = ${degrees(value)}°` : "";
  const shown = unitText(unit);
  return el("span", { class: text.length > kLong ? "value long" : "value", title: text || "none" }, rounded || "none", shown && el("small", {}, ` ${shown}${angle}`));
}

/** A description of the schema, which has names of commands and choices between backticks. */
const described = (text: string): (Node | string)[] => text.split("`").map((part, i) => (i % 2 === 1 ? el("code", {}, part) : part));

function inputRows(inputs: Record<string, Record<string, InputValue>>, schema: Schema): HTMLElement[] {
  return Object.entries(inputs).filter(([, keys]) => Object.keys(keys).length > 0).map(([name, keys]) => {
    const meaning = (key: string) => described(schemaOf(schema, key)?.description ?? "");
    return el("details", { open: true },
      el("summary", {}, el("code", {}, `[${name}]`), " ", ...meaning(name)),
      table([], Object.entries(keys).map(([key, input]) => [
        el("code", {}, key), valueOf(input),
        el("span", { class: "meaning" }, ...meaning(`${name}.${key}`)),
      ])));
  });
}

function files(title: string, list: Manifest["inputs"]): HTMLElement | null {
  if (!list || list.length === 0) return null;
  return el("div", {}, el("h3", {}, title),
    table(["file", "size", "SHA-256"], list.map((file) => [file.path, bytes(file.bytes), el("code", { class: "hash" }, file.sha256)])));
}

/** The inputs and the plan, which may be one of the inputs. */
function inputsOf({ plan, inputs = [] }: Manifest): Manifest["inputs"] {
  return plan && !inputs.some(({ path }) => path === plan.path) ? [plan, ...inputs] : inputs;
}

export function manifestTables(manifest: Manifest): HTMLElement {
  const v = manifest.volatile ?? {};
  const rows: [string, string][] = [["program", `${manifest.program?.name ?? "brash"} ${manifest.program?.version ?? ""}`]];
  for (const [name, version] of Object.entries(manifest.built_with ?? {})) rows.push([name.replace(/_/g, " "), version]);
  if (manifest.glibc) rows.push(["glibc", manifest.glibc]);
  if (manifest.seeds) rows.push(["seed, replicate", `${manifest.seeds.seed}, ${manifest.seeds.replicate}`]);
  if (v.started_at) rows.push(["started", v.started_at]);
  if (v.wall_seconds !== undefined) rows.push(["wall time", `${seconds(v.wall_seconds, 1)} s`]);
  if (v.host_cpu) rows.push(["processor", v.host_cpu]);
  return el("div", { class: "columns even" }, el("div", {}, el("h3", {}, "Manifest"), table([], rows)), el("div", {},
    files("Inputs", inputsOf(manifest)), files("Outputs", manifest.outputs)));
}

export function inputsSection(run: Run, schema: Schema): HTMLElement {
  return section("inputs", "Inputs and manifest",
    el("p", {}, "Every input of the run, defaults included, in SI; the resolved case as a file is in the manifest, and repeats the run to the bit."),
    el("div", { class: "inputs" }, ...inputRows(run.inputs, schema)),
    manifestTables(run.data.manifest));
}
