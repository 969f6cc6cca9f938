// SPDX-License-Identifier: GPL-3.0-or-later
// The arrays of a run that grows: streamed records, laid out as a report has them.
import type { Blocks } from "./data";
import type { LiveData, RunFiles } from "./types";

type Columns = Record<string, number[]>;

/** What modules/report/src/live.cpp writes: columns of new rows; lengths and attitudes in steps of 1e-4. */
export interface Records {
  load: Columns;
  event: Columns;
  split: Columns;
  floe: Columns;
  frame: Columns;
  /** Of each new floe its rings as x, y, x, y, ... */
  outlines: number[][][];
  /** Floe, time, how it ended. */
  ended: [number, number, number][];
  /** Of each new frame: floe, x, y, z, qw, qx, qy, qz, force. */
  poses: number[][][];
  sheets: { time: number; rings: number[][] }[];
}

const kStep = 1e-4;
const kTrack = ["x", "y", "z", "qw", "qx", "qy", "qz"];

/** Polygons as a report stores them: rings of each, nodes of each ring, coordinates. */
class Polygons {
  private readonly rings: number[] = [];
  private readonly nodes: number[] = [];
  private readonly x: number[] = [];
  private readonly y: number[] = [];

  add(rings: number[][]): void {
    this.rings.push(rings.length);
    for (const ring of rings) {
      this.nodes.push(ring.length / 2);
      for (let i = 0; i < ring.length; i += 2) {
        this.x.push(kStep * ring[i]);
        this.y.push(kStep * ring[i + 1]);
      }
    }
  }

  into(blocks: Blocks, name: string): void {
    blocks.set(`${name}.rings`, Int32Array.from(this.rings));
    blocks.set(`${name}.nodes`, Int32Array.from(this.nodes));
    blocks.set(`${name}.x`, Float32Array.from(this.x));
    blocks.set(`${name}.y`, Float32Array.from(this.y));
  }
}

export class Growing {
  private readonly columns = new Map<string, number[]>();
  private readonly outlines = new Polygons();
  private readonly sheets: { time: number; rings: number[][] }[] = [];
  /** Of each floe the frame that has it first, and its poses one after another. */
  private readonly tracks: { first: number; poses: number[][] }[] = [];
  private nFrames = 0;

  /** @param fixed arrays that do not grow: the structure's. */
  constructor(private readonly fixed: Blocks) {
    for (const name of kEmpty) this.columns.set(name, []);
  }

  add(records: Records): void {
    for (const of of ["load", "event", "split", "floe", "frame"] as const)
      for (const [name, values] of Object.entries(records[of])) {
        const column = this.columns.get(`${of}.${name}`) ?? [];
        for (const value of values) column.push(value);
        this.columns.set(`${of}.${name}`, column);
      }
    for (const rings of records.outlines) {
      this.outlines.add(rings);
      this.tracks.push({ first: 0, poses: [] });
    }
    for (const [floe, time, end] of records.ended) {
      this.columns.get("floe.death")![floe] = time;
      this.columns.get("floe.end")![floe] = end;
    }
    for (const frame of records.poses) this.addFrame(frame);
    this.sheets.push(...records.sheets);
  }

  private addFrame(poses: number[][]): void {
    for (const [floe, ...pose] of poses) {
      const track = this.tracks[floe];
      if (track.poses.length === 0) track.first = this.nFrames;
      track.poses.push(pose);
    }
    ++this.nFrames;
  }

  blocks(): Blocks {
    const blocks: Blocks = new Map(this.fixed);
    for (const [name, values] of this.columns) blocks.set(name, Float64Array.from(values));
    this.outlines.into(blocks, "outline");
    this.putTracks(blocks);
    this.putSheets(blocks);
    return blocks;
  }

  private putTracks(blocks: Blocks): void {
    const n = this.tracks.reduce((sum, { poses }) => sum + poses.length, 0);
    blocks.set("track.frame", Int32Array.from(this.tracks.flatMap(({ first, poses }) => poses.map((_, i) => first + i))));
    blocks.set("track.count", Int32Array.from(this.tracks, ({ poses }) => poses.length));
    const columns = [...kTrack, "force"].map((name) => {
      const column = new Float32Array(n);
      blocks.set(`track.${name}`, column);
      return column;
    });
    let at = 0;
    for (const { poses } of this.tracks)
      for (const pose of poses) {
        pose.forEach((value, k) => (columns[k][at] = k < kTrack.length ? kStep * value : value));
        ++at;
      }
  }

  /** The newest sheet is used for the one at the end. */
  private putSheets(blocks: Blocks): void {
    const sheets = this.sheets.length > 0 ? this.sheets : [{ time: 0, rings: [] }];  // of a field of floes
    const all = [...sheets, sheets[sheets.length - 1]];
    const polygons = new Polygons();
    for (const { rings } of all) polygons.add(rings);
    polygons.into(blocks, "sheet");
    blocks.set("sheet.time", Float64Array.from(all, ({ time }) => time));
    const end = ["x", "y", "z", "qw", "qx", "qy", "qz"].map((name) => this.columns.get(`frame.structure_${name}`)?.at(-1));
    if (end.every((value) => value !== undefined)) blocks.set("structure.end", Float64Array.from(end as number[]));
  }

  /** The files of a run that has none yet. */
  files({ manifest, origin }: LiveData): RunFiles {
    return { kind: "run", origin, manifest, summary: { statistics_from: 0 } as RunFiles["summary"], closed_forms: { kind: "", loads: [] }, loads: null, drawn_rows: { n: 0, span: 1 } };
  }
}

/** Columns that a run without rows has. */
const kEmpty = ["event.time", "event.pieces", "split.time", "floe.parent", "floe.birth", "frame.time", "load.time"];
