// SPDX-License-Identifier: GPL-3.0-or-later
// A report in headless Chromium: what the tests and the pictures share.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const { BRASH, BRASH_PACKAGES, BRASH_CHROMIUM = "/usr/bin/chromium" } = process.env;

const kFlags = [
  "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run",
  "--disable-background-networking", "--disable-component-update", "--disable-sync", "--force-color-profile=srgb",
];

export function brash(...args) {
  return execFileSync(BRASH, args, { encoding: "utf8", stdio: ["ignore", "pipe", "inherit"] });
}

export function scratch() {
  return mkdtempSync(join(tmpdir(), "brash-report-"));
}

/** Rows of a CSV file as objects of texts. */
export function readCsv(path) {
  const [head, ...rows] = readFileSync(path, "utf8").trim().split("\n").map((line) => line.split(","));
  return rows.map((row) => Object.fromEntries(head.map((name, i) => [name, row[i]])));
}

/** Holds that axe-core finds no fault in a page, light, dark and narrow. */
export async function expectAccessible(page) {
  const axe = readFileSync(createRequire(join(BRASH_PACKAGES, "package.json")).resolve("axe-core/axe.min.js"), "utf8");
  const faults = async () => {
    await page.evaluate("document.querySelectorAll('details').forEach((d) => (d.open = true))");
    await page.evaluate(axe);
    const { violations } = await page.evaluate("axe.run(document, { resultTypes: ['violations'] })");
    return violations.flatMap(({ id, nodes }) => nodes.map(({ html, failureSummary }) => `${id}: ${html.slice(0, 160)}: ${failureSummary}`));
  };
  for (const theme of ["light", "dark"]) {
    await page.getByLabel("Colours").selectOption(theme);
    assert.deepEqual(await faults(), [], theme);
  }
  await page.setViewportSize({ width: 390, height: 800 });
  assert.deepEqual(await faults(), [], "narrow");
}

/** Lays a page out as a browser does for a print on A4: 182 mm between the margins. */
export async function onPaper(page) {
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  await page.emulateMedia({ media: "print" });
  await page.setViewportSize({ width: 688, height: 1000 });
}

/** Back to a screen. */
export async function offPaper(page) {
  await page.emulateMedia({ media: "screen" });
  await page.setViewportSize({ width: 1366, height: 768 });
  await page.evaluate(() => dispatchEvent(new Event("afterprint")));
}

/** Holds that a page on paper is light, shows nothing to click, has its whole width and charts that are drawn for it. */
export async function expectPrintable(page) {
  const found = await page.evaluate(() => {
    const seen = (selector) => [...document.querySelectorAll(selector)].filter((e) => e.checkVisibility());
    const brightness = (colour) => colour.match(/[\d.]+/g).slice(0, 3).reduce((sum, n) => sum + Number(n), 0);
    return {
      width: document.documentElement.scrollWidth,
      controls: seen("button:not(.link), select, input, textarea, a.skip:focus").map((e) => e.outerHTML.slice(0, 120)),
      paper: brightness(getComputedStyle(document.body).backgroundColor),
      ink: brightness(getComputedStyle(document.body).color),
      // Three pixels for one, but for half a pixel of a column's width.
      charts: seen(".plot canvas").map((canvas) => canvas.width / canvas.clientWidth),
      // A grid in the colours of a dark page is nearly black.
      darkest: seen(".plot canvas").map((canvas) => {
        const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
        let [n, dark] = [0, 0];
        for (let i = 0; i < data.length; i += 4) if (data[i + 3] > 200) ++n && (dark += data[i] + data[i + 1] + data[i + 2] < 200);
        return dark / n;
      }),
    };
  });
  assert.equal(found.width, 688);
  assert.deepEqual(found.controls, []);
  assert.ok(found.paper > 3 * 250 && found.ink < 3 * 60, JSON.stringify(found));
  for (const ratio of found.charts) assert.ok(Math.abs(ratio - 3) < 0.02, `a chart has ${ratio} pixels for one of the page`);
  for (const share of found.darkest) assert.ok(share < 0.35, `${share} of a chart is dark`);
}

/** Software draws the replay, and a busy machine draws it slowly [ms]. */
const kPatience = 300e3;

/** Waits until `holds` does in the page. The page's policy forbids what Playwright's own wait does. */
export async function until(page, holds) {
  for (const start = Date.now(); Date.now() - start < kPatience; ) {
    if (await page.evaluate(holds)) return;
    await new Promise((done) => setTimeout(done, 50));
  }
  throw new Error(`still waiting for ${holds}`);
}

