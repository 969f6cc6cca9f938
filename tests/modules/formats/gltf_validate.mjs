// SPDX-License-Identifier: GPL-3.0-or-later
// Prints the report of Khronos' validator on a file: node gltf_validate.mjs PACKAGES FILE.glb
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";

const [packages, file] = process.argv.slice(2);
const { validateBytes } = createRequire(join(packages, "package.json"))("gltf-validator");
const report = await validateBytes(new Uint8Array(readFileSync(file)), { maxIssues: 20 });
console.log(JSON.stringify(report));
