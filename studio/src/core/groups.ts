/** Groups: the frames around their members, and who moves with them. */

import { around, grown, type Point, type Rect } from "./geometry";
import type { BorderView } from "./protocol/BorderView";
import type { ObjectView } from "./protocol/ObjectView";

export type Objects = ReadonlyMap<string, ObjectView>;

/** Room between a frame and what is in it, and above it for the label. */
const ROOM = 10;
const LABEL = 20;
/** Groups in groups, at most. */
const DEEPEST = 16;

export function members(object: ObjectView | undefined): readonly string[] {
  return object?.control?.is === "group" ? object.control.members : [];
}

export function isGroup(object: ObjectView): boolean {
  return object.control?.is === "group";
}

/** Everything in some groups that is no group itself; objects that are no groups stand for themselves. */
export function leaves(ids: Iterable<string>, objects: Objects): Set<string> {
  const found = new Set<string>();
  const seen = new Set<string>();
  const visit = (id: string, deep: number) => {
    const object = objects.get(id);
    if (!object || deep > DEEPEST || seen.has(id)) return;
    seen.add(id);
    if (!isGroup(object)) found.add(id);
    else for (const member of members(object)) visit(member, deep + 1);
  };
  for (const id of ids) visit(id, 0);
  return found;
}

/**
 * The frame of a group about its members, as they stand now; none about nothing. A group in it counts with its frame.
 */
export function groupFrame(
  id: string,
  objects: Objects,
  rectOf: (object: ObjectView) => Rect,
  deep = 0,
): Rect | undefined {
  const object = objects.get(id);
  if (!object || deep > DEEPEST) return undefined;
  if (!isGroup(object)) return rectOf(object);
  const rects = members(object).map((member) => groupFrame(member, objects, rectOf, deep + 1));
  const all = around(rects.filter((rect) => rect !== undefined));
  const label = object.control?.is === "group" ? object.control.label.trim() : "";
  return all && grown(all, ROOM, label === "" ? ROOM : LABEL + ROOM / 2);
}

/** How deep a group lies in others: the deepest is drawn last. */
export function depths(objects: Objects): Map<string, number> {
  const above = new Map<string, string[]>();
  for (const object of objects.values()) {
    for (const member of members(object)) {
      if (objects.get(member)?.control?.is !== "group") continue;
      above.set(member, [...(above.get(member) ?? []), object.id]);
    }
  }
  const depth = new Map<string, number>();
  const visit = (id: string, deep: number): number => {
    const known = depth.get(id);
    if (known !== undefined) return known;
    depth.set(id, deep);
    const parents = above.get(id) ?? [];
    const own = deep > DEEPEST ? 0 : Math.max(-1, ...parents.map((parent) => visit(parent, deep + 1))) + 1;
    depth.set(id, own);
    return own;
  };
  for (const object of objects.values()) if (isGroup(object)) visit(object.id, 0);
  return depth;
}

/** The outline of a blob: the hull of the members' corners, rounded, as the `d` of a path about an origin. */
export function blobPath(rects: readonly Rect[], origin: Point, radius = 14): string {
  const corners = rects.flatMap(([x, y, w, h]): Point[] => [
    [x, y],
    [x + w, y],
    [x + w, y + h],
    [x, y + h],
  ]);
  const ring = hull(corners);
  if (ring.length < 3) return "";
  const parts = ring.map((here, k) => {
    const before = ring[(k + ring.length - 1) % ring.length] ?? here;
    const after = ring[(k + 1) % ring.length] ?? here;
    const [a, b] = [pushed(before, here, radius), pushed(here, after, radius)];
    const place = ([x, y]: Point) => `${round(x - origin[0])},${round(y - origin[1])}`;
    return `${k === 0 ? "M" : "L"}${place(a[1])} A${radius},${radius} 0 0 1 ${place(b[0])}`;
  });
  return `${parts.join(" ")} Z`;
}

function round(x: number): number {
  return Math.round(x * 10) / 10;
}

/** A side moved outwards by a distance; the ring runs clockwise as seen with y downwards. */
function pushed(a: Point, b: Point, by: number): [Point, Point] {
  const length = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1;
  const [nx, ny] = [((b[1] - a[1]) / length) * by, (-(b[0] - a[0]) / length) * by];
  return [
    [a[0] + nx, a[1] + ny],
    [b[0] + nx, b[1] + ny],
  ];
}

/** The convex hull, clockwise as seen with y downwards, without points on straight sides. */
export function hull(points: readonly Point[]): Point[] {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (run: Iterable<Point>) => {
    const chain: Point[] = [];
    for (const point of run) {
      for (;;) {
        const [b, a] = [chain.at(-1), chain.at(-2)];
        if (!a || !b || turn(a, b, point) > 0) break;
        chain.pop();
      }
      chain.push(point);
    }
    chain.pop();
    return chain;
  };
  return [...half(sorted), ...half(sorted.reverse())];
}

function turn(a: Point, b: Point, c: Point): number {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

export function isBlob(border: BorderView): boolean {
  return border === "blob";
}
