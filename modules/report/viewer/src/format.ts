// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as a reader wants them.

/** `digits` significant digits, without exponent where it reads well; U+2212 as the minus. */
export function number(value: number | null | undefined, digits = 4): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  let text: string;
  if (size >= 1e7 || size < 1e-4) {
    const [mantissa, exponent] = value.toExponential(Math.max(0, digits - 1)).split("e");
    text = `${Number(mantissa)} × 10${superscript(Number(exponent))}`;
  } else {
    text = size >= 10 ** (digits - 1) ? String(Math.round(value)) : trimmed(Number(value.toPrecision(digits)), digits);
  }
  return text.replace(/-/g, "−");
}

function trimmed(value: number, digits: number): string {
  const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(Math.abs(value))));
  return value.toFixed(decimals);
}

export function superscript(exponent: number): string {
  return String(exponent).replace(/./g, (c) => (c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(c)] ?? c));
}

/** A unit of a case file as it is printed: "kg m-3" as "kg m⁻³", "m^0.5" as a root. */
export const unitText = (unit: string): string =>
  unit === "1" ? "" : unit.replace(/m\^0\.5/g, "√m").replace(/(?<=[A-Za-z])-?\d+/g, (power) => superscript(Number(power)));

/** A unit of the page: kilo-, or at the scale of a basin less. */
export interface Scale {
  one: number;
  prefix: "k" | "" | "m";
}

/** The unit in which the largest of some values has a digit before the point. */
export function scaleFor(largest: number): Scale {
  if (largest === 0 || !(largest < 1e3)) return { one: 1e3, prefix: "k" };
  return largest >= 1 ? { one: 1, prefix: "" } : { one: 1e-3, prefix: "m" };
}

const used = { loads: scaleFor(0), energies: scaleFor(0) };

/** Chooses the units of a page's loads and energies by the largest of each [N], [J]. */
export function chooseUnits(largestLoad: number, largestEnergy: number): void {
  used.loads = scaleFor(largestLoad);
  used.energies = scaleFor(largestEnergy);
}

/** So many decimals. What rounds to zero has no sign. */
export const rounded = (value: number, decimals: number): string => value.toFixed(decimals).replace(/^-(0\.?0*)$/, "$1").replace("-", "−");
/** One decimal. */
export const fixed = (value: number | null | undefined): string =>
  value === null || value === undefined || !Number.isFinite(value) ? "–" : rounded(value, 1);
/** A ratio of two quantities that are never tiny: what is far below any measurement is the rounding of zero. */
export const ratio = (value: number): string => number(Math.abs(value) < 1e-9 ? 0 : value, 4);
const inUnit = (value: number | null | undefined, { one }: Scale): string => fixed(typeof value === "number" ? value / one : value);
/** Newtons in loadUnit(), joules in energyUnit(). */
export const loadText = (value: number | null | undefined): string => inUnit(value, used.loads);
export const energyText = (value: number | null | undefined): string => inUnit(value, used.energies);
export const inLoadUnit = (newtons: number): number => newtons / used.loads.one;
export const loadUnit = (): string => `${used.loads.prefix}N`;
export const energyUnit = (): string => `${used.energies.prefix}J`;
export const kPa = (value: number): string => number(value / 1e3, 4);
export const degrees = (radians: number): string => rounded((radians * 180) / Math.PI, 1);
export const seconds = (value: number, decimals = 2): string => rounded(value, decimals);
/** How far `value` is from `of`, as "+3.1 %". */
export const deviation = (value: number | null, of: number): string =>
  value === null ? "–" : percent(value / of - 1).replace(/^(?!−)/, "+");
export const percent = (share: number): string => `${rounded(100 * share, 1)} %`;
export const bytes = (n: number | undefined): string =>
  n === undefined ? "–" : n < 1e4 ? `${n} B` : n < 1e7 ? `${(n / 1e3).toFixed(0)} kB` : `${(n / 1e6).toFixed(1)} MB`;
