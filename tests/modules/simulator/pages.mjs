// SPDX-License-Identifier: GPL-3.0-or-later
// Opens a page of the simulator or of the case builder.
import { pathToFileURL } from "node:url";
import { until } from "../report/browser.mjs";

/** @param browser of browse(). */
export async function openPage(browser, file) {
  const page = await browser.context.newPage();
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type()) && !/GPU stall|GL Driver Message|willReadFrequently/.test(message.text()))
      browser.complaints.push(message.text());
  });
  page.on("pageerror", (error) => browser.complaints.push(String(error)));
  await page.goto(pathToFileURL(file).href);
  await until(page, () => window.brashSimulator?.firstPicture > 0);
  return page;
}
