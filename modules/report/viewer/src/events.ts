// SPDX-License-Identifier: GPL-3.0-or-later
// The crack event that was chosen, with all its numbers.
import { type Crack, crackOf } from "./crack";
import type { Run } from "./data";
import { el } from "./dom";
import { degrees, kPa, loadText, loadUnit, number, ratio, seconds } from "./format";
import { describePeak, type Peak } from "./loads";
import { eventFigure } from "./plan";

/** How the crack went, and what its numbers then mean. */
function courseOf(crack: Crack): string {
  if (crack.circumferential.length === 0) return "The pieces of this crack touch no ice that stayed.";
  const course = crack.isCircle ? "The crack is the circle of the breaking length." : "The crack followed the stress in the ice, not a circle.";
  if (!crack.hasTrapezoid) return `${course} No trapezoid with a depth fits this edge, so b and θ have no meaning.`;
  return crack.isCircle ? course : `${course} The trapezoid is a fit to the edge that describes the event: b, c, θ and μ belong to it.`;
}

/** A number of an event: its name, value, unit and meaning. */
type Row = [string, string, string, string];

/** A crack that is further from a peak has little to do with it [s]. */
const kTogether = 0.5;

const listOf = (numbers: Row[]): HTMLElement => el("dl", { class: "numbers" },
  ...numbers.map(([name, value, unit, meaning]) => el("div", { title: meaning }, el("dt", {}, name), el("dd", {}, value, unit && el("small", {}, ` ${unit}`)))));

export class EventCard {
  readonly element = el("div", { class: "event-card", "aria-live": "polite" });
  private shown = -1;
  private explains = false;

  constructor(
    private readonly run: Run,
    private readonly onChoose: (event: number) => void,
  ) {
    this.show(-1);
  }

  /** The event that it shows; -1: none. */
  get event(): number {
    return this.shown;
  }

  /** @param peak the load peak that was clicked, if the event was chosen by one. */
  show(event: number, peak?: Peak): void {
    this.shown = event;
    if (event < 0) {
      const text = this.run.nEvents > 0 ? "Click a load peak, or a red point of the plan, to see the crack event behind it." : "The ice has not broken.";
      this.element.replaceChildren(el("p", { class: "hint do" }, text), ...(this.run.nEvents > 0 ? [this.steps()] : []));
      return;
    }
    const crack = crackOf(this.run, event);
    const numbers = this.numbers(event, crack);
    this.element.replaceChildren(
      el("div", { class: "bar" }, el("strong", {}, `Crack ${event + 1} of ${this.run.nEvents}`),
        el("span", {}, `at ${seconds(this.run.column("event.time")[event])} s`), this.steps()),
      el("div", { class: "event-body" }, eventFigure(this.run, event, crack), listOf(numbers)),
      this.glossary(numbers),
      el("p", { class: "hint course" }, courseOf(crack)),
      ...(peak ? [el("p", { class: "hint peak" }, this.behind(peak))] : []),
    );
  }

  /** All meanings at once, for readers without a mouse; it stays open from crack to crack. */
  private glossary(numbers: Row[]): HTMLElement {
    const list = el("details", { class: "glossary", open: this.explains, toggle: () => (this.explains = list.open) },
      el("summary", {}, "What these numbers mean"),
      el("dl", {}, ...numbers.map(([name, , , meaning]) => el("div", {}, el("dt", {}, name), el("dd", {}, meaning)))));
    return list;
  }

  private behind(peak: Peak): string {
    const gap = this.run.column("event.time")[peak.event] - peak.time;
    const when = Math.abs(gap) < 5e-4 ? "in the same step" : `${seconds(Math.abs(gap))} s ${gap > 0 ? "later" : "before"}`;
    const which = Math.abs(gap) > kTogether ? "No crack came with it: the nearest one came" : "The crack came";
    return `Peak of ${describePeak(peak)} ${which} ${when}.`;
  }

  private steps(): HTMLElement {
    const to = (event: number) => () => this.onChoose((event + this.run.nEvents) % this.run.nEvents);
    return el("span", { class: "steps" },
      el("button", { type: "button", click: to(Math.max(0, this.event) - 1), title: "Previous crack" }, "‹"),
      el("button", { type: "button", click: to(this.event + 1), title: "Next crack" }, "›"));
  }

  private numbers(event: number, crack: Crack): Row[] {
    const at = (name: string) => this.run.column(`event.${name}`)[event];
    const force = at("p") * at("c") * at("thickness");
    const fitted = (...row: Row): Row[] => (crack.hasTrapezoid ? [row] : []);
    return [
      ...fitted("b", number(at("b"), 4), "m", "depth of the fitted trapezoid"),
      ["c", number(at("c"), 4), "m", "contact length"],
      ...fitted("θ", degrees(at("theta")), "°", "opening angle of the trapezoid"),
      ["μ₁", ratio(at("mu1")), "", "out-of-plane over in-plane normal force"],
      ["μ₂", ratio(at("mu2")), "", "in-plane friction over in-plane normal force"],
      ["p", kPa(at("p")), "kPa", "pressure on the contact"],
      ["p c h", loadText(force), loadUnit(), "in-plane normal force"],
      ["σ", kPa(at("sigma_max")), "kPa", "largest principal stress where failure is checked"],
      ["l_break", number(at("l_break"), 4), "m", crack.isCircle ? "breaking length: radius of the crack" : "breaking length: from the tip to the crack, along the trapezoid's axis"],
      ["wedges", String(at("wedges")), "", "number of wedges drawn"],
      ["pieces", String(at("pieces")), "", "floes that came of it"],
      ...fitted("fit error", number(at("fit_error"), 3), "", "area between trapezoid and edge over the window's"),
      ["in range", at("in_range") ? "yes" : "no", "", "whether the failure model's inputs were within its range"],
    ];
  }
}
