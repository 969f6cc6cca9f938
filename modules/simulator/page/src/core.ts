// SPDX-License-Identifier: GPL-3.0-or-later
// What the page asks of the core, which runs in a worker.
import type { Records } from "../../../report/viewer/src/growing";
import type { ClosedForm, Manifest } from "../../../report/viewer/src/types";

export interface Loaded {
  wasm: Uint8Array;
  models: Record<string, Uint8Array>;
}

export interface Asked {
  id: number;
  what: string;
  values: (string | number)[];
  load?: Loaded;
}

/** What `brash check` and `brash loads` say of a case. */
export interface Description {
  toml: string;
  derived: { name: string; value: number; unit: string }[];
  warnings: { id: string; text: string }[];
  loads: { kind: string; loads: ClosedForm[] };
}

export interface Made {
  head: { kind: "live"; manifest: Manifest; arrays: Record<string, number[]> };
  start: Records;
}

export interface Advanced {
  records: Records;
  time: number;
  done: boolean;
}

/** A message of the program. */
export class Refused extends Error {}

const text = (id: string): string => document.getElementById(id)?.textContent ?? "";

/** Files packed behind a line that lists them. */
async function unpack(base64: string): Promise<Record<string, Uint8Array>> {
  const letters = atob(base64);
  const packed = new Uint8Array(letters.length);
  for (let i = 0; i < packed.length; ++i) packed[i] = letters.charCodeAt(i);
  const bytes = new Uint8Array(await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer());
  const end = bytes.indexOf(10);
  const sizes = JSON.parse(new TextDecoder().decode(bytes.subarray(0, end))) as Record<string, number>;
  const files: Record<string, Uint8Array> = {};
  let at = end + 1;
  for (const [name, size] of Object.entries(sizes)) {
    files[name] = bytes.slice(at, at + size);
    at += size;
  }
  return files;
}

export class Core {
  private readonly worker: Worker;
  private readonly waiting = new Map<number, { done: (said: unknown) => void; fail: (error: Error) => void }>();
  private n = 0;

  private constructor() {
    this.worker = new Worker(URL.createObjectURL(new Blob([text("brash-worker")], { type: "text/javascript" })));
    this.worker.onmessage = ({ data: { id, text: said } }: MessageEvent<{ id: number; text: string }>) => {
      const { done, fail } = this.waiting.get(id)!;
      this.waiting.delete(id);
      const answer = JSON.parse(said) as { error?: string };
      if (answer.error !== undefined) fail(new Refused(answer.error));
      else done(answer);
    };
    this.worker.onerror = (event) => {
      for (const { fail } of this.waiting.values()) fail(new Error(event.message));
      this.waiting.clear();
    };
  }

  /** The core in this file; null in a page without it. */
  static async start(): Promise<Core | null> {
    const packed = text("brash-core").trim();
    if (packed === "") return null;
    const { "core.wasm": wasm, ...models } = await unpack(packed);
    const core = new Core();
    await core.ask("load", [], { wasm, models });
    return core;
  }

  check(toml: string, name: string): Promise<Description> {
    return this.ask("check", [toml, name]);
  }

  make(toml: string, name: string): Promise<Made> {
    return this.ask("make", [toml, name]);
  }

  advance(steps: number): Promise<Advanced> {
    return this.ask("advance", [steps]);
  }

  private ask<T>(what: string, values: (string | number)[], load?: Loaded): Promise<T> {
    const id = this.n++;
    return new Promise((done, fail) => {
      this.waiting.set(id, { done: done as (said: unknown) => void, fail });
      this.worker.postMessage({ id, what, values, load } satisfies Asked);
    });
  }
}
