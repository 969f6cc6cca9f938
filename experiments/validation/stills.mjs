#!/usr/bin/env node
// SPDX-License-Identifier: GPL-3.0-or-later
// Stills of a run's replay, as they stand on the site: stills.mjs RUN_FOLDER [PICTURE_FOLDER]
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { browse, look, root, sized, smoothed } from "./replay_page.mjs";

const [run, pictures = join(root, "docs/figures")] = process.argv.slice(2);
/** Views of the end of the run. */
const kViews = ["Wake", "Below"];

const browser = await browse({ width: 1600, height: 1000 });
await smoothed(browser);
const page = await browser.open(join(run, "report.html"));
await sized(page, 880, 480);
for (const view of kViews) {
  await look(page, view);
  const { time, still } = await page.evaluate(() => {
    const { player, replay } = window.brashReport.report;
    player.seek(player.duration);
    return { time: player.time, still: replay.still() };
  });
  const path = join(pictures, `replay-${view.toLowerCase()}.png`);
  writeFileSync(path, Buffer.from(still.split(",")[1], "base64"));
  console.log(`${path}: ${time.toFixed(2)} s, ${view}`);
}
await browser.close();
