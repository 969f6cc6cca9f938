// SPDX-License-Identifier: GPL-3.0-or-later
// Unpacks what the program put into the page. Loops, since `from` with a function takes ten times as long.
import type { BlockEntry, Numbers, PageData, RunFiles } from "./types";

export type Blocks = Map<string, Numbers>;

function text(id: string): string {
  return document.getElementById(id)?.textContent ?? "";
}

export function readData(): PageData {
  return JSON.parse(text("brash-data")) as PageData;
}

async function inflate(base64: string): Promise<Uint8Array> {
  const letters = atob(base64);
  const packed = new Uint8Array(letters.length);
  for (let i = 0; i < packed.length; ++i) packed[i] = letters.charCodeAt(i);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Puts the bytes of `count` numbers, stored byte plane after byte plane from `start` on, together again. */
function joined(bytes: Uint8Array, start: number, count: number, size: number): ArrayBuffer {
  const out = new Uint8Array(count * size);
  for (let plane = 0; plane < size; ++plane)
    for (let i = 0; i < count; ++i) out[i * size + plane] = bytes[start + plane * count + i];
  return out.buffer;
}

/** Whole numbers from their zigzag-coded differences. */
function summed(coded: Uint32Array): Int32Array {
  const out = new Int32Array(coded.length);
  let value = 0;
  for (let i = 0; i < coded.length; ++i) {
    value = (value + ((coded[i] >>> 1) ^ -(coded[i] & 1))) | 0;
    out[i] = value;
  }
  return out;
}

function unpacked(entry: BlockEntry, bytes: Uint8Array, start: number): Numbers {
  const size = entry.kind === "f64" ? 8 : 4;
  const buffer = joined(bytes, start, entry.count, size);
  if (entry.kind === "f64") return new Float64Array(buffer);
  if (entry.kind === "f32") return new Float32Array(buffer);
  const whole = summed(new Uint32Array(buffer));
  if (entry.unit === 1) return whole;
  const out = new Float32Array(whole);
  for (let i = 0; i < out.length; ++i) out[i] = whole[i] * entry.unit;
  return out;
}

export async function readBlocks(directory: BlockEntry[]): Promise<Blocks> {
  const blocks: Blocks = new Map();
  if (directory.length === 0) return blocks;
  const bytes = await inflate(text("brash-packed"));
  let start = 0;
  for (const entry of directory) {
    blocks.set(entry.name, unpacked(entry, bytes, start));
    start += entry.count * (entry.kind === "f64" ? 8 : 4);
  }
  return blocks;
}

/** The arrays whose names begin with `prefix`, without it. */
export function part(blocks: Blocks, prefix: string): Blocks {
  return new Map([...blocks].filter(([name]) => name.startsWith(prefix)).map(([name, values]) => [name.slice(prefix.length), values]));
}

export type Ring = [number, number][];

/** Polygons stored by their rings: `name`.rings, .nodes, .x, .y. */
export function polygons(blocks: Blocks, name: string): Ring[][] {
  const column = (part: string) => blocks.get(`${name}.${part}`)!;
  const [rings, nodes, x, y] = [column("rings"), column("nodes"), column("x"), column("y")];
  let ring = 0;
  let node = 0;
  return Array.from(rings, (n) =>
    Array.from({ length: n }, () => Array.from({ length: nodes[ring++] }, () => [x[node], y[node++]] as [number, number])),
  );
}

/**
 * Which floes each event made, by their places among those that broke off the level ice, in the order of their births.
 * Other floes come without an event: floes of the start, ice that crushing severs, and parts of sheets that split.
 * @param splits times at which sheets split.
 */
export function piecesOfEvents(times: Numbers, pieces: Numbers, births: number[], splits: Numbers): number[][] {
  const rounding = 1e-9; // s
  const isAt = (time: number, other: number | undefined) => other !== undefined && Math.abs(other - time) < rounding;
  let next = 0;
  /** Floes severed in the step of an event: ice is severed first, then it breaks, and then sheets split. */
  const severed = (event: number): number => {
    const time = times[event];
    if (splits.some((other) => isAt(time, other))) return 0;
    let [made, born] = [0, 0];
    for (let i = event; isAt(time, times[i]); ++i) made += pieces[i];
    while (isAt(time, births[next + born])) ++born;
    return Math.max(0, born - made);
  };
  return Array.from(times, (time, event) => {
    while (next < births.length && births[next] < time - rounding) ++next;
    if (!isAt(time, times[event - 1])) next += severed(event);
    const first = next;
    next = Math.min(first + pieces[event], births.length);
    return Array.from({ length: next - first }, (_, i) => first + i);
  });
}

/** Rings of a body that lies level, where its pose puts them. */
function placed(rings: Ring[], at: (name: string) => number): Ring[] {
  const angle = 2 * Math.atan2(at("qz"), at("qw"));
  const [c, s, x, y] = [Math.cos(angle), Math.sin(angle), at("x"), at("y")];
  return rings.map((ring) => ring.map(([u, v]) => [x + c * u - s * v, y + s * u + c * v]));
}

/** A run with its arrays at hand. */
export class Run {
  outlines: Ring[][] = [];
  sheets: Ring[][] = [];
  /** The structure's waterline at rest, its frame. */
  readonly waterline: Ring[];
  /** Outlines of the land, each with its holes. */
  readonly land: Ring[][];
  /** Half the length or the width of the waterline, whichever is more [m]. */
  readonly radius: number;
  readonly inputs: Record<string, Record<string, InputValue>>;
  /** Floes that broke off the level ice, in the order of their births. The others are pieces of floes. */
  offSheet: number[] = [];
  /** Those that each event made. */
  piecesOf: number[][] = [];
  /** The event that each floe broke off in; -1 for the others. */
  private madeBy = new Int32Array();
  nFloes = 0;
  nEvents = 0;
  duration = 0;

  constructor(
    readonly data: RunFiles,
    public blocks: Blocks,
  ) {
    this.waterline = polygons(blocks, "waterline")[0];
    this.land = blocks.has("land.rings") ? polygons(blocks, "land") : [];
    const extent = (axis: number) => {
      const places = this.waterline.flat().map((point) => point[axis]);
      return Math.max(...places) - Math.min(...places);
    };
    this.radius = 0.5 * Math.max(extent(0), extent(1));
    this.inputs = parseToml(data.manifest.case?.toml ?? "");
    this.take(blocks);
  }

  /** Goes over to arrays that have grown. */
  take(blocks: Blocks): void {
    this.blocks = blocks;
    this.outlines = polygons(blocks, "outline");
    this.sheets = polygons(blocks, "sheet");
    this.nFloes = this.outlines.length;
    this.nEvents = this.column("event.time").length;
    const frames = this.column("frame.time");
    const loads = this.column("load.time");
    this.duration = Math.max(frames.at(-1) ?? 0, loads.at(-1) ?? 0);
    const pieces = this.column("event.pieces");
    const births = this.column("floe.birth");
    this.offSheet = [...this.column("floe.parent")].flatMap((parent, floe) => (parent < 0 ? [floe] : []));
    this.piecesOf = piecesOfEvents(this.column("event.time"), pieces, this.offSheet.map((floe) => births[floe]), this.column("split.time"))
      .map((places) => places.map((place) => this.offSheet[place]));
    this.madeBy = new Int32Array(this.nFloes).fill(-1);
    this.piecesOf.forEach((floes, event) => floes.forEach((floe) => (this.madeBy[floe] = event)));
  }

  /** Whether the ice is a field of floes, and no sheet. */
  get isField(): boolean {
    return this.inputs.field?.kind?.value === "floes";
  }

  get name(): string {
    return this.data.manifest.case?.name ?? "run";
  }

  /** Whether there are poses to replay: a single frame is the start. */
  get hasReplay(): boolean {
    return this.column("frame.time").length >= 2;
  }

  column(name: string): Numbers {
    const found = this.blocks.get(name);
    if (!found) throw new Error(`the report has no column ${name}`);
    return found;
  }

  input(section: string, key: string): number {
    const value = this.inputs[section]?.[key]?.value;
    return typeof value === "number" ? value : NaN;
  }

  /** The structure's waterline at the end, sheet frame. */
  waterlineAtEnd(): Ring[] {
    const pose = this.column("structure.end");
    return placed(this.waterline, (name) => pose[["x", "y", "z", "qw", "qx", "qy", "qz"].indexOf(name)]);
  }

  /** A floe, or the one of the start or the level ice that it is a piece of. */
  private ancestor(floe: number): number {
    const parents = this.column("floe.parent");
    while (parents[floe] >= 0) floe = parents[floe];
    return floe;
  }

  /** The event that broke a floe, or the floe that it is a piece of, off the level ice; -1: none. */
  eventOf(floe: number): number {
    return this.madeBy[this.ancestor(floe)];
  }

  /** Whether a floe, or the floe that it is a piece of, was there at the start. */
  wasThere(floe: number): boolean {
    return this.column("floe.birth")[this.ancestor(floe)] === 0;
  }

  /** The sheet in whose time an event came: before its step, or after it. */
  sheetOf(event: number, after: boolean): Ring[] {
    const times = this.column("sheet.time");
    const time = this.column("event.time")[event];
    let index = 0;
    while (index + 2 < times.length && times[index + 1] < time + (after ? 1e-9 : -1e-9)) ++index;
    return this.sheets[index];
  }

  /** Which sheet lies there at a time: the last one that came about until then. */
  sheetAt(time: number): number {
    const times = this.column("sheet.time");
    let index = 0;
    // The last sheet is the one at the end; it differs from the one before by what was crushed since.
    for (let i = 1; i < times.length - 1 && times[i] <= time + 1e-9; ++i) index = i;
    return time >= this.duration ? times.length - 1 : index;
  }

  /** The outline of a floe where it was born, sheet frame. */
  bornAt(floe: number): Ring[] {
    return placed(this.outlines[floe], (name) => this.column(`floe.birth_${name}`)[floe]);
  }
}

export interface InputValue {
  value: number | string | boolean | number[];
  text: string;
  unit: string;
}

/** Reads what the program itself wrote as the resolved case: sections, and `key = value  # unit` lines. */
export function parseToml(toml: string): Record<string, Record<string, InputValue>> {
  const sections: Record<string, Record<string, InputValue>> = {};
  let current: Record<string, InputValue> = {};
  for (const line of toml.split("\n")) {
    const head = /^\[([a-z_.]+)\]$/.exec(line);
    if (head) current = sections[head[1]] = {};
    const entry = /^([a-z_0-9]+) = (".*"|[^#]*?)(?:\s+# (.*))?$/.exec(line);
    if (!entry) continue;
    let value: InputValue["value"] = entry[2];
    try {
      value = JSON.parse(entry[2]) as InputValue["value"];
    } catch {
      // A text in TOML's own escapes, or inf: shown as it is.
    }
    current[entry[1]] = { value, text: typeof value === "string" ? value : entry[2], unit: entry[3] ?? "" };
  }
  return sections;
}
