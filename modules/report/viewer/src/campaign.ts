// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a campaign: results with intervals over what was varied, and every run.
import { type Axes, axesOf, differing } from "./campaign_axes";
import { kMostRows, listChart } from "./campaign_list";
import { decimalsOf, inputOf, kLabel, meaningOf, meanText, resultOf, settingName, titleOf, valueOf } from "./campaign_names";
import { multiples, type Runs } from "./campaign_trends";
import { el, groupedTable, section } from "./dom";
import { number } from "./format";
import { manifestTables } from "./inputs";
import { saveButtons, saveText } from "./save";
import type { CampaignData, CampaignSetting } from "./types";

/** Columns first to look at; the rest follows. */
const kFirst = ["horizontal.mean", "vertical.mean", "horizontal.standard_deviation", "horizontal.quantile_99", "horizontal.maximum", "breaking_frequency"];
const kMostColumns = 6;
const kMostDrawn = 4;

/** Rows of a CSV file as the campaign writes it; cells may be in quotes. */
export function parseCsv(text: string): string[][] {
  const cells = (line: string) =>
    [...line.matchAll(/("(?:[^"]|"")*"|[^,]*)(?:,|$)/g)].slice(0, -1).map((m) => m[1].replace(/^"|"$/g, "").replace(/""/g, '"'));
  return text.split("\n").filter((line) => line !== "").map((line) => cells(line + ","));
}

/** The rows of `campaign.csv` by the setting of each. */
class Table {
  readonly rows = new Map<string, string[][]>();
  private readonly head: string[];

  constructor(text: string) {
    const [head, ...body] = parseCsv(text);
    this.head = head;
    for (const row of body) {
      const setting = this.cell(row, "setting");
      this.rows.set(setting, [...(this.rows.get(setting) ?? []), row]);
    }
  }

  cell(row: string[], column: string): string {
    return row[this.head.indexOf(column)] ?? "";
  }

  readonly runs: Runs = (setting, column) =>
    (this.rows.get(setting) ?? []).map((row) => this.cell(row, column)).filter((text) => text !== "").map(Number);
}

/** Settings under the values of the first input, if there are others: its value, and its settings. */
function groupsOf(data: CampaignData, keys: string[]): [string, CampaignSetting[]][] {
  const groups = new Map<string, CampaignSetting[]>();
  for (const setting of data.summary.settings) {
    const name = keys.length > 1 ? `${inputOf(data, keys[0]).name} ${valueOf(data, setting, keys[0])}` : "";
    groups.set(name, [...(groups.get(name) ?? []), setting]);
  }
  return [...groups];
}

function settingsTable(data: CampaignData, keys: string[], columns: string[]): HTMLElement {
  const inner = keys.length > 1 ? keys.slice(1) : keys;
  const named = keys.includes(kLabel);
  const decimals = columns.map((column) => decimalsOf(data.summary.settings.map(({ statistics }) => statistics[column]), resultOf(column).scale));
  const differs = (setting: CampaignSetting) =>
    differing(data, setting, keys).map((key) => `${inputOf(data, key).name}: ${valueOf(data, setting, key)}`).join(", ") || "–";
  const link = (setting: CampaignSetting, text: string) => el("a", { href: `#${anchorOf(data, setting)}`, title: "Its runs" }, text);
  const row = (setting: CampaignSetting) => [
    ...(inner.length > 0 ? inner.map((key, i) => (i === 0 ? link(setting, valueOf(data, setting, key)) : valueOf(data, setting, key))) : [link(setting, setting.setting)]),
    setting.n_failed > 0 ? `${setting.n_done} done, ${setting.n_failed} failed` : String(setting.n_done),
    ...columns.map((column, i) => meanText(setting.statistics[column], resultOf(column).scale, decimals[i])),
    ...(named ? [el("div", { class: "unlike" }, differs(setting))] : []),
    Object.entries(setting.warnings ?? {}).map(([id, n]) => `${id} (${n})`).join(", "),
  ];
  const heads = inner.length > 0 ? inner.map((key) => el("span", { title: meaningOf(data, key) }, inputOf(data, key).name)) : ["setting"];
  const cut = (cells: (Node | string)[]) => (data.summary.settings.some(hasWarnings) ? cells : cells.slice(0, -1));
  return groupedTable(cut([...heads, "runs", ...columns.map((column) => titleOf(resultOf(column))),
    ...(named ? ["unlike the first"] : []), "warnings"]),
    groupsOf(data, keys).map(([title, settings]) => ({ title, rows: settings.map((setting) => cut(row(setting))) })), { id: "settings-table" });
}

const hasWarnings = ({ warnings }: CampaignSetting): boolean => Object.keys(warnings ?? {}).length > 0;

const anchorOf = (data: CampaignData, setting: CampaignSetting): string => `setting-${data.summary.settings.indexOf(setting) + 1}`;

/** Every run under its setting; a run that kept its page links to it. */
function runsTable(data: CampaignData, table: Table, keys: string[], columns: string[]): HTMLElement {
  const pages = new Set(data.reports);
  const name = (row: string[]) => {
    const id = table.cell(row, "case");
    return pages.has(id) && table.cell(row, "status") === "done" ? el("a", { href: `cases/${encodeURIComponent(id)}/report.html` }, id) : id;
  };
  const value = (row: string[], column: string) => {
    const text = table.cell(row, column);
    return text === "" ? "none" : number(Number(text) * resultOf(column).scale, 4);
  };
  return groupedTable(["run", "status", ...columns.map((column) => titleOf(resultOf(column)))],
    data.summary.settings.map((setting) => ({
      id: anchorOf(data, setting),
      title: settingName(data, setting, keys),
      rows: (table.rows.get(setting.setting) ?? []).map((row) => [name(row), table.cell(row, "status"), ...columns.map((column) => value(row, column))]),
    })), { id: "runs" });
}

/** Says which settings have cases without a mean load, and why. */
function withoutMean(data: CampaignData, keys: string[]): HTMLElement | false {
  const lacking = data.summary.settings
    .map((s) => ({ s, n: s.n_done - (s.statistics["horizontal.mean"] ?? s.statistics["vertical.mean"] ?? { n: s.n_done }).n }))
    .filter(({ n }) => n > 0);
  if (lacking.length === 0) return false;
  const names = lacking.map(({ s, n }) => `${settingName(data, s, keys)} (${n} of ${s.n_done})`).join("; ");
  return el("p", { class: "note" }, `Runs that were over before their statistics begin (output.statistics_from) have no mean load: ${names}.`);
}

/** Charts over every input that is an axis; without one, a row for each setting. */
function trends({ data, keys, numeric }: Axes, table: Table, columns: string[]): HTMLElement | null {
  const { settings } = data.summary;
  const hasMeans = (column: string) => settings.some((s) => typeof s.statistics[column]?.mean === "number");
  const drawn = columns.filter(hasMeans).slice(0, numeric.length === 0 ? kMostColumns : numeric.length > 3 ? 1 : kMostDrawn);
  if (settings.length < 2 || drawn.length === 0) return null;
  const what = "Means over the replicates with Student's 95 % intervals; pale dots are single runs.";
  if (numeric.length > 0)
    return section("trends", "Trends", el("p", {}, `${what} All charts of a result have one scale.`),
      el("div", { class: "results" },
        ...drawn.flatMap((column) => numeric.map((key) => multiples(data, table.runs, column, key, keys.filter((other) => other !== key))))));
  if (settings.length > kMostRows) return null;
  const nameOf = (setting: CampaignSetting) => keys.map((key) => valueOf(data, setting, key)).join(", ");
  return section("trends", "Settings compared", el("p", {}, `${what} Dashes: the mean of the first setting.`),
    el("div", { class: "charts" }, ...drawn.map((column) => listChart(data, table.runs, column, nameOf))));
}

export function showCampaign(data: CampaignData, parent: HTMLElement): void {
  const { settings, n_cases, n_done, n_failed } = data.summary;
  const known = Object.keys(settings[0]?.statistics ?? {});
  const columns = [...kFirst.filter((name) => known.includes(name)), ...known.filter((name) => !kFirst.includes(name))].slice(0, kMostColumns);
  const axes = axesOf(data);
  const { keys } = axes;
  const table = new Table(data.table);
  const drawn = trends(axes, table, columns);
  parent.append(
    el("div", { class: "figures" }, ...[[n_cases, "runs"], [n_done, "done"], [n_failed, "failed"], [settings.length, "settings"]].map(([n, name]) =>
      el("div", { class: "figure" }, el("b", {}, String(n)), el("span", {}, String(name))))),
    ...(drawn ? [drawn] : []),
    section("settings", "Settings",
      withoutMean(axes.data, keys),
      el("p", { class: "note" }, "Mean over the runs of a setting (95 % interval). ", el("span", { class: "do" }, "A setting links to its runs. "),
        settings.some(hasWarnings) && "Warnings have the number of runs in brackets; summary.json of a run has their words."),
      settingsTable(axes.data, keys, columns)),
    section("all-runs", "Every run",
      el("p", { class: "note" }, el("span", { class: "do" }, "A run that kept all its results links to its page (output.keep = run in the plan). "),
        saveButtons("every run", { CSV: () => saveText("campaign.csv", data.table, "text/csv") })),
      runsTable(axes.data, table, keys, columns)),
    section("inputs", "Origin", manifestTables(data.manifest)),
  );
}
