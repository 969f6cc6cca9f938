// SPDX-License-Identifier: GPL-3.0-or-later
// The simulator as one page, opened from a folder, beside the native program: the same messages, breaks and mean loads.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { browse, expectAccessible, readCsv, saved, scratch, until } from "../report/browser.mjs";
import { openPage } from "./pages.mjs";

const folder = scratch();
const page_file = process.env.BRASH_PAGE;
const kCase = join(process.env.BRASH_SOURCE, "experiments/validation/cone.toml");
const brash = (...args) => spawnSync(process.env.BRASH, args, { encoding: "utf8" });
let browser;

before(async () => {
  browser = await browse();
});

after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

/** Opens the page with settings of its own, `section.key` and value. */
async function opened(settings = {}) {
  const page = await openPage(browser, page_file);
  await page.evaluate(async (all) => {
    const { store, simulation } = window.brashSimulator;
    for (const [name, value] of Object.entries(all)) {
      const at = name.lastIndexOf(".");
      store.setKey(name.slice(0, at), name.slice(at + 1), value);
    }
    await store.checked;
    await simulation.reset();
  }, settings);
  return page;
}

/** Runs the case of the page to its end. */
async function played(page) {
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await until(page, () => window.brashSimulator.simulation.done && !window.brashSimulator.simulation.running);
}

const column = (page, name) => page.evaluate((of) => [...window.brashSimulator.simulation.report.run.column(of)], name);

test("the page draws its case at once, from a folder, without a network", async () => {
  const page = await openPage(browser, page_file);
  const first = await page.evaluate(() => window.brashSimulator.firstPicture);
  console.log(`${(statSync(page_file).size / 1e6).toFixed(2)} MB, first picture after ${(first / 1000).toFixed(2)} s`);
  assert.equal(page.workers().length, 1);
  assert.ok((await column(page, "frame.time")).length > 0);
  assert.equal(await page.locator("canvas").first().isVisible(), true);
  await page.close();
});

test("the page reads a case as the program does", async () => {
  const page = await openPage(browser, page_file);
  const description = await page.evaluate(() => window.brashSimulator.store.description);
  assert.ok(brash("check", kCase, "--keys").stdout.includes(description.toml.trim()), description.toml);
  const native = JSON.parse(brash("loads", kCase, "--json").stdout);
  assert.equal(description.loads.loads.length, native.loads.length);
  description.loads.loads.forEach((load, i) => {
    assert.equal(load.method, native.loads[i].method);
    assert.equal(load.not_applicable, native.loads[i].not_applicable);
    // The elementary functions of the two C libraries differ in the last bit.
    if (load.horizontal !== undefined) assert.ok(Math.abs(load.horizontal / native.loads[i].horizontal - 1) < 1e-12, load.method);
  });
  await page.close();
});

test("a bad case is refused in the program's words", async () => {
  const bad = readFileSync(kCase, "utf8").replace('"0.33 m"', '"0.33 s"').replace("speed = 1.202", "sped = 1.202");
  const file = join(folder, "cone.toml");
  writeFileSync(file, bad);
  const native = brash("check", file);
  assert.equal(native.status, 2);
  const page = await openPage(browser, page_file);
  await page.locator("#case-file textarea").fill(bad);
  await page.evaluate(() => window.brashSimulator.store.checked);
  const said = await page.getByRole("alert").first().innerText();
  assert.equal(said.trim(), native.stderr.replaceAll(file, "cone.toml").replace(/^brash: |^error: /, "").trim());
  assert.equal(await page.getByRole("button", { name: /^Run/ }).isDisabled(), true);
  await page.close();
});

/** The case of the page run by its core without a picture: columns of the breaks, loads, and wall time [s]. */
const computed = (page) => page.evaluate(async () => {
  const { core, store } = window.brashSimulator;
  await core.make(store.text, store.name);
  const start = performance.now();
  const events = {}, times = [], loads = [];
  for (let done = false; !done; ) {
    const { records, ...said } = await core.advance(50);
    done = said.done;
    times.push(...records.load.time);
    loads.push(...records.load.Fx);
    for (const [name, values] of Object.entries(records.event)) (events[name] ??= []).push(...values);
  }
  return { events, times, loads, wall: (performance.now() - start) / 1000 };
});

/** Columns of a break. The first breaks agree to ten digits of the largest value. */
const kColumns = ["time", "x", "y", "b", "c", "theta", "mu1", "mu2", "p", "l_break", "wedges", "pieces", "area_after"];

