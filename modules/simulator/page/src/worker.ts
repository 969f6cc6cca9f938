// SPDX-License-Identifier: GPL-3.0-or-later
// The core in a thread of its own: it computes, and the page continues to draw.
import type { Asked, Loaded } from "./core";

interface Module {
  ccall: (name: string, returns: "string", types: string[], values: (string | number)[]) => string;
  FS: { mkdir: (path: string) => void; writeFile: (path: string, bytes: Uint8Array) => void };
}
/** Made by emscripten; it stands before this script. */
declare const brashCore: (given: { wasmBinary: Uint8Array; print: (text: string) => void; printErr: (text: string) => void }) => Promise<Module>;

let core: Promise<Module> | null = null;

async function load({ wasm, models }: Loaded): Promise<Module> {
  const made = await brashCore({ wasmBinary: wasm, print: () => {}, printErr: () => {} });
  made.FS.mkdir("/models");
  for (const [name, bytes] of Object.entries(models)) made.FS.writeFile(`/models/${name}`, bytes);
  return made;
}

async function said(asked: Asked): Promise<string> {
  if (asked.load) {
    core = load(asked.load);
    await core;
    return "{}";
  }
  const { ccall } = await core!;
  const types = asked.values.map((value) => (typeof value === "number" ? "number" : "string"));
  return ccall(`brash_${asked.what}`, "string", types, asked.values);
}

onmessage = async ({ data }: MessageEvent<Asked>) => {
  let text: string;
  try {
    text = await said(data);
  } catch (error) {
    text = JSON.stringify({ error: `The core of the simulator failed: ${String(error)}` });
  }
  postMessage({ id: data.id, text });
};
