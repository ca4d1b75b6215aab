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
  const least = [Infinity, Infinity, Infinity];
  const greatest = [-Infinity, -Infinity, -Infinity];
  for (let at = 0; at + 2 < positions.length; at += 3) {
    for (let axis = 0; axis < 3; axis++) {
      const value = positions[at + axis] as number;
      if (value < (least[axis] as number)) least[axis] = value;
      if (value > (greatest[axis] as number)) greatest[axis] = value;
    }
  }
  const [a = 0, b = 0, c = 0] = least;
  const [d = 0, e = 0, f = 0] = greatest;
  return [[a + x, b + y, c + z], [d + x, e + y, f + z]];
}