/** Pixels [r, g, b] of a PNG, every `every`th, as the browser decodes it. */
export async function pixelsOf(page, png, every = 31) {
  return page.evaluate(async ([data, step]) => {
    const bitmap = await createImageBitmap(new Blob([Uint8Array.from(atob(data), (c) => c.charCodeAt(0))]));
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    const context = canvas.getContext("2d");
    context.drawImage(bitmap, 0, 0);
    const { data: pixels } = context.getImageData(0, 0, bitmap.width, bitmap.height);
    return Array.from({ length: Math.floor(pixels.length / (4 * step)) }, (_, i) => [...pixels.slice(4 * step * i, 4 * step * i + 3)]);
  }, [png.toString("base64"), every]);
}

/** The page as `chromium --screenshot` sees it, without a script that waits. */
export function plainScreenshot(file, picture, width, height) {
  execFileSync(BRASH_CHROMIUM, ["--headless", ...kFlags, "--hide-scrollbars", `--window-size=${width},${height}`, `--screenshot=${picture}`, pathToFileURL(file).href],
    { stdio: "ignore", timeout: kPatience });
  return readFileSync(picture);
}

/** What a click on an element saves: its name and bytes. */
export async function saved(page, element) {
  const [download] = await Promise.all([page.waitForEvent("download"), element.click()]);
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

/** The content of a saved drawing of a chart: its words, and under each name the paths, with the numbers of its axes. */
export async function readChart(page, svg) {
  return page.evaluate((text) => {
    const root = new DOMParser().parseFromString(text, "image/svg+xml").documentElement;
    const number = (of) => Number(of.textContent.replace("−", "-"));
    const ticks = (anchor, axis) => [...root.querySelectorAll(`text[text-anchor=${anchor}]`)].filter((t) => t.hasAttribute(axis) && t.textContent !== "" && !Number.isNaN(number(t)))
      .map((t) => [Number(t.getAttribute(axis)) - (axis === "y" ? 4 : 0), number(t)]);
    return {
      words: [...root.querySelectorAll("text")].map((t) => t.textContent),
      x: ticks("middle", "x"), y: ticks("end", "y"),
      paths: Object.fromEntries([...root.querySelectorAll("g[clip-path] > g")].map((group) =>
        [group.querySelector("title").textContent, [...group.querySelectorAll("path")].map((path) => path.getAttribute("d"))])),
    };
  }, svg);
}

/** The number at a place of an axis [px], from the first and the last of its ticks. */
export function numberAt(ticks, place) {
  const [[p0, n0], [p1, n1]] = [ticks[0], ticks.at(-1)];
  return n0 + ((place - p0) * (n1 - n0)) / (p1 - p0);
}

/** A browser of its own that can be killed: its pages, and `kill`. */
export async function doomedBrowser() {
  const { chromium } = createRequire(join(BRASH_PACKAGES, "package.json"))("playwright-core");
  const server = await chromium.launchServer({ executablePath: BRASH_CHROMIUM, headless: true, args: kFlags });
  const browser = await chromium.connect(server.wsEndpoint());
  return { newPage: () => browser.newPage(), kill: () => server.kill() };
}

/** Opens pages in one browser. Everything that goes wrong in them, and every request, is written down. */
export async function browse({ width = 1366, height = 768, dark = false, offline = true } = {}) {
  const { chromium } = createRequire(join(BRASH_PACKAGES, "package.json"))("playwright-core");
  const profile = mkdtempSync(join(tmpdir(), "brash-chromium-"));
  const context = await chromium.launchPersistentContext(profile, {
    executablePath: BRASH_CHROMIUM, headless: true, args: kFlags, viewport: { width, height },
    colorScheme: dark ? "dark" : "light", offline, acceptDownloads: true,
  });
  context.setDefaultTimeout(kPatience);
  const complaints = [];
  const requests = [];
  context.on("request", (request) => requests.push(request.url()));
  return {
    context, complaints, requests,
    async open(file) {
      const page = await context.newPage();
      page.on("console", (message) => {
        // Reading pixels back, as the tests do, is slow, and the browser says so.
        if (["error", "warning"].includes(message.type()) && !/GPU stall|GL Driver Message|willReadFrequently/.test(message.text()))
          complaints.push(message.text());
      });
      page.on("pageerror", (error) => complaints.push(String(error)));
      await page.goto(file.startsWith("http:") ? file : pathToFileURL(file).href);
      await until(page, () => window.brashReport?.readyAfter > 0);
      return page;
    },
    async close() {
      await context.close();
      rmSync(profile, { recursive: true, force: true });
    },
  };
}
