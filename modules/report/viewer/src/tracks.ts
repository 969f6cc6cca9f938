// SPDX-License-Identifier: GPL-3.0-or-later
// Where things are at any time, from what was recorded a frame.
import type { Run } from "./data";

/** The frame at or before a time, and how far it is to the next one. */
export function frameAt(run: Run, time: number): { frame: number; share: number } {
  const times = run.column("frame.time");
  let low = 0;
  let high = times.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times[middle] <= time + 1e-9) low = middle;
    else high = middle - 1;
  }
  const next = times[low + 1];
  return { frame: low, share: next === undefined ? 0 : Math.max(0, (time - times[low]) / (next - times[low])) };
}

/** Place and attitude (x, y, z, qw, qx, qy, qz) between the two recorded poses around a time. */
export function floePose(run: Run, floe: number, start: number, n: number, k: number, share: number, time: number): number[] {
  const recorded = (i: number) =>
    kPose.map((name) => run.column(`track.${name}`)[start + Math.min(n - 1, Math.max(0, i))]);
  if (n > 0 && k >= 0) return between(recorded(k), recorded(k + 1), k + 1 < n ? share : 0);
  const born = kPose.map((name) => run.column(`floe.birth_${name}`)[floe]);
  if (n === 0) return born;
  const birth = run.column("floe.birth")[floe];
  const first = run.column("frame.time")[run.column("track.first")[floe]];
  return between(born, recorded(0), first > birth ? Math.min(1, (time - birth) / (first - birth)) : 1);
}

const kPose = ["x", "y", "z", "qw", "qx", "qy", "qz"];

/** Between two poses: straight in place, along the shorter way in attitude. */
function between(a: number[], b: number[], share: number): number[] {
  const sign = a[3] * b[3] + a[4] * b[4] + a[5] * b[5] + a[6] * b[6] < 0 ? -1 : 1;
  const out = a.map((value, i) => value + share * ((i < 3 ? 1 : sign) * b[i] - value));
  const norm = Math.hypot(out[3], out[4], out[5], out[6]);
  for (let i = 3; i < 7; ++i) out[i] /= norm;
  return out;
}
