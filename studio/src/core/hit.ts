/** What lies below a point of the canvas, found by arithmetic: in the far view there is nothing else to ask. */

import { holds, type Point, type Rect } from "./geometry";
import { wireDistance, wireMeets } from "./wires";

/** An end that wires hold on to. */
export interface Grip {
  /** The id that wires name. */
  port: string;
  object: string;
  side: "input" | "output";
  at: Point;
}

/** A wire with its ends. */
export interface Strung {
  /** The output. */
  from: string;
  /** The input. */
  to: string;
  a: Point;
  b: Point;
}

/** How far from a grip it is still taken hold of, in pixels: WCAG asks for targets of 24. */
export const GRIP_REACH = 14;
export const WIRE_REACH = 6;

/** The topmost of rectangles in the order of drawing. */
export function topmost(point: Point, rects: readonly (readonly [string, Rect])[]): string | undefined {
  return rects.findLast(([, rect]) => holds(rect, point))?.[0];
}

/** The nearest grip within reach of a point; of those that `fits` allows. */
export function gripAt(
  point: Point,
  grips: Iterable<Grip>,
  within: number,
  fits: (grip: Grip) => boolean = () => true,
): Grip | undefined {
  let [best, least]: [Grip | undefined, number] = [undefined, within];
  for (const grip of grips) {
    const away = Math.hypot(grip.at[0] - point[0], grip.at[1] - point[1]);
    if (away <= least && fits(grip)) [best, least] = [grip, away];
  }
  return best;
}

/** The nearest wire within reach of a point. */
export function wireAt(point: Point, wires: Iterable<Strung>, within: number): Strung | undefined {
  const field: Rect = [point[0] - within, point[1] - within, 2 * within, 2 * within];
  let [best, least]: [Strung | undefined, number] = [undefined, within];
  for (const wire of wires) {
    if (!wireMeets(field, wire.a, wire.b)) continue;
    const away = wireDistance(point, wire.a, wire.b);
    if (away <= least) [best, least] = [wire, away];
  }
  return best;
}
