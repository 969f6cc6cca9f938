#!/usr/bin/env node
// SPDX-License-Identifier: GPL-3.0-or-later
// What watching costs a run: view_cost.mjs [ROUNDS], processor time of `brash run --view` against a run that nobody watches.
// The first 10 s of the validation case by one thread. It is watched by one browser, and by a reader that takes all and
// draws nothing: the difference is what a browser that draws in software costs the caches of the machine that both use.
// The browser's own processor time is not in it. The order changes from round to round. Prints mean ratios with Student's
// 95 % intervals.
import { spawn } from "node:child_process";
import { rmSync } from "node:fs";
import { get, request } from "node:http";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const root = join(dirname(fileURLToPath(import.meta.url)), "../../..");
process.env.BRASH ??= join(root, "build/release/bin/brash");
process.env.BRASH_PACKAGES ??= join(root, "build/release/modules/report/viewer");
const { browse, scratch } = await import("../../modules/report/browser.mjs");

const kArguments = ["run", join(root, "experiments/validation/cone.toml"), "--threads", "1", "--set", "time.duration=10"];
/** Student's 97.5 % quantiles for 2 to 15 degrees of freedom, from the third round on. */
const kStudent = [4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228, 2.201, 2.179, 2.160, 2.145, 2.131];
const nRounds = Math.min(kStudent.length + 2, Math.max(3, Number(process.argv[2] ?? 8)));
const folder = scratch();
const browser = await browse({ offline: false });

const post = (address, what) => new Promise((done, fail) => {
  request(new URL(what, address), { method: "POST", agent: false }, (response) => response.resume().on("end", done)).on("error", fail).end();
});

/** Takes everything that a page at `address` would. @return that ends with the run, once it has begun. */
const read = (address) => new Promise((begun) => {
  get(address, { agent: false }, (page) => page.resume().on("end", () =>
    get(new URL("events", address), { agent: false }, (events) => {
      const ended = new Promise((done) => events.on("end", done).on("error", done).resume());
      begun({ ended });
    })));
});

/** Processor time [s] of one run; the shell tells that of its child. @param watcher "nobody", "reader" or "browser" */
async function run(watcher, name) {
  const options = ["-o", join(folder, name), ...(watcher === "nobody" ? [] : ["--view"])];
  const child = spawn("bash", ["-c", '"$@" >/dev/null || exit 1; times', "bash", process.env.BRASH, ...kArguments, ...options], { stdio: ["ignore", "pipe", "pipe"] });
  let [times, said] = ["", ""];
  child.stdout.on("data", (text) => (times += text));
  const ended = new Promise((done) => child.on("close", done));
  const told = new Promise((done) => child.stderr.on("data", (text) => /watch at  (\S+)\n/.test((said += text)) && done()));
  let page = null;
  if (watcher !== "nobody") {
    await told;
    const address = /watch at  (\S+)/.exec(said)[1];
    await post(address, "pause");
    if (watcher === "browser") page = await browser.open(address);
    else await read(address);
    await post(address, "resume");
  }
  if (await ended !== 0) throw new Error(`the run failed: ${said}`);
  await page?.close();
  const [, user, system] = /\n(\S+) (\S+)\s*$/.exec(times);
  const seconds = (text) => Number(text.split("m")[0]) * 60 + parseFloat(text.split("m")[1]);
  return seconds(user) + seconds(system);
}

const kWatchers = ["nobody", "reader", "browser"];
const ratios = { reader: [], browser: [] };
for (let i = 0; i < nRounds; ++i) {
  const time = {};
  for (let k = 0; k < kWatchers.length; ++k) {
    const watcher = kWatchers[(i + k) % kWatchers.length];
    time[watcher] = await run(watcher, `${i}-${watcher}`);
  }
  for (const watcher of ["reader", "browser"]) ratios[watcher].push(time[watcher] / time.nobody);
  console.log(`round ${i + 1}: ${kWatchers.map((watcher) => `${watcher} ${time[watcher].toFixed(2)} s`).join(", ")}`);
}
for (const [watcher, all] of Object.entries(ratios)) {
  const mean = all.reduce((sum, ratio) => sum + ratio, 0) / nRounds;
  const deviation = Math.sqrt(all.reduce((sum, ratio) => sum + (ratio - mean) ** 2, 0) / (nRounds - 1));
  const half = kStudent[nRounds - 3] * deviation / Math.sqrt(nRounds);
  const percent = (ratio) => (100 * (ratio - 1)).toFixed(1);
  console.log(`a ${watcher} costs ${percent(mean)} % of a run's processor time (95 %: ${percent(mean - half)} to ${percent(mean + half)}; ${nRounds} rounds)`);
}
await browser.close();
rmSync(folder, { recursive: true });
