/** The order in which the keyboard goes through a canvas. */

import type { Point, Rect } from "./geometry";
import { middle } from "./geometry";

type Placed = readonly [id: string, rect: Rect];

/** Left to right in bands that flow down: what starts at about the same x goes from top to bottom. */
export function readingOrder(objects: readonly Placed[], column = 80): string[] {
  const across = [...objects].sort((a, b) => a[1][0] - b[1][0] || a[1][1] - b[1][1]);
  const ordered: string[] = [];
  let band: Placed[] = [];
  const flush = () => {
    band.sort((a, b) => a[1][1] - b[1][1] || a[1][0] - b[1][0]);
    ordered.push(...band.map(([id]) => id));
  };
  for (const object of across) {
    const first = band[0];
    if (first && object[1][0] - first[1][0] > column) {
      flush();
      band = [];
    }
    band.push(object);
  }
  flush();
  return ordered;
}

export type Direction = "left" | "right" | "up" | "down";

/** The nearest object in a direction; what lies straight on counts for nearer than what lies aside. */
export function neighbour(from: Rect, objects: Iterable<Placed>, direction: Direction): string | undefined {
  const [cx, cy] = middle(from);
  let best: string | undefined;
  let least = Infinity;
  for (const [id, rect] of objects) {
    const [dx, dy] = offset([cx, cy], middle(rect));
    const ahead = { left: -dx, right: dx, up: -dy, down: dy }[direction];
    const aside = Math.abs(direction === "left" || direction === "right" ? dy : dx);
    if (ahead <= 1 || aside > 3 * ahead) continue;
    const cost = ahead + 2 * aside;
    if (cost < least) [best, least] = [id, cost];
  }
  return best;
}

function offset(a: Point, b: Point): Point {
  return [b[0] - a[0], b[1] - a[1]];
}
