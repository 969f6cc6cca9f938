// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as a reader wants them.

/** `digits` significant digits, without exponent where it reads well; U+2212 as the minus. */
export function number(value: number | null | undefined, digits = 4): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const rounded = Number(value.toPrecision(digits));
  let text: string;
  if (size >= 1e7 || size < 1e-4) {
    const [mantissa, exponent] = value.toExponential(Math.max(0, digits - 1)).split("e");
    text = `${Number(mantissa)} × 10${superscript(Number(exponent))}`;
  } else {
    text = size >= 10 ** (digits - 1) ? String(Math.round(value)) : trimmed(rounded, digits);
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

/** Newtons as kilonewtons with one decimal. */
export const kN = (value: number | null | undefined): string =>
  value === null || value === undefined || !Number.isFinite(value) ? "–" : (value / 1e3).toFixed(1).replace(/^-0\.0$/, "0.0").replace("-", "−");
export const kJ = kN;
export const kPa = (value: number): string => number(value / 1e3, 4);
export const degrees = (radians: number): string => ((radians * 180) / Math.PI).toFixed(1).replace("-", "−");
export const seconds = (value: number, decimals = 2): string => value.toFixed(decimals).replace("-", "−");
/** How far `value` is from `of`, as "+3.1 %". */
export const deviation = (value: number | null, of: number): string =>
  value === null ? "–" : percent(value / of - 1).replace(/^(?!−)/, "+");
export const percent = (share: number): string => `${(100 * share).toFixed(1).replace(/^-0\.0$/, "0.0").replace("-", "−")} %`;
export const bytes = (n: number | undefined): string =>
  n === undefined ? "–" : n < 1e4 ? `${n} B` : n < 1e7 ? `${(n / 1e3).toFixed(0)} kB` : `${(n / 1e6).toFixed(1)} MB`;
