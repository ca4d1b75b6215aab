/** Lining up with what is near while something is dragged. */

import { meets, grown, type Point, type Rect } from "./geometry";

/** A line to show while something lines up with something else. */
export interface Guide {
  axis: "x" | "y";
  at: number;
  from: number;
  to: number;
}

export interface Snap {
  /** The step with which the dragged things line up. */
  by: Point;
  guides: Guide[];
}

/** How far around the dragged things others are looked at. */
const NEAR = 400;

/**
 * The step nearest to `by` with which an edge or middle of the dragged rectangle stands in line with one of the others,
 * at most `within` away from it on each axis.
 */
export function snap(dragged: Rect, by: Point, others: Iterable<Rect>, within: number): Snap {
  const rect: Rect = [dragged[0] + by[0], dragged[1] + by[1], dragged[2], dragged[3]];
  const field = grown(rect, NEAR);
  const near = [...others].filter((other) => meets(other, field));
  const [x, y] = [nearest(rect, near, 0, within), nearest(rect, near, 1, within)];
  const guides = [guide("x", x, rect, y?.by ?? 0), guide("y", y, rect, x?.by ?? 0)];
  return {
    by: [by[0] + (x?.by ?? 0), by[1] + (y?.by ?? 0)],
    guides: guides.filter((one) => one !== undefined),
  };
}

interface Fit {
  by: number;
  at: number;
  other: Rect;
}

function lines(rect: Rect, axis: 0 | 1): [number, number, number] {
  const [low, size] = [rect[axis], rect[axis === 0 ? 2 : 3]];
  return [low, low + size / 2, low + size];
}

function nearest(rect: Rect, others: readonly Rect[], axis: 0 | 1, within: number): Fit | undefined {
  const own = lines(rect, axis);
  let best: Fit | undefined;
  for (const other of others) {
    lines(other, axis).forEach((at, k) => {
      const by = at - (own[k] ?? at);
      if (Math.abs(by) <= within && Math.abs(by) < Math.abs(best?.by ?? Infinity)) best = { by, at, other };
    });
  }
  return best;
}

function guide(axis: "x" | "y", fit: Fit | undefined, rect: Rect, aside: number): Guide | undefined {
  if (!fit) return undefined;
  const along = axis === "x" ? 1 : 0;
  const size = along === 1 ? 3 : 2;
  const own = rect[along] + aside;
  const from = Math.min(own, fit.other[along]);
  return { axis, at: fit.at, from, to: Math.max(own + rect[size], fit.other[along] + fit.other[size]) };
}
