/** Boxes along the axes, in double precision. */

import type { Bounds, Point3 } from "./preview";

export function union(first: Bounds | null, second: Bounds | null): Bounds | null {
  if (!first || !second) return first ?? second;
  const [[a, b, c], [d, e, f]] = first;
  const [[g, h, i], [j, k, l]] = second;
  return [
    [Math.min(a, g), Math.min(b, h), Math.min(c, i)],
    [Math.max(d, j), Math.max(e, k), Math.max(f, l)],
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
  let [a, b, c] = [Infinity, Infinity, Infinity];
  let [d, e, f] = [-Infinity, -Infinity, -Infinity];
  // Written out: all that is shown passes here with each change.
  for (let at = 0; at + 2 < positions.length; at += 3) {
    const [u, v, w] = [positions[at] as number, positions[at + 1] as number, positions[at + 2] as number];
    if (u < a) a = u;
    if (u > d) d = u;
    if (v < b) b = v;
    if (v > e) e = v;
    if (w < c) c = w;
    if (w > f) f = w;
  }
  return [[a + x, b + y, c + z], [d + x, e + y, f + z]];
}
