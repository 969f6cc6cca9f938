#!/usr/bin/env node
// SPDX-License-Identifier: GPL-3.0-or-later
// How long a report takes until it can be used, and to draw a frame: load.mjs REPORT.html
// Medians of seven pages in a browser that runs already; the first one, which starts the browser's own processes, stands
// apart. Processor time is that of the page's main thread, which a busy machine does not change. The drawing is done by
// SwiftShader, on the processor; a graphics card takes a small part of that. A picture of the playing replay is told twice:
// as pictures a second on the clock, and as processor time of all the browser's processes, which a busy machine does not
// change. BRASH_PAGES sets the number of pages [7].
import { readdirSync, readFileSync, statSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const root = join(dirname(fileURLToPath(import.meta.url)), "../../..");
process.env.BRASH_PACKAGES ??= join(root, "build/release/modules/report/viewer");
const { browse, until } = await import("../../modules/report/browser.mjs");

const kPages = Number(process.env.BRASH_PAGES ?? 7);
const kPictures = 30;
const kTicks = 100;  // of Linux's clock for processes, a second
const kSteps = 50;
const [file] = process.argv.slice(2);
const browser = await browse();

/** Processor time [s] of this process's children and theirs. */
function browserTime() {
  const found = new Map();
  for (const id of readdirSync("/proc").filter((name) => /^\d+$/.test(name))) {
    try {
      const fields = readFileSync(`/proc/${id}/stat`, "utf8").replace(/^.*\) /s, "").split(" ");
      found.set(Number(id), { parent: Number(fields[1]), time: (Number(fields[11]) + Number(fields[12])) / kTicks });
    } catch {
      // It has ended.
    }
  }
  const isMine = (id) => id === process.pid || (found.has(id) && isMine(found.get(id).parent));
  return [...found].filter(([id]) => id !== process.pid && isMine(id)).reduce((sum, [, { time }]) => sum + time, 0);
}

/** Pictures of the playing replay: how many a second, and processor time of each [s]. */
async function play(page) {
  const before = browserTime();
  const seconds = await page.evaluate((n) => new Promise((done) => {
    const { player, replay: { scene } } = window.brashReport.report;
    const { onDraw } = scene;
    let [drawn, start] = [0, 0];
    player.seek(0.3 * player.duration);
    scene.onDraw = () => {
      onDraw();
      if (drawn++ === 0) start = performance.now();
      if (drawn <= n && player.playing) return;
      if (drawn <= n) {
        player.seek(0.3 * player.duration);
        return player.toggle();
      }
      scene.onDraw = onDraw;
      player.pause();
      done((performance.now() - start) / 1e3);
    };
    player.setSpeed(0.1);
    player.toggle();
  }), kPictures);
  return { rate: kPictures / seconds, picture: (browserTime() - before) / kPictures };
}

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
  const { rate, picture } = await play(page);
  await page.close();
  return { processor, clock, frame, floes, frames, rate, picture };
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
console.log(`${(1e3 * median("frame")).toFixed(1)} ms of the page's processor time a frame of the replay`);
console.log(`${median("rate").toFixed(1)} pictures a second while it plays (${sorted("rate")[0].toFixed(1)} to ${sorted("rate").at(-1).toFixed(1)}), ` +
  `${(1e3 * median("picture")).toFixed(0)} ms of the browser's processor time each`);
await browser.close();
