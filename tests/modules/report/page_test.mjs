// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a run, seen as its reader sees it: pixels and numbers.
import assert from "node:assert/strict";
import { copyFileSync, readFileSync, rmSync, statSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { brash, browse, pixelsOf, readCsv, scratch, until } from "./browser.mjs";

const kHostile = "</script><script>window.pwned = 1</script><img src=x onerror='window.pwned = 2'>";
const folder = scratch();
const run = join(folder, "run");
let browser, page, summary, events, history;

before(async () => {
  // A case whose name and texts would run if anything took them for HTML.
  const file = join(folder, "<script>window.pwned = 3<.toml");
  copyFileSync(join(process.env.BRASH_SOURCE, "experiments/validation/cone.toml"), file);
  brash("run", file, "-o", run, "--set", "time.duration=4", "--set", "output.statistics_from=1", "--set", `reference.source="${kHostile}"`);
  summary = JSON.parse(readFileSync(join(run, "summary.json"), "utf8"));
  events = readCsv(join(run, "events.csv")).filter((row) => row.event === "break");
  history = readCsv(join(run, "history.csv"));
  browser = await browse();
  page = await browser.open(join(run, "report.html"));
});

after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

/** Calls `look(report, run, argument)` in the page. */
const ask = (look, argument) =>
  page.evaluate(`(${look})(window.brashReport.report, window.brashReport.run, ${JSON.stringify(argument ?? null)})`);

/** Colours of the replay on a coarse grid, as the reader sees them. */
const replayColours = async (every = 31) => pixelsOf(page, await page.locator(".stage canvas").screenshot(), every);

/** Colours of the style, as [r, g, b]. */
const styleColours = (names) => page.evaluate((all) => all.map((name) => {
  const context = new OffscreenCanvas(1, 1).getContext("2d");
  context.fillStyle = getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  context.fillRect(0, 0, 1, 1);
  return [...context.getImageData(0, 0, 1, 1).data.slice(0, 3)];
}), names);

const isNear = (a, b, tolerance) => a.every((value, i) => Math.abs(value - b[i]) <= tolerance);

test("the arrays in the page are those of the run's files", async () => {
  const columns = await ask((_, r) => ({
    b: [...r.column("event.b")], x: [...r.column("event.x")], time: [...r.column("event.time")], Fx: [...r.column("load.Fx")],
  }));
  for (const name of ["b", "x", "time"]) assert.deepEqual(columns[name], events.map((row) => Number(row[name])));
  assert.deepEqual(columns.Fx, history.map((row) => Math.fround(Number(row.Fx))));
});

test("the replay shows structure, ice and water", async () => {
  await page.getByLabel("see through").uncheck();
  await page.waitForTimeout(100);
  const colours = await replayColours();
  const share = (is) => colours.filter(([r, g, b]) => is(r, g, b)).length / colours.length;
  // The camera looks at all three; each fills far more than a twentieth of the picture.
  assert.ok(share((r, g, b) => r > 1.4 * b && r > g) > 0.05, "no structure");
  assert.ok(share((r, g, b) => r > 190 && g > 200 && b > 205) > 0.05, "no ice");
  assert.ok(share((r, g, b) => b > 1.15 * r && b < 220) > 0.02, "no water");
});

test("as many floes are drawn as the events made until then", async () => {
  const n_initial = summary.n_floes_born - events.reduce((sum, row) => sum + Number(row.pieces), 0);
  for (const time of [0, 1.5, 2.5, 4]) {
    const shown = await ask((report, _, t) => (report.player.seek(t), report.replay.scene.floes.nVisible), time);
    const born = events.filter((row) => Number(row.time) <= time + 1e-9).reduce((sum, row) => sum + Number(row.pieces), n_initial);
    const deaths = readCsv(join(run, "events.csv")).filter((row) => row.event === "deleted" && Number(row.time) <= time);
    assert.equal(shown, born - deaths.length, `at ${time} s`);
  }
});

test("floes at rest lie in the waterline, and where they broke off", async () => {
  const { z, gap } = await ask((_, r) => {
    const frame = r.column("track.frame"), count = r.column("track.count");
    let start = 0, gap = 0, z = [];
    for (let i = 0; i < r.nFloes; start += count[i++]) {
      if (frame[start] !== 0) continue;
      z.push(r.column("track.z")[start]);
      gap = Math.max(gap, Math.hypot(r.column("track.x")[start] - r.column("floe.birth_x")[i], r.column("track.y")[start] - r.column("floe.birth_y")[i]));
    }
    return { z, gap };
  });
  assert.ok(z.length > 0);
  // h (1/2 - rho_i / rho_w) with 0.33 m, 900 and 1025 kg/m3; places are rounded to 1 mm.
  for (const height of z) assert.ok(Math.abs(height - 0.33 * (0.5 - 900 / 1025)) <= 1e-3, `${height}`);
  assert.ok(gap <= 1.5e-3);
});

test("the sheet of the replay is that of the ledger", async () => {
  const areas = await ask((_, r) => {
    const area = (rings) => rings.reduce((sum, ring) => sum + ring.reduce((s, [x, y], i) => {
      const [u, v] = ring[(i + 1) % ring.length];
      return s + 0.5 * (x * v - u * y);
    }, 0), 0);
    return r.sheets.map(area);
  });
  // Vertices are rounded to 1 mm; the boundary is about 200 m long.
  assert.ok(Math.abs(areas.at(-1) - Number(summary.ledger.sheet)) < 0.2, `${areas.at(-1)}`);
  for (let i = 1; i < areas.length; ++i) assert.ok(areas[i] <= areas[i - 1] + 0.05);
});

test("the means shown are those of summary.json", async () => {
  const cells = await page.locator("#moments tbody tr").first().locator("td").allTextContents();
  const names = await page.locator("#moments thead tr > *").allTextContents();
  const shown = (name) => cells[names.indexOf(name)];
  assert.deepEqual([shown("Fx [kN]"), shown("Fz [kN]")], [summary.horizontal.mean, summary.vertical.mean].map((n) => (n / 1e3).toFixed(1).replace("-", "−")));
  const steady = history.filter((row) => Number(row.time) > summary.statistics_from + 1e-9);
  const mean = steady.reduce((sum, row) => sum + Number(row.My), 0) / steady.length / 1e3;
  assert.equal(shown("My [kN m]"), mean.toFixed(1).replace("-", "−"));
});

test("the load history's cursor stands at the replay's time and stays in view", async () => {
  const cursor = (time) => ask(async (report, _, t) => {
    report.player.seek(t);
    await new Promise((done) => requestAnimationFrame(() => setTimeout(done, 30)));
    const plot = report.loads.chart.plot;
    const line = document.querySelector(".loads .now").getBoundingClientRect();
    const over = plot.over.getBoundingClientRect();
    return { off: 0.5 * (line.left + line.right) - over.left - plot.valToPos(t, "x"), share: line.height / over.height, min: plot.scales.x.min, max: plot.scales.x.max };
  }, time);
  const { off, share } = await cursor(2);
  assert.ok(Math.abs(off) < 0.6 && share > 0.99, `${off} px, ${share}`);
  await ask((report) => report.loads.chart.plot.setScale("x", { min: 0.5, max: 1 }));
  const moved = await cursor(3);
  assert.ok(moved.min <= 3 && moved.max >= 3 && Math.abs(moved.max - moved.min - 0.5) < 1e-6);
  await ask((report) => report.loads.showAll());
});

test("every sample can be zoomed to", async () => {
  await ask(async (report) => {
    report.player.seek(2);
    for (let i = 0; i < 20; ++i) {
      report.loads.zoom(0.5);
      await new Promise((done) => setTimeout(done));
    }
  });
  const { span, n } = await ask(({ loads }) => {
    const plot = loads.chart.plot;
    return { span: plot.scales.x.max - plot.scales.x.min, n: plot.data[0].length };
  });
  assert.equal(n, history.length);
  assert.ok(span <= 0.0401);
  await ask((report) => report.loads.showAll());
});

test("a click on a load peak shows the numbers of the crack behind it", async () => {
  const peak = history.reduce((best, row) => (Number(row.Fx) > Number(best.Fx) ? row : best));
  const at = await ask(({ loads }, _, [t, f]) => {
    const plot = loads.chart.plot;
    plot.over.scrollIntoView({ block: "center", behavior: "instant" });
    const box = plot.over.getBoundingClientRect();
    return [box.left + plot.valToPos(t, "x"), box.top + plot.valToPos(f, "y")];
  }, [Number(peak.time), Number(peak.Fx) / 1e3]);
  await page.mouse.click(at[0], at[1] + 2);
  const card = await page.locator(".event-card").innerText();
  const gaps = events.map((row) => Math.abs(Number(row.time) - Number(peak.time)));
  const nearest = events.filter((_, i) => gaps[i] <= Math.min(...gaps) + 1e-6);
  const event = nearest.reduce((best, row) => (row.p * row.c > best.p * best.c ? row : best));
  assert.match(card, new RegExp(`Crack ${events.indexOf(event) + 1} of ${events.length}`));
  for (const name of ["b", "c", "mu1", "l_break"]) {
    const shown = await page.locator(".numbers div", { has: page.locator(`dt:text-is("${{ mu1: "μ₁" }[name] ?? name}")`) }).locator("dd").innerText();
    assert.equal(Number(shown.replace(" m", "").replace("−", "-")), Number(Number(event[name]).toPrecision(4)), name);
  }
  assert.ok(card.includes((Number(peak.Fx) / 1e3).toFixed(1)), "the peak's load is missing");
  assert.equal(await ask((report) => report.player.time), Number(peak.time));
  assert.equal(await page.locator(".breaks .chosen").count(), 1);
});

test("the fitted trapezoid has the depth, tip and angle of the event", async () => {
  const data = await page.locator(".event-body .trapezoid").getAttribute("d");
  const points = data.match(/-?[\d.]+ -?[\d.]+/g).map((pair) => pair.split(" ").map(Number));
  const index = Number((await page.locator(".event-card strong").innerText()).match(/\d+/)[0]) - 1;
  const distance = ([a, b], [c, d]) => Math.hypot(a - c, b - d);
  // The path is written to the millimetre.
  assert.ok(Math.abs(distance(points[0], points[3]) - events[index].c) < 2e-3);
  assert.ok(Math.abs(distance(points[1], points[2]) - events[index].c - 2 * events[index].b * Math.tan(events[index].theta / 2)) < 4e-3);
});

test("keys play, step and change the view", async () => {
  await page.locator("body").click({ position: { x: 5, y: 5 } });
  await ask((report) => report.player.seek(1));
  await page.keyboard.press("ArrowRight");
  const next = await ask((_, r) => r.column("frame.time").find((time) => time > 1 + 1e-9));
  assert.equal(await ask((report) => report.player.time), next);
  // So slowly that the run does not end before a busy machine has answered.
  await ask((report) => report.player.setSpeed(0.05));
  await page.keyboard.press("Space");
  assert.equal(await ask((report) => report.player.playing), true);
  await until(page, () => window.brashReport.report.player.time > 1.08);
  await page.keyboard.press("Space");
  await ask((report) => report.player.setSpeed(1));
  assert.equal(await ask((report) => report.player.playing), false);
  const place = () => ask((report) => report.replay.scene.camera.position.toArray());
  const before = await place();
  await page.keyboard.press("3");
  assert.notDeepEqual(await place(), before);
  await page.keyboard.press("1");
});

test("floes can be coloured by contact force and age", async () => {
  for (const choice of ["force", "age", "cause"]) {
    await page.locator("#colouring").selectOption(choice);
    assert.equal(await ask((report) => report.replay.scene.floes.colouring), choice);
    assert.ok((await page.locator(".legend span").count()) >= 2);
  }
});

test("the legends' colours are those of the pictures, in light and dark", async () => {
  // Without the structure and its shadow, when the floes of the initial crack are no longer tinted as newborn.
  await ask((report) => (report.player.seek(0.45), report.replay.look("Above"), (report.replay.scene.hull.visible = false)));
  for (const theme of ["light", "dark"]) {
    await page.getByLabel("Colours").selectOption(theme);
    await ask((report) => report.replay.scene.drawNow());
    const colours = await replayColours(7);
    const [ice, initial, young, old] = await styleColours(["--scene-ice", "--scene-initial", "--plan-young", "--plan-old"]);
    const share = (colour) => colours.filter((pixel) => isNear(pixel, colour, 3)).length / colours.length;
    // Level ice in the sun; an eighth of the picture is far less than it fills. The floes of the initial crack are small.
    assert.ok(share(ice) > 0.125, `${theme}: level ice is not drawn in its colour`);
    assert.ok(share(initial) > 5e-4, `${theme}: the initial crack is not drawn in its colour`);
    // In the plan the first floe has the legend's first colour, and the last one goes towards its second.
    const [first, last] = await page.locator(".plan .floes path").evaluateAll((all) => [all[0], all.at(-1)].map((path) => {
      const context = new OffscreenCanvas(1, 1).getContext("2d");
      context.fillStyle = getComputedStyle(path).fill;
      context.fillRect(0, 0, 1, 1);
      return [...context.getImageData(0, 0, 1, 1).data.slice(0, 3)];
    }));
    const darkness = (colour) => -colour.reduce((sum, n) => sum + n, 0);
    assert.ok(isNear(first, young, 1), `${theme}: ${first}`);
    assert.ok(darkness(young) < darkness(last) && darkness(last) <= darkness(old), `${theme}: later floes are not darker`);
  }
  await page.getByLabel("Colours").selectOption("light");
  await ask((report) => ((report.replay.scene.hull.visible = true), report.replay.look("Bow")));
});

test("the scale is as long as it says", async () => {
  await ask((report) => (report.replay.look("Above"), report.replay.scene.drawNow()));
  const [width, text] = await page.locator(".scale").evaluate((bar) => [bar.getBoundingClientRect().width, bar.textContent]);
  // Two points at the structure, that many metres apart, on the screen.
  const apart = await ask(({ replay }, _, length) => {
    const { camera, controls, canvas } = replay.scene;
    const right = controls.target.clone();
    right.y += length;
    const [a, b] = [controls.target.clone().project(camera), right.project(camera)];
    return 0.5 * Math.hypot((a.x - b.x) * canvas.clientWidth, (a.y - b.y) * canvas.clientHeight);
  }, Number(text.split(" ")[0]));
  assert.ok(Math.abs(width - apart) < 0.02 * apart, `${width} and ${apart}`);
  await ask((report) => report.replay.look("Bow"));
});

test("light and dark differ in page, replay and charts", async () => {
  const sky = async () => (await replayColours())[40];
  const look = async () => [await page.evaluate(() => getComputedStyle(document.body).backgroundColor), ...(await sky())];
  await ask((report) => (report.replay.scene.look("Side"), report.replay.scene.drawNow()));
  const light = await look();
  await page.getByLabel("Colours").selectOption("dark");
  await ask((report) => report.replay.scene.drawNow());
  const dark = await look();
  assert.notEqual(light[0], dark[0]);
  assert.ok(dark[1] + dark[2] + dark[3] < light[1] + light[2] + light[3] - 200);
  await page.getByLabel("Colours").selectOption("light");
});

test("a run that is over before its statistics begin shows none", async () => {
  const early = join(folder, "early");
  brash("run", join(process.env.BRASH_SOURCE, "experiments/validation/demo.toml"), "-o", early, "--set", "time.duration=1");
  const shown = await browser.open(join(early, "report.html"));
  assert.equal(await shown.locator("#moments").count(), 0);
  assert.equal(await shown.locator(".figure.none").count(), 3);
  assert.match(await shown.locator(".figures").innerText(), /statistics begin at \d+\.\d+ s, the run ends at 1\.00 s/);
  assert.match(await shown.locator("#statistics").innerText(), /over before its statistics begin/);
  await shown.close();
});

test("a run without frames offers no replay, but its loads and cracks", async () => {
  const still = join(folder, "still");
  brash("run", join(process.env.BRASH_SOURCE, "experiments/validation/cone.toml"), "-o", still, "--set", "time.duration=3", "--set", "output.frames_per_second=0");
  const shown = await browser.open(join(still, "report.html"));
  assert.equal(await shown.locator("canvas[aria-label^=Replay], input[type=range], .keys").count(), 0);
  assert.match(await shown.locator("#report").innerText(), /No frames recorded after the start \(output\.frames_per_second = 0\)/);
  const cracks = readCsv(join(still, "events.csv")).filter((row) => row.event === "break").length;
  assert.ok(cracks > 0);
  assert.equal(await shown.locator(".breaks circle").count(), cracks);
  assert.match(await shown.locator(".event-card").innerText(), new RegExp(`of ${cracks}`));
  // 1.202 m/s for 3 s from 7 m before the edge.
  const structure = await shown.locator('[aria-label^="Plan of the channel"] .structure').first().evaluate((path) => {
    const { x, width } = path.getBBox();
    return { x, width };
  });
  assert.ok(Math.abs(structure.x + 0.5 * structure.width - (3 * 1.202 - 7)) < 2e-3);  // places are rounded to 1 mm
  assert.ok(Math.abs(structure.width - 13.6) < 4e-3);
  await shown.close();
});

test("the works to cite are given as BibTeX, with the versions of the manifest", async () => {
  const text = await page.locator(".bibtex pre").evaluate((e) => e.textContent);
  const manifest = JSON.parse(readFileSync(join(run, "manifest.json"), "utf8"));
  const keys = [...text.matchAll(/^@\w+\{(\w+),$/gm)].map((found) => found[1]);
  assert.deepEqual(keys.slice(0, 4), ["brash", "bullet", "cgal", "ndem_ann_2023"]);
  assert.equal(new Set(keys).size, keys.length);
  assert.ok(text.includes("doi = {10.3390/jmse11030469}"));
  assert.ok(text.includes(`version = {${manifest.program.version}}`));
  assert.ok(text.includes(`version = {${manifest.built_with.CGAL}}`));
  assert.equal((text.match(/\{/g) ?? []).length, (text.match(/\}/g) ?? []).length);
  const link = await page.locator(".bibtex a").evaluate((a) => [a.download, decodeURIComponent(a.href.split(",").slice(1).join(","))]);
  assert.deepEqual(link, ["brash.bib", text]);
});

test("nothing hangs over the edge of a narrow page", async () => {
  await page.setViewportSize({ width: 400, height: 800 });
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 400);
  await page.setViewportSize({ width: 1366, height: 768 });
});

test("texts of the case are shown and not run", async () => {
  assert.equal(await page.evaluate(() => window.pwned), undefined);
  assert.equal(await page.locator("h1").innerText(), "<script>window.pwned = 3<");
  assert.ok((await page.locator("#inputs").innerText()).includes(kHostile));
});

test("nothing is complained about, nothing is asked of a network, and the file is small", () => {
  assert.deepEqual(browser.complaints, []);
  assert.deepEqual(browser.requests.filter((url) => !/^(file|data|blob):/.test(url)), []);
  assert.ok(statSync(join(run, "report.html")).size < 2e6);
});
