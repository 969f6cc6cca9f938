// SPDX-License-Identifier: GPL-3.0-or-later
// The load history: its samples, their causes, the cracks, and the replay's time.
import uPlot from "uplot";
import { axis, Chart, type Shown } from "./charts";
import { kLoadNames, kLoads, type LoadChoice } from "./choice";
import type { Run } from "./data";
import { css, el } from "./dom";
import { fixed, inLoadUnit, loadText, seconds } from "./format";
import type { Mark } from "./marks";
import { isOnPaper } from "./paper";
import type { Player } from "./player";
import { csv, saveButtons, saveText } from "./save";
import type { LoadName } from "./types";

const kCauses: [string, string, string][] = [
  ["", "total", "--accent"],
  ["crushing_", "crushing", "--red"],
  ["floe_normal_", "floes", "--teal"],
  ["floe_friction_", "friction", "--ochre"],
];

export interface Peak {
  time: number;
  index: number;
  /** In the order of the causes: total, crushing, floes normal, floes friction [N]. */
  loads: number[];
  /** The crack event nearest in time, or -1. */
  event: number;
  unit: string;
}

/** A history that is drawn over the history of the run [s], [N or N m]. */
export interface Overlay {
  label: string;
  colour: string;
  times: ArrayLike<number>;
  values: (load: LoadName) => ArrayLike<number> | null;
}

/** What the causes of a load mean, for the legend. */
const kMeaning = "Total: what the structure feels · crushing: at the sheet's edge · floes: their normal forces · friction: of the floes";

export class LoadHistory {
  readonly element: HTMLElement;
  readonly chart: Chart;
  private readonly notes = el("p", { class: "hint" });
  /** The replay's time. It moves over the chart, which is not drawn again. */
  private readonly now = el("div", { class: "now" });

  constructor(
    private readonly run: Run,
    private readonly player: Player,
    private readonly choice: LoadChoice,
    private readonly overlays: Overlay[],
    private readonly onPeak: (peak: Peak) => void,
  ) {
    this.chart = new Chart("Load history", 250, () => this.make());
    this.chart.keepsRange = true;
    const choose = el(
      "select",
      { "aria-label": "Load", change: () => choice.set(choose.value as LoadName) },
      ...kLoadNames.map((name) => el("option", { value: name }, kLoads[name].title)),
    );
    choice.onChange(() => {
      choose.value = choice.name;
      this.chart.redraw();
      this.tell();
    });
    this.element = el(
      "div",
      { class: "loads" },
      el("div", { class: "bar" }, el("strong", {}, "Load on the structure"), choose,
        el("button", { type: "button", click: () => this.zoom(0.5), title: "Zoom in on the upright line" }, "+"),
        el("button", { type: "button", click: () => this.zoom(2), title: "Zoom out" }, "−"),
        el("button", { type: "button", click: () => this.showAll(), title: "The whole history" }, "all"),
        saveButtons("every load by cause", { "all CSV": () => this.saveAll() })),
      this.chart.element,
      this.notes,
    );
    this.tell();
    player.onChange(() => this.keepInView());
  }

  zoom(factor: number): void {
    const plot = this.chart.plot;
    if (!plot) return;
    const times = this.run.column("load.time");
    const span = Math.max(factor * (plot.scales.x.max! - plot.scales.x.min!), 4 * (times[1] - times[0]));
    const min = Math.max(0, Math.min(this.player.time - 0.5 * span, this.player.duration - span));
    plot.setScale("x", { min, max: Math.min(this.player.duration, min + span) });
  }

  /** Follows a run that has grown; a view of all of it stays one. */
  renew(): void {
    const max = this.chart.plot?.scales.x.max ?? 0;
    const showsAll = max >= this.drawn - 1e-6;
    this.drawn = this.player.duration;
    this.tell();
    this.chart.redraw();
    if (showsAll) this.showAll();
  }

  /** Duration of all runs when they were drawn last [s]. */
  private drawn = 0;

  showAll(): void {
    this.chart.plot?.setScale("x", { min: 0, max: this.player.duration });
  }

  /** The largest sample near a time, whichever way it acts, and the crack event that belongs to it. */
  peakNear(time: number, reach: number): Peak {
    const times = this.run.column("load.time");
    const total = this.run.column(`load.${this.choice.name}`);
    let index = -1;
    for (let i = 0; i < times.length; ++i)
      if (Math.abs(times[i] - time) <= reach && (index < 0 || Math.abs(total[i]) > Math.abs(total[index]))) index = i;
    if (index < 0) index = nearest(times, time);
    return {
      time: times[index],
      index,
      loads: kCauses.map(([cause]) => this.run.column(`load.${cause}${this.choice.name}`)[index]),
      event: this.eventNear(times[index]),
      unit: this.choice.unit,
    };
  }

