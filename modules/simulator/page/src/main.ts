// SPDX-License-Identifier: GPL-3.0-or-later
import { redrawCharts } from "../../../report/viewer/src/charts";
import { el, section } from "../../../report/viewer/src/dom";
import { preparePrints } from "../../../report/viewer/src/paper";
import { builderSection, caseFile } from "./builder";
import { besides, controlPanel, messages } from "./controls";
import { Core } from "./core";
import { Simulation } from "./simulation";
import { CaseStore } from "./store";

declare global {
  interface Window {
    /** For scripts that look at an open page. */
    brashSimulator?: { store: CaseStore; simulation: Simulation | null; core: Core | null; firstPicture?: number };
  }
}

const kThemes = ["auto", "light", "dark"];

function header(title: string, subtitle: string, retheme: () => void): HTMLElement {
  const root = document.documentElement;
  const theme = el("select", { "aria-label": "Colours", change: () => {
    root.dataset.theme = theme.value;
    retheme();
  } }, ...kThemes.map((name) => el("option", { value: name }, name)));
  return el("header", {},
    el("a", { class: "skip", href: "#start" }, "Skip to the page"),
    el("div", { class: "title" }, el("h1", {}, title), el("p", {}, subtitle)),
    el("nav", { "aria-label": "Contents" }), el("label", { class: "theme" }, theme));
}

async function main(): Promise<void> {
  const parent = document.getElementById("report")!;
  const loading = el("p", { class: "note", role: "status" }, "The core is being unpacked.");
  parent.append(loading);
  const core = await Core.start();
  loading.remove();
  const store = new CaseStore(core, document.getElementById("brash-template")!.textContent!, core ? "cone.toml" : "mine.toml");
  const simulation = core ? new Simulation(store) : null;
  window.brashSimulator = { store, simulation, core };
  const retheme = () => {
    redrawCharts();
    simulation?.report?.replay?.scenes.forEach((scene) => scene.setTheme());
  };
  const title = core ? "brash simulator" : "brash case builder";
  document.title = title;
  const subtitle = core ? "how a structure breaks ice · this file holds the program, and asks no network" : "a form for every key of a case";
  const head = header(title, subtitle, retheme);
  const { element, copy } = caseFile(store);
  parent.append(head, el("div", { id: "start", tabindex: -1 }));
  if (simulation)
    parent.append(section("simulator", "Simulator", controlPanel(store, copy), messages(store), simulation.controls, simulation.view));
  parent.append(builderSection(store, element, messages(store), core ? besides(store) : null));
  head.querySelector("nav")!.append(...["simulator", "builder"].flatMap((id) => {
    const part = document.getElementById(id);
    return part ? [el("a", { href: `#${id}` }, part.querySelector("h2")!.textContent)] : [];
  }), el("a", { href: "#case-file" }, "Case file"));
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", retheme);
  preparePrints(retheme);
  await store.check();
  await simulation?.reset();
  requestAnimationFrame(() => setTimeout(() => (window.brashSimulator!.firstPicture = performance.now())));
}

main().catch((error: unknown) => {
  document.getElementById("report")!.append(el("p", { class: "note bad" }, `This page cannot be shown: ${String(error)}`));
  throw error;
});
