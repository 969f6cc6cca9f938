#!/usr/bin/env node
// SPDX-License-Identifier: GPL-3.0-or-later
// The annotated pictures of docs/one-run-explained.md, from the report of `./dev demo`: one_run.mjs [RUN_FOLDER] [PICTURE_FOLDER]
// Numbers on a picture are those of the page's lists. They are placed by the parts of the report, and by the time of the peak.
import { join } from "node:path";
import { browse, root, smoothed } from "../../experiments/validation/replay_page.mjs";

const [run = join(root, "results/demo"), pictures = join(root, "docs/figures")] = process.argv.slice(2);
const kWidth = 780;   // of the report [px]: one column, as wide as a page of the site
const kMargin = 10;   // around a picture [px]

/** Numbers: [number, selector, which of its elements, place across and down as shares of the element's box, shift in px]. */
const kPictures = {
  "one-run-replay": {
    from: ".figures", to: ".replay",
    marks: [[1, ".figures .figure", 0, [0.78, 0.14]], [2, ".figures .figure", 3, [0.78, 0.14]], [3, ".figures .figure", 4, [0.92, 0.14]],
            [4, ".stage", 0, [0.77, 0.42]], [5, ".stage", 0, [0.73, 0.72]], [6, ".transport", 0, [0.55, 0.5]]],
  },
  "one-run-loads": {
    from: ".loads", to: ".event-card",
    marks: [[7, ".loads .u-over", 0, ["peak", 0.1], [20, 0]], [8, ".loads .u-over", 0, [1, 0.72], [14, 0]],
            [9, ".event-card figure svg", 0, [0.66, 0.3], [34, 0]], [10, ".event-card .numbers", 0, [0.48, 1.18]]],
  },
  "one-run-channel": {
    from: ".plan-view", to: ".plan-view .legend",
    marks: [[11, ".plan-view svg", 0, [0.1, 0.55]], [12, ".plan-view svg", 0, [0.43, 0.78]], [13, ".plan-view svg", 0, [0.17, 0.33]]],
  },
};

/** Puts numbers on the page, and gives the box from the first to the last part of the picture, in px of the document. */
const annotate = (page, { from, to, marks }) => page.evaluate(({ from, to, marks }) => {
  const { player } = window.brashReport.report;
  document.querySelectorAll(".mark").forEach((mark) => mark.remove());
  for (const [number, selector, which, [across, down], [dx, dy] = [0, 0]] of marks) {
    const box = document.querySelectorAll(selector)[which].getBoundingClientRect();
    const share = across === "peak" ? player.time / player.duration : across;
    const mark = document.createElement("div");
    mark.className = "mark";
    mark.textContent = number;
    mark.style.cssText = `position: absolute; left: ${scrollX + box.left + share * box.width + dx - 14}px;
      top: ${scrollY + box.top + down * box.height + dy - 14}px; width: 28px; height: 28px; border-radius: 50%; z-index: 99;
      background: #b3261e; color: white; border: 2px solid white; box-sizing: border-box;
      font: bold 15px/24px sans-serif; text-align: center;`;
    document.body.append(mark);
  }
  const [first, last] = [from, to].map((selector) => document.querySelector(selector).getBoundingClientRect());
  return { y: scrollY + first.top, height: last.bottom - first.top };
}, { from, to, marks });

const browser = await browse({ width: kWidth, height: 1400 });
await smoothed(browser);
const page = await browser.open(join(run, "report.html"));
for (const [name, picture] of Object.entries(kPictures)) {
  const { y, height } = await annotate(page, picture);
  const path = join(pictures, `${name}.png`);
  await page.screenshot({ path, fullPage: true, clip: { x: 0, y: y - kMargin, width: kWidth, height: height + 2 * kMargin } });
  console.log(path);
}
await browser.close();
