/** Arrows at the edge of the window that point to what lies beyond it. */

import { clamp, middle, toWindow, type Lens, type Point, type Rect } from "./geometry";

export interface EdgeArrow {
  id: string;
  /** The tip of the arrow, in pixels of the window. */
  at: Point;
  /** Where it points, in degrees clockwise from the right. */
  turn: number;
  /** How many things lie that way: those whose arrows would cover each other have one. */
  count: number;
}

/** From the edge to the tips. */
const MARGIN = 22;
/** Arrows nearer to each other than this are one. */
const APART = 26;

/** The arrows to those of these rectangles of the canvas that are out of sight. */
export function edgeArrows(rects: Iterable<readonly [string, Rect]>, lens: Lens, [width, height]: Point): EdgeArrow[] {
  const arrows: EdgeArrow[] = [];
  const centre: Point = [width / 2, height / 2];
  for (const [id, rect] of rects) {
    const [x, y] = toWindow(lens, middle(rect));
    if (x >= 0 && y >= 0 && x <= width && y <= height) continue;
    const at: Point = [clamp(x, MARGIN, Math.max(width - MARGIN, MARGIN)), clamp(y, MARGIN, Math.max(height - MARGIN, MARGIN))];
    const near = arrows.find((arrow) => Math.hypot(arrow.at[0] - at[0], arrow.at[1] - at[1]) < APART);
    if (near) near.count += 1;
    else arrows.push({ id, at, turn: (Math.atan2(y - centre[1], x - centre[0]) * 180) / Math.PI, count: 1 });
  }
  return arrows;
}
