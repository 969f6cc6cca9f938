// SPDX-License-Identifier: GPL-3.0-or-later
// Bundles the page of a report into one HTML text and writes it as C++: build.mjs PACKAGES_FOLDER PAGE.cpp
import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const packages = resolve(process.argv[2]);
const { build } = createRequire(join(packages, "package.json"))("esbuild");

const { outputFiles } = await build({
  entryPoints: [join(here, "src/main.ts")],
  nodePaths: [join(packages, "node_modules")],
  bundle: true,
  minify: true,
  write: false,
  outfile: "page.js",
  format: "iife",
  target: ["chrome103", "firefox113", "safari16.4"],
  legalComments: "eof",
  loader: { ".css": "text" },
});
const script = outputFiles[0].text;
const style = readFileSync(join(here, "style.css"), "utf8");
const uplot = readFileSync(join(packages, "node_modules/uplot/dist/uPlot.min.css"), "utf8");
// The policy allows this script and no other: the data of a report cannot bring one along.
const hash = `sha256-${createHash("sha256").update(script).digest("base64")}`;
// Functions as replacements: a `$&` in the script would mean something in a text.
const page = readFileSync(join(here, "page.html"), "utf8")
  .replace("SCRIPT-HASH", () => hash)
  .replace("/*STYLE*/", () => uplot + style)
  .replace("/*SCRIPT*/", () => script);

const kDelimiter = "BRASH_PAGE";
if (page.includes(`)${kDelimiter}"`)) throw new Error("the page holds the delimiter of its C++ literal");
const pieces = [];
for (let i = 0; i < page.length; i += 8000) pieces.push(`R"${kDelimiter}(${page.slice(i, i + 8000)})${kDelimiter}"`);
writeFileSync(
  resolve(process.argv[3]),
  `#include "page.hpp"\n\nnamespace brash::report {\n\nusing namespace std::literals;\n\n` +
    `const std::string_view kPage =\n${pieces.join("\n")}sv;\n\n}  // namespace brash::report\n`,
);
