// SPDX-License-Identifier: GPL-3.0-or-later
// `brash run --view`: who may watch, what is seen, what can be asked, and that the run stays the same.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { mkdirSync, readFileSync, rmSync } from "node:fs";
import { request } from "node:http";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { brash, browse, doomedBrowser, readCsv, scratch, until } from "./browser.mjs";

const folder = scratch();
const kCase = join(process.env.BRASH_SOURCE, "experiments/validation/cone.toml");
const kSettings = ["--set", "time.duration=6", "--set", "output.statistics_from=1"];
const running = [];
/** A browser on a busy machine is slow [ms]. */
const kPatience = 300e3;
let browser;

before(async () => {
  browser = await browse({ offline: false });
});

after(async () => {
  await browser?.close();
  for (const { process } of running) process.kill("SIGKILL");
  rmSync(folder, { recursive: true, force: true });
});

/** Starts a run of a case that is watched. `ended` becomes its exit code. */
async function watchedCase(file, name, ...options) {
  const child = spawn(process.env.BRASH, ["run", file, "-o", join(folder, name), "--view", ...options], { stdio: ["ignore", "ignore", "pipe"] });
  const run = { process: child, ended: new Promise((done) => child.on("close", done)), said: "" };
  running.push(run);
  await new Promise((done) => child.stderr.on("data", (text) => {
    run.said += text;
    if (/watch at  \S+\n/.test(run.said)) done();
  }));
  run.address = /watch at  (\S+)/.exec(run.said)[1];
  return run;
}

const watched = (name, ...options) => watchedCase(kCase, name, ...kSettings, ...options);

/** The status of a request, without a browser. */
const ask = (address, { method = "GET", headers = {} } = {}) => new Promise((done, fail) => {
  const sent = request(address, { method, headers, agent: false }, (response) => {
    done(response.statusCode);
    response.destroy();
  });
  sent.on("error", fail);
  sent.end();
});

/** How the page is packed for a browser that takes everything. */
const encoding = (address) => new Promise((done, fail) => {
  request(address, { agent: false, headers: { "Accept-Encoding": "gzip, deflate, br" } }, (response) => {
    done(response.headers["content-encoding"]);
    response.destroy();
  }).on("error", fail).end();
});

/** The lines of a stream from its start, until `enough` of them say so or it ends. */
const stream = (address, enough = () => false) => new Promise((done, fail) => {
  let text = "";
  const sent = request(new URL("events", address), { agent: false }, (response) => {
    response.on("data", (part) => {
      text += part;
      if (enough(text)) response.destroy();
    });
    response.on("close", () => done(text));
  });
  sent.on("error", fail);
  sent.end();
});

const paused = async (address) => assert.equal(await ask(new URL("pause", address), { method: "POST" }), 204);

test("nobody comes in without the token, and nothing but this machine", { timeout: kPatience }, async () => {
  const run = await watched("token");
  await paused(run.address);
  const { origin, pathname, hostname, host } = new URL(run.address);
  assert.equal(hostname, "127.0.0.1");
  assert.match(pathname, /^\/[0-9a-f]{32}\/$/);
  const wrong = pathname.replace(/[0-9a-f]/, (digit) => (digit === "0" ? "1" : "0"));
  for (const path of ["/", wrong, `${wrong}events`, "/events", `/${"0".repeat(32)}/`, `${pathname}../events/`, pathname.toUpperCase() === pathname ? "/A/" : pathname.toUpperCase()])
    assert.equal(await ask(origin + path), 403, path);
  for (const act of ["pause", "resume", "stop"]) assert.equal(await ask(`${origin}${wrong}${act}`, { method: "POST" }), 403, act);
  // A page of another name that leads to this machine does not get in with the token either.
  assert.equal(await ask(run.address, { headers: { Host: `evil.example:${host.split(":")[1]}` } }), 403);
  assert.equal(await ask(run.address), 200);
  assert.equal(await ask(new URL("stop", run.address)), 404, "a link cannot stop a run");
  assert.equal(await encoding(run.address), undefined, "the run's processor packs the page for a way without length");
  const other = await watched("other-token");
  assert.notEqual(new URL(other.address).pathname, pathname, "each run has a token of its own");
  assert.equal(await ask(origin + new URL(other.address).pathname), 403);
  other.process.kill("SIGINT");
  assert.equal(await other.ended, 3);
  run.process.kill("SIGINT");  // also while it is paused
  assert.equal(await run.ended, 3);
});

/** Waits until the page shows the first button as `text`. */
const shows = async (page, text) => {
  while ((await page.locator(".live button").first().textContent()) !== text) await new Promise((done) => setTimeout(done, 50));
};

