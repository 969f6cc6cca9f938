// SPDX-License-Identifier: GPL-3.0-or-later
// The structure's mesh as the program gives it, and its parts above and below the water at rest.
import { BufferAttribute, BufferGeometry } from "three";
import { toCreasedNormals } from "three/addons/utils/BufferGeometryUtils.js";
import type { Run } from "./data";

type Point = [number, number, number];

/** The mesh, its frame: z upwards from the waterplane. */
export function hullOf(run: Run): BufferGeometry {
  const [x, y, z] = ["x", "y", "z"].map((axis) => run.column(`mesh.${axis}`));
  const places = Float32Array.from({ length: 3 * x.length }, (_, i) => [x, y, z][i % 3][Math.floor(i / 3)]);
  return new BufferGeometry()
    .setIndex(Array.from(run.column("mesh.triangles")))
    .setAttribute("position", new BufferAttribute(places, 3));
}

/** The corners of a polygon on one side of z = 0. */
function clipped(polygon: Point[], above: boolean): Point[] {
  const kept: Point[] = [];
  const isKept = ([, , z]: Point) => (above ? z >= 0 : z <= 0);
  polygon.forEach((a, i) => {
    const b = polygon[(i + 1) % polygon.length];
    if (isKept(a)) kept.push(a);
    if (a[2] * b[2] >= 0) return;
    const share = a[2] / (a[2] - b[2]);
    kept.push([a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), 0]);
  });
  return kept;
}

/** The part of a mesh above or below the water, shaded round where its facets meet at a small angle. */
export function partOf(mesh: BufferGeometry, above: boolean): BufferGeometry {
  const places = mesh.getAttribute("position");
  const index = mesh.getIndex()!;
  const corner = (i: number): Point => [places.getX(index.getX(i)), places.getY(index.getX(i)), places.getZ(index.getX(i))];
  const corners: number[] = [];
  for (let i = 0; i < index.count; i += 3) {
    const polygon = clipped([corner(i), corner(i + 1), corner(i + 2)], above);
    for (let k = 2; k < polygon.length; ++k) corners.push(...polygon[0], ...polygon[k - 1], ...polygon[k]);
  }
  const kRound = 0.5;  // [rad]
  const part = new BufferGeometry().setAttribute("position", new BufferAttribute(new Float32Array(corners), 3));
  return toCreasedNormals(part, kRound);
}
