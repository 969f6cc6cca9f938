// SPDX-License-Identifier: GPL-3.0-or-later
// The pages on paper: a run in dark colours, two runs, a campaign and a run that goes on.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { rmSync, writeFileSync } from "node:fs";
import { request } from "node:http";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { brash, browse, expectPrintable, offPaper, onPaper, scratch, until } from "./browser.mjs";

const folder = scratch();
const kCase = join(process.env.BRASH_SOURCE, "experiments/validation/cone.toml");
const kSettings = ["--set", "time.duration=4", "--set", "output.statistics_from=1"];
let browser, live;

before(async () => {
  brash("run", kCase, "-o", join(folder, "one"), ...kSettings);
  browser = await browse({ offline: false });
});

after(async () => {
  await browser?.close();
  live?.kill("SIGKILL");
  rmSync(folder, { recursive: true, force: true });
});

/** Holds that each picture of a replay is there, and more than one colour. */
async function expectPictures(page, n) {
  const colours = await page.locator("img.still").evaluateAll((all) => all.map((image) => {
    const canvas = new OffscreenCanvas(60, 40);
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0, 60, 40);
    return image.clientHeight > 100 ? new Set(new Uint32Array(context.getImageData(0, 0, 60, 40).data.buffer)).size : 0;
  }));
  assert.equal(colours.length, n);
  for (const count of colours) assert.ok(count > 50, `${count} colours`);
}

test("a run in dark colours is printed in light ones, with its replay, and is dark again afterwards", async () => {
  const page = await browser.open(join(folder, "one", "report.html"));
  await page.getByLabel("Colours").selectOption("dark");
  await page.locator(".u-legend .u-label", { hasText: "friction" }).first().waitFor();
  const widths = () => page.locator(".plot canvas").evaluateAll((all) => all.map((canvas) => canvas.width));
  const before_print = await widths();
  await onPaper(page);
  await expectPrintable(page);
  await expectPictures(page, 1);
  assert.equal(await page.locator(".u-off:visible").count(), 0, "the name of a line that is not drawn");
  const { number, line } = await page.locator(".plan-view .ruler").evaluate((group) => ({
    number: group.querySelector("text").getBoundingClientRect().height, line: parseFloat(getComputedStyle(document.body).fontSize),
  }));
  assert.ok(number > 0.8 * line && number < 2 * line, `letters of the plan: ${number} px, of the text: ${line} px`);
  await offPaper(page);
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), "dark");
  assert.deepEqual(await widths(), before_print);
  await page.close();
});

test("a print takes the paper that is there, and its charts are drawn before it begins", async () => {
  const page = await browser.open(join(folder, "one", "report.html"));
  const paper = async (format) => /\/MediaBox \[0 0 ([\d.]+) ([\d.]+)\]/.exec((await page.pdf({ format, preferCSSPageSize: true })).toString("latin1")).slice(1).map((n) => Math.round(Number(n) / 72 * 25.4));
  assert.deepEqual(await paper("Letter"), [216, 279]);
  assert.deepEqual(await paper("A4"), [210, 297]);
  // Firefox begins to print once the event has been told.
  const drawn = await page.evaluate(() => {
    dispatchEvent(new Event("beforeprint"));
    return [...document.querySelectorAll(".plot canvas")].map((c) => new Set(new Uint32Array(c.getContext("2d").getImageData(0, 0, c.width, c.height).data.buffer)).size);
  });
  assert.ok(drawn.length > 3);
  for (const colours of drawn) assert.ok(colours > 10, `${colours} colours`);
  await page.close();
});

test("two runs are printed, each with its picture and under its name", async () => {
  brash("report", join(folder, "one"), join(folder, "one"), "-o", join(folder, "two.html"));
  const page = await browser.open(join(folder, "two.html"));
  await onPaper(page);
  await expectPrintable(page);
  await expectPictures(page, 2);
  const order = await page.locator(".stage").first().evaluate((stage) => [".stage-title", ".still", ".legend"].map((name) => stage.querySelector(name).getBoundingClientRect().top));
  assert.deepEqual(order, order.toSorted((a, b) => a - b));
  await page.close();
});

test("a campaign is printed, and names each of its inputs once", async () => {
  const plan = join(folder, "plan.toml");
  writeFileSync(plan, `[campaign]\ncase = "${kCase}"\nreplicates = 2\n[set]\ntime.duration = 0.5\noutput.statistics_from = 0.1\n` +
    `[[grid]]\nstructure.speed = [0.8, 1.2]\n[output]\nkeep = "history"\n`);
  brash("campaign", plan, "-o", join(folder, "campaign"));
  const page = await browser.open(join(folder, "campaign", "report.html"));
  await onPaper(page);
  await expectPrintable(page);
  const paths = await page.locator("#inputs table").nth(1).locator("tbody td:first-child").allTextContents();
  assert.equal(paths.length, 2);
  assert.equal(new Set(paths).size, 2);
  assert.ok(!/links to/.test(await page.locator("#report").innerText()));
  await page.close();
});

test("a run that goes on is printed with its replay and without its buttons", async () => {
  live = spawn(process.env.BRASH, ["run", kCase, "-o", join(folder, "live"), "--view", "--set", "time.duration=100"], { stdio: ["ignore", "ignore", "pipe"] });
  const address = await new Promise((done) => live.stderr.on("data", (text) => /watch at  (\S+)\n/.test(text) && done(/watch at  (\S+)/.exec(text)[1])));
  const post = (what) => new Promise((done) => request(new URL(what, address), { method: "POST", agent: false }, (response) => response.resume().on("end", done)).end());
  await post("pause");
  const page = await browser.open(address);
  await post("resume");
  await until(page, () => window.brashReport.run.nEvents > 0);
  await post("pause");
  await until(page, () => document.querySelector(".live button").textContent === "Continue the run");
  // What was under way would draw the page anew.
  for (let last = -1, now = 0; now !== last; await page.waitForTimeout(1000)) [last, now] = [now, await page.evaluate(() => window.brashReport.run.duration)];
  await onPaper(page);
  await expectPrintable(page);
  await expectPictures(page, 1);
  await page.close();
});
