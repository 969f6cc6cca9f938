// SPDX-License-Identifier: GPL-3.0-or-later
// Names of colours, drawn in these colours.
import { el } from "./dom";

/** A colour or the two ends of a range, by the names of CSS variables, or the class of a line; and what it means. */
export interface Swatch {
  colour: string | [string, string];
  text: string;
  kind?: "area" | "line" | "dashes" | "dot";
}

export const kLand: Swatch = { colour: "--scene-land", text: "land" };

export function legend(swatches: Swatch[], attributes: Record<string, string> = {}): HTMLElement {
  return el("div", { class: "legend", ...attributes }, ...swatches.map(({ colour, text, kind = "area" }) => {
    const ramp = Array.isArray(colour);
    const style = ramp ? `--from: var(${colour[0]}); --to: var(${colour[1]})` : `--colour: var(${colour})`;
    return el("span", {}, el("i", { class: ramp ? "ramp" : kind, style }), text);
  }));
}
