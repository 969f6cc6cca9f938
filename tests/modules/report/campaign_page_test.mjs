// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a campaign, from a folder as docs/reference/plan.md describes it.
import assert from "node:assert/strict";
import { mkdirSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { brash, browse, scratch } from "./browser.mjs";

const folder = scratch();
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

test("each setting shows its mean with the interval", async () => {
  const rows = page.locator("#settings-table tbody tr");
  assert.equal(await rows.count(), kSettings.length);
  assert.deepEqual((await rows.nth(3).locator("td").allTextContents()).slice(0, 5),
    ["angle-70deg_speed-1.2", "1", "1", "240.0 (231.0 to 249.0)", "120.0"]);
});

test("what was varied together is one input: trends over the angle and over the speed, for each column", async () => {
  const labels = await page.locator("#trends .chart .u-legend tr:first-child .u-label").allTextContents();
  assert.deepEqual([...new Set(labels)], ["structure.angle [°]", "structure.speed [m s-1]"]);
  assert.equal(labels.length, 2 * 4);  // of the first columns
});

test("each run links to its report, or to its summary when it kept no report", async () => {
  const rows = page.locator("#runs tbody tr");
  assert.equal(await rows.count(), 8);
  const links = await rows.locator("a").evaluateAll((all) => all.map((a) => a.getAttribute("href")));
  assert.equal(links[0], "cases/angle-50deg_speed-0.5-r0000/report.html");
  assert.equal(links[1], "cases/angle-50deg_speed-0.5-r0001/summary.json");
  assert.equal(links.length, 7);
  assert.ok((await rows.nth(7).innerText()).includes("failed"));
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

test("charts are drawn, nothing is complained about and nothing is asked of a network", async () => {
  const drawn = await page.locator("#trends canvas").evaluateAll((all) =>
    all.map((c) => new Set(new Uint32Array(c.getContext("2d").getImageData(0, 0, c.width, c.height).data.buffer)).size));
  for (const colours of drawn) assert.ok(colours > 10);
  assert.deepEqual(browser.complaints, []);
  assert.deepEqual(browser.requests.filter((url) => !/^(file|data|blob):/.test(url)), []);
});
