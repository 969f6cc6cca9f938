// SPDX-License-Identifier: GPL-3.0-or-later
// What a campaign varied: inputs that are axes of a grid, and lists of settings that only their names distinguish.
import { kLabel, schemaOf } from "./campaign_names";
import type { CampaignData, CampaignSetting } from "./types";

type Count = (...keys: string[]) => number;

/** How many combinations of values keys take. */
const counts = (settings: CampaignSetting[]): Count => (...keys) =>
  new Set(settings.map((s) => JSON.stringify(keys.map((key) => s.values[key])))).size;

/** Keys that take more than one value, without those that follow from another; of those that change together, the first. */
function variedKeys(settings: CampaignSetting[], count: Count): string[] {
  const varied = Object.keys(settings[0]?.values ?? {}).filter((key) => count(key) > 1);
  const follows = (key: string, other: string) => count(key, other) === count(other);
  return varied.filter((key, i) => !varied.some((other, j) => j !== i && follows(key, other) && (j < i || !follows(other, key))));
}

/** Whether every value of each of the keys meets every value of the others. */
const isGrid = (count: Count, keys: string[]): boolean => keys.reduce((product, key) => product * count(key), 1) === count(...keys);

export interface Axes {
  /** The data, whose settings have their names as a value where the names are used for inputs. */
  data: CampaignData;
  /** Inputs that distinguish the settings. */
  keys: string[];
  /** Those inputs that are numbers on axes of their own. */
  numeric: string[];
}

/** The inputs that a campaign varied. Inputs that form no grid among each other become one: the setting's name. */
export function axesOf(data: CampaignData): Axes {
  const { settings } = data.summary;
  const count = counts(settings);
  const keys = variedKeys(settings, count);
  const isNumber = (key: string) =>
    schemaOf(data.schema, key)?.type !== "boolean" && settings.every((s) => typeof s.values[key] === "number");
  if (isGrid(count, keys)) return { data, keys, numeric: keys.filter(isNumber) };
  const free = keys.filter((key) => count(key) * count(...keys.filter((other) => other !== key)) === count(...keys));
  const joined = keys.filter((key) => !free.includes(key));
  const names = namesOf(settings, free, joined);
  const named = settings.map((s, i) => ({ ...s, values: { [kLabel]: names[i], ...s.values } }));
  return { data: { ...data, summary: { ...data.summary, settings: named } }, keys: [kLabel, ...free], numeric: free.filter(isNumber) };
}

/** The parts of each setting's name that settings with the same values of `joined` have in common. */
function namesOf(settings: CampaignSetting[], free: string[], joined: string[]): string[] {
  const without = free.map((key) => new RegExp(`(^|_)${key.split(".").at(-1)!}-[^_]*`));
  const parts = (s: CampaignSetting) => without.reduce((name, part) => name.replace(part, ""), s.setting).split("_").filter((part) => part !== "");
  const groupOf = (s: CampaignSetting) => JSON.stringify(joined.map((key) => s.values[key]));
  const common = new Map<string, string[]>();
  for (const s of settings) common.set(groupOf(s), (common.get(groupOf(s)) ?? parts(s)).filter((part) => parts(s).includes(part)));
  return settings.map((s) => common.get(groupOf(s))!.join("_") || s.setting);
}

/** Inputs in which a setting differs from the first one, except the inputs that are shown beside it. */
export function differing(data: CampaignData, setting: CampaignSetting, beside: string[]): string[] {
  const [first] = data.summary.settings;
  return Object.keys(first.values).filter((key) => !beside.includes(key) && JSON.stringify(first.values[key]) !== JSON.stringify(setting.values[key]));
}
