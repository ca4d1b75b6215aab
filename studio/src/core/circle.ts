/** Circles as points. */

import type { Point3 } from "./preview";
import type { CircleView } from "./protocol/CircleView";

/** Points all around, the first twice: from where the circle touches its curve. */
export function circlePoints({ centre, x, y, radius }: CircleView, count: number): Point3[] {
  return Array.from({ length: count + 1 }, (_, at) => {
    const angle = (at / count) * 2 * Math.PI;
    const [along, across] = [radius * Math.cos(angle), radius * Math.sin(angle)];
    return [0, 1, 2].map((axis) => (centre[axis] ?? 0) + (x[axis] ?? 0) * along + (y[axis] ?? 0) * across) as unknown as Point3;
  });
}
