// SPDX-License-Identifier: GPL-3.0-or-later
// uPlot in the page's colours.
import uPlot from "uplot";
import { css, el } from "./dom";

export type Series = uPlot.Series & { stroke: string };

/** Axes as thin as the page's rules. */
export function axis(label: string, more: Partial<uPlot.Axis> = {}): uPlot.Axis {
  return {
    label,
    labelSize: 18,
    labelFont: "12px system-ui, sans-serif",
    font: "11px system-ui, sans-serif",
    labelGap: 0,
    size: more.side === 1 || more.scale ? 56 : 30,
    gap: 4,
    stroke: css("--muted"),
    grid: { stroke: css("--rule"), width: 1 },
    ticks: { stroke: css("--rule"), width: 1, size: 4 },
    ...more,
  };
}

/** A chart that fills its element's width, made anew when the theme changes. */
export class Chart {
  readonly element: HTMLElement;
  plot: uPlot | null = null;
  private readonly holder = el("div", { class: "plot" });

  constructor(
    private readonly height: number,
    private readonly make: () => { options: Omit<uPlot.Options, "width" | "height">; data: uPlot.AlignedData },
    caption?: string,
  ) {
    this.element = el("figure", { class: "chart" }, this.holder, caption !== undefined && el("figcaption", {}, caption));
    new ResizeObserver(() => this.fit()).observe(this.holder);
    kCharts.push(this);
  }

  redraw(): void {
    const width = this.holder.clientWidth;
    if (width === 0) return;
    const x = this.plot?.scales.x;
    const range = x && this.plot && x.min !== undefined && x.max !== undefined ? { min: x.min!, max: x.max! } : null;
    this.plot?.destroy();
    const { options, data } = this.make();
    this.plot = new uPlot({ ...options, width, height: this.height }, data, this.holder);
    if (range && this.keepsRange) this.plot.setScale("x", range);
  }

  keepsRange = false;

  private fit(): void {
    if (!this.plot) this.redraw();
    else if (this.plot.width !== this.holder.clientWidth && this.holder.clientWidth > 0)
      this.plot.setSize({ width: this.holder.clientWidth, height: this.height });
  }
}

const kCharts: Chart[] = [];

export function redrawCharts(): void {
  for (const chart of kCharts) chart.redraw();
}
