/** Arrows for how places move: lines and heads, all to one scale. */

import type { Point3 } from "./preview";
import type { ArrowView } from "./protocol/ArrowView";

/** The longest arrow is this part of the model's size. */
const LONGEST = 0.12;
/** A head is this part of its arrow, and half as wide. */
const HEAD = 0.25;
/** What moves less than this part of the fastest place stands still to the eye. */
const STILL = 0.01;

/** The ends of the lines of arrows, two points a line, beside an origin. */
export function arrowLines(arrows: readonly ArrowView[], size: number, origin: Point3): number[] {
  const lengths = arrows.map(({ by }) => Math.hypot(...by));
  const fastest = Math.max(0, ...lengths);
  const scale = fastest > 0 ? (LONGEST * size) / fastest : 0;
  const lines: number[] = [];
  arrows.forEach(({ at, by }, index) => {
    const length = lengths[index] ?? 0;
    if (!(length > STILL * fastest)) return;
    const tip = plus(at, by, scale);
    put(lines, origin, at, tip);
    const across = acrossOf(by);
    const foot = plus(at, by, scale * (1 - HEAD));
    const half = (0.5 * HEAD * length * scale) / Math.hypot(...across);
    for (const side of [half, -half]) put(lines, origin, plus(foot, across, side), tip);
  });
  return lines;
}

function plus(a: Point3, b: Point3, scale: number): Point3 {
  return [a[0] + scale * b[0], a[1] + scale * b[1], a[2] + scale * b[2]];
}

function put(lines: number[], origin: Point3, ...points: Point3[]): void {
  for (const point of points) point.forEach((value, axis) => lines.push(value - (origin[axis] ?? 0)));
}

/** A direction upright to another: the cross product with the axis that it lies along least. */
function acrossOf([x, y, z]: Point3): Point3 {
  const [a, b, c] = [Math.abs(x), Math.abs(y), Math.abs(z)];
  // Flat arrows have flat heads.
  if (c <= a || c <= b) return [y, -x, 0];
  return [0, z, -y];
}
