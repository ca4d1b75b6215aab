/** What lies under the pointer or in a window, for positions already on the screen (x right, y down, in pixels). */

export interface Rectangle {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

export function rectangle(x: number, y: number, u: number, v: number): Rectangle {
  return { left: Math.min(x, u), top: Math.min(y, v), right: Math.max(x, u), bottom: Math.max(y, v) };
}

export function holds({ left, top, right, bottom }: Rectangle, x: number, y: number): boolean {
  return x >= left && x <= right && y >= top && y <= bottom;
}

/** Where on a segment (0 to 1) the place nearest to a point is, and the square of how far that is. */
export function nearestOnSegment(
  x: number, y: number, ax: number, ay: number, bx: number, by: number,
): [at: number, distanceSquared: number] {
  const [dx, dy] = [bx - ax, by - ay];
  const length = dx * dx + dy * dy;
  const at = length > 0 ? Math.min(Math.max(((x - ax) * dx + (y - ay) * dy) / length, 0), 1) : 0;
  const [ex, ey] = [ax + dx * at - x, ay + dy * at - y];
  return [at, ex * ex + ey * ey];
}

/** Whether a segment touches a rectangle: Liang and Barsky's clipping. */
export function segmentTouches(box: Rectangle, ax: number, ay: number, bx: number, by: number): boolean {
  const [dx, dy] = [bx - ax, by - ay];
  let from = 0;
  let to = 1;
  for (const [step, room] of [[-dx, ax - box.left], [dx, box.right - ax], [-dy, ay - box.top], [dy, box.bottom - ay]] as const) {
    if (step === 0) {
      if (room < 0) return false;
    } else if (step < 0) {
      from = Math.max(from, room / step);
    } else {
      to = Math.min(to, room / step);
    }
  }
  return from <= to;
}

/** Whether a triangle touches a rectangle. */
export function triangleTouches(
  box: Rectangle, ax: number, ay: number, bx: number, by: number, cx: number, cy: number,
): boolean {
  if (segmentTouches(box, ax, ay, bx, by) || segmentTouches(box, bx, by, cx, cy) || segmentTouches(box, cx, cy, ax, ay)) {
    return true;
  }
  // No edge touches it: the rectangle lies inside the triangle or apart from it, and one corner tells.
  const side = (px: number, py: number, qx: number, qy: number) =>
    (qx - px) * (box.top - py) - (qy - py) * (box.left - px);
  const [first, second, third] = [side(ax, ay, bx, by), side(bx, by, cx, cy), side(cx, cy, ax, ay)];
  return (first >= 0 && second >= 0 && third >= 0) || (first <= 0 && second <= 0 && third <= 0);
}
