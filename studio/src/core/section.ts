/** A plane that cuts the view, by a unit normal and how far along it the plane is from the origin. */

import { centre, cornersOf } from "./bounds";
import type { Bounds, Point3 } from "./preview";

export function dot(a: Point3, b: Point3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** How far along a normal a box reaches. */
export function reach(box: Bounds, normal: Point3): readonly [number, number] {
  const places = cornersOf(box).map((corner) => dot(corner, normal));
  return [Math.min(...places), Math.max(...places)];
}

/** The place of the plane: as it was put, else through the middle of a box. */
export function placeOf(at: number | undefined, normal: Point3, box: Bounds | null): number {
  return at ?? (box ? dot(centre(box), normal) : 0);
}

/** The corners of a square of the plane that covers a box, and its middle. */
export function square(normal: Point3, at: number, box: Bounds): { middle: Point3; corners: Point3[] } {
  const [u, v] = axesAcross(normal);
  const middle = centre(box);
  const off = at - dot(middle, normal);
  const on: Point3 = [middle[0] + normal[0] * off, middle[1] + normal[1] * off, middle[2] + normal[2] * off];
  const [wide, high] = [u, v].map((axis) => {
    const [least, greatest] = reach(box, axis);
    return (greatest - least) * 0.55;
  }) as [number, number];
  const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([a = 0, b = 0]) =>
    on.map((value, axis) => value + (u[axis] ?? 0) * a * wide + (v[axis] ?? 0) * b * high) as unknown as Point3);
  return { middle: on, corners };
}

/** Two unit vectors across a normal: level and upright where there is such a way. */
function axesAcross(normal: Point3): [Point3, Point3] {
  const [x, y, z] = normal;
  const flat = Math.hypot(x, y);
  const u: Point3 = flat > 1e-9 ? [-y / flat, x / flat, 0] : [1, 0, 0];
  return [u, [y * u[2] - z * u[1], z * u[0] - x * u[2], x * u[1] - y * u[0]]];
}
