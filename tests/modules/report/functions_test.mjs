// SPDX-License-Identifier: GPL-3.0-or-later
// Functions of the pages that need no browser: texts, tables and counts.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { join } from "node:path";
import { test } from "node:test";

const { BRASH_PACKAGES: packages, BRASH_SOURCE: source } = process.env;
const { build } = createRequire(join(packages, "package.json"))("esbuild");

/** What a source of the pages exports. */
async function exported(path) {
  const { outputFiles } = await build({
    entryPoints: [join(source, path)], nodePaths: [join(packages, "node_modules")], bundle: true, write: false, format: "esm",
  });
  return import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].contents).toString("base64")}`);
}

// A chart's library asks at its start how fine the screen is.
Object.assign(globalThis, { matchMedia: () => ({ addEventListener: () => {} }), devicePixelRatio: 1 });
const { csv } = await exported("modules/report/viewer/src/save.ts");
const { duration } = await exported("modules/report/viewer/src/extremes.ts");
const { piecesOfEvents } = await exported("modules/report/viewer/src/data.ts");
const { decimalsOf, meanText, resultOf, titleOf } = await exported("modules/report/viewer/src/campaign_names.ts");
const { countsOf } = await exported("modules/report/viewer/src/statistics.ts");
const { chooseUnits, degrees, energyText, energyUnit, loadText, loadUnit, ratio, seconds } = await exported("modules/report/viewer/src/format.ts");
const { shownUnit } = await exported("modules/report/viewer/src/choice.ts");
const { valueIn, withValue } = await exported("modules/simulator/page/src/case_text.ts");

test("texts with commas, quotes and line ends keep their cell of a CSV file", () => {
  const names = ["a, b", "3,5", 'so "called"', "two\nlines"];
  assert.equal(csv([["setting", names], ["mean [kN]", [1, null, 3, 4]]]),
    'setting,mean [kN]\n"a, b",1\n"3,5",\n"so ""called""",3\n"two\nlines",4\n');
});

test("pieces are those of their event, also where ice was severed between two", () => {
  const births = [0, 0, 1, 1, 1.5, 2, 2, 2];  // two of the start, one severed at 1.5 s
  assert.deepEqual(piecesOfEvents([1, 2, 2], [2, 1, 2], births, []), [[2, 3], [5], [6, 7]]);
});

test("pieces are those of their event, also where ice was severed or a sheet split in its step", () => {
  const births = [1, 1, 1, 2, 2, 2];
  assert.deepEqual(piecesOfEvents([1, 2, 2], [2, 1, 1], births, []), [[1, 2], [4], [5]]);  // the first of a step is severed
  assert.deepEqual(piecesOfEvents([1, 2, 2], [2, 1, 1], births, [2]), [[1, 2], [3], [4]]);  // the last of 2 s is of a split
});

test("the units of a page fit its largest load and its largest energy", () => {
  assert.equal(`${loadText(34.25)} ${loadUnit()}, ${energyText(34.25)} ${energyUnit()}`, "0.0 kN, 0.0 kJ");  // before any are known
  chooseUnits(340, 2.5e4);
  assert.equal(`${loadText(-34.25)} ${loadUnit()}, ${energyText(2510)} ${energyUnit()}`, "−34.3 N, 2.5 kJ");
  assert.equal(shownUnit("Fx") + ", " + shownUnit("My"), "kN, kN m");  // of a bundle of its own
  chooseUnits(0.5, 12);
  assert.equal(`${loadText(0.0123)} ${loadUnit()}, ${energyText(null)} ${energyUnit()}`, "12.3 mN, – J");
  chooseUnits(0, NaN);
  assert.equal(`${loadText(1e4)} ${loadUnit()}, ${energyUnit()}`, "10.0 kN, kJ");
});

test("means of one result have one number of decimals", () => {
  const column = (mean, half) => ({ mean, mean_95: half === null ? null : [mean - half, mean + half], n: 3 });
  const columns = [column(22.5, 0.9999), column(23.5, 1.6), column(24.25, 12), column(21.04, null), column(20, 0)];
  const texts = (of) => of.map((each) => meanText(each, 1, decimalsOf(of, 1)));
  assert.deepEqual(texts(columns), ["22.5 (21.5 to 23.5)", "23.5 (21.9 to 25.1)", "24.3 (12.3 to 36.3)", "21.0 (one run)", "20.0 (20.0 to 20.0)"]);
  assert.deepEqual(texts([column(21.043, null)]), ["21.04 (one run)"]);
  assert.deepEqual(texts([column(-0.001, 0.5)]), ["0.00 (−0.50 to 0.50)"]);
});

test("the rounding of zero is zero", () => {
  assert.deepEqual([-1.209e-15, 0.027, -0.5].map(ratio), ["0", "0.02700", "−0.5000"]);
  assert.equal(degrees(-1e-9), "0.0");
  assert.equal(seconds(-1e-9), "0.00");
});

test("results of a campaign have their units", () => {
  const titles = {
    "mean_by_region.leg_1.total.Fx": "mean by region leg 1 total Fx [kN]", "initial_floes.size_quantiles.50": "initial floes size quantiles 50 [m]",
    "contact_iterations.mean_last_change": "contact iterations mean last change [m/s]", "horizontal.mean_95.lower": "lower end of the interval of the mean horizontal load [kN]",
    "piece_area_quantiles.50": "piece area quantiles 50 [m²]", "n_floes_broken": "n floes broken",
  };
  assert.deepEqual(Object.keys(titles).map((column) => titleOf(resultOf(column))), Object.values(titles));
});

test("a duration keeps the zeros of whole numbers", () => {
  for (const [time, text] of [[600, "600 s"], [10, "10 s"], [1.5, "1.5 s"], [3600, "1 h"], [36000, "10 h"], [5400, "1.5 h"], [360000, "100 h"]])
    assert.equal(duration(time), text);
});

test("a histogram counts more values than a call takes arguments", () => {
  const { counts, width, largest } = countsOf(Float64Array.from({ length: 300_000 }, (_, i) => (i % 240) + 0.5));
  assert.deepEqual([counts.length, largest, width], [24, 239.5, 239.5 / 24]);
  assert.equal(counts.reduce((sum, n) => sum + n, 0), 300_000);
});

test("an array over several lines is one value of a case file", () => {
  const toml = [
    "[structure]", "legs = [       # four of them", "  [5, 5],", '  [5, -5],    # "starboard"', "  [-5]", "]  # last", "speed = 1", "",
    "[ice]", "thickness = 0.3", "",
  ].join("\n");
  assert.equal(valueIn(toml, "structure", "legs"), "[ [5, 5], [5, -5], [-5] ]");
  assert.equal(valueIn(toml, "structure", "speed"), "1");
  const rest = "speed = 1\n\n[ice]\nthickness = 0.3\n";
  assert.equal(withValue(toml, "structure", "legs", "[[1, 2]]"), `[structure]\nlegs = [[1, 2]]  # last\n${rest}`);
  assert.equal(withValue(toml, "structure", "legs", null), `[structure]\n${rest}`);
  assert.equal(withValue(toml, "structure", "angle", "1"), toml.replace("speed = 1", "speed = 1\nangle = 1"));
});

test("a bracket in a text, or a sign of comment in it, ends no value", () => {
  const toml = '[reference]\nsource = "[1] # of \\"Lu\\""  # a paper\nmean = 3\n';
  assert.equal(valueIn(toml, "reference", "source"), '"[1] # of \\"Lu\\""');
  assert.equal(valueIn(toml, "reference", "mean"), "3");
  assert.equal(withValue(toml, "reference", "source", "'x'"), "[reference]\nsource = 'x'  # a paper\nmean = 3\n");
});
