// SPDX-License-Identifier: GPL-3.0-or-later
// What the pages of reports and of the simulator share: bundling, and a page as a literal of C++.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const libraries = join(dirname(fileURLToPath(import.meta.url)), "libraries");

/** The style of the charts. */
export const uplotStyle = readFileSync(join(libraries, "uplot.css"), "utf8");

/** A script of TypeScript with all that it imports, as one text. `esbuild` is the path of the bundler. */
export function bundled(esbuild, entry) {
  const options = ["--bundle", "--minify", "--format=iife", "--target=chrome103,firefox113,safari16.4", "--legal-comments=eof", "--loader:.css=text"];
  return execFileSync(esbuild, [entry, ...options, "--log-level=warning"], {
    encoding: "utf8", env: { ...process.env, NODE_PATH: libraries }, maxBuffer: 1 << 26, stdio: ["ignore", "pipe", "inherit"],
  });
}

/** A text as C++, in pieces; the delimiter must not occur in it. */
export function literal(text, delimiter) {
  if (text.includes(`)${delimiter}"`)) throw new Error("the page holds the delimiter of its C++ literal");
  const pieces = [];
  for (let i = 0; i < text.length; i += 8000) pieces.push(`R"${delimiter}(${text.slice(i, i + 8000)})${delimiter}"`);
  return `${pieces.join("\n")}sv`;
}
