/**
 * Boxes along the axes, in double precision. All that is shown passes here with each change: what is done for each part
 * takes nothing apart, which would leave more behind than the geometry itself.
 */

import type { Bounds, Point3 } from "./preview";

export function union(first: Bounds | null, second: Bounds | null): Bounds | null {
  if (!first || !second) return first ?? second;
  const a = first[0];
  const b = first[1];
  const c = second[0];
  const d = second[1];
  return [
    [Math.min(a[0], c[0]), Math.min(a[1], c[1]), Math.min(a[2], c[2])],
    [Math.max(b[0], d[0]), Math.max(b[1], d[1]), Math.max(b[2], d[2])],
  ];
}

/** The box as it is seen from an origin. */
export function from([[a, b, c], [d, e, f]]: Bounds, [x, y, z]: Point3): Bounds {
  return [[a - x, b - y, c - z], [d - x, e - y, f - z]];
}

export function centre([[a, b, c], [d, e, f]]: Bounds): Point3 {
  // Half of each first: the sum of two great numbers may not exist.
  return [a / 2 + d / 2, b / 2 + e / 2, c / 2 + f / 2];
}

/** Half the diagonal. */
export function radius([[a, b, c], [d, e, f]]: Bounds): number {
  return Math.hypot(d - a, e - b, f - c) / 2;
}

export function cornersOf([[a, b, c], [d, e, f]]: Bounds): Point3[] {
  return [
    [a, b, c], [d, b, c], [a, e, c], [d, e, c],
    [a, b, f], [d, b, f], [a, e, f], [d, e, f],
  ];
}

/** The box of positions that are offsets from an origin; null where there are none. */
export function boundsOfPositions(positions: Float32Array, [x, y, z]: Point3): Bounds | null {
  if (positions.length < 3) return null;
  let a = Infinity;
  let b = Infinity;
  let c = Infinity;
  let d = -Infinity;
  let e = -Infinity;
  let f = -Infinity;
  for (let at = 0; at + 2 < positions.length; at += 3) {
    const u = positions[at] as number;
    const v = positions[at + 1] as number;
    const w = positions[at + 2] as number;
    if (u < a) a = u;
    if (u > d) d = u;
    if (v < b) b = v;
    if (v > e) e = v;
    if (w < c) c = w;
    if (w > f) f = w;
  }
  return [[a + x, b + y, c + z], [d + x, e + y, f + z]];
}
