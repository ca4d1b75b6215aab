/** Wires: curves that leave an output to the right and come into an input from the left. */

import type { Structure } from "./protocol/Structure";
import type { WireView } from "./protocol/WireView";
import { meets, segmentDistance, type Point, type Rect } from "./geometry";

/** The four control points of a wire's curve. */
export type Curve = readonly [Point, Point, Point, Point];

/** How far the curve goes straight on at its ends: half the way across, more where it has to turn back. */
export function reach([ax, ay]: Point, [bx, by]: Point): number {
  const across = bx - ax;
  const down = Math.abs(by - ay);
  const forward = across >= 0 ? 0.5 * across : -0.3 * across + 0.2 * down;
  return Math.max(forward, 0.25 * Math.min(down, 120), 8);
}

export function wireCurve(a: Point, b: Point): Curve {
  const r = reach(a, b);
  return [a, [a[0] + r, a[1]], [b[0] - r, b[1]], b];
}

/** The curve as the `d` of an SVG path. */
export function wirePath(a: Point, b: Point): string {
  const [, c, d] = wireCurve(a, b);
  return `M${a[0]},${a[1]} C${c[0]},${c[1]} ${d[0]},${d[1]} ${b[0]},${b[1]}`;
}

export function curvePoint([a, b, c, d]: Curve, t: number): Point {
  const s = 1 - t;
  const [p, q, r, u] = [s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t];
  return [p * a[0] + q * b[0] + r * c[0] + u * d[0], p * a[1] + q * b[1] + r * c[1] + u * d[1]];
}

/** The rectangle of the control points: the curve lies in it. */
export function curveBounds(curve: Curve): Rect {
  const xs = curve.map(([x]) => x);
  const ys = curve.map(([, y]) => y);
  const [x, y] = [Math.min(...xs), Math.min(...ys)];
  return [x, y, Math.max(...xs) - x, Math.max(...ys) - y];
}

/** The distance of a point from a wire, to about a tenth of a unit: the curve is walked in short chords. */
export function wireDistance(point: Point, a: Point, b: Point): number {
  const curve = wireCurve(a, b);
  const steps = Math.min(64, Math.max(12, Math.ceil(Math.hypot(b[0] - a[0], b[1] - a[1]) / 16)));
  let least = Infinity;
  let from = a;
  for (let k = 1; k <= steps; k++) {
    const to = curvePoint(curve, k / steps);
    least = Math.min(least, segmentDistance(point, from, to));
    from = to;
  }
  return least;
}

/** Whether a wire can be seen in a rectangle; no wire that can is told not to. */
export function wireMeets(rect: Rect, a: Point, b: Point): boolean {
  return meets(rect, curveBounds(wireCurve(a, b)));
}

/** How a wire is drawn. A double line is a broad one with a narrower one of the ground's colour in it. */
export interface WireLook {
  colour: "plain" | "empty" | "selected";
  width: number;
  /** The width of the gap between two lines; 0 for one line. */
  gap: number;
  dashed: boolean;
  opacity: number;
  /** Drawn only as short waves at its ends. */
  wireless: boolean;
}

/** The look of a wire by the data on it, the input's wish, and whether an end of it is selected. */
export function wireLook(structure: Structure | undefined, view: WireView, selected: boolean): WireLook {
  const load = structure ?? "empty";
  const double = load === "list" || load === "tree";
  const look: WireLook = {
    colour: selected ? "selected" : load === "empty" ? "empty" : "plain",
    width: double ? 5 : 2,
    gap: double ? 2 : 0,
    dashed: load === "tree",
    opacity: 1,
    wireless: false,
  };
  if (selected || view === "normal") return look;
  if (view === "faint") return { ...look, width: double ? 3 : 1, gap: double ? 1.6 : 0, opacity: 0.45 };
  return { ...look, width: 1, gap: 0, dashed: false, wireless: true };
}

export const DASHES = "9 5";

/** The short waves that stand for a wire which is not drawn, before a grip; `side` 1 to its right, −1 to its left. */
export function wirelessPath([x, y]: Point, side: 1 | -1): string {
  const arc = (r: number) => {
    const at = (across: number, down: number) => `${x + side * r * across},${y + r * down}`;
    return `M${at(0.8, -0.7)} C${at(1.15, -0.25)} ${at(1.15, 0.25)} ${at(0.8, 0.7)}`;
  };
  return `${arc(8)} ${arc(12)}`;
}