test("two browsers see the run go on, and one pauses it for both", { timeout: kPatience }, async () => {
  const run = await watched("pair", "--set", "time.duration=20");  // long enough to be paused by hand
  await paused(run.address);
  const [a, b] = [await browser.open(run.address), await browser.open(run.address)];
  await Promise.all([a, b].map((page) => shows(page, "Continue the run")));
  await a.getByRole("button", { name: "Continue the run" }).click();
  await shows(b, "Pause the run");
  await b.getByRole("button", { name: "Pause the run" }).click();
  await shows(a, "Continue the run");
  const duration = (page) => page.evaluate(() => window.brashReport.run.duration);
  // A step that had begun, and what was under way.
  await new Promise((done) => setTimeout(done, 1500));
  const stood = await duration(a);
  await new Promise((done) => setTimeout(done, 1500));
  assert.equal(await duration(a), stood, "a paused run goes on");
  assert.equal(await duration(b), stood);
  await b.getByRole("button", { name: "Continue the run" }).click();
  for (const page of [a, b]) await until(page, () => /The run is done/.test(document.querySelector(".live").textContent));
  assert.equal(await run.ended, 0);
  // What was streamed is what the run left.
  const history = readCsv(join(folder, "pair", "history.csv"));
  const events = readCsv(join(folder, "pair", "events.csv")).filter((row) => row.event === "break");
  for (const page of [a, b]) {
    const seen = await page.evaluate(() => {
      const { run: r, report } = window.brashReport;
      report.player.seek(r.duration);
      return { Fx: [...r.column("load.Fx")], b: [...r.column("event.b")], n: report.replay.scene.floes.nVisible, end: [...r.column("floe.end")] };
    });
    assert.deepEqual(seen.Fx, history.map((row) => Number(row.Fx)));
    assert.deepEqual(seen.b, events.map((row) => Number(row.b)));
    assert.equal(seen.n, JSON.parse(readFileSync(join(folder, "pair", "summary.json"), "utf8")).n_floes_present);
    await page.close();
  }
});