// A break of the preset paper depends on the place of the structure alone. But a speed that differs by 1e-11 gives the
// program itself another seventh break. The preset brash judges under the loads of the floes, where the last bits of the C
// libraries grow sooner: only its mean can agree.
for (const [preset, nEqual] of [["paper", 6], ["brash", 0]])
  test(`preset ${preset}: the first ${nEqual} breaks are the program's to ten digits, and the mean load is within its interval`, async () => {
    const run = join(folder, preset);
    const settings = { "time.duration": "10", "algorithm.preset": JSON.stringify(preset), "output.statistics_from": "4" };
    const sets = Object.entries(settings).flatMap(([name, value]) => ["--set", `${name}=${value}`]);
    const start = process.hrtime.bigint();
    assert.equal(brash("run", kCase, "-o", run, ...sets).status, 0);
    const native = Number(process.hrtime.bigint() - start) / 1e9;
    const page = await opened(settings);
    const { events: breaks, times, loads, wall } = await computed(page);
    console.log(`${preset}: 10 s in ${wall.toFixed(2)} s of wall time in the page, ${native.toFixed(2)} s native with its files`);

    const events = readCsv(join(run, "events.csv")).filter(({ event }) => event === "break").slice(0, nEqual);
    assert.equal(events.length, nEqual);
    let largest = 0;
    for (const name of kColumns) {
      const known = events.map((event) => Number(event[name]));
      const size = Math.max(...known.map(Math.abs));
      breaks[name].slice(0, nEqual).forEach((value, i) => {
        largest = Math.max(largest, Math.abs(value - known[i]) / size);
        assert.ok(Math.abs(value - known[i]) <= 1e-10 * size, `${name} of break ${i + 1}: ${value} in the page, ${known[i]}`);
      });
    }
    if (nEqual > 0) console.log(`${preset}: the first ${nEqual} breaks differ by ${largest.toExponential(1)} at most`);

    assert.equal(times.length, 1000);
    const counted = loads.filter((_, i) => times[i] >= 4);
    const mean = counted.reduce((sum, load) => sum + load, 0) / counted.length;
    const { horizontal } = JSON.parse(readFileSync(join(run, "summary.json"), "utf8"));
    console.log(`${preset}: mean ${(mean / 1e3).toFixed(1)} kN in the page, ${(horizontal.mean / 1e3).toFixed(1)} kN native`);
    assert.ok(mean >= horizontal.mean_95[0] && mean <= horizontal.mean_95[1], `${mean} is outside ${horizontal.mean_95}`);
    await page.close();
  });

test("controls change the case, and buttons play, stop and begin it anew", async () => {
  const page = await openPage(browser, page_file);
  const thickness = page.getByRole("spinbutton", { name: "Thickness of the ice [m], as a number" });
  await thickness.fill("0.4");
  await thickness.press("Tab");
  await page.evaluate(() => window.brashSimulator.store.checked);
  assert.match(await page.locator("#case-file textarea").inputValue(), /^thickness = "0\.4 m"/m);
  await page.getByRole("button", { name: "Run again" }).click();
  await until(page, () => window.brashSimulator.simulation.report.run.duration > 0.2);
  await page.getByRole("button", { name: "Pause" }).click();
  const idle = () => !document.querySelector(".live button:nth-of-type(2)").disabled;
  await until(page, idle);  // the batch on its way is whole
  const paused = await page.evaluate(() => window.brashSimulator.simulation.report.run.duration);
  await page.getByRole("button", { name: "Step" }).click();
  await until(page, idle);
  const stepped = await page.evaluate(() => window.brashSimulator.simulation.report.run.duration);
  assert.ok(Math.abs(stepped - paused - 0.01) < 1e-9, `${paused} to ${stepped}`);
  await page.getByRole("button", { name: "Reset" }).click();
  await until(page, () => window.brashSimulator.simulation.report.run.duration === 0);

  await page.getByRole("button", { name: "Save the case" }).first().click({ trial: true });
  const { bytes } = await saved(page, page.getByRole("button", { name: "Save the case" }).first());
  const file = join(folder, "saved.toml");
  writeFileSync(file, bytes);
  assert.match(brash("check", file, "--keys").stdout, /^thickness = 0\.4 /m);
  writeFileSync(file, bytes.toString().replace('"0.4 m"', '"55 cm"'));
  await page.locator("input[type=file]").setInputFiles(file);
  await page.evaluate(() => window.brashSimulator.store.checked);
  await until(page, () => window.brashSimulator.store.resolved.ice.thickness.value === 0.55);
  assert.equal(await thickness.inputValue(), "0.55");
  await page.close();
});

test("a picture is drawn at most once a frame, and the next steps wait for it", async () => {
  const page = await opened({ "time.duration": "1" });
  const counted = await page.evaluate(async () => {
    const { core, simulation } = window.brashSimulator;
    let frames = 0, waiting = 0, most = 0, calls = 0;
    const advance = core.advance.bind(core);
    core.advance = async (steps) => {
      ++calls;
      most = Math.max(most, ++waiting);
      const said = await advance(steps);
      --waiting;
      return said;
    };
    let running = true;
    const count = () => {
      ++frames;
      if (running) requestAnimationFrame(count);
    };
    requestAnimationFrame(count);
    const { run } = simulation.report;
    let drawn = 0;
    const take = run.take.bind(run);
    run.take = (blocks) => {
      ++drawn;
      take(blocks);
    };
    simulation.toggle();
    while (!simulation.done || simulation.running) await new Promise((done) => setTimeout(done, 20));
    running = false;
    return { frames, drawn, most, calls };
  });
  assert.equal(counted.most, 1, "one batch of steps at a time");
  assert.ok(counted.drawn <= counted.frames + 1, `${counted.drawn} pictures in ${counted.frames} frames`);
  assert.ok(counted.calls >= counted.drawn - 1);
  await page.close();
});

test("axe-core finds no fault, light, dark and narrow", async () => {
  const page = await opened({ "time.duration": "0.5" });
  await played(page);
  await expectAccessible(page);
  await page.close();
});

test("nothing is asked of a network", () => {
  assert.deepEqual(browser.requests.filter((url) => !/^(file|data|blob|about):/.test(url)), []);
  assert.deepEqual(browser.complaints, []);
});
