// SPDX-License-Identifier: GPL-3.0-or-later
// The land of field.shore in the report: in the replay, in the plan and in their legends.
import assert from "node:assert/strict";
import { readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { brash, browse, pixelsOf, scratch } from "./browser.mjs";

const folder = scratch();
const kCase = join(process.env.BRASH_SOURCE, "experiments/validation/cone.toml");
const kSettings = ["time.duration=1.5", "output.statistics_from=1", "field.initial_crack=false"].flatMap((set) => ["--set", set]);
/** A cape beside the structure with a pond in it, and a coast so far away that no view should care. */
const kCape = [[[-6, 9], [12, 9], [12, 24], [-6, 24]], [[0, 18], [0, 21], [6, 21], [6, 18]]];
const kCoast = [[[-8000, 200], [8000, 200], [8000, 8000], [-8000, 8000]]];
let browser, page, plain;

before(async () => {
  const ring = (nodes) => `(${[...nodes, nodes[0]].map((node) => node.join(" ")).join(", ")})`;
  writeFileSync(join(folder, "shore.wkt"), `MULTIPOLYGON (${[kCape, kCoast].map((rings) => `(${rings.map(ring).join(", ")})`).join(", ")})\n`);
  brash("run", kCase, "-o", join(folder, "shore"), ...kSettings, "--set", `field.shore="${join(folder, "shore.wkt")}"`);
  brash("run", kCase, "-o", join(folder, "plain"), ...kSettings);
  // The run's folder has its own copy.
  rmSync(join(folder, "shore.wkt"));
  brash("report", join(folder, "shore"));
  browser = await browse();
  page = await browser.open(join(folder, "shore", "report.html"));
  plain = await browser.open(join(folder, "plain", "report.html"));
});

after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

/** Share of the replay from above that has the colour of land, which a level surface in the sun has; no shadow falls there. */
async function landInReplay(of) {
  const { still, colour } = await of.evaluate(() => {
    const { player, replay } = window.brashReport.report;
    player.seek(0);
    replay.look("Above");
    const context = new OffscreenCanvas(1, 1).getContext("2d");
    context.fillStyle = getComputedStyle(document.documentElement).getPropertyValue("--scene-land").trim();
    context.fillRect(0, 0, 1, 1);
    return { still: replay.still(), colour: [...context.getImageData(0, 0, 1, 1).data.slice(0, 3)] };
  });
  const pixels = await pixelsOf(of, Buffer.from(still.split(",")[1], "base64"), 13);
  return pixels.filter((pixel) => pixel.every((value, i) => Math.abs(value - colour[i]) <= 6)).length / pixels.length;
}

const shown = (of) => of.evaluate(() => ({
  legends: [".stage .legend", ".plan-view .legend"].map((name) => document.querySelector(name).textContent.includes("land")),
  n: document.querySelectorAll(".plan-view .land path").length,
  box: document.querySelector(".plan-view svg").viewBox.baseVal.width,
  land: window.brashReport.run.land,
}));

test("land lies in the plan and in the replay, in light and dark, and both legends name it", async () => {
  const { legends, n, land } = await shown(page);
  assert.deepEqual(legends, [true, true]);
  assert.equal(n, 1, "of what is near");
  assert.deepEqual(land.map((rings) => rings.length), [2, 1]);
  for (const rings of land) for (const [x, y] of rings[0]) assert.ok([...kCape[0], ...kCoast[0]].some(([u, v]) => Math.hypot(x - u, y - v) < 0.01), `${x} ${y}`);
  for (const theme of ["light", "dark"]) {
    await page.getByLabel("Colours").selectOption(theme);
    const share = await landInReplay(page);
    assert.ok(share > 0.02, `${theme}: land is ${share} of the replay`);
  }
});

test("far land moves neither the camera nor the border of the plan", async () => {
  const camera = (of) => of.evaluate(() => {
    const { player, replay } = window.brashReport.report;
    player.seek(0);
    return Object.keys({ Wake: 0, Above: 0 }).map((name) => {
      replay.look(name);
      return replay.scene.camera.position.toArray();
    });
  });
  assert.deepEqual(await camera(page), await camera(plain));
  assert.ok((await shown(page)).box < 60);
});

test("a run without a shore shows none and says nothing of it", async () => {
  const { legends, n, land } = await shown(plain);
  assert.deepEqual([legends, n, land], [[false, false], 0, []]);
  const share = await landInReplay(plain);
  assert.ok(share < 0.005, `${share} of a replay without land has its colour`);
  assert.deepEqual(browser.complaints, []);
});

test("the picture of the end of the run has the land too", () => {
  const count = (name) => [...readFileSync(join(folder, name, "plan.svg"), "utf8").matchAll(/class="land"/g)].length;
  assert.deepEqual([count("shore"), count("plain")], [2, 0]);
});
