#!/usr/bin/env node
// SPDX-License-Identifier: GPL-3.0-or-later
// How long a report takes until it can be used, and to draw a frame: load.mjs REPORT.html
// Processor time of the page's main thread, which a busy machine does not change, beside wall time. The drawing itself is
// done by SwiftShader in a process of its own; a graphics card takes a small part of that.
import { statSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const root = join(dirname(fileURLToPath(import.meta.url)), "../../..");
process.env.BRASH_PACKAGES ??= join(root, "build/release/modules/report/viewer");
const { browse, until } = await import("../../modules/report/browser.mjs");

const [file] = process.argv.slice(2);
const browser = await browse();
const page = await browser.context.newPage();
const devtools = await browser.context.newCDPSession(page);
await devtools.send("Performance.enable", { timeDomain: "threadTicks" });
const spent = async () => {
  const { metrics } = await devtools.send("Performance.getMetrics");
  return metrics.find(({ name }) => name === "TaskDuration").value;
};
await page.goto(pathToFileURL(file).href);
await until(page, () => window.brashReport?.readyAfter > 0);
const [loaded, wall] = [await spent(), await page.evaluate(() => window.brashReport.readyAfter)];
const { floes, frames } = await page.evaluate(() => ({
  floes: window.brashReport.run.nFloes,
  frames: window.brashReport.run.column("frame.time").length,
}));
const kSteps = 50;
await page.evaluate((n) => {
  const { player } = window.brashReport.report;
  for (let i = 0; i < n; ++i) player.seek((player.duration * i) / n);
}, kSteps);
console.log(`${file}: ${(statSync(file).size / 1e6).toFixed(2)} MB, ${floes} floes, ${frames} frames`);
console.log(`ready after ${loaded.toFixed(2)} s of processor time (${(wall / 1e3).toFixed(2)} s on the clock)`);
console.log(`${((1e3 * ((await spent()) - loaded)) / kSteps).toFixed(1)} ms of processor time a frame of the replay`);
await browser.close();
