// SPDX-License-Identifier: GPL-3.0-or-later
// uPlot in the page's colours.
import uPlot from "uplot";
import { chartSvg } from "./chart_svg";
import { css, el } from "./dom";
import { number } from "./format";
import { type Mark, paintMarks } from "./marks";
import { fineness, isOnPaper } from "./paper";
import { csv, pngOf, save, saveButtons, saveText } from "./save";

/** A tick as tables write their numbers: no separator of thousands, which depends on the reader's browser. */
const plain = (n: number): string => (Math.abs(n) >= 1e6 ? number(n, 3) : String(Number(n.toPrecision(6)))).replace("-", "−");

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
    values: (_, splits) => splits.map((n) => (n === null ? "" : plain(n))),
    ...more,
  };
}

/** Pixels of a canvas for each pixel of the page: for what a chart draws itself. */
const pixelRatio = (): number => (devicePixelRatio || 1) * fineness();

type Options = Omit<uPlot.Options, "width" | "height">;

/** The content of a chart. */
export interface Shown {
  options: Options;
  data: uPlot.AlignedData;
  /** The marks besides its lines, asked at each drawing. */
  marks?: () => Mark[];
  /** Of its columns as CSV, with units; without: the labels of its series. */
  heads?: string[];
  /** Width of columns over their distance, for a chart of columns. */
  columns?: number;
}

/** The same chart, `k` times as large in all. */
function enlarged(options: Options, k: number): Options {
  if (k === 1) return options;
  const font = (text: string | undefined) => text?.replace(/^\d+/, (size) => String(k * Number(size)));
  const scaled = <T extends object>(of: T, ...names: (keyof T)[]): T =>
    ({ ...of, ...Object.fromEntries(names.filter((name) => typeof of[name] === "number").map((name) => [name, k * Number(of[name])])) });
  return {
    ...options,
    axes: options.axes?.map((each, i) => ({
      ...scaled(each, "labelSize", "size", "gap"), font: font(each.font as string), labelFont: font(each.labelFont),
      space: k * (i === 0 ? 50 : 30), grid: scaled(each.grid!, "width"), ticks: scaled(each.ticks!, "width", "size"),
    })),
    series: options.series.map((each) => ({ ...scaled(each, "width"), points: scaled(each.points ?? {}, "size") })),
  };
}

/** Pixels of a saved picture for each of its drawing. */
const kFinePng = 2;

/** Largest height of a chart on paper over its width. */
const kTallest = 0.6;

/** A chart that fills its element's width, made again when the theme changes. */
export class Chart {
  readonly element: HTMLElement;
  plot: uPlot | null = null;
  private shown: Shown | null = null;
  private readonly holder: HTMLElement;
  private readonly caption = el("figcaption");

  /** @param name what it shows, for readers who do not see it, and for the names of its files. */
  constructor(
    readonly name: string,
    private readonly height: number,
    private readonly make: () => Shown,
    private readonly tell?: () => string,
  ) {
    this.holder = el("div", { class: "plot", role: "group", "aria-label": name });
    this.element = el("figure", { class: "chart" }, this.holder, this.caption, this.saves());
    new ResizeObserver(() => this.fit()).observe(this.holder);
    kCharts.push(this);
  }

  redraw(): void {
    this.caption.textContent = this.tell?.() ?? "";
    const width = this.holder.clientWidth;
    if (width === 0) return;
    const x = this.plot?.scales.x;
    const range = x && this.plot && x.min !== undefined && x.max !== undefined ? { min: x.min!, max: x.max! } : null;
    this.plot?.destroy();
    this.shown = this.make();
    const { options, data, marks } = this.shown;
    const k = fineness();
    const hooks = { ...options.hooks, draw: [(plot: uPlot) => paintMarks(plot, marks?.() ?? [], pixelRatio()), ...(options.hooks?.draw ?? [])] };
    this.plot = new uPlot({ ...enlarged({ ...options, hooks }, k), width: k * width, height: k * (isOnPaper() ? Math.min(this.height, Math.round(kTallest * width)) : this.height) }, data, this.holder);
    if (range && this.keepsRange) this.plot.setScale("x", range);
    // uPlot draws once the script has ended, too late for a print in Firefox.
    if (isOnPaper()) this.plot.batch(() => {});
    this.open(this.plot);
  }

  /** The lines are a picture; their names below are buttons, which show and hide a line by keys too. */
  private open(plot: uPlot): void {
    const picture = plot.root.querySelector(".u-wrap")!;
    picture.setAttribute("role", "img");
    picture.setAttribute("aria-label", this.name);
    const names = [...plot.root.querySelectorAll<HTMLElement>(".u-legend .u-label")].slice(1);
    if (names.length < 2) return;
    names.forEach((name, i) => {
      const tell = () => name.setAttribute("aria-pressed", String(plot.series[i + 1].show));
      name.setAttribute("role", "button");
      name.tabIndex = 0;
      name.parentElement!.addEventListener("click", tell);
      name.addEventListener("keydown", (event) => {
        if (event.key !== "Enter" && event.key !== " ") return;
        event.preventDefault();
        event.stopPropagation();
        name.click();
      });
      tell();
    });
  }

  keepsRange = false;

  /** The whole chart as an editable drawing; null before the chart was drawn. */
  drawing(): SVGSVGElement | null {
    if (!this.plot || !this.shown) return null;
    const { marks, columns } = this.shown;
    return chartSvg({ plot: this.plot, title: this.name, caption: this.caption.textContent ?? "", marks: marks?.() ?? [], columns });
  }

  private svgText(): string {
    return new XMLSerializer().serializeToString(this.drawing()!);
  }

  private saves(): HTMLElement {
    const file = this.name.toLowerCase().replace(/[^a-z0-9]+/g, "-");
    const withPlot = (act: (plot: uPlot) => void | Promise<void>) => () => (this.plot ? act(this.plot) : undefined);
    return saveButtons(this.name, {
      SVG: withPlot(() => saveText(`${file}.svg`, this.svgText(), "image/svg+xml")),
      PNG: withPlot(async () => save(`${file}.png`, await pngOf(this.svgText(), kFinePng))),
      CSV: withPlot((plot) => saveText(`${file}.csv`, csv(plot.series.map((series, i) => [this.shown?.heads?.[i] ?? String(series.label), plot.data[i]])), "text/csv")),
    });
  }

  private fit(): void {
    if (isOnPaper()) return;
    if (!this.plot) this.redraw();
    else if (this.plot.width !== this.holder.clientWidth && this.holder.clientWidth > 0)
      this.plot.setSize({ width: this.holder.clientWidth, height: this.height });
  }
}

const kCharts: Chart[] = [];

export function redrawCharts(): void {
  for (const chart of kCharts) chart.redraw();
}
