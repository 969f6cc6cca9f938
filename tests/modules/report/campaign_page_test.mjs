// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a campaign, from a folder as docs/reference/plan.md describes it.
import assert from "node:assert/strict";
import { mkdirSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { brash, browse, numberAt, readChart, saved, scratch } from "./browser.mjs";

const folder = scratch();
const listed = join(folder, "listed");
let browser, page;

/** Columns with names as long as they come. */
const kWide = ["horizontal.standard_deviation", "horizontal.quantile_99", "horizontal.maximum"];
const statistics = (mean) => ({
  "horizontal.mean": { n: 2, mean, standard_deviation: 4e3, mean_95: [mean - 9e3, mean + 9e3] },
  "vertical.mean": { n: 1, mean: 0.5 * mean, standard_deviation: null, mean_95: null },
  ...Object.fromEntries(kWide.map((name) => [name, { n: 2, mean, standard_deviation: 4e3, mean_95: [mean - 9e3, mean + 9e3] }])),
  n_breaks: { n: 2, mean: 12, standard_deviation: 1, mean_95: [3, 21] },
});
const kSettings = [
  ["angle-50deg_speed-0.5", 0.872664625997165, 0.5, 80e3], ["angle-50deg_speed-1.2", 0.872664625997165, 1.2, 90e3],
  ["angle-70deg_speed-0.5", 1.2217304763960306, 0.5, 110e3], ["angle-70deg_speed-1.2", 1.2217304763960306, 1.2, 240e3],
].map(([setting, angle, speed, mean], i) => ({
  setting, case: `cone_${setting}`, values: { "structure.angle": angle, "structure.speed": speed, "output.statistics_from": speed === 0.5 ? 16 : 8 },
  n_done: i === 3 ? 1 : 2, n_failed: i === 3 ? 1 : 0, stopped_by: "replicates", statistics: statistics(mean),
}));

function writeCampaign() {
  const rows = ["case,setting,replicate,status,structure.angle,structure.speed,horizontal.mean,vertical.mean," + kWide.join(",") + ",n_breaks"];
  for (const s of kSettings)
    for (const replicate of [0, 1]) {
      const id = `${s.setting}-r000${replicate}`;
      const failed = s.n_failed > 0 && replicate === 1;
      rows.push([id, s.setting, replicate, failed ? "failed" : "done", s.values["structure.angle"], s.values["structure.speed"],
        ...(failed ? ["", "", "", "", "", ""] : [s.statistics["horizontal.mean"].mean + 1e3 * replicate, 4e4, 1e5, 2e5, 3e5, 12])].join(","));
      if (failed) continue;
      mkdirSync(join(folder, "cases", id), { recursive: true });
      if (replicate === 0) writeFileSync(join(folder, "cases", id, "report.html"), "");
    }
  writeFileSync(join(folder, "campaign.csv"), rows.join("\n") + "\n");
  writeFileSync(join(folder, "summary.json"), JSON.stringify({ format: "brash-campaign-1", n_cases: 8, n_done: 7, n_failed: 1, settings: kSettings }));
  writeFileSync(join(folder, "manifest.json"), JSON.stringify({ program: { name: "brash", version: "</script><b>" }, inputs: [] }));
}

/** Laws switched one by one: no input is an axis, the labels alone tell the settings apart. The speed is one, if it varies. */
const kLaws = [["all", 1, "stress", 1, 100e3], ["flat", 0, "stress", 1, 140e3], ["disc", 1, "disc", 1, 120e3], ["none", 0, "disc", 0, 60e3]];
function writeList(to, speeds) {
  const settings = kLaws.flatMap(([label, joint, pattern, second, mean]) => speeds.map((speed) => ({
    setting: speeds.length > 1 ? `${label}_speed-${speed}` : label, case: `cone_${label}`,
    values: { "failure.joint_loads": joint, "failure.pattern": pattern, "failure.second_order": second, "structure.speed": speed },
    n_done: 2, n_failed: 0, stopped_by: "replicates", statistics: { "horizontal.mean": { n: 2, mean, standard_deviation: 4e3, mean_95: [mean - 9e3, mean + 9e3] } },
  })));
  const rows = settings.flatMap(({ setting, values, statistics: { "horizontal.mean": { mean } } }) =>
    [-1, 1].map((way, r) => [`${setting}-r000${r}`, setting, r, "done", ...Object.values(values), mean + 2e3 * way].join(",")));
  mkdirSync(to, { recursive: true });
  writeFileSync(join(to, "campaign.csv"), `case,setting,replicate,status,${Object.keys(settings[0].values).join(",")},horizontal.mean\n${rows.join("\n")}\n`);
  writeFileSync(join(to, "summary.json"), JSON.stringify({ format: "brash-campaign-1", n_cases: rows.length, n_done: rows.length, n_failed: 0, settings }));
  writeFileSync(join(to, "manifest.json"), JSON.stringify({ program: { name: "brash", version: "0" }, inputs: [] }));
  brash("report", to);
}

before(async () => {
  writeCampaign();
  brash("report", folder);
  browser = await browse();
  page = await browser.open(join(folder, "report.html"));
});

after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

test("each setting stands under its first input, with means and intervals in units and to the digits that they bear", async () => {
  const groups = await page.locator("#settings-table .group").allTextContents();
  assert.deepEqual(groups, ["structure angle 50°", "structure angle 70°"]);
  const heads = await page.locator("#settings-table thead th").allTextContents();
  assert.deepEqual(heads.slice(0, 4), ["structure speed", "runs", "mean horizontal load [kN]", "mean vertical load [kN]"]);
  const rows = page.locator("#settings-table tbody tr:not(.group)");
  assert.equal(await rows.count(), kSettings.length);
  assert.deepEqual((await rows.nth(3).locator("td").allTextContents()).slice(0, 4),
    ["1.2 m/s", "1 done, 1 failed", "240.0 (231.0 to 249.0)", "120.0 (one run)"]);
});

test("what was varied together is one input: for each result a chart over the angle and over the speed, of one scale", async () => {
  const names = await page.locator("#trends .chart .plot").evaluateAll((all) => all.map((plot) => plot.ariaLabel));
  assert.equal(names.length, 2 * 4);  // of the first columns
  assert.deepEqual(names.slice(0, 2), ["mean horizontal load [kN] over structure angle [°]", "mean horizontal load [kN] over structure speed [m/s]"]);
  // The second input is a line for each of its values.
  const lines = await page.locator("#trends .chart").first().locator(".u-legend .u-label").allTextContents();
  assert.deepEqual(lines, ["structure angle [°]", "structure speed 0.5 m/s", "structure speed 1.2 m/s"]);
});

test("a saved chart has the mean, the interval and the single runs of each setting", async () => {
  const chart = page.locator("#trends .chart").nth(1);  // mean horizontal load over speed
  const shown = await readChart(page, (await saved(page, chart.getByRole("button", { name: "SVG", exact: true }))).bytes.toString());
  const near = (place, newtons) => assert.ok(Math.abs(numberAt(shown.y, Number(place)) - newtons / 1e3) < 0.1, `${newtons} N at ${place}`);
  const bars = shown.paths["95 % interval of the mean"].map((path) => [.../M\S+ (\S+)h\S+ ?\S*M\S+ (\S+)h/.exec(path)].slice(1));
  assert.equal(bars.length, kSettings.length);
  kSettings.forEach(({ statistics: of }, i) => bars[i].forEach((place, k) => near(place, of["horizontal.mean"].mean_95[k])));
  assert.equal(shown.paths["single run"].length, 7);
  const places = (path) => [...path.matchAll(/M\S+ (\S+)a/g)].map(([, y]) => y);
  near(places(shown.paths["single run"][0])[0], kSettings[0].statistics["horizontal.mean"].mean);
  for (const [name, [first, second]] of [["structure angle 50°", [80e3, 90e3]], ["structure angle 70°", [110e3, 240e3]]]) {
    assert.ok(shown.words.includes(name));
    const means = places(shown.paths[name][1]);
    near(means[0], first);
    near(means[1], second);
  }
  assert.ok(shown.words.includes("single run") && shown.words.includes("95 % interval of the mean"));
  assert.ok(shown.words.some((text) => text.startsWith("mean horizontal load [kN] over structure speed [m/s]")));
});

test("no key path is shown where a name can be", async () => {
  const shown = await page.locator("#trends, #settings, #all-runs").allInnerTexts();
  for (const text of shown) assert.ok(!/\b(structure\.|horizontal\.|vertical\.)/.test(text), text);
});

test("a setting links to its runs, and a run to its page if it kept one", async () => {
  const runs = page.locator("#runs tbody tr:not(.group)");
  assert.equal(await runs.count(), 8);
  const links = await runs.locator("a").evaluateAll((all) => all.map((a) => a.getAttribute("href")));
  assert.deepEqual(links, kSettings.map(({ setting }) => `cases/${setting}-r0000/report.html`));
  assert.ok((await runs.nth(7).innerText()).includes("failed"));
  const targets = await page.locator("#settings-table a").evaluateAll((all) => all.map((a) => document.querySelector(a.getAttribute("href"))?.textContent ?? ""));
  targets.forEach((text, i) => assert.ok(text.includes(`${kSettings[i].setting}-r0000`), text));
});

test("no table hangs over the edge of a laptop's page, or of a sheet of paper", async () => {
  const over = () => page.locator(".table").evaluateAll((all) => all.filter((t) => t.scrollWidth > t.clientWidth).length);
  assert.equal(await over(), 0);
  await page.emulateMedia({ media: "print" });
  await page.setViewportSize({ width: 688, height: 1000 });  // 182 mm of A4 between its margins
  assert.equal(await over(), 0);
  await page.emulateMedia({ media: "screen" });
  await page.setViewportSize({ width: 1366, height: 768 });
});

test("settings that labels tell apart are rows of one chart for each result, each dot where its value is", async () => {
  writeList(listed, [1.2]);
  const list = await browser.open(join(listed, "report.html"));
  assert.equal(await list.locator("#trends canvas").count(), 0, "a chart over a switch has a point in each corner");
  const charts = list.locator("#trends .list-chart");
  assert.equal(await charts.count(), 1);
  const drawn = await charts.evaluate((svg) => ({
    ticks: [...svg.querySelectorAll(".scale-lines text")].slice(0, -1).map((t) => [Number(t.textContent), t.x.baseVal[0].value]),
    rows: [...svg.querySelectorAll(".setting")].map((row) => ({
      name: row.querySelector("text").textContent,
      singles: [...row.querySelectorAll(".single")].map((c) => c.cx.baseVal.value),
      mean: row.querySelector(".mean").cx.baseVal.value,
      interval: (({ x, width }) => [x, x + width])(row.querySelector(".interval").getBBox()),
    })),
  }));
  assert.deepEqual(drawn.rows.map(({ name }) => name), kLaws.map(([label]) => label));
  const [[n0, x0], [n1, x1]] = [drawn.ticks[0], drawn.ticks.at(-1)];
  // Places are written to a hundredth of a pixel; a browser keeps them in single precision.
  const near = (x, newtons) => assert.ok(Math.abs(x - (x0 + ((newtons / 1e3 - n0) * (x1 - x0)) / (n1 - n0))) < 0.05, `${newtons} N at ${x}`);
  drawn.rows.forEach(({ singles, mean, interval }, i) => {
    const value = kLaws[i][4];
    near(mean, value);
    singles.forEach((x, k) => near(x, value + (k ? 2e3 : -2e3)));
    interval.forEach((x, k) => near(x, value + (k ? 9e3 : -9e3)));
  });
  const rows = await list.locator("#settings-table tbody tr").evaluateAll((all) => all.map((row) => [row.cells[0], row.cells[row.cells.length - 1]].map((c) => c.textContent)));
  assert.deepEqual(rows, [["all", "–"], ["flat", "failure joint loads: off"], ["disc", "failure pattern: disc"],
    ["none", "failure joint loads: off, failure pattern: disc, failure second order: off"]]);
  await list.close();
});

test("a labelled list over an axis is a line for each label", async () => {
  writeList(join(folder, "over-speed"), [0.5, 1.2]);
  const over = await browser.open(join(folder, "over-speed", "report.html"));
  assert.deepEqual(await over.locator("#trends .chart .plot").evaluateAll((all) => all.map((plot) => plot.ariaLabel)), ["mean horizontal load [kN] over structure speed [m/s]"]);
  assert.deepEqual(await over.locator("#trends .u-legend .u-label").allTextContents(), ["structure speed [m/s]", ...kLaws.map(([label]) => `setting ${label}`)]);
  await over.close();
});

test("charts are drawn, nothing is complained about and nothing is asked of a network", async () => {
  const drawn = await page.locator("#trends canvas").evaluateAll((all) =>
    all.map((c) => new Set(new Uint32Array(c.getContext("2d").getImageData(0, 0, c.width, c.height).data.buffer)).size));
  for (const colours of drawn) assert.ok(colours > 10);
  assert.deepEqual(browser.complaints, []);
  assert.deepEqual(browser.requests.filter((url) => !/^(file|data|blob):/.test(url)), []);
});
