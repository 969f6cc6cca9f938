// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a campaign of which every text is made to run: it is shown, and nothing of it runs or leads anywhere.
import assert from "node:assert/strict";
import { mkdirSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { brash, browse, scratch } from "./browser.mjs";

const folder = scratch();
let browser, page;
let n = 0;
/** A text that says which one ran. */
const hostile = (what) =>
  `${what}</script><script>window.pwned=${++n}</script><img src=x onerror='window.pwned=${n}'><svg onload=window.pwned=${n}>`;

const kFolder = "javascript:alert(1)";
const kColumn = hostile("column");
const kVaried = hostile("structure.speed");
const kOther = hostile("failure.model");
const kSettings = [1, 2, 3, 4].map((i) => ({
  setting: hostile(`javascript:window.pwned=${i}//`), case: hostile("case"), values: { [kVaried]: i % 2, [kOther]: hostile(`value ${i > 2}`).replace(/\d+/g, "7") },
  n_done: 1, n_failed: 0, stopped_by: hostile("stop"), statistics: { [kColumn]: { n: 1, mean: i, standard_deviation: null, mean_95: null } },
}));

before(async () => {
  const quoted = (text) => `"${text}"`;
  const rows = [["case", "setting", "replicate", "status", quoted(kVaried), quoted(kColumn)]];
  kSettings.forEach((s, i) => rows.push([quoted(i === 0 ? kFolder : `javascript:alert(1)//${s.setting}`), quoted(s.setting), 0, "done", s.values[kVaried], 1]));
  mkdirSync(join(folder, "cases", kFolder), { recursive: true });
  writeFileSync(join(folder, "cases", kFolder, "report.html"), "");
  writeFileSync(join(folder, "campaign.csv"), rows.map((row) => row.join(",")).join("\n") + "\n");
  writeFileSync(join(folder, "summary.json"), JSON.stringify({ format: "brash-campaign-1", n_cases: hostile("4"), n_done: 4, n_failed: 0, settings: kSettings }));
  writeFileSync(join(folder, "manifest.json"), JSON.stringify({
    program: { name: hostile("name"), version: hostile("version") }, glibc: hostile("glibc"), plan: { path: hostile("plan"), sha256: hostile("hash") },
    built_with: { [hostile("tool")]: hostile("1") }, cases_made_by: [{ program: { version: hostile("v") }, inputs: [{ name: hostile("m"), sha256: hostile("s") }], n_cases: 1 }],
    outputs: [{ path: hostile("output"), sha256: hostile("hash") }], inputs: [{ path: hostile("input"), sha256: hostile("hash") }],
  }));
  brash("report", folder);
  browser = await browse();
  page = await browser.open(join(folder, "report.html"));
});

after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

test("nothing that a file says runs", async () => {
  await page.waitForTimeout(200);
  assert.equal(await page.evaluate("window.pwned"), undefined);
  assert.equal(await page.evaluate("document.querySelectorAll('img, main script, svg[onload]').length"), 0);
  assert.equal(await page.evaluate("document.scripts.length"), 3, "the page's own three");
  assert.deepEqual(browser.requests.filter((url) => !/^(file|data|blob):/.test(url)), []);
});

test("it is shown as it is written", async () => {
  const text = await page.evaluate("document.body.textContent");
  for (const shown of [kSettings[1].setting, hostile("value").split("</script>")[1].slice(0, 8)]) assert.ok(text.includes(shown), shown);
  assert.ok((await page.locator("#runs").innerText()).includes("<script>"));
});

test("links lead into the campaign's folder only", async () => {
  const links = await page.locator("#runs a").evaluateAll((all) => all.map((a) => a.href));
  assert.equal(links.length, 1, "the run that kept a page");
  const inside = await page.evaluate("new URL('cases/', location.href).href");
  for (const link of links) assert.ok(link.startsWith(inside), link);
});
