// SPDX-License-Identifier: GPL-3.0-or-later
// The load history: every sample, its causes, the cracks, and the replay's time.
import uPlot from "uplot";
import { axis, Chart } from "./charts";
import type { Run } from "./data";
import { css, el } from "./dom";
import { kN, seconds } from "./format";
import type { Player } from "./player";

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
}

export class LoadHistory {
  readonly element: HTMLElement;
  readonly chart: Chart;
  private axisName: "Fx" | "Fz" = "Fx";

  constructor(
    private readonly run: Run,
    private readonly player: Player,
    private readonly onPeak: (peak: Peak) => void,
  ) {
    this.chart = new Chart(250, () => this.make());
    this.chart.keepsRange = true;
    const choose = el(
      "select",
      { "aria-label": "Direction of the load", change: () => this.setAxis(choose.value as "Fx" | "Fz") },
      el("option", { value: "Fx" }, "horizontal, Fx"),
      el("option", { value: "Fz" }, "vertical, Fz"),
    );
    this.element = el(
      "div",
      { class: "loads" },
      el("div", { class: "bar" }, el("strong", {}, "Load on the structure"), choose,
        el("button", { type: "button", click: () => this.zoom(0.5), title: "Zoom in on the upright line" }, "+"),
        el("button", { type: "button", click: () => this.zoom(2), title: "Zoom out" }, "−"),
        el("button", { type: "button", click: () => this.showAll(), title: "The whole history" }, "all")),
      this.chart.element,
      el("p", { class: "hint" }, "Click a peak for the crack behind it; drag to zoom. Ticks: cracks. Dashes: mean."),
    );
    player.onChange(() => this.keepInView());
  }

  setAxis(name: "Fx" | "Fz"): void {
    this.axisName = name;
    this.chart.redraw();
  }

  zoom(factor: number): void {
    const plot = this.chart.plot;
    if (!plot) return;
    const times = this.run.column("load.time");
    const span = Math.max(factor * (plot.scales.x.max! - plot.scales.x.min!), 4 * (times[1] - times[0]));
    const min = Math.max(0, Math.min(this.player.time - 0.5 * span, this.run.duration - span));
    plot.setScale("x", { min, max: Math.min(this.run.duration, min + span) });
  }

  showAll(): void {
    this.chart.plot?.setScale("x", { min: 0, max: this.run.duration });
  }

  /** The highest sample near a time, and the crack event that belongs to it. */
  peakNear(time: number, reach: number): Peak {
    const times = this.run.column("load.time");
    const total = this.run.column(`load.${this.axisName}`);
    let index = -1;
    for (let i = 0; i < times.length; ++i)
      if (Math.abs(times[i] - time) <= reach && (index < 0 || total[i] > total[index])) index = i;
    if (index < 0) index = nearest(times, time);
    return {
      time: times[index],
      index,
      loads: kCauses.map(([cause]) => this.run.column(`load.${cause}${this.axisName}`)[index]),
      event: this.eventNear(times[index]),
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

  private make(): { options: Omit<uPlot.Options, "width" | "height">; data: uPlot.AlignedData } {
    const column = (name: string) => this.run.column(`load.${name}${this.axisName}`);
    const data = [Array.from(this.run.column("load.time")), ...kCauses.map(([cause]) => Array.from(column(cause), (n) => n / 1e3))];
    const options: Omit<uPlot.Options, "width" | "height"> = {
      cursor: { drag: { x: true, y: false }, points: { size: 5 } },
      legend: { live: true },
      scales: { x: { time: false } },
      axes: [axis("time [s]"), axis("load [kN]", { size: 50 })],
      series: [
        { label: "time", value: (_: uPlot, t: number | null) => (t === null ? "–" : `${seconds(t)} s`) },
        ...kCauses.map(([, label, colour], i) => ({
          label,
          stroke: css(colour),
          width: i === 0 ? 1.4 : 1,
          show: i < 3,
          points: { show: false },
          value: (_: uPlot, n: number | null) => (n === null ? "–" : `${n.toFixed(1).replace("-", "−")}`),
        })),
      ],
      hooks: { draw: [(plot) => this.mark(plot)], ready: [(plot) => this.listen(plot)] },
    };
    return { options, data: data as unknown as uPlot.AlignedData };
  }

  /** Mean with its interval, cracks, and the time of the replay. */
  private mark(plot: uPlot): void {
    const { ctx, bbox } = plot;
    const ratio = devicePixelRatio || 1;
    const summary = this.axisName === "Fx" ? this.run.data.summary.horizontal : this.run.data.summary.vertical;
    const x = (t: number) => plot.valToPos(t, "x", true);
    const y = (n: number) => plot.valToPos(n / 1e3, "y", true);
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    ctx.lineWidth = ratio;
    const { mean, mean_95: [low, high] } = summary;
    if (mean !== null && low !== null) {
      const from = x(this.run.data.summary.statistics_from);
      ctx.fillStyle = css("--band");
      ctx.fillRect(from, y(high), bbox.left + bbox.width - from, y(low) - y(high));
      this.line(ctx, css("--accent"), [from, y(mean)], [bbox.left + bbox.width, y(mean)], [5 * ratio, 4 * ratio]);
    }
    for (const t of this.run.column("event.time"))
      this.line(ctx, css("--red"), [x(t), bbox.top + bbox.height], [x(t), bbox.top + bbox.height - 7 * ratio]);
    this.line(ctx, css("--ink"), [x(this.player.time), bbox.top], [x(this.player.time), bbox.top + bbox.height]);
    ctx.restore();
  }

  private line(ctx: CanvasRenderingContext2D, colour: string, a: number[], b: number[], dash: number[] = []): void {
    ctx.strokeStyle = colour;
    ctx.setLineDash(dash);
    ctx.beginPath();
    ctx.moveTo(a[0], a[1]);
    ctx.lineTo(b[0], b[1]);
    ctx.stroke();
  }

  private listen(plot: uPlot): void {
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
    if (span < this.run.duration - 1e-6 && (this.player.time < min || this.player.time > max)) {
      const start = Math.max(0, Math.min(this.player.time - 0.1 * span, this.run.duration - span));
      plot.setScale("x", { min: start, max: start + span });
    } else {
      plot.redraw(false, false);
    }
  }
}

function nearest(times: ArrayLike<number>, time: number): number {
  let best = 0;
  for (let i = 1; i < times.length; ++i) if (Math.abs(times[i] - time) < Math.abs(times[best] - time)) best = i;
  return best;
}

/** A peak in words: how much of it came from where. */
export function describePeak(peak: Peak): string {
  const [total, crushing, normal, friction] = peak.loads.map(kN);
  return `${total} kN at ${seconds(peak.time)} s: ${crushing} kN crushing at the edge, ${normal} kN floes, ${friction} kN their friction.`;
}
