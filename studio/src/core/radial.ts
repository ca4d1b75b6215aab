/** A ring of sectors about a point: which of them a pointer is in, and their outlines. The first is at the top. */

import type { Point } from "./geometry";

const TURN = 2 * Math.PI;

export interface Ring {
  /** How many sectors. */
  count: number;
  inner: number;
  outer: number;
}

/** The angle of a sector's middle, clockwise from the top. */
export function angleOf({ count }: Pick<Ring, "count">, index: number): number {
  return (TURN * index) / Math.max(count, 1);
}

/** The point at an angle (clockwise from the top) and a distance; y points down. */
export function polar(angle: number, radius: number): Point {
  return [radius * Math.sin(angle), -radius * Math.cos(angle)];
}

/** The middle of a sector. */
export function middleOf(ring: Ring, index: number): Point {
  return polar(angleOf(ring, index), (ring.inner + ring.outer) / 2);
}

/** The sector that a pointer is in, seen from the middle; beyond the ring it counts too, in the hole it does not. */
export function sectorAt({ count, inner }: Ring, [x, y]: Point): number | undefined {
  if (count < 1 || Math.hypot(x, y) < inner) return undefined;
  const turn = Math.atan2(x, -y) / TURN;
  return Math.round((turn < 0 ? turn + 1 : turn) * count) % count;
}

/** The outline of a sector as an SVG path, with a gap of so many pixels to its neighbours. */
export function sectorPath(ring: Ring, index: number, gap = 2): string {
  const { count, inner, outer } = ring;
  const middle = angleOf(ring, index);
  const half = TURN / Math.max(count, 1) / 2;
  const corner = (side: -1 | 1, radius: number) => {
    const [x, y] = polar(middle + side * (half - Math.min(gap / 2 / radius, half)), radius);
    return `${round(x)},${round(y)}`;
  };
  // Half a turn or more takes the long way round.
  const long = half > Math.PI / 2 ? 1 : 0;
  return (
    `M${corner(-1, inner)}L${corner(-1, outer)}A${outer},${outer} 0 ${long} 1 ${corner(1, outer)}` +
    `L${corner(1, inner)}A${inner},${inner} 0 ${long} 0 ${corner(-1, inner)}Z`
  );
}

function round(x: number): number {
  return Math.round(x * 100) / 100;
}

/** The sector after a step with the keyboard: from none to the first. */
export function stepped(count: number, at: number | undefined, by: number): number | undefined {
  if (count < 1) return undefined;
  if (at === undefined) return by > 0 ? 0 : count - 1;
  return (((at + by) % count) + count) % count;
}