  /** The event nearest in time; of several in one step the one with the largest contact force p c h. */
  private eventNear(time: number): number {
    const times = this.run.column("event.time");
    const force = (i: number) => this.run.column("event.p")[i] * this.run.column("event.c")[i];
    let best = -1;
    for (let i = 0; i < times.length; ++i) {
      const gain = best < 0 ? 1 : Math.abs(times[best] - time) - Math.abs(times[i] - time);
      if (gain > 1e-6 || (gain > -1e-6 && force(i) > force(best))) best = i;
    }
    return best;
  }

  private make(): Shown {
    const shown = (values: ArrayLike<number>) => Array.from(values, inLoadUnit);
    const column = (cause: string) => shown(this.run.column(`load.${cause}${this.choice.name}`));
    const own = [Array.from(this.run.column("load.time")), ...kCauses.map(([cause]) => column(cause))] as uPlot.AlignedData;
    const overlays = this.shown();
    const data = overlays.length === 0 ? own
      : uPlot.join([own, ...overlays.map(({ times, values }) => [Array.from(times), shown(values)] as uPlot.AlignedData)]);
    const series = (label: string, colour: string, width: number, show = true): uPlot.Series => ({
      label, width, show, stroke: css(colour), spanGaps: true, points: { show: false }, value: (plot, value, i) => this.valueAt(plot, value, i),
    });
    const options: Shown["options"] = {
      cursor: { drag: { x: true, y: false }, points: { size: 5 } },
      legend: { live: true },
      scales: { x: { time: false } },
      axes: [axis("time [s]"), axis(`${this.choice.name} [${this.choice.unit}]`, { size: 56 })],
      series: [
        { label: "time", value: (_: uPlot, t: number | null) => `${seconds(t ?? this.player.time)} s` },
        ...kCauses.map(([, label, colour], i) => series(label, colour, i === 0 ? 1.4 : 1, i < 3)),
        ...overlays.map(({ label, colour }) => series(label, colour, 1.3)),
      ],
      hooks: { draw: [(plot) => this.placeNow(plot)], ready: [(plot) => this.listen(plot)] },
    };
    const head = (label: string) => `${this.choice.name} ${label} [${this.choice.unit}]`;
    const heads = ["time [s]", ...kCauses.map(([, label]) => head(label)), ...overlays.map(({ label }) => head(label))];
    return { options, data, heads, marks: () => this.marks() };
  }

  private shown(): { label: string; colour: string; times: ArrayLike<number>; values: ArrayLike<number> }[] {
    return this.overlays.flatMap(({ label, colour, times, values }) => {
      const of = values(this.choice.name);
      return of ? [{ label, colour, times, values: of }] : [];
    });
  }

  /** The value under the cursor; away from the chart, the one at the replay's time. */
  private valueAt(plot: uPlot, value: number | null, series: number): string {
    const shown = value ?? plot.data[series]?.[nearest(plot.data[0], this.player.time)];
    return shown === null || shown === undefined ? "" : fixed(shown);
  }

  private saveAll(): void {
    const names = kCauses.flatMap(([cause]) => kLoadNames.map((name) => cause + name));
    const head = (name: string) => `${name} [${/M.$/.test(name) ? "N m" : "N"}]`;
    saveText("loads.csv", csv([["time [s]", this.run.column("load.time")],
      ...names.map((name): [string, ArrayLike<number>] => [head(name), this.run.column(`load.${name}`)])]), "text/csv");
  }

  /** The mean with its interval, and the reference where there is one [N]. */
  private levels(): { mean: number; interval: [number, number] | null; reference: number } | null {
    const own = this.run.data.loads?.[this.choice.name];
    const reference = this.choice.name === "Fx" ? this.run.input("reference", "mean_horizontal") : NaN;
    if (!own) return Number.isFinite(reference) ? { mean: NaN, interval: null, reference } : null;
    const [low, high] = own.mean_95;
    return { mean: own.mean, interval: low === null || high === null ? null : [low, high], reference };
  }

