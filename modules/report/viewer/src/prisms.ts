// SPDX-License-Identifier: GPL-3.0-or-later
// Plan polygons as solids: triangles to fill and edges to draw.
import { ShapeUtils, Vector2 } from "three";
import type { Ring } from "./data";

/** Triangles and edges of plan polygons between two heights, every ring once at the top and once at the bottom. */
export class Prisms {
  readonly x: number[] = [];
  readonly y: number[] = [];
  readonly z: number[] = [];
  readonly triangles: number[] = [];
  readonly edges: number[] = [];

  /** @param rings outline counter-clockwise, holes clockwise. */
  add(rings: Ring[], bottom: number, top: number): void {
    const start = this.x.length;
    const nodes = rings.flat();
    const contour = rings[0].map(([x, y]) => new Vector2(x, y));
    const holes = rings.slice(1).map((ring) => ring.map(([x, y]) => new Vector2(x, y)));
    for (const z of [top, bottom])
      for (const [x, y] of nodes) {
        this.x.push(x);
        this.y.push(y);
        this.z.push(z);
      }
    const n = nodes.length;
    for (const [a, b, c] of ShapeUtils.triangulateShape(contour, holes)) {
      this.triangles.push(start + a, start + b, start + c);
      this.triangles.push(start + n + c, start + n + b, start + n + a);
    }
    let first = start;
    for (const ring of rings) {
      for (let i = 0; i < ring.length; ++i) {
        const a = first + i;
        const b = first + ((i + 1) % ring.length);
        this.triangles.push(a, a + n, b, b, a + n, b + n);
        this.edges.push(a, b, a + n, b + n);
      }
      first += ring.length;
    }
  }

  get size(): number {
    return this.x.length;
  }

  positions(): Float32Array {
    const out = new Float32Array(3 * this.size);
    for (let i = 0; i < this.size; ++i) out.set([this.x[i], this.y[i], this.z[i]], 3 * i);
    return out;
  }
}

/** Rings of one sheet as polygons: a counter-clockwise ring begins one, clockwise rings are its holes. */
export function polygonsOf(rings: Ring[]): Ring[][] {
  const polygons: Ring[][] = [];
  for (const ring of rings) {
    const area = ring.reduce((sum, [x, y], i) => {
      const [u, v] = ring[(i + 1) % ring.length];
      return sum + x * v - u * y;
    }, 0);
    if (area > 0 || polygons.length === 0) polygons.push([ring]);
    else polygons.at(-1)!.push(ring);
  }
  return polygons;
}
