// SPDX-License-Identifier: GPL-3.0-or-later
// Bundles the page of a report into one HTML text and writes it as C++: build.mjs ESBUILD PAGE.cpp
import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { bundled, literal, uplotStyle } from "./bundle.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const [esbuild, output] = process.argv.slice(2);
const script = bundled(esbuild, join(here, "src/main.ts"));
const style = readFileSync(join(here, "style.css"), "utf8");
// The policy allows this script and no other: the data of a report cannot bring one along.
const hash = `sha256-${createHash("sha256").update(script).digest("base64")}`;
// Functions as replacements: a `$&` in the script would mean something in a text.
const page = readFileSync(join(here, "page.html"), "utf8")
  .replace("SCRIPT-HASH", () => hash)
  .replace("/*STYLE*/", () => uplotStyle + style)
  .replace("/*SCRIPT*/", () => script);
writeFileSync(
  output,
  `#include "page.hpp"\n\nnamespace brash::report {\n\nusing namespace std::literals;\n\n` +
    `const std::string_view kPage =\n${literal(page, "BRASH_PAGE")};\n\n}  // namespace brash::report\n`,
);
