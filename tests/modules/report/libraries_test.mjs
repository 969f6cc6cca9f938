// SPDX-License-Identifier: GPL-3.0-or-later
// The libraries that the page is built of are what package-lock.json names, and nobody has edited them.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, rmSync, statSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";

const { BRASH_PACKAGES: packages, BRASH_SOURCE: source } = process.env;
const viewer = join(source, "modules/report/viewer");
const filesOf = (folder, below = "") => readdirSync(join(folder, below)).sort().flatMap((name) => {
  const file = join(below, name);
  return statSync(join(folder, file)).isDirectory() ? filesOf(folder, file) : [file];
});

test("the kept libraries are the ones that the locked packages give", () => {
  const made = mkdtempSync(join(tmpdir(), "brash-libraries-"));
  try {
    execFileSync(process.execPath, [join(viewer, "libraries.mjs"), packages, made]);
    const kept = join(viewer, "libraries");
    assert.deepEqual(filesOf(kept), filesOf(made));
    assert.ok(filesOf(kept).includes("three.js"));
    for (const file of filesOf(made))
      assert.ok(readFileSync(join(kept, file)).equals(readFileSync(join(made, file))),
        `${file} differs from the locked packages: make it again with \`node modules/report/viewer/libraries.mjs ${packages}\``);
  } finally {
    rmSync(made, { recursive: true });
  }
});
