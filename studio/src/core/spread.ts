/** Making room on the canvas: all that lies beyond a line gives way. */

import { middle, type Point, type Rect } from "./geometry";

/**
 * The steps by which objects give way when a hand drags from one point to another: those that lie farther on than
 * where it began, in the direction in which it went mostly.
 */
export function spreadSteps(rects: Iterable<readonly [string, Rect]>, from: Point, to: Point): Map<string, Point> {
  const by: Point = [to[0] - from[0], to[1] - from[1]];
  const axis = Math.abs(by[0]) >= Math.abs(by[1]) ? 0 : 1;
  const far = by[axis];
  const step: Point = axis === 0 ? [far, 0] : [0, far];
  const steps = new Map<string, Point>();
  if (far === 0) return steps;
  for (const [id, rect] of rects) if ((middle(rect)[axis] - from[axis]) * Math.sign(far) > 0) steps.set(id, step);
  return steps;
}
