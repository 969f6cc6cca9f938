// SPDX-License-Identifier: GPL-3.0-or-later
// The ice and the water of a site, with sources: the choice that `brash new --ice` offers.
import { el } from "../../../report/viewer/src/dom";
import { valueIn, withoutSource, withSource, withValue } from "./case_text";
import { readSchema, sectionsOf } from "./schema";
import type { CaseStore } from "./store";

interface Site {
  name: string;
  brine?: string;
  /** A value of a key, and a remark on it besides the source of the key. */
  values: Record<string, [string | number, string]>;
}

/** modules/io/site_ice.json. */
interface SiteIce {
  default: string;
  keys: Record<string, string>;
  sites: Record<string, Site>;
}

function sourceOf(ice: SiteIce, site: Site, key: string): string {
  const source = ice.keys[key];
  return [source, ...(source.includes("v_b") && site.brine ? [site.brine] : []), site.values[key][1]].filter((text) => text !== "").join(" ");
}

/** A key of the ice of a site: its value as it is written, null where it is left out. */
interface SiteKey {
  path: string;
  section: string;
  key: string;
  meaning: string;
  value: string | null;
}

/** The keys of a site, as `brash new` writes them. Model ice has the required ones, and its friction. */
function keysOf(ice: SiteIce, name: string): SiteKey[] {
  const sections = sectionsOf(readSchema());
  return Object.keys(ice.keys).map((path) => {
    const [section, key] = path.split(".");
    const { schema, required } = sections.find((of) => of.name === section)!.keys.find((of) => of.name === key)!;
    const usual = required || path === "ice.friction_structure" ? (schema.default ?? schema.examples![0]) : undefined;
    const value = ice.sites[name].values[path]?.[0] ?? usual;
    return { path, section, key, meaning: schema.description ?? "", value: value === undefined ? null : JSON.stringify(value) };
  });
}

/** The line at the head of a new case that names its ice. */
const kIceLine = /^# Ice: .*$/m;

/** The case with the ice of a site. */
function withIce(toml: string, ice: SiteIce, name: string): string {
  const site = ice.sites[name];
  return keysOf(ice, name).reduce((text, { path, section, key, meaning, value }) => {
    const written = withValue(withoutSource(text, section, key, meaning), section, key, value);
    return path in site.values ? withSource(written, section, key, sourceOf(ice, site, path)) : written;
  }, toml.replace(kIceLine, () => `# Ice: ${site.name}.`));
}

/** The case without the name of its ice, after a change that makes it other ice; another thickness does not. */
export function withoutIceName(toml: string, section: string, key: string): string {
  return section === "ice" && key !== "thickness" ? toml.replace(new RegExp(`${kIceLine.source}\n`, "m"), "") : toml;
}

/** The site whose ice a case has, but for its thickness; "" where it has none's. */
function siteOf(toml: string, ice: SiteIce): string {
  const isOf = (name: string) => keysOf(ice, name).every(({ path, section, key, value }) => path === "ice.thickness" || valueIn(toml, section, key) === value);
  return Object.keys(ice.sites).find(isOf) ?? "";
}

export function iceChoice(store: CaseStore): HTMLElement {
  const ice = JSON.parse(document.getElementById("brash-site-ice")!.textContent!) as SiteIce;
  const choose = el("select", { id: "site-ice", change: () => choose.value && store.alter(withIce(store.text, ice, choose.value)) },
    el("option", { value: "" }, "as written"), ...Object.entries(ice.sites).map(([name, site]) => el("option", { value: name }, `${name}: ${site.name}`)));
  store.onChange(() => (choose.value = siteOf(store.text, ice)));
  return el("p", { class: "do" }, el("label", { for: "site-ice" }, "Which ice? "), choose,
    " It sets thickness, strengths, modulus, densities and friction. The case file names the source of each value.");
}
