// SPDX-License-Identifier: GPL-3.0-or-later
// The ice and the water of a site, with sources: the choice that `brash new --ice` offers.
import { el } from "../../../report/viewer/src/dom";
import { commentIn, valueIn, withValue } from "./case_text";
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

/** The case with the ice of a site. Model ice has the values of the case that the page began with. */
function withIce(toml: string, ice: SiteIce, name: string, first: string): string {
  const site = ice.sites[name];
  return Object.keys(ice.keys).reduce((text, path) => {
    const [section, key] = path.split(".");
    if (path in site.values) return withValue(text, section, key, JSON.stringify(site.values[path][0]), `# ${name}: ${sourceOf(ice, site, path)}`);
    return withValue(text, section, key, valueIn(first, section, key), commentIn(first, section, key));
  }, toml);
}

export function iceChoice(store: CaseStore): HTMLElement {
  const ice = JSON.parse(document.getElementById("brash-site-ice")!.textContent!) as SiteIce;
  const first = store.text;
  const choose = el("select", { id: "site-ice", change: () => store.set(withIce(store.text, ice, choose.value, first)) },
    ...Object.entries(ice.sites).map(([name, site]) => el("option", { value: name }, `${name}: ${site.name}`)));
  return el("p", { class: "do" }, el("label", { for: "site-ice" }, "Ice "), choose,
    " It sets thickness, strengths, modulus, densities and friction. The case file names the source of each value.");
}
