/** Which of many points is nearest to a place on the screen. */

export interface SeenVertex {
  /** Its number among the points. */
  index: number;
  /** How far it is from the place, in pixels. */
  far: number;
  depth: number;
}

/** Places this near each other, in pixels, are one for a hand: the one before counts. */
const SAME = 1;

/** Whether one is the better to take: nearer to the place, or as near and before. */
export function isBefore(a: SeenVertex, b: SeenVertex): boolean {
  return a.far < b.far - SAME || (a.far < b.far + SAME && a.depth < b.depth);
}

/**
 * The point nearest to a place of a pane within `reach` pixels, of those that are in one place there the one before.
 * `project` is the matrix of the view, column by column; what is behind the eye is not seen.
 */
export function nearestVertex(
  positions: ArrayLike<number>, project: ArrayLike<number>, [width, height]: readonly [number, number],
  [x, y]: readonly [number, number], reach: number,
): SeenVertex | undefined {
  const e = (at: number) => project[at] ?? 0;
  let best: SeenVertex | undefined;
  for (let index = 0; index * 3 + 2 < positions.length; index++) {
    const [px, py, pz] = [positions[index * 3] ?? 0, positions[index * 3 + 1] ?? 0, positions[index * 3 + 2] ?? 0];
    const w = e(3) * px + e(7) * py + e(11) * pz + e(15);
    if (w <= 0) continue;
    const u = ((e(0) * px + e(4) * py + e(8) * pz + e(12)) / w + 1) * 0.5 * width;
    const v = (1 - (e(1) * px + e(5) * py + e(9) * pz + e(13)) / w) * 0.5 * height;
    const far = Math.hypot(u - x, v - y);
    if (!(far <= reach)) continue;
    const seen = { index, far, depth: (e(2) * px + e(6) * py + e(10) * pz + e(14)) / w };
    if (!best || isBefore(seen, best)) best = seen;
  }
  return best;
}
