// SPDX-License-Identifier: GPL-3.0-or-later
// What the report of a run adds and gives away: the crack's true line, a measured history, a second run, files.
import assert from "node:assert/strict";
import { readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { brash, browse, numberAt, pixelsOf, plainScreenshot, readChart, readCsv, saved, scratch } from "./browser.mjs";

const folder = scratch();
const [run, other, drifting] = [join(folder, "disc"), join(folder, "stress"), join(folder, "drifting")];
const kCase = join(process.env.BRASH_SOURCE, "experiments/validation/cone.toml");
let browser, page, events;

before(async () => {
  brash("run", kCase, "-o", run, "--set", "time.duration=3", "--set", "output.statistics_from=1");
  brash("run", kCase, "-o", other, "--set", "algorithm.preset=brash", "--set", "time.duration=2", "--set", "output.statistics_from=1");
  events = readCsv(join(run, "events.csv")).filter((row) => row.event === "break");
  browser = await browse();
  page = await browser.open(join(run, "report.html"));
});

after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

const ask = (at, look, argument) =>
  at.evaluate(`(${look})(window.brashReport.report, window.brashReport.run, ${JSON.stringify(argument ?? null)})`);

test("the headline tells the largest load of the run from that of its statistics", async () => {
  const late = join(folder, "late");
  brash("run", kCase, "-o", late, "--set", "time.duration=1.5", "--set", "output.statistics_from=1.3");
  const loads = readCsv(join(late, "history.csv")).map((row) => [Number(row.time), Number(row.Fx)]);
  const [time, whole] = loads.reduce((most, row) => (row[1] > most[1] ? row : most));
  const within = Math.max(...loads.filter(([at]) => at > 1.3).map(([, load]) => load));
  assert.ok(whole > within);
  const shown = await browser.open(join(late, "report.html"));
  const figures = await shown.locator(".figures .figure").allInnerTexts();
  const figure = (name) => figures.find((text) => text.includes(name));
  assert.ok(figure("largest horizontal from 1.30 s on").startsWith((within / 1e3).toFixed(1)));
  assert.ok(figure("largest horizontal of the whole run").startsWith((whole / 1e3).toFixed(1)));
  assert.ok(figure("largest horizontal of the whole run").includes(`at ${time.toFixed(2)} s, before the statistics begin`));
  await shown.close();
});

test("the header names the presets and the programs of the runs", async () => {
  const { program } = JSON.parse(readFileSync(join(run, "manifest.json"), "utf8"));
  const [own, changed] = [run, other].map((of) => JSON.parse(readFileSync(join(of, "summary.json"), "utf8")).origin.presets[0]);
  assert.equal(changed, "brash");
  assert.ok((await page.locator("header p").first().innerText()).includes(`preset: ${own}; program: brash ${program.version}`));
  const two = join(folder, "two.html");
  brash("report", run, other, "-o", two);
  const shown = await browser.open(two);
  assert.ok((await shown.locator("header p").first().innerText()).includes(`preset: brash; program: brash ${program.version}`));
  const row = await shown.locator("#compared tr", { hasText: "made with" }).locator("td").allInnerTexts();
  assert.deepEqual(row.slice(-2), [own, changed].map((preset) => `preset: ${preset}; program: brash ${program.version}`));
  await shown.close();
});

test("a crack that is a circle is drawn as one, with the breaking length about the trapezoid's tip", async () => {
  for (const [i, row] of events.entries()) {
    await ask(page, (report, _, event) => report.choose(event), i);
    assert.equal(await page.locator(".event-body .reach").count(), 1, `crack ${i + 1}`);
    const { cx, cy, r } = await page.locator(".event-body .reach").evaluate((c) => ({ cx: c.cx.baseVal.value, cy: c.cy.baseVal.value, r: c.r.baseVal.value }));
    for (const [shown, name] of [[cx, "tip_x"], [-cy, "tip_y"], [r, "l_break"]]) assert.ok(Math.abs(shown - Number(row[name])) < 1e-5, name);
  }
});

test("a crack that followed the stress is drawn as it went, and its trapezoid, if there is one, is called a fit", async () => {
  const shown = await browser.open(join(other, "report.html"));
  const cracks = await ask(shown, (_, r) => Array.from({ length: r.nEvents }, (__, i) => i));
  const along = JSON.parse(readFileSync(join(other, "summary.json"), "utf8")).breaks_decided.along_stress;
  let n = 0;
  for (const crack of cracks) {
    await ask(shown, (report, _, event) => report.choose(event), crack);
    if ((await shown.locator(".event-body .reach").count()) > 0) continue;
    ++n;
    // Where no trapezoid fits the edge, none is shown, and no zeros in its place.
    const fits = await ask(shown, (_, run, event) => run.column("event.b")[event] > 0, crack);
    assert.match(await shown.locator(".course").innerText(), fits ? /followed the stress.*trapezoid is a fit/s : /followed the stress.*No trapezoid/s);
    assert.equal(await shown.locator(".event-body .trapezoid").count(), fits ? 1 : 0);
    const names = await shown.locator(".numbers dt").allInnerTexts();
    for (const name of ["b", "θ", "fit error"]) assert.equal(names.includes(name), fits, name);
    // Its line is made of edges of the pieces.
    const strokes = (await shown.locator(".event-body .crack").getAttribute("d")).match(/-?[\d.]+ -?[\d.]+/g);
    const outlines = (await shown.locator(".event-body .pieces path").evaluateAll((all) => all.map((p) => p.getAttribute("d")).join(""))).match(/-?[\d.]+ -?[\d.]+/g);
    assert.ok(strokes.length > 4);
    for (const point of strokes) assert.ok(outlines.includes(point), point);
  }
  assert.ok(along > 0);
  assert.equal(n, along);
  await shown.close();
});

test("splits of a drifting sheet, and of floes, are listed and marked as events.csv has them", async () => {
  // Ice so brittle that the first pushes split it.
  brash("run", kCase, "-o", drifting, ...["algorithm.preset=brash", "field.border=free", "ice.fracture_toughness=2000", "time.duration=2", "random.seed=3", "output.statistics_from=1"].flatMap((set) => ["--set", set]));
  const rows = (kind) => readCsv(join(drifting, "events.csv")).filter((row) => row.event === kind);
  const [split, broken] = [rows("split"), rows("broken")];
  assert.ok(split.length > 0 && broken.length > 0);
  const at = await browser.open(join(drifting, "report.html"));
  const cells = (of) => at.locator(`#splits-of-${of} tbody tr`).evaluateAll((all) => all.map((row) => [...row.cells].map((cell) => cell.textContent)));
  const sheets = await cells("sheets");
  assert.deepEqual(sheets.map(([time, , , parts]) => [time, parts]), split.map((row) => [Number(row.time).toFixed(2), row.pieces]));
  sheets.forEach(([, x, y], i) => [[x, "x"], [y, "y"]].forEach(([text, name]) => assert.ok(Math.abs(Number(text.replace("−", "-")) - Number(split[i][name])) < 6e-3, text)));
  assert.deepEqual((await cells("floes")).map(([time]) => time).sort(), broken.map((row) => Number(row.time).toFixed(2)).sort());
  assert.equal(await at.locator(".plan .of-sheet").count(), split.length);
  assert.equal(await at.locator(".plan .of-floe").count(), broken.length);
  await at.locator("#splits-of-sheets button").last().click();
  assert.ok(Math.abs(await ask(at, (report) => report.player.time) - Number(split.at(-1).time)) < 1e-9);
  assert.equal(await at.locator(".plan .of-sheet.chosen").count(), 1);
  assert.equal(await page.locator("#splits").count(), 0, "a run without splits has no list of them");
  await at.close();
});

test("every load can be shown, and the statistics follow", async () => {
  await page.getByLabel("Load", { exact: true }).selectOption("Mz");
  assert.match(await page.locator("#extremes h3").first().innerText(), /Load events of Mz/);
  assert.equal(await page.evaluate(() => window.brashReport.report.loads.chart.plot.axes[1].label), "Mz [kN m]");
  await page.getByLabel("Load", { exact: true }).selectOption("Fx");
});

test("load events are those of `brash stats`, and a click goes to the peak", async () => {
  brash("stats", join(run, "history.csv"), "--column", "Fx", "--from", "1.005", "--events", join(folder, "events.csv"));
  const peaks = readCsv(join(folder, "events.csv")).sort((a, b) => b.peak - a.peak).slice(0, 10);
  const rows = page.locator("#load-events tbody tr");
  assert.equal(await rows.count(), peaks.length);
  assert.deepEqual(await rows.locator("td:nth-child(2)").allTextContents(), peaks.map((row) => (Number(row.peak) / 1e3).toFixed(1)));
  await rows.first().locator("button").click();
  assert.equal(await ask(page, (report) => report.player.time), Number(peaks[0].peak_time));
});

test("loads, plan and crack are saved as they are", async () => {
  const loads = await saved(page, page.getByRole("button", { name: "all CSV" }));
  assert.equal(loads.name, "loads.csv");
  const [head, first] = loads.bytes.toString().split("\n");
  const history = readCsv(join(run, "history.csv"));
  assert.equal(loads.bytes.toString().trim().split("\n").length, history.length + 1);
  assert.equal(Number(first.split(",")[head.split(",").indexOf("Fx [N]")]), Math.fround(Number(history[0].Fx)));
  const shown = (await saved(page, page.locator(".loads .chart").getByRole("button", { name: "CSV", exact: true }))).bytes.toString().split("\n");
  assert.equal(shown[0], "time [s],Fx total [kN],Fx crushing [kN],Fx floes [kN],Fx friction [kN]");
  assert.ok(Math.abs(Number(shown[1].split(",")[1]) - Number(history[0].Fx) / 1e3) < 1e-3);
  const drawing = (await saved(page, page.locator(".plan-view").getByRole("button", { name: "SVG" }))).bytes.toString();
  assert.equal((drawing.match(/<circle/g) ?? []).length >= events.length, true);
  assert.ok(!/var\(|color\(srgb/.test(drawing), "a drawing's colours are its own");
  assert.ok(/<text[^>]*paint-order: ?stroke/.test(drawing), "numbers are readable over floes");
  const lines = (await saved(page, page.locator(".loads .chart").getByRole("button", { name: "SVG" }))).bytes.toString();
  assert.ok(lines.includes("Fx [kN]") && lines.includes("crushing"));
  const picture = await saved(page, page.locator(".plan-view").getByRole("button", { name: "PNG" }));
  assert.ok(new Set((await pixelsOf(page, picture.bytes, 997)).map(String)).size > 5, "the picture is empty");
});

test("a saved chart shows the mean with its interval, the reference, cracks, points and columns where the page has them", async () => {
  const longer = join(folder, "longer");
  brash("run", kCase, "-o", longer, ...["time.duration=8", "output.statistics_from=1", "output.frames_per_second=0"].flatMap((set) => ["--set", set]));
  const at = await browser.open(join(longer, "report.html"));
  const chartOf = (name) => at.locator("figure.chart", { has: at.getByRole("group", { name, exact: true }) });
  const save = async (name, format) => (await saved(at, chartOf(name).getByRole("button", { name: format, exact: true }))).bytes;
  const drawing = (await save("Load history", "SVG")).toString();
  const loads = await readChart(at, drawing);
  const { mean, mean_95 } = JSON.parse(readFileSync(join(longer, "summary.json"), "utf8")).horizontal;
  // Places are written to a hundredth of a pixel, of which the highest tick is at most 340 from the lowest.
  const kN = (place) => numberAt(loads.y, Number(place));
  const isNear = (shown, newtons) => assert.ok(Math.abs(shown - newtons / 1e3) < (0.02 / 340) * 2 * loads.y.at(-1)[1], `${shown} kN for ${newtons} N`);
  const [, low, , high] = /^M\S+ (\S+)H(\S+)V(\S+)H/.exec(loads.paths["95 % interval of the mean"][0]);
  isNear(kN(low), mean_95[0]);
  isNear(kN(high), mean_95[1]);
  isNear(kN(/^M\S+ (\S+)H/.exec(loads.paths.mean[0])[1]), mean);
  isNear(kN(/^M\S+ (\S+)H/.exec(loads.paths["reference mean"][0])[1]), 111.8e3);
  const times = readCsv(join(longer, "events.csv")).filter((row) => row.event === "break").map((row) => Number(row.time));
  assert.equal(loads.paths.cracks.length, times.length);
  loads.paths.cracks.forEach((path, i) => assert.ok(Math.abs(numberAt(loads.x, Number(/^M(\S+)/.exec(path)[1])) - times[i]) < 0.01));
  for (const name of ["total", "mean", "95 % interval of the mean", "reference mean", "cracks", "Load history."]) assert.ok(loads.words.includes(name), name);
  assert.ok(!loads.words.includes("friction"), "the name of a line that is hidden");
  // The picture is the drawing, twice as fine.
  const picture = await pixelsOf(at, await save("Load history", "PNG"), 7);
  const [red, green, blue] = [0, 1, 2].map((part) => picture.filter((pixel) => pixel[part] > 250).length / picture.length);
  assert.ok(red > 0.5 && green > 0.5 && blue > 0.5, "a picture on white");
  assert.ok(picture.some(([r, g, b]) => r > 150 && g < 60 && b < 60), "cracks are red");

  const shares = await readChart(at, (await save("Exceedance of the load", "SVG")).toString());
  const nPeaks = await at.evaluate(() => window.brashReport.run.data.loads.Fx.events.length);
  assert.equal(shares.paths["of the peaks"][1].match(/Z/g).length, nPeaks);
  const lengths = await readChart(at, (await save("Histogram: breaking length", "SVG")).toString());
  const columns = lengths.paths.count[0].match(/V[\d.]+h/g).map((top) => Math.round(numberAt(lengths.y, Number(top.slice(1, -1)))));
  assert.equal(columns.reduce((sum, n) => sum + n, 0), times.length);
  assert.ok(lengths.words.some((text) => /Quantiles 5, 25, 50, 75, 95 %/.test(text)));
  await at.close();
});

test("the film shows the run from start to end", async () => {
  await page.getByLabel("Speed of the replay").selectOption("4");
  const film = await saved(page, page.getByRole("button", { name: "film" }));
  assert.equal(film.name, "cone.webm");
  const player = await browser.context.newPage();
  const [width, duration, n] = await player.evaluate(async (data) => {
    const video = document.createElement("video");
    video.muted = true;
    video.src = `data:video/webm;base64,${data}`;
    await new Promise((done, fail) => Object.assign(video, { onloadeddata: done, onerror: () => fail(new Error(video.error.message)) }));
    const seen = new Set();
    for (let time = 0.05; time < video.duration; time += 0.1) {
      video.currentTime = time;
      await new Promise((done) => (video.onseeked = done));
      const canvas = new OffscreenCanvas(40, 24);
      canvas.getContext("2d").drawImage(video, 0, 0, 40, 24);
      seen.add(canvas.getContext("2d").getImageData(0, 0, 40, 24).data.join());
    }
    return [video.videoWidth, video.duration, seen.size];
  }, film.bytes.toString("base64"));
  assert.ok(width > 300);
  // 3 s at four times their speed, in pictures of a thirtieth of a second.
  assert.ok(Math.abs(duration - 0.75) < 0.07, `${duration} s`);
  assert.ok(n >= 5, `${n} different pictures`);
  await player.close();
  await page.getByLabel("Speed of the replay").selectOption("1");
});

test("a load that acts downwards has its peaks, high quantiles and extremes at its lower end, with their sign", async () => {
  const upward = join(folder, "upward");
  const sets = ["structure.breaking=upward", "time.duration=4", "output.statistics_from=1", "output.frames_per_second=2"];
  brash("run", kCase, "-o", upward, ...sets.flatMap((set) => ["--set", set]));
  const file = join(upward, "history.csv");
  const stats = JSON.parse(brash("stats", file, "--column", "Fz", "--from", "1.005", "--negate", "--json", "--events", join(folder, "down.csv")));
  assert.ok(stats.mean > 0, "Fz acts downwards");
  const kN = (newtons) => (newtons / 1e3).toFixed(1).replace("-", "−");
  const at = await browser.open(join(upward, "report.html"));
  await at.getByLabel("Load", { exact: true }).selectOption("Fz");
  const peaks = readCsv(join(folder, "down.csv")).map((row) => Number(row.peak)).sort((a, b) => b - a).slice(0, 10);
  assert.ok(peaks.length > 2);
  assert.deepEqual(await at.locator("#load-events tbody td:nth-child(2)").allTextContents(), peaks.map((peak) => kN(-peak)));
  assert.match(await at.locator("#extremes").innerText(), /the load falls through its mean[^]*undershot once in/);

  const column = (await at.locator("#moments thead tr > *").allTextContents()).indexOf("Fz [kN]");
  const cell = (name) => at.locator("#moments tbody tr", { has: at.getByText(name, { exact: true }) }).locator("td").nth(column).innerText();
  assert.equal(await cell("99 % quantile"), kN(-stats.quantile_99));
  assert.equal(await cell("end of the larger loads"), "lower");
  assert.equal(await cell("smallest"), kN(-stats.maximum));
  const closed = await at.locator("#closed-forms tbody tr", { hasText: "99 % quantile" }).locator("td").allTextContents();
  assert.deepEqual(closed.slice(3), [kN(-stats.quantile_99), "vertical: above it 99 % of the time"]);

  const { events, spectrum } = await at.evaluate(() => window.brashReport.run.data.loads.Fz);
  assert.ok(events.every(({ peak }) => peak < -stats.mean), "below the mean");
  assert.match(await at.getByText(/^Exceedance of/).innerText(), new RegExp(`; peaks of ${events.length} load events`));
  brash("stats", file, "--column", "Fz", "--from", "1.005", "--spectrum", join(folder, "spectrum.csv"));
  assert.deepEqual(spectrum.density.map(Math.fround), readCsv(join(folder, "spectrum.csv")).map((row) => Math.fround(Number(row.density))));
  const lowest = readCsv(file).reduce((least, row) => (Number(row.Fz) < Number(least.Fz) ? row : least));
  assert.equal(await ask(at, (report) => (report.loads.chooseLargest(), report.player.time)), Number(lowest.time));
  await at.close();
});

test("a measured history lies over the loads, with its statistics", async () => {
  const file = join(folder, "measured.csv");
  const rows = Array.from({ length: 120 }, (_, i) => `${(0.025 * i).toFixed(3)},${(50 + 40 * Math.sin(0.2 * i)).toFixed(3)}`);
  writeFileSync(file, `time [s],force [kN]\n${rows.join("\n")}\n`);
  brash("report", run, "--measured", file);
  const shown = await browser.open(join(run, "report.html"));
  const plot = await shown.evaluate(() => {
    const { data, series } = window.brashReport.report.loads.chart.plot;
    const i = series.findIndex(({ label }) => label === "measured.csv: force");
    return { values: data[i].filter((n) => n !== null && n !== undefined), times: data[0].filter((_, k) => data[i][k] !== null && data[i][k] !== undefined) };
  });
  assert.equal(plot.values.length, rows.length);
  for (const [k, row] of rows.entries()) {
    assert.ok(Math.abs(plot.times[k] - Number(row.split(",")[0])) < 1e-9);
    assert.ok(Math.abs(plot.values[k] - Number(row.split(",")[1])) < 1e-4);  // single precision
  }
  const mean = rows.reduce((sum, row) => sum + Number(row.split(",")[1]), 0) / rows.length;
  const names = await shown.locator("#moments thead tr > *").allTextContents();
  const cells = await shown.locator("#moments tbody tr").first().locator("td").allTextContents();
  assert.equal(cells[names.indexOf("Fx measured [kN]")], mean.toFixed(1));
  await shown.close();
});

test("a field of floes is not taken for level ice", async () => {
  const field = join(folder, "field");
  brash("run", join(process.env.BRASH_SOURCE, "experiments/fields/cone.toml"), "-o", field,
    ...["time.duration=1", "output.statistics_from=0.5", "field.length=60", "field.width=60"].flatMap((set) => ["--set", set]));
  const at = await browser.open(join(field, "report.html"));
  assert.match(await at.locator("#channel").innerText(), /The field from above/);
  assert.match(await at.locator("#closed-forms").innerText(), /They are for level ice, not for a field of floes/);
  assert.doesNotMatch(await page.locator("#closed-forms").innerText(), /field of floes/);
  assert.match(await at.locator("#ledger").innerText(), /of the ice[^]*Where the ice has gone/);
  await at.close();
});

test("two runs move under one slider", async () => {
  const both = join(folder, "both.html");
  brash("report", run, other, "-o", both);
  const shown = await browser.open(both);
  assert.equal(await shown.locator(".stage canvas").count(), 2);
  assert.equal(await shown.locator("input[type=range]").count(), 1);
  await ask(shown, (report) => report.player.seek(1.5));
  const alone = await browser.open(join(other, "report.html"));
  await ask(alone, (report) => report.player.seek(1.5));
  const place = (scene) => Array.from(scene.floes.place.array);
  assert.deepEqual(await ask(shown, `({ replay }) => (${place})(replay.scenes[1])`), await ask(alone, `({ replay }) => (${place})(replay.scene)`));
  assert.match(await shown.locator("#differences").innerText(), /algorithm\.preset\s+paper\s+brash/);
  const series = await shown.evaluate(() => window.brashReport.report.loads.chart.plot.series.map(({ label }) => label));
  assert.equal(series.at(-1), "cone (second)");
  assert.equal(await shown.evaluate(() => document.documentElement.scrollWidth <= innerWidth), true);
  await alone.close();
  await shown.close();
});

test("the replay is drawn where nothing waits for it, also under a header that wraps", async () => {
  const water = async (width) => {
    const picture = plainScreenshot(join(run, "report.html"), join(folder, "plain.png"), width, 900);
    const colours = await pixelsOf(page, picture);
    return colours.filter(([r, , b]) => b > 1.5 * r && b > 60).length / colours.length;
  };
  for (const width of [560, 1000, 1366]) {
    // Chromium may take its picture before a busy machine has drawn the first frame.
    let found = 0;
    for (let attempt = 0; attempt < 5 && found <= 0.03; ++attempt) found = await water(width);
    assert.ok(found > 0.03, `${width} px wide: ${found}`);
  }
});

test("nothing is complained about, and nothing is asked of a network", () => {
  assert.deepEqual(browser.complaints, []);
  assert.deepEqual(browser.requests.filter((url) => !/^(file|data|blob):/.test(url)), []);
});
