#!/usr/bin/env node
// SPDX-License-Identifier: GPL-3.0-or-later
// How long a report takes until it can be used, and to draw a frame: load.mjs REPORT.html
// Medians of seven pages in a browser that runs already; the first one, which starts the browser's own processes, stands
// apart. Processor time is that of the page's main thread, which a busy machine does not change. The drawing is done by
// SwiftShader, on the processor; a graphics card takes a small part of that.
import { statSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const root = join(dirname(fileURLToPath(import.meta.url)), "../../..");
process.env.BRASH_PACKAGES ??= join(root, "build/release/modules/report/viewer");
const { browse, until } = await import("../../modules/report/browser.mjs");

const kPages = 7;
const kSteps = 50;
const [file] = process.argv.slice(2);
const browser = await browse();

async function load() {
  const page = await browser.context.newPage();
  const devtools = await browser.context.newCDPSession(page);
  await devtools.send("Performance.enable", { timeDomain: "threadTicks" });
  const spent = async () => {
    const { metrics } = await devtools.send("Performance.getMetrics");
    return metrics.find(({ name }) => name === "TaskDuration").value;
  };
  await page.goto(pathToFileURL(file).href);
  await until(page, () => window.brashReport?.readyAfter > 0);
  const processor = await spent();
  const clock = await page.evaluate(() => window.brashReport.readyAfter / 1e3);
  const { floes, frames } = await page.evaluate(() => ({
    floes: window.brashReport.run.nFloes,
    frames: window.brashReport.run.column("frame.time").length,
  }));
  await page.evaluate((n) => {
    const { player } = window.brashReport.report;
    for (let i = 0; i < n; ++i) player.seek((player.duration * i) / n);
  }, kSteps);
  const frame = (await spent() - processor) / kSteps;
  await page.close();
  return { processor, clock, frame, floes, frames };
}

const first = await load();
const pages = [];
for (let i = 0; i < kPages; ++i) pages.push(await load());
const sorted = (name) => pages.map((page) => page[name]).sort((a, b) => a - b);
const median = (name) => sorted(name)[(kPages - 1) / 2];
const clocks = sorted("clock");
console.log(`${file}: ${(statSync(file).size / 1e6).toFixed(2)} MB, ${first.floes} floes, ${first.frames} frames`);
console.log(`ready after ${median("processor").toFixed(2)} s of processor time, ${median("clock").toFixed(2)} s on the clock ` +
  `(${clocks[0].toFixed(2)} to ${clocks.at(-1).toFixed(2)}; the first page ${first.clock.toFixed(2)})`);
console.log(`${(1e3 * median("frame")).toFixed(1)} ms of processor time a frame of the replay`);
await browser.close();
