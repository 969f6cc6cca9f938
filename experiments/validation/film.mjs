#!/usr/bin/env node
// SPDX-License-Identifier: GPL-3.0-or-later
// The film and the figures of a run in README and site, each by the export of its report: film.mjs RUN_FOLDER [PICTURE_FOLDER]
// The report films in WebM. A README shows that nowhere, so its pictures become an animated WebP (Debian: python3-pil).
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { browse, look, root, saved, sized, smoothed } from "./replay_page.mjs";

const [run, pictures = join(root, "docs/figures")] = process.argv.slice(2);
const kSpeed = "4";           // of the report's film
const kSlower = 2;            // than the film the WebP is
const kPerSecond = 8;         // pictures of the WebP
const kQuality = 55;          // of its pictures, 0 to 100
const [kWidth, kHeight] = [720, 392];

const browser = await browse({ width: 1600, height: 1000 });
const folder = mkdtempSync(join(tmpdir(), "brash-film-"));

/** Writes what a button saves. */
async function write(page, name, buttons, format) {
  const { bytes } = await saved(page, buttons.getByRole("button", { name: format, exact: true }));
  writeFileSync(join(pictures, name), bytes);
  console.log(`${join(pictures, name)}: ${(bytes.length / 1e3).toFixed(0)} kB`);
}

async function figures() {
  const page = await browser.open(join(run, "report.html"));
  await write(page, "validation-loads.svg", page.locator(".loads .chart"), "SVG");
  await write(page, "validation-channel.png", page.locator(".plan-view"), "PNG");
  await write(page, "validation-crack.png", page.locator(".event-card figure"), "PNG");
  await page.close();
}

/** The report's own film. */
async function film() {
  const page = await browser.open(join(run, "report.html"));
  await sized(page, kWidth, kHeight);
  await look(page, "Wake");
  // Pictures twice as fine as wanted, which the reduction smooths; the page would film coarse ones in software.
  await page.evaluate(() => {
    const { scene } = window.brashReport.report.replay;
    scene.setMoving = () => {};
    scene.renderer.setPixelRatio(2);
  });
  await page.getByLabel("Speed of the replay").selectOption(kSpeed);
  // A machine without a graphics card takes minutes.
  const made = page.waitForEvent("download", { timeout: 0 });
  await page.getByRole("button", { name: "film", exact: true }).evaluate((button) => button.click());
  const bytes = readFileSync(await (await made).path());
  await page.close();
  return bytes;
}

/** Its pictures as files, in order. */
async function picturesOf(webm) {
  const page = await browser.context.newPage();
  const duration = await page.evaluate(async (data) => {
    window.film = Object.assign(document.createElement("video"), { muted: true, src: `data:video/webm;base64,${data}` });
    await new Promise((done, fail) => Object.assign(window.film, { onloadeddata: done, onerror: () => fail(new Error(window.film.error.message)) }));
    return window.film.duration;
  }, webm.toString("base64"));
  const paths = [];
  for (let time = 0; time < duration; time += 1 / (kSlower * kPerSecond)) {
    const png = await page.evaluate(async (at) => {
      const { film: video } = window;
      video.currentTime = at;
      await new Promise((done) => (video.onseeked = done));
      const canvas = Object.assign(document.createElement("canvas"), { width: video.videoWidth, height: video.videoHeight });
      canvas.getContext("2d").drawImage(video, 0, 0);
      return canvas.toDataURL("image/png").split(",")[1];
    }, time);
    paths.push(join(folder, `${String(paths.length).padStart(4, "0")}.png`));
    writeFileSync(paths.at(-1), Buffer.from(png, "base64"));
  }
  await page.close();
  return paths;
}

/** One WebP of all, without end; its last picture stays for two seconds. */
const kJoin = `
import sys
from PIL import Image
path, quality, milliseconds, *names = sys.argv[1:]
first, *rest = [Image.open(name).convert("RGB").reduce(2) for name in names]
durations = [int(milliseconds)] * len(rest) + [2000]
first.save(path, save_all=True, append_images=rest, duration=durations, loop=0, quality=int(quality), method=6)
`;

await figures();
await smoothed(browser);
const webm = await film();
const frames = await picturesOf(webm);
const path = join(pictures, "validation-film.webp");
execFileSync("/usr/bin/python3", ["-c", kJoin, path, kQuality, Math.round(1e3 / kPerSecond), ...frames].map(String), { stdio: "inherit" });
console.log(`${path}: ${(statSync(path).size / 1e3).toFixed(0)} kB, ${frames.length} pictures; the report's WebM: ${(webm.length / 1e3).toFixed(0)} kB`);
rmSync(folder, { recursive: true });
await browser.close();