test("a field of floes is seen, with the structure where it is now and the forces so far", { timeout: kPatience }, async () => {
  const run = await watchedCase(join(process.env.BRASH_SOURCE, "experiments/fields/cone.toml"), "field", "--set", "time.duration=1");
  await paused(run.address);
  const page = await browser.open(run.address);
  await until(page, () => window.brashReport?.report?.replay);
  await page.locator("#colouring").selectOption("force");
  await page.getByRole("button", { name: "Continue the run" }).click();
  await until(page, () => /The run is done/.test(document.querySelector(".live").textContent));
  assert.equal(await run.ended, 0);
  const seen = await page.evaluate(() => {
    const { run: r, report } = window.brashReport;
    const corners = document.querySelector(".plan .structure").getAttribute("d").match(/-?[\d.]+ /g).map(Number);
    return {
      n: report.replay.scene.floes.nVisible, largest: report.replay.scene.floes.largestForce, forces: Math.max(...r.column("track.force")),
      middle: 0.5 * (Math.min(...corners) + Math.max(...corners)), end: r.column("structure.end")[0],
      legends: [...document.querySelectorAll(".legend")].map((e) => e.textContent).join(" "),
    };
  });
  assert.equal(seen.n, JSON.parse(readFileSync(join(folder, "field", "summary.json"), "utf8")).n_floes_present);
  assert.ok(seen.forces > 1e4 && seen.largest === seen.forces, JSON.stringify(seen));
  assert.ok(Math.abs(seen.middle - seen.end) < 2e-3, JSON.stringify(seen));
  assert.match(seen.legends, new RegExp(`contact force, 0 to ${(seen.largest / 1e3).toFixed(1)}`));
  assert.match(seen.legends, /floe where it was at the start.*structure's waterline now/);
  assert.doesNotMatch(seen.legends, /broke off/);
  await page.close();
});

test("a page that nobody sees is not drawn until somebody does", { timeout: kPatience }, async () => {
  const run = await watched("hidden", "--set", "time.duration=100");
  await paused(run.address);
  const [seen, hidden] = [await browser.open(run.address), await browser.open(run.address)];
  const duration = (page) => page.evaluate(() => window.brashReport.run.duration);
  for (const page of [seen, hidden]) await until(page, () => window.brashReport.run.duration > 0);
  const hide = (on) => hidden.evaluate((is) => {
    Object.defineProperty(document, "hidden", { get: () => is, configurable: true });
    document.dispatchEvent(new Event("visibilitychange"));
  }, on);
  await new Promise((done) => setTimeout(done, 1000));
  await hide(true);
  const stood = await duration(hidden);
  await seen.getByRole("button", { name: "Continue the run" }).click();
  while ((await duration(seen)) < stood + 1) await new Promise((done) => setTimeout(done, 100));
  assert.equal(await duration(hidden), stood);
  await hide(false);
  while ((await duration(hidden)) < stood + 1) await new Promise((done) => setTimeout(done, 100));
  run.process.kill("SIGINT");
  assert.equal(await run.ended, 3);
  for (const page of [seen, hidden]) await page.close();
});

test("what nobody takes is not made before somebody does, also in a pause", { timeout: kPatience }, async () => {
  const run = await watched("late", "--set", "time.duration=100");
  await new Promise((done) => setTimeout(done, 1500));
  await paused(run.address);
  await new Promise((done) => setTimeout(done, 500));
  const text = await stream(run.address, (got) => /^event: records\n.*\n\n/ms.test(got));
  const records = [...text.matchAll(/^data: (\{.*)$/gm)].map((found) => JSON.parse(found[1]).load.time);
  assert.equal(records.length, 1, "records that nobody took came one by one");
  assert.ok(records[0].length > 1);
  run.process.kill("SIGINT");
  assert.equal(await run.ended, 3);
});

test("watching changes no byte of the results, and neither does a browser that is killed", { timeout: kPatience }, async () => {
  brash("run", kCase, "-o", join(folder, "alone"), ...kSettings);
  const run = await watched("watched");
  await paused(run.address);
  const doomed = await doomedBrowser();
  const page = await doomed.newPage();
  await page.goto(run.address);
  await until(page, () => window.brashReport?.run?.duration > 0);
  assert.equal(await ask(new URL("resume", run.address), { method: "POST" }), 204);
  await doomed.kill();
  // A reader that never reads is left hanging.
  const hanging = request(new URL("events", run.address), { agent: false }, (response) => response.pause());
  hanging.on("error", () => {});
  hanging.end();
  const whole = stream(run.address);
  assert.equal(await run.ended, 0);
  hanging.destroy();
  assert.match(await whole, /event: end\ndata: "The run is done/);
  for (const file of ["run.nc", "history.csv", "events.csv", "summary.json", "plan.svg"])
    assert.ok(readFileSync(join(folder, "watched", file)).equals(readFileSync(join(folder, "alone", file))), file);
});

test("a browser that was cut off goes on behind the last event that it has", { timeout: kPatience }, async () => {
  const run = await watched("cut");
  await paused(run.address);
  const first = await stream(run.address, (text) => text.includes("event: paused"));
  const ids = [...first.matchAll(/^id: (\d+)$/gm)].map((found) => Number(found[1]));
  assert.deepEqual(ids, ids.map((_, i) => i));
  const again = await new Promise((done) => {
    const sent = request(new URL("events", run.address), { agent: false, headers: { "Last-Event-ID": String(ids.at(-1) - 1) } }, (response) =>
      response.once("data", (part) => (response.destroy(), done(String(part)))));
    sent.end();
  });
  assert.ok(again.startsWith(`id: ${ids.at(-1)}\n`), again);
  run.process.kill("SIGTERM");
  assert.equal(await run.ended, 3);
});

test("a browser stops the run, which is then resumed, and seen from its start", { timeout: kPatience }, async () => {
  const run = await watched("stopped");
  await paused(run.address);
  const page = await browser.open(run.address);
  await until(page, () => window.brashReport.run.duration > 0);
  await page.getByRole("button", { name: "Stop the run" }).click();
  assert.equal(await run.ended, 3);
  await until(page, () => /The run was stopped at .* --resume/.test(document.querySelector(".live").textContent));
  await page.close();
  const resumed = await watched("stopped", "--resume");
  const text = await stream(resumed.address);
  assert.equal(await resumed.ended, 0);
  const times = [...text.matchAll(/^data: (\{.*)$/gm)].flatMap((found) => JSON.parse(found[1]).load.time);
  assert.deepEqual(times, readCsv(join(folder, "stopped", "history.csv")).map((row) => Number(row.time)));
});

test("a run that fails says why to those who watch", { timeout: kPatience }, async () => {
  const run = await watched("fails", "--set", "output.checkpoint_interval=0.2");
  await paused(run.address);
  let begins;
  const begun = new Promise((done) => (begins = done));
  const told = stream(run.address, (text) => text.includes("event: records") && begins());
  await begun;  // it has removed checkpoints of older runs, and does not wait for those who come later
  const checkpoint = join(folder, "fails", "checkpoint.nc");
  rmSync(checkpoint, { force: true });
  mkdirSync(join(checkpoint, "in-the-way"), { recursive: true });
  assert.equal(await ask(new URL("resume", run.address), { method: "POST" }), 204);
  const text = await told;
  assert.match(text, /^event: end\ndata: "The run failed\. .*checkpoint\.nc/m);
  assert.equal(await run.ended, 1);
});

test("the page of a run asks its own server, and nobody else", () => {
  assert.deepEqual(browser.requests.filter((url) => !/^(http:\/\/127\.0\.0\.1:\d+\/[0-9a-f]{32}\/|data:|blob:|about:)/.test(url)), []);
  assert.deepEqual(browser.complaints.filter((text) => !/ERR_CONNECTION_REFUSED/.test(text)), []);
});
