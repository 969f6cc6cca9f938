// SPDX-License-Identifier: GPL-3.0-or-later
// Plausible values, narrower than the allowed ones: the warnings of `brash check` about them, for a page without the core.
import { typedOf, valueIn } from "./case_text";
import { type KeySchema, type Range, readSchema, sectionsOf } from "./schema";

export interface Warning {
  id: string;
  text: string;
}

/** Names of a unit and its multiples that a case file may have; the sizes are in the unit. */
const kUnits: Record<string, Record<string, number>> = {
  Pa: { Pa: 1, kPa: 1e3, MPa: 1e6, GPa: 1e9 },
  m: { m: 1, cm: 1e-2, mm: 1e-3, km: 1e3 },
  "kg m-3": { "kg/m3": 1, "kg m-3": 1, "kg/m^3": 1, "t/m3": 1e3 },
  "m s-1": { "m/s": 1, "m s-1": 1, "cm/s": 1e-2, "km/h": 1 / 3.6 },
  "1": { "": 1, percent: 1e-2, "%": 1e-2 },
  rad: { rad: 1, deg: Math.PI / 180 },
};

/** A unit in SI; NaN where this page does not know it. */
export const sizeOfUnit = (name: string, si: string): number => kUnits[si]?.[name] ?? NaN;

/** A quantity in SI; NaN where this page does not know the unit. */
function inSi(value: string, unit: string): number {
  const found = /^([-+.\d][-+.\deE]*)\s*(.*)$/.exec(typedOf(value).trim());
  if (!found) return NaN;
  const isBare = found[2] === "" && !/^["']/.test(value);
  return Number(found[1]) * (isBare ? 1 : (kUnits[unit]?.[found[2]] ?? NaN));
}

/** The size of a value in SI: of a number, or of a vector. */
function sizeOf(value: string, unit: string): number {
  const items = /^\[(.*)\]$/s.exec(value.trim());
  return items ? Math.hypot(...items[1].split(",").map((item) => inSi(item.trim(), unit))) : inSi(value, unit);
}

/** A quantity in the unit that keeps it short: 0.33 m is 33 cm. */
function inWords(value: number, unit: string): string {
  const shown = (size: number, name: string) => `${Number((value / size).toPrecision(4))}${name && ` ${name}`}`;
  if (unit === "Pa") for (const [name, size] of [["GPa", 1e9], ["MPa", 1e6], ["kPa", 1e3]] as const) if (value >= size) return shown(size, name);
  if (unit === "m") return value < 1 ? shown(1e-2, "cm") : shown(1, "m");
  return shown(1, { "kg m-3": "kg/m3", "m s-1": "m/s", "1": "" }[unit] ?? unit);
}

const rangeText = ({ least, most }: Range, unit: string): string => `${inWords(least, unit)} to ${inWords(most, unit)}`;

/** The plausible values of a key in a sentence; "" where it has none. */
export function plausibleText(schema: KeySchema): string {
  const ranges = schema["x-plausible"];
  if (!ranges) return "";
  const unit = schema["x-unit"] ?? "1";
  return `Plausible: ${rangeText(ranges.sea, unit)} at sea${ranges.model ? `, ${rangeText(ranges.model, unit)} in model ice` : ""}. `;
}

const has = ({ least, most }: Range, value: number): boolean => value >= least && value <= most;

/** Whether the source of a reference is a test in a basin. */
export const namesABasin = (source: string): boolean => /basin|ice tank|model test|model ice/i.test(source);

/** The value of a key as it is written, or its default. */
function written(toml: string, section: string, key: string, schema: KeySchema): string | null {
  const usual = schema.default === undefined || schema.default === "" ? null : JSON.stringify(schema.default);
  return valueIn(toml, section, key) ?? usual;
}

/** Whether the ice may be model ice: as thin as sheets of basins are, or of a reference from a basin. */
function mayBeModelIce(toml: string, thickness: KeySchema): boolean {
  const model = thickness["x-plausible"]?.model;
  const value = written(toml, "ice", "thickness", thickness);
  const isThin = model !== undefined && value !== null && has(model, inSi(value, "m"));
  return isThin || namesABasin(typedOf(valueIn(toml, "reference", "source") ?? ""));
}

function warningOf(where: string, value: string, schema: KeySchema, mayBeModel: boolean): Warning | null {
  const ranges = schema["x-plausible"]!;
  const unit = schema["x-unit"] ?? "1";
  const size = sizeOf(value, unit);
  const isModel = ranges.model !== undefined && has(ranges.model, size);
  if (Number.isNaN(size) || has(ranges.sea, size) || (isModel && mayBeModel)) return null;
  const text = isModel
    ? `${where} = ${value} is of model ice, and the thickness is of ice at sea, which has ${rangeText(ranges.sea, unit)} (${ranges.sea.source}): take the ice of a site, or name the basin of a test in reference.source`
    : `${where} = ${value} has not been measured. ${plausibleText(schema)}Check its unit. Sources: ${[ranges.sea, ranges.model].flatMap((range) => range?.source ?? []).join("; ")}`;
  return { id: ranges.warning, text };
}

/** Values of a case outside their plausible ranges. */
export function warningsOf(toml: string): Warning[] {
  const sections = sectionsOf(readSchema());
  const thickness = sections.find(({ name }) => name === "ice")!.keys.find(({ name }) => name === "thickness")!.schema;
  const mayBeModel = mayBeModelIce(toml, thickness);
  return sections.flatMap(({ name, keys }) => keys.flatMap(({ name: key, schema }) => {
    const value = schema["x-plausible"] ? written(toml, name, key, schema) : null;
    return (value === null ? null : warningOf(`${name}.${key}`, value, schema, mayBeModel || key === "thickness")) ?? [];
  }));
}
