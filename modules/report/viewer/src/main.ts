// SPDX-License-Identifier: GPL-3.0-or-later
import { showCampaign } from "./campaign";
import { redrawCharts } from "./charts";
import { part, readBlocks, readData, Run } from "./data";
import { el } from "./dom";
import { chooseUnitsFor } from "./figures";
import { type LiveReport, showLive } from "./live";
import { preparePrints } from "./paper";
import { type RunReport, showRun } from "./run";
import type { Manifest, PageData } from "./types";

declare global {
  interface Window {
    /** For scripts that look at an open report. */
    brashReport?: { run?: Run; report?: RunReport | LiveReport; readyAfter?: number };
  }
}

const kThemes = ["auto", "light", "dark"];

function subtitle(data: PageData): string {
  const { manifest } = data;
  const two = data.kind === "run" && data.other;
  const parts = [two ? "two simulated runs" : { run: "simulated run", live: "run in progress", campaign: "campaign" }[data.kind]];
  if (manifest.seeds && !two) parts.push(`seed ${manifest.seeds.seed}`);
  if (manifest.volatile?.started_at) parts.push(manifest.volatile.started_at.slice(0, 10));
  const origins = [data.origin, ...(two ? [two.origin] : [])];
  parts.push(...new Set(origins.map((origin) => origin || `program: brash ${manifest.program?.version ?? ""}`)));
  return parts.join(" · ");
}

function header(data: PageData, title: string, onTheme: () => void): HTMLElement {
  const root = document.documentElement;
  const theme = el("select", {
    "aria-label": "Colours",
    change: () => {
      root.dataset.theme = theme.value;
      onTheme();
    },
  }, ...kThemes.map((name) => el("option", { value: name }, name)));
  const keys = data.kind !== "campaign" && el("details", { class: "keys" }, el("summary", {}, "keys"),
    el("p", {}, "space: play · ← →: one frame, with shift one second · [ ]: slower, faster · , .: start, end · 1 to 5: views · on the replay w a s d: turn, + −: nearer, further · mouse: orbit, wheel, right button"));
  return el("header", {},
    el("a", { class: "skip", href: "#start" }, "Skip to the report"),
    el("div", { class: "title" }, el("h1", {}, title), el("p", {}, subtitle(data))),
    el("nav", { "aria-label": "Contents" }), keys, el("label", { class: "theme" }, "colours ", theme));
}

function fillContents(head: HTMLElement): void {
  head.querySelector("nav")!.append(...[...document.querySelectorAll("section")].map((part) =>
    el("a", { href: `#${part.id}` }, part.querySelector("h2")!.textContent)));
}

function titleOf(data: PageData): string {
  if (data.kind === "campaign") {
    const first = data.summary.settings[0];
    return `${first?.case.replace(`_${first.setting}`, "") ?? ""} campaign`;
  }
  const name = ({ manifest }: { manifest: Manifest }) => manifest.case?.name ?? "run";
  return data.kind === "run" && data.other ? `${name(data)} and ${name(data.other)}` : name(data);
}

async function main(): Promise<void> {
  const data = readData();
  const parent = document.getElementById("report")!;
  const title = titleOf(data);
  document.title = `${title} – brash report`;
  const handle: NonNullable<Window["brashReport"]> = {};
  window.brashReport = handle;
  const retheme = () => {
    redrawCharts();
    handle.report?.replay?.scenes.forEach((scene) => scene.setTheme());
    handle.report?.player.seek(handle.report.player.time);
  };
  const head = header(data, title, retheme);
  parent.append(head, el("div", { id: "start", tabindex: -1 }));
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", retheme);
  preparePrints(retheme);
  if (data.kind === "campaign") {
    showCampaign(data, parent);
  } else if (data.kind === "live") {
    const live = showLive(data, await readBlocks(data.blocks), parent);
    handle.report = live;
    handle.run = live.run;
  } else {
    const blocks = await readBlocks(data.blocks);
    handle.run = new Run(data, blocks);
    const other = data.other ? new Run(data.other, part(blocks, "other.")) : null;
    chooseUnitsFor(other ? [handle.run, other] : [handle.run]);
    handle.report = showRun(handle.run, other, data, parent);
    if (!handle.report.replay) head.querySelector(".keys")?.remove();
  }
  fillContents(head);
  requestAnimationFrame(() => setTimeout(() => (handle.readyAfter = performance.now())));
}

main().catch((error: unknown) => {
  document.getElementById("report")!.append(el("p", { class: "note bad" }, `This report cannot be shown: ${String(error)}`));
  throw error;
});
