// SPDX-License-Identifier: GPL-3.0-or-later
// Where things are at any time, from what was recorded a frame.
import type { Numbers } from "./types";
import type { Run } from "./data";

/** The frame at or before a time, and how far it is to the next one. */
export function frameAt(run: Run, time: number): { frame: number; share: number } {
  const times = run.column("frame.time");
  const frame = lastUpTo(times, 0, times.length, time + 1e-9);
  const next = times[frame + 1];
  return { frame, share: next === undefined ? 0 : Math.max(0, (time - times[frame]) / (next - times[frame])) };
}

/** Index of the last of sorted `values` in [from, to) that is at most `limit`; `from`, if none is. */
function lastUpTo(values: ArrayLike<number>, from: number, to: number, limit: number): number {
  let [low, high] = [from, to - 1];
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (values[middle] <= limit) low = middle;
    else high = middle - 1;
  }
  return low;
}

const kPose = ["x", "y", "z", "qw", "qx", "qy", "qz"];

/** Place and attitude: x, y, z, qw, qx, qy, qz. */
export type Pose = Float64Array;

/** The poses of all floes. Of equal ones in a row, the first and the last may be recorded alone. */
export class Tracks {
  private readonly start: Int32Array;
  private readonly frame: Numbers;
  private readonly force: Numbers;
  private readonly recorded: Numbers[];
  private readonly birth: Numbers;
  private readonly born: Numbers[];
  private readonly times: Numbers;
  private readonly next = new Float64Array(kPose.length);

  constructor(run: Run) {
    const count = run.column("track.count");
    this.start = new Int32Array(count.length + 1);
    count.forEach((n, floe) => (this.start[floe + 1] = this.start[floe] + n));
    this.frame = run.column("track.frame");
    this.force = run.column("track.force");
    this.recorded = kPose.map((name) => run.column(`track.${name}`));
    this.birth = run.column("floe.birth");
    this.born = kPose.map((name) => run.column(`floe.birth_${name}`));
    this.times = run.column("frame.time");
  }

  /** The record that holds of a floe at a frame; -1 before its first one. */
  at(floe: number, frame: number): number {
    const [from, to] = [this.start[floe], this.start[floe + 1]];
    return from === to || this.frame[from] > frame ? -1 : lastUpTo(this.frame, from, to, frame);
  }

  /** Whether a floe lies still between a record and the next one. */
  rests(floe: number, record: number): boolean {
    if (record < 0) return this.start[floe] === this.start[floe + 1];
    return record + 1 === this.start[floe + 1] || this.recorded.every((column) => column[record] === column[record + 1]);
  }

  /** The contact force at a record [N]. */
  forceAt(record: number): number {
    return record < 0 ? 0 : this.force[record];
  }

  /** Puts the pose of a floe at `time` into `out`: between the records around it, or between birth and the first one. */
  pose(floe: number, record: number, time: number, out: Pose): void {
    const [from, to] = [this.start[floe], this.start[floe + 1]];
    if (record >= 0) return this.between(record, record + 1 < to ? record + 1 : record, time, out);
    for (let i = 0; i < kPose.length; ++i) out[i] = this.born[i][floe];
    if (from === to) return;
    const first = this.times[this.frame[from]];
    const share = first > this.birth[floe] ? Math.min(1, Math.max(0, (time - this.birth[floe]) / (first - this.birth[floe]))) : 1;
    this.read(from, this.next);
    mix(out, this.next, share);
  }

  private between(a: number, b: number, time: number, out: Pose): void {
    this.read(a, out);
    const [before, after] = [this.times[this.frame[a]], this.times[this.frame[b]]];
    if (after <= before) return;
    this.read(b, this.next);
    mix(out, this.next, Math.min(1, Math.max(0, (time - before) / (after - before))));
  }

  private read(record: number, out: Pose): void {
    for (let i = 0; i < kPose.length; ++i) out[i] = this.recorded[i][record];
  }
}

/** Takes a pose towards another: straight in place, along the shorter way in attitude. */
function mix(a: Pose, b: Pose, share: number): void {
  const sign = a[3] * b[3] + a[4] * b[4] + a[5] * b[5] + a[6] * b[6] < 0 ? -1 : 1;
  for (let i = 0; i < 7; ++i) a[i] += share * ((i < 3 ? 1 : sign) * b[i] - a[i]);
  const norm = Math.hypot(a[3], a[4], a[5], a[6]);
  for (let i = 3; i < 7; ++i) a[i] /= norm;
}
