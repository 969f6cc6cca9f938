// SPDX-License-Identifier: GPL-3.0-or-later
// The case builder of `brash new --page`: what it writes, `brash check` reads; it is accessible and asks no network.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { readFileSync, rmSync, writeFileSync } from "node:fs";
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
  assert.match(brash("new", "--kind", "cube").stderr, /cube is not a kind of structure/);
  assert.equal(brash("new", "--page", page_file).status, 2);
});

test("the page begins as a new case with the ice of a site does", async () => {
  const page = await openPage(browser, page_file);
  const text = await page.locator("textarea").inputValue();
  assert.equal(text, brash("new", "--ice", "baltic").stdout);
  assert.match(text, /^preset = "brash"/m);
  assert.equal(await page.locator("#site-ice").inputValue(), "baltic");
  assert.equal(await page.locator(".warnings:visible").count(), 0);
  await page.close();
});

test("the ice of a site comes with its sources, as brash new writes it", async () => {
  const page = await openPage(browser, page_file);
  const [text, choice] = [page.locator("textarea"), page.locator("#site-ice")];
  // A section that has lost its keys stays.
  const keys = (toml) => toml.split("\n").filter((line) => /^#/.test(line) || /^(thickness|density|\w+_modulus|\w+_strength|friction_\w+) /.test(line))
    .map((line) => line.replace(/ {2,}#.*/, "")).sort();
  for (const ice of ["bohai", "arctic", "basin", "baltic"]) {
    await choice.selectOption(ice);
    assert.deepEqual(keys(await text.inputValue()), keys(brash("new", "--ice", ice).stdout), ice);
    assert.equal(await choice.inputValue(), ice);
  }
  const file = join(folder, "baltic.toml");
  writeFileSync(file, await text.inputValue());
  const checked = brash("check", file, "--keys");
  assert.equal(checked.status, 0, checked.stderr);
  assert.match(checked.stdout, /^youngs_modulus = 3100000000/m);
  assert.match(await text.inputValue(), /^# Derived: 1\.76 .*\(Timco and O'Brien 1994\)[^]*?^flexural_strength = "690 kPa" {2,}# Flexural strength/m);
  assert.equal(await page.locator("#key-ice-friction_structure").inputValue(), "0.1");
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
  const checked = brash("check", file, "--keys");
  assert.equal(checked.status, 0, checked.stderr);
  assert.match(checked.stdout, /^thickness = 0\.45 /m);
  assert.match(checked.stdout, /^speed = 1\.5 /m);
  assert.match(checked.stdout, /^model = "wedge"/m);
  assert.ok(!/^friction_ice/m.test(text), "an empty field is not a key");
  await page.locator("textarea").fill(text.replace("1.5", "2.25"));
  assert.equal(await page.locator("#key-structure-speed").inputValue(), "2.25");
  // Keys of other kinds of structure are not asked for.
  assert.equal(await page.locator("#key-structure-entrance").isVisible(), false);
  await page.locator("#key-structure-kind").selectOption("wedge-bow");
  assert.equal(await page.locator("#key-structure-entrance").isVisible(), true);
  await page.close();
});

test("a chosen kind of structure comes with its keys, and check takes the file", async () => {
  const page = await openPage(browser, page_file);
  const text = page.locator("textarea");
  await page.locator("#key-structure-speed").fill("0.9 m/s");
  const file = join(folder, "kind.toml");
  for (const kind of ["ship", "wedge-bow", "mesh", "plane", "faceted-cone", "ship", "cone"]) {
    await page.locator("#key-structure-kind").selectOption(kind);
    const now = await text.inputValue();
    assert.match(now, /^speed = "0\.9 m\/s"/m, "its speed stays");
    assert.equal(/^\[hull\]$/m.test(now), kind === "ship");
    writeFileSync(file, now);
    const checked = brash("check", file);
    if (kind === "mesh") assert.match(checked.stderr, /structure\.file = "hull\.stl": there is no file/, "a mesh is the reader's");
    else assert.equal(checked.status, 0, `${kind}: ${checked.stderr}`);
  }
  await page.close();
});

test("three answers end in a case that check takes, and in commands that there are", async () => {
  const page = await openPage(browser, page_file);
  const [text, structure, cover, question] = [page.locator("textarea"), ...["structure", "cover", "question"].map((name) => page.locator(`#choose-${name}`))];
  const file = join(folder, "chosen.toml");
  assert.equal(await structure.inputValue(), "cone", "as the page begins");
  const first = await text.inputValue();
  for (const made of ["floater", "pier", "ship", "wall", "mesh", "floater", "cone"])
    for (const ice of ["floes", "level"]) {
      await structure.selectOption(made);
      await cover.selectOption(ice);
      assert.deepEqual([await structure.inputValue(), await cover.inputValue()], [made, ice]);
      writeFileSync(file, await text.inputValue());
      const checked = brash("check", file);
      if (made === "mesh") assert.match(checked.stderr, /structure\.file = "hull\.stl": there is no file/, "a mesh is the reader's");
      else assert.equal(checked.status, 0, `${made}, ${ice}: ${checked.stderr}`);
    }
  const bare = (toml) => toml.replace(/ {2,}#/g, " #");
  assert.equal(bare(await text.inputValue()), bare(first), "back to the start, nothing is left of the others");
  const help = {};
  for (const made of ["cone", "ship", "floater"]) {
    await structure.selectOption(made);
    const asked = await question.locator("option").evaluateAll((all) => all.filter(({ hidden }) => !hidden).map(({ value }) => value));
    assert.equal(asked.includes("resistance"), made === "ship");
    assert.equal(asked.includes("offset"), made === "floater");
    for (const each of asked) {
      await question.selectOption(each);
      const commands = (await page.locator("#answer pre.commands").innerText()).trim().split("\n");
      assert.equal(commands[0], "brash check mine.toml");
      assert.ok(commands.length > 1);
      for (const [, name, rest] of commands.map((line) => /^brash (export \w+|\w+) (.*)$/.exec(line))) {
        help[name] ??= brash(...name.split(" "), "--help").stdout;
        for (const [option] of rest.matchAll(/(?<= )--?[a-z-]+/g)) assert.match(help[name], new RegExp(`(^|[ ,])${option}[ ,]`, "m"), `${name} ${option}`);
      }
    }
  }
  // The plan that an answer shows is one that the program reads.
  await structure.selectOption("cone");
  await question.selectOption("years");
  const [plan, states] = await page.locator("#answer pre:not(.commands)").allInnerTexts();
  assert.match(states, /^ice\.thickness,hours\n/);
  writeFileSync(join(folder, "plan.toml"), plan);
  writeFileSync(join(folder, "mine.toml"), await text.inputValue());
  const status = brash("campaign", join(folder, "plan.toml"), "-o", join(folder, "results"), "--status");
  assert.match(status.stdout, /^0 of 30 cases done/, status.stderr);
  await page.close();
});

test("ranges are in the unit in which a key is written", async () => {
  const page = await openPage(browser, page_file);
  assert.match(await page.locator("#key-structure-angle-meaning").innerText(), /Unit: deg, .* rad without one\. Range: \d+(\.\d+)? to 90 deg/);
  assert.match(await page.locator("#key-ice-youngs_modulus-meaning").innerText(), /Range: [\d.]+ to \d+ GPa/);
  await page.close();
});

test("on a phone the file stays in sight above the fields", async () => {
  const page = await openPage(browser, page_file);
  await page.setViewportSize({ width: 390, height: 844 });
  const visible = () => page.locator("textarea").evaluate((area) => {
    const { top, bottom } = area.getBoundingClientRect();
    return top >= 0 && bottom <= 0.45 * innerHeight;
  });
  await page.locator("#key-structure-speed").scrollIntoViewIfNeeded();
  await page.locator("#key-structure-speed").evaluate((field) => field.scrollIntoView({ block: "center" }));
  assert.ok(await visible());
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  await page.close();
});

test("comments and a measured load follow the values that they are of", async () => {
  const page = await openPage(browser, page_file);
  const text = page.locator("textarea");
  await page.locator("#key-ice-flexural_strength").fill("450 kPa");
  let now = await text.inputValue();
  assert.match(now, /^flexural_strength = "450 kPa" {2}# Flexural strength sigma_f,/m, "the meaning stays");
  assert.doesNotMatch(now, /Derived: 1\.76 exp/, "the source of the former value goes");
  assert.match(now, /Derived: effective modulus/, "other sources stay");
  assert.doesNotMatch(now, /^# Ice: /m, "it is no more the ice of that site");
  assert.equal(await page.locator("#site-ice").inputValue(), "");
  // A case with a measured load, and sources behind its values.
  await text.fill(readFileSync(join(process.env.BRASH_SOURCE, "experiments/validation/cone.toml"), "utf8"));
  await page.locator("#key-time-duration").fill("30");
  assert.match(await text.inputValue(), /^mean_horizontal = "111\.8 kN"/m, "a longer run has the same load");
  await page.locator("#key-ice-thickness").fill("45 cm");
  now = await text.inputValue();
  assert.match(now, /^thickness = "45 cm"$/m);
  assert.match(now, /^youngs_modulus = "0\.35 GPa" +# Table 1$/m);
  assert.doesNotMatch(now, /mean_horizontal|"measured in/);
  await page.evaluate(() => window.brashSimulator.store.checked);
  assert.match(await page.locator(".warnings").first().innerText(), /reference\.mean_horizontal = "111\.8 kN" was measured in the case before this change/);
  const file = join(folder, "changed.toml");
  writeFileSync(file, now);
  assert.equal(brash("check", file).status, 0);
  await page.close();
});

test("values that no ice has are warned of as brash check does", async () => {
  const page = await openPage(browser, page_file);
  const ids = async () => {
    await page.evaluate(() => window.brashSimulator.store.checked);
    return page.locator(".warnings:visible code").allTextContents();
  };
  const plausible = ["thickness", "density", "youngs-modulus", "flexural-strength", "compressive-strength", "friction-structure", "fast-current"];
  const file = join(folder, "doubtful.toml");
  for (const [key, value, expected] of [
    ["structure-start_distance", "9 m", []], ["ice-flexural_strength", "0.7", ["flexural-strength"]], ["ice-flexural_strength", "690 kPa", []],
    ["ice-youngs_modulus", "350 MPa", ["youngs-modulus"]], ["ice-thickness", "5 cm", []], ["ice-thickness", "6 m", ["thickness", "youngs-modulus"]],
    ["ice-thickness", "0.4 m", ["youngs-modulus"]], ["reference-source", "a model basin", []], ["reference-source", "", ["youngs-modulus"]],
    ["ice-youngs_modulus", "3.1 GPa", []], ["ice-friction_structure", "", ["friction-structure"]], ["ice-friction_structure", "0.1", []],
    ["water-current", "[9, 0]", ["fast-current"]], ["water-current", "[\"3 m/s\", \"-3 m/s\"]", []], ["water-current", "", []],
  ]) {
    const field = page.locator(`#key-${key}`);
    if (!(await field.isVisible())) await page.locator(`details:has(#key-${key}) > summary`).click();
    await field.fill(value);
    assert.deepEqual(await ids(), expected, `${key} = ${value}`);
    assert.equal(await page.locator(".doubt:visible").count(), expected.length, "each beside its field");
    writeFileSync(file, await page.locator("textarea").inputValue());
    const said = brash("check", file).stderr;
    const native = plausible.filter((id) => said.includes(`warning: ${id}:`));
    assert.deepEqual(native.sort(), [...expected].sort(), `${key} = ${value}: ${said}`);
  }
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
