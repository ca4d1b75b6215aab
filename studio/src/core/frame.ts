/** Construction planes: where typed coordinates count from, and in which drawings lie. */

import type { Point3 } from "./preview";

export interface Frame {
  origin: Point3;
  /** Unit vectors at right angles, `z` along x × y. */
  x: Point3;
  y: Point3;
  z: Point3;
}

/** The planes of the grids, with the axes that Rhino gives them. */
export const FRAMES: Record<"xy" | "xz" | "yz", Frame> = {
  xy: { origin: [0, 0, 0], x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] },
  xz: { origin: [0, 0, 0], x: [1, 0, 0], y: [0, 0, 1], z: [0, -1, 0] },
  yz: { origin: [0, 0, 0], x: [0, 1, 0], y: [0, 0, 1], z: [1, 0, 0] },
};

export function along(from: Point3, ...steps: readonly (readonly [number, Point3])[]): Point3 {
  const sum = (axis: 0 | 1 | 2) => steps.reduce((value, [far, way]) => value + far * way[axis], from[axis]);
  return [sum(0), sum(1), sum(2)];
}

export function minus(a: Point3, b: Point3): Point3 {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

export function dot(a: Point3, b: Point3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function distance(a: Point3, b: Point3): number {
  return Math.hypot(...minus(a, b));
}

/** The point of these coordinates in a frame. */
export function pointAt({ origin, x, y, z }: Frame, [u, v, w]: Point3): Point3 {
  return along(origin, [u, x], [v, y], [w, z]);
}

/** The coordinates of a point in a frame. */
export function coordinatesIn({ origin, x, y, z }: Frame, point: Point3): Point3 {
  const away = minus(point, origin);
  return [dot(away, x), dot(away, y), dot(away, z)];
}

export function cross(a: Point3, b: Point3): Point3 {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}
