#!/usr/bin/env node
// SPDX-License-Identifier: GPL-3.0-or-later
// Stills of a run's replay, as they stand in the README: stills.mjs RUN_FOLDER [PICTURE_FOLDER]
// The page's packages are those of the build (BRASH_PACKAGES, default build/release/modules/report/viewer).
import { writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const root = join(dirname(fileURLToPath(import.meta.url)), "../..");
process.env.BRASH_PACKAGES ??= join(root, "build/release/modules/report/viewer");
const { browse } = await import(join(root, "tests/modules/report/browser.mjs"));

const [run, pictures = join(root, "docs/figures")] = process.argv.slice(2);
const kWidth = 880;
const kHeight = 480;
/** Part of the run, and the view: from one place astern, and at the end from below. */
const kStills = [[0.15, "Wake"], [0.5, "Wake"], [1, "Wake"], [1, "Below"]];

const browser = await browse({ width: 1600, height: 1000 });
const page = await browser.open(join(run, "report.html"));
// The replay alone, at the size of a picture.
await page.addStyleTag({
  content: `.stage { position: fixed !important; inset: 0 auto auto 0; z-index: 9; width: ${kWidth}px; height: ${kHeight}px !important; max-height: none; border: 0; border-radius: 0; } .legend { display: none !important; }`,
});
// It would follow that size once the page is drawn anew.
await page.evaluate(([width, height]) => window.brashReport.report.replay.scene.resize(width, height), [kWidth, kHeight]);
for (const [i, [part, view]] of kStills.entries()) {
  const { time, still } = await page.evaluate(([share, name]) => {
    const { player, replay } = window.brashReport.report;
    const { scene } = replay;
    scene.follow = false;
    // The camera stands where the middle of the run is seen best; the structure passes.
    player.seek((name === "Wake" ? 0.42 : 1) * player.duration);
    scene.look(name);
    if (name === "Wake") scene.camera.position.sub(scene.controls.target).multiplyScalar(1.15).add(scene.controls.target);
    player.seek(share * player.duration);
    return { time: player.time, still: replay.still() };
  }, [part, view]);
  const path = join(pictures, `replay-${i + 1}.png`);
  writeFileSync(path, Buffer.from(still.split(",")[1], "base64"));
  console.log(`${path}: ${time.toFixed(2)} s, ${view}`);
}
await browser.close();
