/** Where a box about something opens, so that it can be seen whole and does not cover what it is about. */

import { clamp, meets, type Point, type Rect } from "./geometry";

const GAP = 8;

/** The corner of a box of this size: below the rectangle, else above it, else beside it, else where there is room. */
export function boxPlace([x, y, w, h]: Rect, [width, height]: Point, [roomX, roomY]: Point): Point {
  const left = clamp(x, GAP, Math.max(roomX - width - GAP, GAP));
  const top = clamp(y, GAP, Math.max(roomY - height - GAP, GAP));
  const tries: Point[] = [
    [left, y + h + GAP],
    [left, y - height - GAP],
    [x + w + GAP, top],
    [x - width - GAP, top],
  ];
  const whole = tries.find(([a, b]) => a >= GAP && b >= GAP && a + width + GAP <= roomX && b + height + GAP <= roomY);
  if (whole) return whole;
  const under: Point = [left, clamp(y + h + GAP, GAP, Math.max(roomY - height - GAP, GAP))];
  return meets([...under, width, height], [x, y, w, h]) ? [left, Math.max(roomY - height - GAP, GAP)] : under;
}
