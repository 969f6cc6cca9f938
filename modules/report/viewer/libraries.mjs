// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the files of libraries/ from the packages that package-lock.json names: libraries.mjs PACKAGES_FOLDER [FOLDER].
// The files are kept, so that a build needs neither npm nor a network. A test makes them again and compares.
import { cpSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const packages = resolve(process.argv[2]);
const folder = resolve(process.argv[3] ?? join(dirname(fileURLToPath(import.meta.url)), "libraries"));
const { build } = createRequire(join(packages, "package.json"))("esbuild");
const at = (path) => join(packages, "node_modules", path);

// The names by which the page's sources import them. The add-ons import "three" too, so they carry no copy of it.
await build({
  entryPoints: {
    three: at("three/build/three.module.js"),
    "three/addons/controls/OrbitControls": at("three/examples/jsm/controls/OrbitControls.js"),
    "three/addons/utils/BufferGeometryUtils": at("three/examples/jsm/utils/BufferGeometryUtils.js"),
    uplot: at("uplot/dist/uPlot.esm.js"),
    "webm-muxer": at("webm-muxer/build/webm-muxer.mjs"),
  },
  external: ["three"],
  bundle: true,
  minify: true,
  format: "esm",
  legalComments: "inline",
  outdir: folder,
});
cpSync(at("uplot/dist/uPlot.min.css"), join(folder, "uplot.css"));

const licences = ["three", "uplot", "webm-muxer"].map((name) => {
  const { version, license } = JSON.parse(readFileSync(at(`${name}/package.json`), "utf8"));
  return `${name} ${version} (${license})\n\n${readFileSync(at(`${name}/LICENSE`), "utf8").trim()}\n`;
});
writeFileSync(join(folder, "licences.txt"), licences.join(`\n${"-".repeat(60)}\n\n`));
