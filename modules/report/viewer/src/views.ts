// SPDX-License-Identifier: GPL-3.0-or-later
// Where the camera is, and how far.
import type { Run } from "./data";

export interface View {
  /** Where the camera is, from the point that it looks at, in sizes of the scene. */
  from: [number, number, number];
  /** That point, from the structure's origin, in radii of its waterline. */
  at: [number, number, number];
}

export const kViews: Record<string, View> = {
  Bow: { from: [3.6, -3.0, 2.6], at: [0.45, 0, 0.2] },
  Wake: { from: [-3.5, -2.7, 3.1], at: [-0.15, 0.05, 0.15] },
  Above: { from: [0, -0.01, 6.2], at: [0.35, 0, 0] },
  Side: { from: [0, -4.6, 0.5], at: [0.5, 0, -0.1] },
  Below: { from: [3.0, -2.7, -1.6], at: [0.1, 0, -0.3] },
};

/** The size of the scene [m]: the structure's radius, but no less than thick ice needs, whose pieces are larger than the
 * structure, and less in thin ice, whose pieces would be specks. */
export function sizeOf(run: Run): number {
  const lengths = Array.from(run.column("event.l_break")).sort((a, b) => a - b);
  if (lengths.length === 0) return run.radius;
  const quantile = (share: number) => lengths[Math.floor(share * (lengths.length - 1))];
  const asPieces = Math.min(run.radius, Math.max(0.5 * run.radius, 8 * quantile(0.5)));
  return Math.max(asPieces, 1.5 * quantile(0.95));
}

/** How much further away a camera must be to see as much across a picture that is narrower than wide. */
export const furtherIn = (aspect: number): number => Math.max(1, 1.45 / aspect);

/** A round length [m] that is between 60 and 150 pixels long. */
export function scaleLength(pixelsPerMetre: number): number {
  const exponent = Math.floor(Math.log10(150 / pixelsPerMetre));
  return [5, 2, 1].map((digit) => digit * 10 ** exponent).find((length) => length * pixelsPerMetre <= 150)!;
}
