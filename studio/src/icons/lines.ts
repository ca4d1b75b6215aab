/** Plain figures as paths: lines, circles, arrows, and what stands along a curve. */

import { fill, hotFill, n, type Drawing } from "./piece";

type Point = readonly [x: number, y: number];
/** A cubic curve, by its four points. */
export type Cubic = readonly [Point, Point, Point, Point];

/** A line through points that are given one after the other: x, y, x, y. */
export function line(...numbers: readonly number[]): string {
  let out = "";
  for (let k = 0; k + 1 < numbers.length; k += 2) out += `${k === 0 ? "M" : "L"}${n(numbers[k] ?? 0)} ${n(numbers[k + 1] ?? 0)}`;
  return out;
}

export const poly = (...numbers: readonly number[]): string => `${line(...numbers)}Z`;

export function rect(x: number, y: number, width: number, height: number): string {
  return `M${n(x)} ${n(y)}H${n(x + width)}V${n(y + height)}H${n(x)}Z`;
}

export function ellipse(x: number, y: number, rx: number, ry: number): string {
  const half = `A${n(rx)} ${n(ry)} 0 1 1`;
  return `M${n(x - rx)} ${n(y)}${half} ${n(x + rx)} ${n(y)}${half} ${n(x - rx)} ${n(y)}Z`;
}

export const circle = (x: number, y: number, r: number): string => ellipse(x, y, r, r);

/** Part of a circle, by angles in degrees that run clockwise from the right. */
export function arc(x: number, y: number, r: number, from: number, to: number): string {
  const at = (degrees: number) => {
    const angle = (degrees * Math.PI) / 180;
    return `${n(x + r * Math.cos(angle))} ${n(y + r * Math.sin(angle))}`;
  };
  const large = Math.abs(to - from) > 180 ? 1 : 0;
  return `M${at(from)}A${n(r)} ${n(r)} 0 ${large} ${to > from ? 1 : 0} ${at(to)}`;
}

/** A regular polygon; the first corner is at an angle in degrees, −90 is above. */
export function ngon(x: number, y: number, r: number, corners: number, first = -90): string {
  const numbers = Array.from({ length: corners }, (_, k) => ((first + (360 * k) / corners) * Math.PI) / 180);
  return poly(...numbers.flatMap((angle) => [x + r * Math.cos(angle), y + r * Math.sin(angle)]));
}

/** The two strokes of an arrow's head, at the end of a line that runs in a direction. */
export function head(x: number, y: number, dx: number, dy: number, size = 3.5): string {
  const length = Math.hypot(dx, dy) || 1;
  const [ux, uy] = [(dx / length) * size, (dy / length) * size];
  const side = 0.75;
  return line(x - ux - uy * side, y - uy + ux * side, x, y, x - ux + uy * side, y - uy - ux * side);
}

export function arrow(x1: number, y1: number, x2: number, y2: number, size = 3.5): string {
  return line(x1, y1, x2, y2) + head(x2, y2, x2 - x1, y2 - y1, size);
}

/** An arrow with two heads. */
export const span = (x1: number, y1: number, x2: number, y2: number, size = 3): string =>
  arrow(x1, y1, x2, y2, size) + head(x1, y1, x1 - x2, y1 - y2, size);

/** An arrow along part of a circle. */
export function turnArrow(x: number, y: number, r: number, from: number, to: number, size = 3.5): string {
  const angle = (to * Math.PI) / 180;
  const way = to > from ? 1 : -1;
  const [cx, sy] = [Math.cos(angle), Math.sin(angle)];
  // The head follows the chord of the arc's last piece: it would stick out of a small arc otherwise.
  const back = ((to - way * Math.min(28, (size / r) * 30)) * Math.PI) / 180;
  return (
    arc(x, y, r, from, to) +
    head(x + r * cx, y + r * sy, cx - Math.cos(back), sy - Math.sin(back), size)
  );
}

/** Points, three and a half units wide. */
const DOT = 1.75;
const dots = (tone: typeof fill, r: number) => (...numbers: readonly number[]): Drawing => {
  const out: Drawing[] = [];
  for (let k = 0; k + 1 < numbers.length; k += 2) out.push(tone(circle(numbers[k] ?? 0, numbers[k + 1] ?? 0, r)));
  return out;
};
export const dot = dots(fill, DOT);
export const hotDot = dots(hotFill, DOT + 0.25);
export const speck = dots(fill, 1.1);
export const hotSpeck = dots(hotFill, 1.1);

export const path = ([a, b, c, d]: Cubic): string =>
  `M${n(a[0])} ${n(a[1])}C${n(b[0])} ${n(b[1])} ${n(c[0])} ${n(c[1])} ${n(d[0])} ${n(d[1])}`;

export function pointOf([a, b, c, d]: Cubic, t: number): Point {
  const s = 1 - t;
  const mix = (k: 0 | 1) => s * s * s * a[k] + 3 * s * s * t * b[k] + 3 * s * t * t * c[k] + t * t * t * d[k];
  return [mix(0), mix(1)];
}

/** The direction of a curve at a parameter, of length 1. */
function alongOf([a, b, c, d]: Cubic, t: number): Point {
  const s = 1 - t;
  const mix = (k: 0 | 1) => s * s * (b[k] - a[k]) + 2 * s * t * (c[k] - b[k]) + t * t * (d[k] - c[k]);
  const length = Math.hypot(mix(0), mix(1)) || 1;
  return [mix(0) / length, mix(1) / length];
}

/** Straight lines from point to point of a curve. */
export const chords = (curve: Cubic, ...at: readonly number[]): string => line(...at.flatMap((t) => pointOf(curve, t)));

/** The part of a curve between two parameters. */
export function part(curve: Cubic, from: number, to: number): Cubic {
  const after = split(curve, from)[1];
  return split(after, (to - from) / (1 - from))[0];
}

function split([a, b, c, d]: Cubic, t: number): readonly [Cubic, Cubic] {
  const mix = (p: Point, q: Point): Point => [p[0] + (q[0] - p[0]) * t, p[1] + (q[1] - p[1]) * t];
  const [ab, bc, cd] = [mix(a, b), mix(b, c), mix(c, d)];
  const [abc, bcd] = [mix(ab, bc), mix(bc, cd)];
  const middle = mix(abc, bcd);
  return [
    [a, ab, abc, middle],
    [middle, bcd, cd, d],
  ];
}

export const hotDotsOn = (curve: Cubic, ...at: readonly number[]): Drawing => hotDot(...at.flatMap((t) => pointOf(curve, t)));

/** Short strokes across a curve. */
export function ticksOn(curve: Cubic, length: number, ...at: readonly number[]): string {
  return across(curve, -length, length, at);
}

/** Strokes that stand on one side of a curve. */
export function normalsOn(curve: Cubic, length: number, ...at: readonly number[]): string {
  return across(curve, 0, length, at);
}

function across(curve: Cubic, from: number, to: number, at: readonly number[]): string {
  return at
    .map((t) => {
      const [[x, y], [dx, dy]] = [pointOf(curve, t), alongOf(curve, t)];
      return line(x + dy * from, y - dx * from, x + dy * to, y - dx * to);
    })
    .join("");
}

/** Strokes that run away from a point, from one distance to another, by angles in degrees. */
export function rays(x: number, y: number, angles: readonly number[], from: number, to: number): string {
  return angles
    .map((degrees) => {
      const [c, s] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
      return line(x + c * from, y + s * from, x + c * to, y + s * to);
    })
    .join("");
}
