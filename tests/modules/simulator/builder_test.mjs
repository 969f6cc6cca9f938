// SPDX-License-Identifier: GPL-3.0-or-later
// The case builder of `brash new --page`: what it writes, `brash check` reads; it is accessible and asks no network.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { browse, expectAccessible, offPaper, onPaper, scratch } from "../report/browser.mjs";
import { openPage } from "./pages.mjs";

const folder = scratch();
const page_file = join(folder, "builder.html");
const brash = (...args) => spawnSync(process.env.BRASH, args, { encoding: "utf8" });
let browser;

before(async () => {
  execFileSync(process.env.BRASH, ["new", "--page", page_file]);
  browser = await browse();
});

after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

test("a new case is one that brash check reads", () => {
  for (const kind of ["cone", "plane", "ship"]) {
    const file = join(folder, `${kind}.toml`);
    assert.equal(brash("new", "-o", file, "--kind", kind).status, 0);
    assert.equal(brash("check", file).status, 0, kind);
    assert.equal(brash("new", "-o", file).status, 2, "a file that is there stays");
  }
  assert.match(brash("new", "--kind", "cube").stderr, /cube is no kind of structure/);
  assert.equal(brash("new", "--page", page_file).status, 2);
});

test("the ice of a site comes with its sources, and goes again", async () => {
  const page = await openPage(browser, page_file);
  const [text, choice] = [page.locator("textarea"), page.locator("#site-ice")];
  const first = await text.inputValue();
  await choice.selectOption("baltic");
  const file = join(folder, "baltic.toml");
  writeFileSync(file, await text.inputValue());
  const checked = brash("check", file);
  assert.equal(checked.status, 0, checked.stderr);
  assert.match(checked.stdout, /^youngs_modulus = 3100000000/m);
  assert.match(await text.inputValue(), /^flexural_strength = "690 kPa" {2}# baltic: Derived: .*Timco and O'Brien 1994.*v_b = 0.0251/m);
  assert.equal(await page.locator("#key-ice-friction_structure").inputValue(), "0.1");
  await choice.selectOption("basin");
  const values = (toml) => toml.split("\n").map((line) => line.replace(/ {2,}# /, "  # ")).join("\n");
  assert.equal(values(await text.inputValue()), values(first));
  await page.close();
});

test("the form writes a case file, and what is written shows in the form", async () => {
  const page = await openPage(browser, page_file);
  await page.locator("#key-ice-thickness").fill("45 cm");
  await page.locator("#key-structure-speed").fill("1.5");
  await page.locator("details:has(#key-failure-model) > summary").click();
  await page.locator("#key-failure-model").selectOption("wedge");
  await page.locator("#key-ice-friction_ice").fill("");
  const text = await page.locator("textarea").inputValue();
  const file = join(folder, "built.toml");
  writeFileSync(file, text);
  const checked = brash("check", file);
  assert.equal(checked.status, 0, checked.stderr);
  assert.match(checked.stdout, /^thickness = 0\.45 /m);
  assert.match(checked.stdout, /^speed = 1\.5 /m);
  assert.match(checked.stdout, /^model = "wedge"/m);
  assert.match(text, /^thickness = "45 cm" {2}# Table 1$/m, "comments stay");
  assert.ok(!/^friction_ice/m.test(text), "an empty field is no key");
  await page.locator("textarea").fill(text.replace("1.5", "2.25"));
  assert.equal(await page.locator("#key-structure-speed").inputValue(), "2.25");
  // Keys of other kinds of structure are not asked for.
  assert.equal(await page.locator("#key-structure-entrance").isVisible(), false);
  await page.locator("#key-structure-kind").selectOption("wedge-bow");
  assert.equal(await page.locator("#key-structure-entrance").isVisible(), true);
  await page.close();
});

test("a key offers the names of its section's kind alone", async () => {
  const page = await openPage(browser, page_file);
  const border = () => page.evaluate(() => [...document.querySelector("#key-field-border").options].filter(({ hidden }) => !hidden).map((option) => option.textContent));
  assert.deepEqual(await border(), ["default: fixed", "fixed", "free"]);
  await page.locator("#key-field-kind").selectOption("floes");
  assert.deepEqual(await border(), ["default: free", "free", "walls"]);
  await page.close();
});

test("a value out of its range is refused at once", async () => {
  const page = await openPage(browser, page_file);
  await page.locator("#key-ice-density").fill("2000");
  await page.evaluate(() => window.brashSimulator.store.checked);
  assert.match(await page.getByRole("alert").first().innerText(), /ice\.density = 2000 is outside its range, 500 to 1000/);
  assert.equal(await page.locator("#key-ice-density").getAttribute("aria-invalid"), "true");
  await page.locator("#key-ice-density").fill("917 kg/m3");
  await page.evaluate(() => window.brashSimulator.store.checked);
  assert.equal(await page.getByRole("alert").count(), 0);
  await page.close();
});

test("paper shows the case file in full, and the keys that it has", async () => {
  const page = await openPage(browser, page_file);
  await page.getByLabel("Colours").selectOption("dark");
  const open = () => page.locator(".form details").evaluateAll((all) => all.map((each) => each.open));
  const before_print = await open();
  await onPaper(page);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 688);
  assert.equal(await page.locator("pre.on-paper").innerText(), await page.locator("textarea").inputValue());
  assert.equal(await page.locator("textarea:visible, button:visible").count(), 0);
  const keys = await page.locator(".field:visible label").allTextContents();
  const written = (await page.locator("textarea").inputValue()).match(/^\w+(?= = )/gm);
  assert.deepEqual(keys.map((text) => text.split(" ")[0]).sort(), written.sort());
  await offPaper(page);
  assert.deepEqual(await open(), before_print);
  assert.equal(await page.locator("pre.on-paper:visible").count(), 0);
  await page.close();
});

test("axe-core finds no fault, light, dark and narrow", async () => {
  const page = await openPage(browser, page_file);
  await expectAccessible(page);
  await page.close();
});

test("nothing is asked of a network", () => {
  assert.deepEqual(browser.requests.filter((url) => !/^(file|data|blob|about):/.test(url)), []);
  assert.deepEqual(browser.complaints, []);
});