  private tell(): void {
    const levels = this.levels();
    const marks = [this.run.nEvents > 0 && "red ticks: cracks", this.run.column("split.time").length > 0 && "violet ticks on top: sheets that split", levels && Number.isFinite(levels.mean) && (levels.interval ? "dashes: mean, with its 95 % interval" : "dashes: mean"),
      levels && Number.isFinite(levels.reference) && "dots: reference mean"].filter(Boolean).join(" · ");
    const peak = this.run.nEvents > 0 ? "Click a peak for the crack behind it" : "Click a peak to see it in the replay";
    this.notes.replaceChildren(
      el("span", { class: "do" }, `${peak}; drag to zoom; choose a name above to show or hide its line. `), kMeaning,
      marks && ` · ${marks}`, ".", this.ofLongRun());
  }

  /** That a long run is drawn by the extremes of its loads, and where all rows are. */
  private ofLongRun(): string {
    const { n, span } = this.run.data.drawn_rows;
    return span > 1 ? ` Of this long run ${n} rows are drawn, the extremes of every ${span} steps. run.nc and history.csv have all rows.` : "";
  }

  /** Mean with its interval, the reference and cracks. */
  private marks(): Mark[] {
    const ticks = (column: string, name: string, colour: string, edge: "top" | "bottom", length: number): Mark[] =>
      Array.from(this.run.column(column), (x) => ({ kind: "tick", name, colour: css(colour), x, edge, length }));
    return [
      ...this.levelMarks(),
      ...ticks("event.time", "cracks", "--red", "bottom", 7),
      ...ticks("split.time", "sheets that split", "--violet", "top", 12),
      ...(isOnPaper() ? [{ kind: "upright", name: "time of the replay", colour: css("--ink"), x: this.player.time } as const] : []),
    ];
  }

  private levelMarks(): Mark[] {
    const levels = this.levels();
    if (!levels) return [];
    const [mean, reference] = [inLoadUnit(levels.mean), inLoadUnit(levels.reference)];
    const { statistics_from: from, statistics_until: to } = this.run.data.summary;
    const marks: Mark[] = [];
    if (levels.interval) {
      const [low, high] = levels.interval.map(inLoadUnit);
      marks.push({ kind: "band", name: "95 % interval of the mean", colour: css("--band"), from, to, low, high });
    }
    if (Number.isFinite(mean)) marks.push({ kind: "level", name: "mean", colour: css("--accent"), from, to, at: mean, dash: [5, 4] });
    if (Number.isFinite(reference)) marks.push({ kind: "level", name: "reference mean", colour: css("--ink"), from: 0, at: reference, dash: [2, 3] });
    return marks;
  }

  private placeNow(plot: uPlot): void {
    const x = plot.valToPos(this.player.time, "x");
    this.now.hidden = x < 0 || x > plot.over.clientWidth;
    this.now.style.transform = `translateX(${x.toFixed(2)}px)`;
  }

  private listen(plot: uPlot): void {
    plot.over.append(this.now);
    let pressedAt = 0;
    plot.over.addEventListener("mousedown", (event) => (pressedAt = event.clientX));
    plot.over.addEventListener("mouseup", (event) => {
      if (Math.abs(event.clientX - pressedAt) > 3) return;
      const time = plot.posToVal(event.clientX - plot.over.getBoundingClientRect().left, "x");
      this.choose(time, 6 * (plot.posToVal(1, "x") - plot.posToVal(0, "x")));
    });
  }

  /** The largest load of the history. */
  chooseLargest(): void {
    this.choose(0.5 * this.run.duration, this.run.duration);
  }

  choose(time: number, reach: number): void {
    const peak = this.peakNear(time, reach);
    this.player.seek(peak.time);
    this.onPeak(peak);
  }

  private keepInView(): void {
    const plot = this.chart.plot;
    if (!plot) return;
    const { min, max } = plot.scales.x as { min: number; max: number };
    const span = max - min;
    if (span < this.player.duration - 1e-6 && (this.player.time < min || this.player.time > max)) {
      const start = Math.max(0, Math.min(this.player.time - 0.1 * span, this.player.duration - span));
      plot.setScale("x", { min: start, max: start + span });
    } else {
      this.placeNow(plot);
    }
    plot.setLegend({ idx: null } as unknown as { idx: number });
  }
}

function nearest(times: ArrayLike<number>, time: number): number {
  let best = 0;
  for (let i = 1; i < times.length; ++i) if (Math.abs(times[i] - time) < Math.abs(times[best] - time)) best = i;
  return best;
}

/** A peak in words: how much of it came from where. */
export function describePeak(peak: Peak): string {
  const [total, crushing, normal, friction] = peak.loads.map(loadText);
  return `${total} ${peak.unit} at ${seconds(peak.time)} s: ${crushing} ${peak.unit} crushing at the edge, ${normal} ${peak.unit} floes, ${friction} ${peak.unit} their friction.`;
}
