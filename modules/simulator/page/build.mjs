// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the page of the simulator, one HTML file: build.mjs ESBUILD PAGE.html [CORE_FOLDER]. Without a core the
// page is the case builder alone; PAGE.cpp is that page as C++.
import { createHash } from "node:crypto";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { bundled, literal, uplotStyle } from "../../report/viewer/bundle.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const root = resolve(here, "../../..");
const [esbuild, output, core] = process.argv.slice(2);
const read = (...path) => readFileSync(join(root, ...path), "utf8");

/** The core and the failure models: a line with names and sizes, then all bytes; compressed, as base64. */
function packedCore() {
  const models = "experiments/failure_database";
  const names = readdirSync(join(root, models)).filter((name) => /^cone_.*\.json$/.test(name)).sort();
  const files = Object.fromEntries([["core.wasm", readFileSync(join(core, "core.wasm"))], ...names.map((name) => [name, readFileSync(join(root, models, name))])]);
  const sizes = JSON.stringify(Object.fromEntries(Object.entries(files).map(([name, { length }]) => [name, length])));
  return gzipSync(Buffer.concat([Buffer.from(`${sizes}\n`), ...Object.values(files)]), { level: 9 }).toString("base64");
}

/** Text in a script element, which ends at its closing tag; the worker's scripts and JSON may have such a text in a string. */
const inside = (text) => text.replace(/<\/(script)/gi, "<\\/$1").replace(/<!--/g, "<\\!--");

const script = bundled(esbuild, join(here, "src/main.ts"));
const style = uplotStyle + read("modules/report/viewer/style.css") + readFileSync(join(here, "style.css"), "utf8");
const parts = {
  "SCRIPT-HASH": `sha256-${createHash("sha256").update(script).digest("base64")}`,
  "/*STYLE*/": style,
  "BRASH-SCHEMA": inside(JSON.stringify(JSON.parse(read("modules/io/case.schema.json")))),
  "BRASH-SITE-ICE": inside(JSON.stringify(JSON.parse(read("modules/io/site_ice.json")))),
  "BRASH-KINDS": inside(JSON.stringify(JSON.parse(readFileSync(join(here, "new_kinds.json"), "utf8")))),
  // The builder begins as `brash new --ice baltic` does, the simulator with the validation case, of which it draws 20 s at once.
  "BRASH-TEMPLATE": core ? read("experiments/validation/cone.toml").replace(/^(#.*\n)+\n/, "") : readFileSync(join(here, "new_case.toml"), "utf8").replace(/^# SPDX.*\n/, ""),
  "BRASH-WORKER": core ? inside(readFileSync(join(core, "core.js"), "utf8") + bundled(esbuild, join(here, "src/worker.ts"))) : "",
  "BRASH-CORE": core ? packedCore() : "",
  "/*SCRIPT*/": script,
};
let page = readFileSync(join(here, "page.html"), "utf8");
// The policy's hash would hold for the script alone; the parts come in one pass, so that none is sought in another.
page = page.replace(/SCRIPT-HASH|\/\*STYLE\*\/|BRASH-(?:SCHEMA|SITE-ICE|KINDS|TEMPLATE|WORKER|CORE)|\/\*SCRIPT\*\//g, (mark) => parts[mark]);
if (output.endsWith(".cpp")) {
  writeFileSync(output, `#include "brash/simulator/builder.hpp"\n\nusing namespace std::literals;\n\n` +
    `const std::string_view brash::simulator::kBuilder =\n${literal(page, "BRASH_BUILDER")};\n`);
  process.exit();
}
writeFileSync(output, page);
console.log(`${output}: ${(page.length / 1e6).toFixed(2)} MB`);
