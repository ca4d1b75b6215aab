/** Points and rectangles of the canvas; y points down. */

export type Point = readonly [x: number, y: number];
export type Rect = readonly [x: number, y: number, width: number, height: number];

export function union(a: Rect, b: Rect): Rect {
  const x = Math.min(a[0], b[0]);
  const y = Math.min(a[1], b[1]);
  return [x, y, Math.max(a[0] + a[2], b[0] + b[2]) - x, Math.max(a[1] + a[3], b[1] + b[3]) - y];
}

/** The smallest rectangle around all; none around nothing. */
export function around(rects: Iterable<Rect>): Rect | undefined {
  let all: Rect | undefined;
  for (const rect of rects) all = all ? union(all, rect) : rect;
  return all;
}

export function grown([x, y, w, h]: Rect, by: number, top = by): Rect {
  return [x - by, y - top, w + 2 * by, h + by + top];
}

export function moved([x, y, w, h]: Rect, [dx, dy]: Point): Rect {
  return [x + dx, y + dy, w, h];
}

/** The rectangle with two points at opposite corners. */
export function between(a: Point, b: Point): Rect {
  return [Math.min(a[0], b[0]), Math.min(a[1], b[1]), Math.abs(a[0] - b[0]), Math.abs(a[1] - b[1])];
}

export function holds([x, y, w, h]: Rect, [px, py]: Point): boolean {
  return px >= x && px <= x + w && py >= y && py <= y + h;
}

export function inside(inner: Rect, outer: Rect): boolean {
  return (
    inner[0] >= outer[0] &&
    inner[1] >= outer[1] &&
    inner[0] + inner[2] <= outer[0] + outer[2] &&
    inner[1] + inner[3] <= outer[1] + outer[3]
  );
}

export function meets(a: Rect, b: Rect): boolean {
  return a[0] <= b[0] + b[2] && b[0] <= a[0] + a[2] && a[1] <= b[1] + b[3] && b[1] <= a[1] + a[3];
}

export function middle([x, y, w, h]: Rect): Point {
  return [x + w / 2, y + h / 2];
}

export function distance(a: Point, b: Point): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
}

/** The distance of a point from a segment. */
export function segmentDistance(p: Point, a: Point, b: Point): number {
  const [ux, uy] = [b[0] - a[0], b[1] - a[1]];
  const square = ux * ux + uy * uy;
  const along = square > 0 ? ((p[0] - a[0]) * ux + (p[1] - a[1]) * uy) / square : 0;
  const t = Math.min(1, Math.max(0, along));
  return Math.hypot(p[0] - a[0] - t * ux, p[1] - a[1] - t * uy);
}

export function clamp(x: number, low: number, high: number): number {
  return Math.min(Math.max(x, low), high);
}

/** What the window shows: the canvas point at its corner times `zoom` lies at `-x`, `-y`. */
export interface Lens {
  x: number;
  y: number;
  zoom: number;
}

/** The limits of the zoom. The farthest shows 40,000 units of a canvas in the 200 pixels that a phone leaves for it. */
export const NEAREST = 5;
export const FARTHEST = 0.005;

/** The canvas point below a pixel of the window. */
export function toCanvas(lens: Lens, [x, y]: Point): Point {
  return [(x - lens.x) / lens.zoom, (y - lens.y) / lens.zoom];
}

/** The pixel of the window above a canvas point. */
export function toWindow(lens: Lens, [x, y]: Point): Point {
  return [x * lens.zoom + lens.x, y * lens.zoom + lens.y];
}

/** Zooms so that the canvas point below a pixel stays there. */
export function zoomed(lens: Lens, at: Point, factor: number): Lens {
  const zoom = clamp(lens.zoom * factor, FARTHEST, NEAREST);
  const scale = zoom / lens.zoom;
  return { x: at[0] - (at[0] - lens.x) * scale, y: at[1] - (at[1] - lens.y) * scale, zoom };
}

/** Below this zoom there is only room for headings: labels of groups and scribbles. */
export const STRUCTURE_BELOW = 0.15;
/** Farther away than this headings lie over each other; what is first seen of a long definition is nearer, within limits. */
const TOO_FAR = 0.08;
const FIRST_LOOK: readonly [least: number, most: number] = [STRUCTURE_BELOW, 0.5];

/**
 * What is seen of a definition at first: all of it; most of it from its beginning, where names could not be read else and
 * no headings stand for them; or
 * the beginning of one that is so long that nothing of it could be read, as wide as the window where that is near enough.
 * Where that is too wide, it is where most of its beginning stands.
 */
export function firstLook(rects: readonly Rect[], [width, height]: Point, margin: number, areHeaded = false): Lens | undefined {
  const all = around(rects);
  if (!all) return undefined;
  const whole = fitted(all, [width, height], 1, margin);
  if (whole.zoom >= (areHeaded ? TOO_FAR : STRUCTURE_BELOW)) return whole;
  const room: Point = [Math.max(width - 2 * margin, 1), Math.max(height - 2 * margin, 1)];
  const nearer = clamp(Math.max(room[0] / Math.max(all[2], 1), room[1] / Math.max(all[3], 1)), ...FIRST_LOOK);
  const zoom = whole.zoom >= TOO_FAR ? STRUCTURE_BELOW : nearer;
  const [w, h] = [room[0] / zoom, room[1] / zoom];
  const begins = rects.filter((rect) => rect[1] < all[1] + h);
  const x = all[2] <= w ? all[0] - (w - all[2]) / 2 : crowded(begins.map((rect) => [rect[0], rect[0] + rect[2]]), w);
  const y = all[3] <= h ? all[1] - (h - all[3]) / 2 : all[1];
  return { x: margin - x * zoom, y: margin - y * zoom, zoom };
}

/** Where a stretch of a length begins that holds most of some spans whole; the first of several such. */
function crowded(spans: readonly Point[], length: number): number {
  const byStart = [...spans].sort((a, b) => a[0] - b[0]);
  let best = { count: 0, from: byStart[0]?.[0] ?? 0 };
  byStart.forEach(([from], k) => {
    let count = 0;
    for (let l = k; l < byStart.length && (byStart[l]?.[0] ?? 0) <= from + length; l++) {
      if ((byStart[l]?.[1] ?? 0) <= from + length) count += 1;
    }
    if (count > best.count) best = { count, from };
  });
  return best.from;
}

/** The view that shows a rectangle whole, no larger than `most`. */
export function fitted(rect: Rect, [width, height]: Point, most = 1, margin = 40): Lens {
  const room: Point = [Math.max(width - 2 * margin, 1), Math.max(height - 2 * margin, 1)];
  const zoom = clamp(Math.min(room[0] / Math.max(rect[2], 1), room[1] / Math.max(rect[3], 1)), FARTHEST, most);
  const [cx, cy] = middle(rect);
  return { x: width / 2 - cx * zoom, y: height / 2 - cy * zoom, zoom };
}
