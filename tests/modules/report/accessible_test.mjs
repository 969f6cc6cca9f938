// SPDX-License-Identifier: GPL-3.0-or-later
// The pages for readers who do not see them, use no mouse, or want no motion: axe-core finds no fault in any state.
import assert from "node:assert/strict";
import { mkdirSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { brash, browse, expectAccessible, scratch } from "./browser.mjs";

const folder = scratch();
const [run, other, campaign, list] = ["run", "other", "campaign", "list"].map((name) => join(folder, name));
const kCase = join(process.env.BRASH_SOURCE, "experiments/validation/cone.toml");
let browser;

/** @param key what varies; its values are in the settings' names too. */
function writeCampaign(to, key, values) {
  const settings = values.map((value) => ({
    setting: `v-${value}`, case: `cone_v-${value}`, values: { [key]: value }, n_done: 2, n_failed: 0, stopped_by: "replicates",
    warnings: { "short-run": 1 }, statistics: { "horizontal.mean": { n: 2, mean: 9e4, standard_deviation: 4e3, mean_95: [8e4, 1e5] } },
  }));
  const rows = settings.flatMap(({ setting, values }) => [0, 1].map((r) => [`${setting}-r000${r}`, setting, r, "done", values[key], 9e4 + r].join(",")));
  mkdirSync(join(to, "cases", `v-${values[0]}-r0000`), { recursive: true });
  writeFileSync(join(to, "cases", `v-${values[0]}-r0000`, "report.html"), "");
  writeFileSync(join(to, "campaign.csv"), `case,setting,replicate,status,${key},horizontal.mean\n${rows.join("\n")}\n`);
  writeFileSync(join(to, "summary.json"), JSON.stringify({ format: "brash-campaign-1", n_cases: 4, n_done: 4, n_failed: 0, settings }));
  writeFileSync(join(to, "manifest.json"), JSON.stringify({ program: { name: "brash", version: "0" }, inputs: [] }));
  brash("report", to);
}

before(async () => {
  brash("run", kCase, "-o", run, "--set", "time.duration=3", "--set", "output.statistics_from=1");
  brash("run", kCase, "-o", other, "--set", "time.duration=1", "--seed", "2");
  brash("report", run, other, "-o", join(folder, "both.html"));
  writeCampaign(campaign, "structure.speed", [0.5, 1.2]);
  writeCampaign(list, "failure.pattern", ["disc", "stress"]);
  browser = await browse();
});

after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

const kPages = { "a run": join(run, "report.html"), "a run without statistics": join(other, "report.html"), "two runs": join(folder, "both.html"), "a campaign": join(campaign, "report.html"), "a campaign of named settings": join(list, "report.html") };

for (const [what, file] of Object.entries(kPages))
  test(`axe-core finds no fault in the page of ${what}, light, dark and narrow`, async () => {
    const page = await browser.open(file);
    await expectAccessible(page);
    await page.close();
  });

test("everything that a mouse can do to a replay, keys can", async () => {
  const page = await browser.open(kPages["a run"]);
  const focused = () => page.evaluate(() => document.activeElement.getAttribute("aria-label") ?? document.activeElement.textContent);
  const reached = new Set();
  for (let i = 0; i < 80; ++i) {
    await page.keyboard.press("Tab");
    reached.add(await focused());
  }
  for (const name of ["Skip to the report", "Play", "Time of the replay", "Speed of the replay", "Wake", "Load", "Crack 1 at 0.97 s"])
    assert.ok([...reached].some((text) => text.startsWith(name.replace(/ at .*/, ""))), `${name} is not reached by Tab: ${[...reached].join(" | ")}`);
  // A crack by Enter, and the camera by the arrows of the picture itself.
  await page.locator(".breaks circle").nth(1).focus();
  await page.keyboard.press("Enter");
  assert.match(await page.locator(".event-card strong").innerText(), /Crack 2/);
  // The name of a line shows and hides it.
  const crushing = page.locator(".loads .u-label").filter({ hasText: "crushing" });
  for (const shown of [false, true]) {
    await crushing.focus();
    await page.keyboard.press("Enter");
    assert.equal(await crushing.getAttribute("aria-pressed"), String(shown));
    assert.equal(await page.evaluate(() => window.brashReport.report.loads.chart.plot.series[2].show), shown);
  }
  const camera = () => page.evaluate(() => window.brashReport.report.replay.scene.camera.position.toArray());
  for (const [key, moves] of [["w", true], ["d", true], ["+", true], ["q", false]]) {
    const place = await camera();
    await page.locator(".stage canvas").focus();
    await page.keyboard.press(key);
    // A frame that is drawn in between may turn the last bit of a place.
    const way = Math.hypot(...(await camera()).map((x, i) => x - place[i]));
    assert.equal(way > 1e-6, moves, `${key} moves the camera by ${way} m`);
  }
  await page.close();
});

test("nothing moves by itself, and a wish for less motion stills what is left", async () => {
  const page = await browser.open(kPages["a run"]);
  assert.equal(await page.evaluate(() => window.brashReport.report.player.playing), false);
  await page.emulateMedia({ reducedMotion: "reduce" });
  // Playing then goes in steps of half a second, which a reader asked for by the key.
  await page.evaluate(() => window.brashReport.report.player.seek(0));
  await page.locator("body").click({ position: { x: 5, y: 5 } });
  await page.keyboard.press("Space");
  const times = new Set();
  for (let playing = true; playing && times.size < 3; ) {
    const player = await page.evaluate(() => (({ time, playing }) => ({ time, playing }))(window.brashReport.report.player));
    times.add(player.time);
    playing = player.playing;
  }
  await page.keyboard.press("Space");
  for (const time of times) assert.ok(Math.abs(time / 0.5 - Math.round(time / 0.5)) < 1e-9, `${time}`);
  // A slow browser may be at the end at its second look.
  assert.ok([...times].some((time) => time > 0), `${[...times]}`);
  await page.close();
});

test("what changes is told", async () => {
  const page = await browser.open(kPages["a run"]);
  assert.equal(await page.locator(".event-card").getAttribute("aria-live"), "polite");
  assert.equal(await page.locator("input[type=range]").getAttribute("aria-valuetext"), await page.evaluate(() => `${window.brashReport.report.player.time.toFixed(2)} s`));
  await page.close();
  assert.deepEqual(browser.complaints, []);
});
