// SPDX-License-Identifier: GPL-3.0-or-later
// Inputs and results of a campaign as a reader calls them, in units that read well.
import { number, rounded } from "./format";
import type { CampaignColumn, CampaignData, CampaignSetting, Schema, SchemaKey } from "./types";

/** The name of a setting where it is used in place of inputs; no input has a key without a dot. */
export const kLabel = "label";

/** A quantity: its name, its unit, and what an SI value is multiplied with. */
export interface Quantity {
  name: string;
  unit: string;
  scale: number;
}

export const titleOf = ({ name, unit }: Quantity): string => (unit ? `${name} [${unit}]` : name);

const spaced = (key: string): string => key.replace(/[._]/g, " ");

/** Units of the schema as they are shown. */
const kShown: Record<string, [string, number]> = {
  "1": ["", 1], rad: ["°", 180 / Math.PI], "m s-1": ["m/s", 1], N: ["kN", 1e-3], Pa: ["kPa", 1e-3], "kg m-3": ["kg/m³", 1],
};

/** What the schema says of a key, which may lie in a section of a section. */
export function schemaOf(schema: Schema, key: string): SchemaKey | undefined {
  let at: { properties?: Record<string, SchemaKey> } | undefined = schema;
  for (const part of key.split(".")) at = at?.properties?.[part] as typeof at;
  return at as SchemaKey | undefined;
}

/** An input: "ice thickness [m]" for `ice.thickness`, and "setting" where names are used for inputs. */
export function inputOf(data: CampaignData, key: string): Quantity {
  if (key === kLabel) return { name: "setting", unit: "", scale: 1 };
  const written = schemaOf(data.schema, key)?.["x-unit"] ?? "1";
  const [unit, scale] = kShown[written] ?? [written, 1];
  return { name: spaced(key), unit, scale };
}

export const meaningOf = (data: CampaignData, key: string): string =>
  key === kLabel ? "the name that the plan gives" : `${key}: ${schemaOf(data.schema, key)?.description ?? "an input"}`;

const kStatistics: Record<string, string> = {
  mean: "mean", standard_deviation: "deviation of the", minimum: "smallest", maximum: "largest", quantile_1: "1 % quantile of the", quantile_50: "median",
  quantile_95: "95 % quantile of the", quantile_99: "99 % quantile of the", skewness: "skewness of the",
  autocorrelation_time: "autocorrelation time of the", effective_sample_size: "independent samples of the",
};
const kLoads: Record<string, string> = { horizontal: "horizontal load", vertical: "vertical load" };
const kOthers: Record<string, Quantity> = {
  breaking_frequency: { name: "breaks a second", unit: "1/s", scale: 1 },
  n_breaks: { name: "breaks", unit: "", scale: 1 },
  n_floes_born: { name: "floes born", unit: "", scale: 1 },
  n_floes_present: { name: "floes at the end", unit: "", scale: 1 },
  fastest_floe: { name: "fastest floe", unit: "m/s", scale: 1 },
};

/** Units of the other results by parts of their names, and what an SI value is multiplied with. */
const kUnits: [string, string, number][] = [
  ["mean_by_region.", "kN", 1e-3], ["piece_area", "m²", 1], ["breaking_length", "m", 1], ["size_quantiles", "m", 1],
  ["contact_iterations.", "m/s", 1], ["statistics_from", "s", 1],
];

/** A result: "mean horizontal load [kN]" for `horizontal.mean`. */
export function resultOf(column: string): Quantity {
  const [load, statistic, cause] = column.split(".");
  if (kOthers[column]) return kOthers[column];
  if (kLoads[load] && kStatistics[statistic]) {
    const plain = ["skewness", "effective_sample_size"].includes(statistic);
    const [unit, scale] = statistic === "autocorrelation_time" ? ["s", 1] : plain ? ["", 1] : ["kN", 1e-3];
    return { name: `${kStatistics[statistic]} ${kLoads[load]}`, unit: unit as string, scale: scale as number };
  }
  if (kLoads[load] && statistic === "mean_by_cause") return { name: `mean ${kLoads[load]} from ${spaced(cause ?? "")}`, unit: "kN", scale: 1e-3 };
  if (kLoads[load] && statistic === "mean_95") return { name: `${cause} end of the interval of the mean ${kLoads[load]}`, unit: "kN", scale: 1e-3 };
  if (load === "mean_whole_history") return { name: `mean ${statistic} load, whole history`, unit: "kN", scale: 1e-3 };
  if (load === "energy") return { name: `energy: ${spaced(column.slice("energy.".length))}`, unit: "kJ", scale: 1e-3 };
  const [, unit, scale] = kUnits.find(([part]) => column.includes(part)) ?? ["", "", 1];
  return { name: spaced(column), unit, scale };
}

/** The value of an input of a setting. */
export function valueOf(data: CampaignData, setting: CampaignSetting, key: string): string {
  const { unit, scale } = inputOf(data, key);
  const value = setting.values[key];
  if (schemaOf(data.schema, key)?.type === "boolean") return value ? "on" : "off";
  const text = typeof value === "number" ? number(value * scale, 4).replace(/(\.\d*?)0+$/, "$1").replace(/\.$/, "") : String(value);
  return unit && typeof value === "number" ? `${text} ${unit}`.replace(" °", "°") : text;
}

/** A setting by its inputs: "structure angle 50°, structure speed 0.5 m/s". */
export const settingName = (data: CampaignData, setting: CampaignSetting, keys: string[]): string =>
  keys.length === 0 ? setting.setting : keys.map((key) => `${inputOf(data, key).name} ${valueOf(data, setting, key)}`).join(", ");

/** Decimals of all means of one result: two digits of the middle one of its intervals. Null where none has an interval. */
export function decimalsOf(columns: (CampaignColumn | undefined)[], scale: number): number | null {
  const halves = columns.flatMap((column) => (column?.mean_95 ? [0.5 * scale * (column.mean_95[1] - column.mean_95[0])] : []));
  const known = halves.filter((half) => half > 0).sort((a, b) => a - b);
  if (known.length === 0) return halves.length > 0 ? 2 : null;
  return Math.min(6, Math.max(0, 1 - Math.floor(Math.log10(known[Math.floor(known.length / 2)]))));
}

/** A mean with its interval: "240.3 (231.4 to 249.1)". */
export function meanText(column: CampaignColumn | undefined, scale: number, decimals: number | null): string {
  if (!column || column.mean === null) return "none";
  const text = (n: number) => (decimals === null ? number(n, 4) : rounded(n, decimals));
  if (!column.mean_95) return `${text(column.mean * scale)} (one run)`;
  const [low, high] = column.mean_95.map((n) => n * scale);
  return `${text(column.mean * scale)} (${text(low)} to ${text(high)})`;
}
